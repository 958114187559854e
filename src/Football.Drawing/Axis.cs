namespace FootballPhysics.Drawing;

/// <summary>An axis: its title with the unit, its scale, and fixed ends. The data determines the ends that are not fixed.</summary>
public sealed record Axis(string Title)
{
    public AxisScale Scale { get; init; } = AxisScale.Linear;

    /// <summary>The lower end; null to use that of the data.</summary>
    public double? Min { get; init; }

    /// <summary>The upper end; null to use that of the data.</summary>
    public double? Max { get; init; }

    /// <summary>The margin on each side of the data, as a fraction of its range; default 0.04.</summary>
    public double Margin { get; init; } = 0.04;
}
