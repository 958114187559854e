namespace FootballPhysics.Drawing;

/// <summary>What an axis shows: title with unit, scale, and ends where the data shall not decide them.</summary>
public sealed record Axis(string Title)
{
    public AxisScale Scale { get; init; } = AxisScale.Linear;

    /// <summary>Where it begins; null leaves it to the data.</summary>
    public double? Min { get; init; }

    /// <summary>Where it ends; null leaves it to the data.</summary>
    public double? Max { get; init; }

    /// <summary>Room to leave around the data, as a fraction of its range.</summary>
    public double Margin { get; init; } = 0.04;
}
