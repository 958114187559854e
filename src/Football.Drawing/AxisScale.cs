namespace FootballPhysics.Drawing;

/// <summary>How an axis maps values to positions.</summary>
public enum AxisScale
{
    /// <summary>Equal differences have equal lengths.</summary>
    Linear,

    /// <summary>Equal ratios have equal lengths. Values that are not above 0 are omitted.</summary>
    Logarithmic,
}
