namespace FootballPhysics.Drawing;

/// <summary>How an axis maps values to places.</summary>
public enum AxisScale
{
    /// <summary>Equal differences take equal room.</summary>
    Linear,

    /// <summary>Equal ratios take equal room; values that are not above 0 are left out.</summary>
    Logarithmic,
}
