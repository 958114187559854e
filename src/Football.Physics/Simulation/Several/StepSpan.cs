namespace FootballPhysics.Simulation;

/// <summary>The time span of a step of a group.</summary>
/// <param name="start">Start time, s.</param>
/// <param name="length">Length, s.</param>
internal readonly struct StepSpan(double start, double length)
{
    /// <summary>Start time, s.</summary>
    public double Start { get; } = start;

    /// <summary>Length, s.</summary>
    public double Length { get; } = length;

    /// <summary>End time, s.</summary>
    public double End { get; } = start + length;

    /// <summary>Returns the duration from a ball's time to a time within the step, s.</summary>
    /// <remarks>For a whole step it is exactly the length.</remarks>
    public double Left(in BallState s, double time) => s.Time == Start && time == End ? Length : Math.Max(0, time - s.Time);
}
