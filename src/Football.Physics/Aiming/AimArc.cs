namespace Football.Physics;

/// <summary>Which of the two kicks that reach a target to find.</summary>
public enum AimArc
{
    /// <summary>The flatter, faster one; the other where only that lies within the elevation bounds.</summary>
    Low = 0,

    /// <summary>The higher one; the other where only that lies within the elevation bounds.</summary>
    High = 1,
}
