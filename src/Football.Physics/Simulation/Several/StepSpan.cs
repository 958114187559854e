namespace FootballPhysics;

/// <summary>The time that a step of a group takes.</summary>
/// <param name="start">The time of its start, s.</param>
/// <param name="length">Its length, s.</param>
internal readonly struct StepSpan(double start, double length)
{
    /// <summary>The time of its start, s.</summary>
    public double Start { get; } = start;

    /// <summary>Its length, s.</summary>
    public double Length { get; } = length;

    /// <summary>The time of its end, s.</summary>
    public double End { get; } = start + length;

    /// <summary>The duration from a ball's time to a time within the step, s: a whole step has the length of the step to the last bit.</summary>
    public double Left(in BallState s, double time) => s.Time == Start && time == End ? Length : Math.Max(0, time - s.Time);
}
