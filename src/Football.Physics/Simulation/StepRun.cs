using FootballPhysics.Contacts;
using FootballPhysics.Events;
using FootballPhysics.Integration;

namespace FootballPhysics.Simulation;

/// <summary>The state of a step in progress: the time left and the counters that bound the work.</summary>
internal ref struct StepRun
{
    /// <summary>Maximum number of splits per step at the jump in the drag law. Further crossings are not located.</summary>
    public const int MaximumSplits = 16;

    /// <summary>Maximum number of impacts per step. After that, the ball stays on the surface that it hits.</summary>
    public const int MostImpacts = 256;

    /// <summary>Number of events after which a step counts as crowded.</summary>
    private const int MostInCrowd = 14;

    /// <summary>Maximum number of impacts at one instant: two contacts plus eight.</summary>
    /// <remarks>After that, all contacts are resolved together without restitution.</remarks>
    public const int MostAtOnce = 10;

    /// <summary>After this many instants of a step at which a ball stays on a surface, all surfaces nearby become contacts together.</summary>
    /// <remarks>A ball that bounces to rest in a corner stays less often.</remarks>
    private const int MostStays = 32;

    /// <summary>The count of a stay that follows another one within the shortest hop: then the ball alternates between two surfaces.</summary>
    /// <remarks>Below: a squeezed ball stays up to 32 times within microseconds.</remarks>
    private const int QuickStay = 3;

    /// <summary>Maximum number of pieces per step, of all kinds.</summary>
    private const int MostPieces = 1 << 13;

    /// <summary>Maximum number of force evaluations per step, of all kinds.</summary>
    private const long MostEvaluations = 1 << 15;

    /// <summary>Evaluations reserved for one piece, including the search for its end. A piece starts only if this many remain.</summary>
    private const long MostOfPiece = 1 << 12;

    /// <summary>Evaluations of a piece that follows stiff custom forces, with its repetitions.</summary>
    private const int EvaluationsToFollow = 24;

    /// <summary>Number of pieces that may be shorter than the budget allows for all: those that find the edge of a force.</summary>
    private const int MostShort = 64;

    /// <summary>After this many pieces the part length is chosen again, because the reason for short parts may have ended.</summary>
    private const int PiecesOfOneLength = 64;

    /// <summary>Time left, s.</summary>
    public double Left;

    /// <summary>Length of the whole step, s.</summary>
    public double Length;

    /// <summary>End time of the step, s. The clock of the pieces never runs past it, not even by rounding.</summary>
    public double End;

    /// <summary>The counters that bound the work.</summary>
    public StepBudget Spent;

    /// <summary>Length of the parts if the step had to be divided, s; otherwise 0.</summary>
    public double Part;

    /// <summary>True if the integrator would increase a velocity that the Magnus force only rotates, even in parts of this
    /// length.</summary>
    public bool Spirals;

    /// <summary>What is known of the rest of the step as a single piece.</summary>
    public WholeStep Whole;

    /// <summary>The rest of the step in flight, if it was already integrated and contains an event.</summary>
    public FlightStep Taken;

    /// <summary>Number of checks of whether friction holds a ball at rest that rolling resistance does not hold.</summary>
    public int Grips;

    /// <summary>True while the ball slips because its carrier's velocity jumped at the start of the step.</summary>
    /// <remarks>A slip that ends within the step is not reported.</remarks>
    public bool Jumped;

    /// <summary>The carrier's velocity jump divided by the step length, m/s².</summary>
    public Vector3d CarrierGain;

    /// <summary>Length of the step whose errors at the end of a slide are allowed, s.</summary>
    public readonly double Coarse => Math.Max(Length, Log.CoarseStep);

    /// <summary>1/length, 1/s: converts a jump at the start of the step to an acceleration.</summary>
    /// <remarks>It is bounded, so that short steps give finite results.</remarks>
    public readonly double PerStep => 1.0 / Math.Max(Length, ContactTolerances.ShortestForJumps);

    /// <summary>True if the ball has stayed on surfaces so often that all surfaces nearby are contacts for the rest of the step.</summary>
    /// <remarks>Otherwise, a ball that forces press onto one surface while another one lifts it would hit them in turn without an end.</remarks>
    public readonly bool Rattles => Spent.Stays > MostStays;

    /// <summary>Number of events in the log before the step.</summary>
    public int FirstEvent;

    /// <summary>Length of the next piece that follows stiff custom forces, s; 0 if the scene's integrator follows them.</summary>
    public double Followed;

    /// <summary>Receives events and counts.</summary>
    public StepLog Log;

    /// <summary>Ends the step at its first evaluation of the forces; null in every step of a ball.</summary>
    public ForceProbe? Probe;

    private bool _stalls;

    private int _firstZoneEvent;
    private long _lastEvaluation;

    /// <summary>True if the step has changed the velocity by an impulse, or would solve its contacts by impulses.</summary>
    public readonly bool HasImpulses => Spent.AllImpacts > 0 || Spent.Squeezes > 0 || Probe is { UsesImpulses: true };

    /// <summary>Starts a step.</summary>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="time">Start time, s.</param>
    /// <param name="log">Receives events and counts.</param>
    public StepRun(double dt, double time, StepLog log)
    {
        Left = dt;
        Length = dt;
        End = time + dt;
        Log = log;
        _lastEvaluation = log.Evaluations + MostEvaluations - MostOfPiece;
        FirstEvent = log.Events.Count;
        _firstZoneEvent = log.ZoneEvents;
        if (log.Continues)
        {
            Spent = log.Spent;
            _lastEvaluation -= Spent.Evaluations;
        }
    }

    /// <summary>Saves the counters of a step that continues in a later call.</summary>
    public readonly void Close()
    {
        Log.Spent = Spent;
        Log.Spent.Evaluations = Log.Evaluations + MostEvaluations - MostOfPiece - _lastEvaluation;
        Log.Spent.Events = Reported;
    }

    /// <summary>Length of the next part, s: the time left, or an equal share of it if the step had to be divided.</summary>
    public readonly double Next => Part > 0 && Left > Part ? Left / Math.Ceiling((Left / Part) - ContactTolerances.StepRounding) : Left;

    /// <summary>True if the step has reported so many events that slow impacts are only counted.</summary>
    public readonly bool IsCrowded => Reported >= MostInCrowd;

    /// <summary>Number of events of this step so far, without zone events.</summary>
    private readonly int Reported => Spent.Events + Log.Events.Count - FirstEvent - (Log.ZoneEvents - _firstZoneEvent);

    /// <summary>True if a piece takes another part: the step has time and evaluations left, and no event has ended it.</summary>
    /// <param name="world">The world, which counts the searches.</param>
    public bool TakesParts(World world)
    {
        Charge(world);
        return Left > 0 && !Log.Halted && !_stalls && Log.Evaluations <= _lastEvaluation;
    }

    /// <summary>Counts a piece before it is taken.</summary>
    /// <param name="world">The world, which counts the searches.</param>
    /// <returns>False if the step has used up its pieces or its evaluations.</returns>
    public bool Begin(World world)
    {
        Charge(world);
        Spent.Pieces++;
        if (Spent.Pieces % PiecesOfOneLength == 0)
        {
            Part = 0;
            Spirals = false;
        }

        bool goesOn = Spent.Pieces <= MostPieces && Log.Evaluations <= _lastEvaluation && !_stalls;
        if (!goesOn && Followed > 0)
        {
            CountStiff();
        }

        return goesOn;
    }

    /// <summary>The shortest piece that follows custom forces, s: with it, the rest of the step stays within the budget.</summary>
    public readonly double ShortestFollowed => Spent.ShortPieces < MostShort ? OwnForceGuard.ShortestPiece : ShortestOfAll;

    /// <summary>The same if all its pieces have this length.</summary>
    public readonly double ShortestOfAll => Left * EvaluationsToFollow / Math.Max(1, _lastEvaluation - Log.Evaluations);

    /// <summary>Takes pieces of high order from now on, because custom forces are stiff.</summary>
    /// <param name="h">The length of the first one, s.</param>
    public void Follow(double h)
    {
        Followed = Followed > 0 && Followed < h ? Followed : h;
        Log.HasFollowed = true;
    }

    /// <summary>Counts a piece that is shorter than the budget allows for all.</summary>
    public void CountShort(double h) => Spent.ShortPieces += h < ShortestOfAll ? 1 : 0;

    /// <summary>Counts the step as one whose custom forces were not followed.</summary>
    public void CountStiff()
    {
        Log.StiffSteps += Spent.IsStiff ? 0 : 1;
        Spent.IsStiff = true;
    }

    /// <summary>Counts the evaluations of gaps by the searches since the last call as evaluations of this step.</summary>
    public void Charge(World world)
    {
        Log.SearchEvaluations += world.SearchEvaluations;
        _lastEvaluation -= world.SearchEvaluations;
        world.SearchEvaluations = 0;
    }

    /// <summary>Ends the step at the present position, because custom forces change too fast.</summary>
    public void Stall() => _stalls = true;

    /// <summary>Stores the length of a part if it is shorter than requested, s.</summary>
    public void Keep(double part, double requested) => Part = part < requested ? part : Part;

    /// <summary>Counts an impact, and divides the rest of the step from scratch.</summary>
    /// <returns>True if the ball may bounce.</returns>
    public bool Hit()
    {
        Part = 0;
        Spirals = false;
        return Spent.AllImpacts++ < MostImpacts;
    }

    /// <summary>Counts an impact, and returns the number of impacts that have followed one another at about one instant.</summary>
    public int InQuickSuccession(double time)
    {
        Spent.Quick = time - Spent.LastImpact > ContactTolerances.AtOnce ? 1 : Spent.Quick + 1;
        Spent.LastImpact = time;
        return Spent.Quick;
    }

    /// <summary>Counts an instant at which the ball stays on a surface after an impact.</summary>
    public void Stay(double time)
    {
        Spent.Stays += !(time > Spent.LastStay) ? 0 : time - Spent.LastStay < ContactTolerances.ShortestHop ? QuickStay : 1;
        Spent.LastStay = time;
    }

    /// <summary>Reports an event, or only counts it if the step has reported too many.</summary>
    /// <param name="kind">The kind of the event.</param>
    /// <param name="thing">The object; −1 if there is none.</param>
    /// <param name="normal">The normal of the contact.</param>
    /// <param name="s">The ball just before the event.</param>
    /// <param name="velocity">Its velocity just after, m/s.</param>
    /// <param name="spin">Its spin just after, rad/s.</param>
    /// <param name="added">The energy that a bumper added, J.</param>
    /// <param name="contact">The object of an impact.</param>
    public readonly void Report(BallEventKind kind, long thing, in Vector3d normal, in BallState s, in Vector3d velocity, in Vector3d spin, double added = 0, in ImpactContact contact = default)
    {
        if (StepBudget.Reports(kind, Reported, Length))
        {
            Log.Events.Add(new BallEvent(kind, (int)thing, in normal, s.Time, s.Position, s.Velocity, s.Spin, in velocity, in spin, in contact) { AddedEnergy = added });
        }
        else
        {
            Log.UnreportedImpacts++;
        }
    }

    /// <summary>Counts a finished piece: advances the clock and reduces the time left.</summary>
    public void Advance(ref BallState s, double h)
    {
        s.Time = Math.Min(s.Time + h, End);
        Left -= h;
        Log.Steps++;
    }

    /// <summary>Reports a piece to the observer, if there is one.</summary>
    /// <remarks>Only an observer needs the acceleration at the end of the piece.</remarks>
    /// <param name="before">The ball at the start of the piece.</param>
    /// <param name="after">The ball at the end of the piece.</param>
    /// <param name="sweep">The piece.</param>
    /// <param name="order">Order of the integrator used.</param>
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

                // Do not charge this evaluation to the step, because an observer must not change the result.
                _lastEvaluation++;
            }

            Log.Show(in before, in after, sweep.StartAcceleration, in end, order);
        }
    }
}
