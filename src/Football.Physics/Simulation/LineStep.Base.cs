namespace Football.Physics;

/// <summary>Whole steps of a ball on several stationary surfaces, whatever the laws of the air.</summary>
internal abstract class LineStep
{
    /// <summary>A whole step, done if nothing happens in it.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="dt">Its length, s.</param>
    /// <param name="end">When it ends, s.</param>
    /// <param name="log">Where counts are added.</param>
    /// <returns>False if something may happen; then nothing is done.</returns>
    public abstract bool TryWhole(ref BallState s, double dt, double end, StepLog log);
}
