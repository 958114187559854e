namespace FootballPhysics.Simulation;

/// <summary>Whole steps of a ball on several stationary surfaces, for any laws of the air.</summary>
internal abstract class LineStep
{
    /// <summary>Share of its value that a load or a margin must keep in a step.</summary>
    public const double Clear = 0.25;

    /// <summary>Tries a whole step, and completes it if no event is possible.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="end">End time, s.</param>
    /// <param name="log">Receives the counts.</param>
    /// <returns>False if an event is possible; the ball is then unchanged.</returns>
    public abstract bool TryWhole(ref BallState s, double dt, double end, StepLog log);
}
