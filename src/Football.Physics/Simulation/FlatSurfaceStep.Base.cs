namespace FootballPhysics.Simulation;

/// <summary>Whole steps on flat ground, for any laws of the air.</summary>
internal abstract class FlatSurfaceStep
{
    /// <summary>Tries a whole step, and completes it if no event is possible.</summary>
    /// <param name="s">The ball, on the ground.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="end">End time, s.</param>
    /// <param name="log">Receives the counts.</param>
    /// <returns>False if an event is possible; the ball is then unchanged.</returns>
    public abstract bool TryWhole(ref BallState s, double dt, double end, StepLog log);
}
