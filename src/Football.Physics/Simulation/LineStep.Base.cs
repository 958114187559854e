namespace FootballPhysics;

/// <summary>Whole steps of a ball on several stationary surfaces, whatever the laws of the air.</summary>
internal abstract class LineStep
{
    /// <summary>A slip of less than this, m/s, has ended.</summary>
    public const double Sticking = 1e-7;

    /// <summary>The motion is that of the line if no more than this, m/s, remains of it.</summary>
    public const double OnLine = 1e-12;

    /// <summary>A load or a reserve must keep this share of its value in a step.</summary>
    public const double Clear = 0.25;

    /// <summary>A whole step, done if nothing happens in it.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="dt">Its length, s.</param>
    /// <param name="end">When it ends, s.</param>
    /// <param name="log">Where counts are added.</param>
    /// <returns>False if something may happen; then nothing is done.</returns>
    public abstract bool TryWhole(ref BallState s, double dt, double end, StepLog log);
}
