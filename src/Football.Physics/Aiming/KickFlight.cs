using FootballPhysics.Simulation;

namespace FootballPhysics.Aiming;

/// <summary>Simulates a kick step by step until its observer ends the flight.</summary>
internal sealed class KickFlight
{
    private readonly Simulator _simulator;
    private readonly IKickObserver _observer;
    private readonly StepLog _log = new() { IgnoresZones = true };
    private readonly StepLog _watched = new() { IgnoresZones = true };

    /// <param name="simulator">The scene.</param>
    /// <param name="observer">The observer of the flight; a <see cref="PieceObserver"/> if it ever needs the segments of a step.</param>
    public KickFlight(Simulator simulator, IKickObserver observer)
    {
        _simulator = simulator;
        _observer = observer;
        _watched.Observer = observer as PieceObserver;
    }

    /// <summary>The number of path segments of the last flight.</summary>
    public long Pieces { get; private set; }

    /// <summary>Simulates a kick until the observer ends the flight, or up to a time.</summary>
    public void Fly(ref BallState state, double last)
    {
        // A step without an observer is fastest. If its ends are inconclusive, repeat it and pass its segments to the observer.
        Pieces = 0;
        bool isOver = false;
        while (!isOver && state.Time < last && Pieces < AimContext.MostPieces)
        {
            BallState before = state;
            double step = _observer.StepFrom(in before, out bool watches);
            bool ended = false;

            // First take the step without an observer, and evaluate it from its ends.
            if (!watches)
            {
                ended = Take(ref state, step, _log);
                watches = _observer.Doubts(in before, in state, _log, ref ended);
            }

            if (watches)
            {
                // Start again from the same state, so that the repeated step is bit-identical.
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

/// <summary>Controls a <see cref="KickFlight"/>: chooses the steps, evaluates them, and ends the flight.</summary>
internal interface IKickObserver
{
    /// <summary>Returns the length of the next step, in s.</summary>
    /// <param name="state">The ball at the start of the step.</param>
    /// <param name="watches">True if the observer must see the segments of the step.</param>
    double StepFrom(in BallState state, out bool watches);

    /// <summary>Evaluates an unobserved step from its ends.</summary>
    /// <param name="before">The ball at the start of the step.</param>
    /// <param name="after">The ball at the end of the step.</param>
    /// <param name="log">The events and the number of segments of the step.</param>
    /// <param name="ended">True if the flight ends with the step, by an impact or for the observer.</param>
    /// <returns>True if the ends are insufficient: the step is repeated, and <see cref="PieceObserver.Add(in PathSegment)"/> receives its
    /// segments.</returns>
    bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended);

    /// <summary>True if the flight is over after a step.</summary>
    bool IsOver(in BallState before, in BallState after, EventBuffer events, bool ended) => ended;
}
