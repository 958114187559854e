namespace FootballPhysics.Aiming;

/// <summary>Flies a kick, step by step, until its observer has seen enough.</summary>
internal sealed class KickFlight
{
    private readonly Simulator _simulator;
    private readonly KickObserver _observer;
    private readonly StepLog _log = new() { IgnoresZones = true };
    private readonly StepLog _watched = new() { IgnoresZones = true };

    /// <param name="simulator">The scene.</param>
    /// <param name="observer">What it is flown for.</param>
    public KickFlight(Simulator simulator, KickObserver observer)
    {
        _simulator = simulator;
        _observer = observer;
        _watched.Observer = observer;
    }

    /// <summary>Pieces of motion of the last flight.</summary>
    public long Pieces { get; private set; }

    /// <summary>Flies until the observer says that it is over, or a time.</summary>
    public void Fly(ref BallState state, double last)
    {
        // A step that nobody watches is the fastest. Where its ends leave a doubt about what was between, it is taken again, and the observer sees its pieces.
        Pieces = 0;
        bool isOver = false;
        while (!isOver && state.Time < last && Pieces < AimContext.MostPieces)
        {
            BallState before = state;
            double step = _observer.StepFrom(in before, out bool watches);
            bool ended = false;

            // Unwatched at first, and judged by its ends.
            if (!watches)
            {
                ended = Take(ref state, step, _log);
                watches = _observer.Doubts(in before, in state, _log, ref ended);
            }

            if (watches)
            {
                // From the same start, so that it is the same step to the last bit.
                state = before;
                ended = Take(ref state, step, _watched);
            }

            isOver = _observer.IsOver(in before, in state, watches ? _watched.Events : _log.Events, ended);
        }
    }

    private bool Take(ref BallState state, double step, StepLog log)
    {
        log.Clear();
        bool ended = _simulator.StepToImpact(ref state, step, log);
        Pieces += log.Steps;
        return ended;
    }
}

/// <summary>The purpose of a <see cref="KickFlight"/>: the length of its steps, what is read off them, and when it is over.</summary>
internal abstract class KickObserver : PieceObserver
{
    /// <summary>Length of the next step, s.</summary>
    /// <param name="state">The ball at its start.</param>
    /// <param name="watches">Whether its pieces are to be seen in any case.</param>
    public abstract double StepFrom(in BallState state, out bool watches);

    /// <summary>Reads off a step that was not watched what its ends tell.</summary>
    /// <param name="before">The ball at its start.</param>
    /// <param name="after">The ball at its end.</param>
    /// <param name="log">Its events, and how many pieces it had.</param>
    /// <param name="ended">Whether the flight ends with it: by an impact, or for the observer.</param>
    /// <returns>True where that is not enough: the step is taken again, and <see cref="PieceObserver.Add(in PathSegment)"/> sees its pieces.</returns>
    public abstract bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended);

    /// <summary>True when a flight is over after a step.</summary>
    public virtual bool IsOver(in BallState before, in BallState after, EventBuffer events, bool ended) => ended;

    public override bool Add(in PathSegment piece) => false;
}
