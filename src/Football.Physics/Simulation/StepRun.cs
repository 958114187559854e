namespace FootballPhysics;

/// <summary>Rest of a step that is still to be done.</summary>
internal ref struct StepRun
{
    /// <summary>Splits at the drag law's jump that one step may have; a chattering step goes on without more.</summary>
    public const int MaximumSplits = 16;

    /// <summary>Impacts that one step may have. After them the ball stays on what it hits.</summary>
    public const int MostImpacts = 256;

    /// <summary>Events of a step that make a crowd.</summary>
    private const int MostInCrowd = 14;

    /// <summary>Pieces of a step, whatever asks for them.</summary>
    private const int MostPieces = 1 << 13;

    /// <summary>Evaluations of the forces in a step, whatever asks for them.</summary>
    private const long MostEvaluations = 1 << 15;

    /// <summary>No piece takes more than so many of them, those of a search for its end included: so many are left where a piece begins.</summary>
    private const long MostOfPiece = 1 << 12;

    /// <summary>Hits by what moves, each so soon after the one before, s, ...</summary>
    private const double CrowdedFor = 0.01;

    /// <summary>... but not at one instant, s, ...</summary>
    private const double AtOnce = 1e-9;

    /// <summary>... of which more than this make a crowd: the ball is squeezed.</summary>
    private const int MostHits = 4;

    /// <summary>After so many pieces the length of the parts is chosen anew: what asked for short ones may be over.</summary>
    private const int PiecesOfOneLength = 64;

    /// <summary>A jump is never divided by a shorter time, s: its square stays finite.</summary>
    private const double ShortestForJumps = 1e-100;

    /// <summary>Time left, s.</summary>
    public double Left;

    /// <summary>Length of the whole step, s.</summary>
    public double Length;

    /// <summary>When the step ends, s: the clock of its pieces never runs past it, not even by rounding.</summary>
    public double End;

    /// <summary>Splits so far.</summary>
    public int Splits;

    /// <summary>Where the step had to be divided: the length of its parts, s; else 0.</summary>
    public double Part;

    /// <summary>True when the method would make a velocity longer in such parts, which the Magnus force only turns.</summary>
    public bool Spirals;

    /// <summary>Pieces so far.</summary>
    public int Pieces;

    /// <summary>Impacts so far.</summary>
    public int AllImpacts;

    /// <summary>How often the contacts that bear the ball, or their modes, have changed while several did.</summary>
    public int SetChanges;

    /// <summary>Pieces so far in which several contacts bear the ball.</summary>
    public int SetPieces;

    /// <summary>Parts with velocity-level impulses so far.</summary>
    public int Parts;

    /// <summary>Parts so far that are shorter because a normal turns.</summary>
    public int Turns;

    /// <summary>The number of checks whether friction holds a ball at rest that rolling resistance does not hold.</summary>
    public int Grips;

    /// <summary>How often the step has reported that the ball on several surfaces slides or rolls.</summary>
    public int Named;

    /// <summary>True while the ball slips because its carrier's velocity has jumped at the start of the step: a slip that ends within the step is not reported.</summary>
    public bool Jumped;

    /// <summary>By how much that jump was, over the step, m/s².</summary>
    public Vector3d CarrierGain;

    /// <summary>1/length, 1/s: what a jump at the start of a step is multiplied with. That of the shortest steps is bounded, so that no jump times it is no acceleration.</summary>
    public readonly double PerStep => 1.0 / Math.Max(Length, ShortestForJumps);

    /// <summary>How often the ball has begun to slip for want of grip.</summary>
    public int Slips;

    /// <summary>How often moving objects have begun to squeeze the ball.</summary>
    public int Squeezes;

    /// <summary>Impacts since time last went on.</summary>
    public int Impacts;

    /// <summary>Events that the log had before the step.</summary>
    public int FirstEvent;

    /// <summary>Impacts that were taken together, and not told one by one.</summary>
    public int Untold;

    /// <summary>Where events and counts go.</summary>
    public StepLog Log;

    private int _firstZoneEvent;
    private long _lastEvaluation;
    private double _lastHit;
    private int _hits;
    private int _eventsBefore;

    /// <summary>A step.</summary>
    /// <param name="dt">Its length, s.</param>
    /// <param name="time">When it starts, s.</param>
    /// <param name="log">Where events and counts go.</param>
    public StepRun(double dt, double time, StepLog log)
    {
        Left = dt;
        Length = dt;
        End = time + dt;
        Log = log;
        _lastEvaluation = log.Evaluations + MostEvaluations - MostOfPiece;
        _lastHit = double.NegativeInfinity;
        FirstEvent = log.Events.Count;
        _firstZoneEvent = log.ZoneEvents;
        if (log.Continues)
        {
            Continue(in log.Spent);
        }
    }

    /// <summary>Ends a call: a step that continues in a later call keeps its counters.</summary>
    public readonly void Close()
    {
        if (Log.Continues)
        {
            Log.Spent = new StepBudget
            {
                Pieces = Pieces,
                Evaluations = Log.Evaluations + MostEvaluations - MostOfPiece - _lastEvaluation,
                Events = Told,
                Splits = Splits,
                AllImpacts = AllImpacts,
                Impacts = Impacts,
                Untold = Untold,
                SetChanges = SetChanges,
                SetPieces = SetPieces,
                Parts = Parts,
                Turns = Turns,
                Named = Named,
                Slips = Slips,
                Squeezes = Squeezes,
                Hits = _hits,
                LastHit = _lastHit,
            };
        }
    }

    /// <summary>The length of the next part: what is left, or an equal share of it where the step had to be divided, s.</summary>
    public readonly double Next => Part > 0 && Left > Part ? Left / Math.Ceiling((Left / Part) - 1e-9) : Left;

    /// <summary>True when the step has told so much that slow impacts are counted and told no more.</summary>
    public readonly bool IsCrowded => Told >= MostInCrowd;

    /// <summary>Events of the step so far; those of zones change nothing.</summary>
    private readonly int Told => _eventsBefore + Log.Events.Count - FirstEvent - (Log.ZoneEvents - _firstZoneEvent);

    /// <summary>Counts a piece before it is taken.</summary>
    /// <returns>False where the step has had all pieces, or all evaluations, that a step may have.</returns>
    public bool Begin()
    {
        Pieces++;
        if (Pieces % PiecesOfOneLength == 0)
        {
            Divide();
        }

        return Pieces <= MostPieces && Log.Evaluations <= _lastEvaluation;
    }

    /// <summary>Keeps the length of a part that is shorter than what was asked for, s.</summary>
    public void Keep(double part, double asked) => Part = part < asked ? part : Part;

    /// <summary>Counts an impact: after it the step is divided anew.</summary>
    /// <returns>Whether the ball may bounce.</returns>
    public bool Hit()
    {
        Divide();
        return AllImpacts++ < MostImpacts;
    }

    /// <summary>Counts a hit by something that moves; those of one instant once.</summary>
    /// <returns>Whether so many came so soon one after the other that the ball has no room.</returns>
    public bool IsCrowdedAt(double time)
    {
        double since = time - _lastHit;

        // A pause begins the count anew, and several at one instant are one.
        _hits = since > CrowdedFor ? 1 : since > AtOnce ? _hits + 1 : _hits;
        _lastHit = time;
        return _hits > MostHits;
    }

    /// <summary>Reports an event, or only counts it if the step has reported too many.</summary>
    public readonly void Report(in BallEvent item)
    {
        if (StepBudget.Reports(item.Kind, Told, Length))
        {
            Log.Events.Add(in item);
        }
        else
        {
            Log.UnreportedImpacts++;
        }
    }

    /// <summary>Counts a piece as done: the clock goes on, and the time left gets less.</summary>
    public void Advance(ref BallState s, double h)
    {
        s.Time = Math.Min(s.Time + h, End);
        Left -= h;

        // Impacts at one instant are counted until time goes on.
        Impacts = h > 0 ? 0 : Impacts;
        Log.Steps++;
    }

    /// <summary>Shows a piece if anyone watches; only then is the acceleration at its end worth an evaluation.</summary>
    /// <param name="before">The ball at the piece's start.</param>
    /// <param name="after">The ball at its end.</param>
    /// <param name="sweep">The piece.</param>
    /// <param name="order">Order of the method that took it.</param>
    public void Show<TSweep>(in BallState before, in BallState after, ref TSweep sweep, int order)
        where TSweep : struct, ISweep
    {
        if (Log.IsWatched)
        {
            Vector3d end = default;
            if (Log.WantsEnd(in before, in after, sweep.StartAcceleration))
            {
                end = sweep.EndAcceleration();
                Log.Evaluations++;

                // A step does the same whether it is watched or not.
                _lastEvaluation++;
            }

            Log.Show(in before, in after, sweep.StartAcceleration, in end, order);
        }
    }

    /// <summary>Starts with the counters of the calls before.</summary>
    private void Continue(in StepBudget spent)
    {
        Pieces = spent.Pieces;
        _lastEvaluation -= spent.Evaluations;
        _eventsBefore = spent.Events;
        Splits = spent.Splits;
        AllImpacts = spent.AllImpacts;
        Impacts = spent.Impacts;
        Untold = spent.Untold;
        SetChanges = spent.SetChanges;
        SetPieces = spent.SetPieces;
        Parts = spent.Parts;
        Turns = spent.Turns;
        Named = spent.Named;
        Slips = spent.Slips;
        Squeezes = spent.Squeezes;
        _hits = spent.Hits;
        _lastHit = spent.LastHit;
    }

    /// <summary>Forgets the parts: what is left is divided anew.</summary>
    private void Divide()
    {
        Part = 0;
        Spirals = false;
    }
}
