namespace FootballPhysics.Aiming;

/// <summary>A flight or a roll to a given time.</summary>
internal sealed class TimedFlight : IKickObserver
{
    /// <summary>The step of a roll, in s; the step of a fast roll, in s; and the minimum speed of a fast roll, in m/s.</summary>
    /// <remarks>A fast roll can reach the jump in the drag law.</remarks>
    private const double RollStep = 0.1;
    private const double FastRollStep = 0.02;
    private const double FastRoll = 11;

    private readonly KickFlight _kick;
    private double _step;
    private double _end;

    public TimedFlight(Simulator simulator) => _kick = new KickFlight(simulator, this);

    /// <summary>Continues the flight.</summary>
    /// <param name="state">The ball.</param>
    /// <param name="time">The duration, in s.</param>
    /// <param name="longestStep">The longest step in the air, in s.</param>
    /// <returns>The number of path segments.</returns>
    public long Fly(ref BallState state, double time, double longestStep)
    {
        _step = time / Math.Ceiling(time / longestStep);
        _end = state.Time + time;
        _kick.Fly(ref state, _end - (1e-9 * time));
        return _kick.Pieces;
    }

    public double StepFrom(in BallState state, out bool watches)
    {
        // In the air, use equal steps, the last of which ends at the given time. On the ground, use shorter steps for a fast ball.
        watches = false;
        bool isFast = state.Motion == MotionState.Sliding || state.Velocity.LengthSquared > FastRoll * FastRoll;
        return state.Motion == MotionState.Airborne ? _step : Math.Min(isFast ? FastRollStep : RollStep, _end - state.Time);
    }

    public bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended)
    {
        ended = after.Motion == MotionState.Rest;
        return false;
    }
}
