namespace FootballPhysics;

/// <summary>Whole steps on flat ground, whatever the laws of the air.</summary>
internal abstract class FlatSurfaceStep
{
    /// <summary>A whole step, done if nothing happens in it.</summary>
    /// <param name="s">The ball, on the ground.</param>
    /// <param name="dt">Its length, s.</param>
    /// <param name="end">When it ends, s.</param>
    /// <param name="log">Where counts are added.</param>
    /// <returns>False where something may happen; then nothing is done.</returns>
    public abstract bool TryWhole(ref BallState s, double dt, double end, StepLog log);
}
