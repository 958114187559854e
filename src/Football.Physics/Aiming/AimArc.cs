namespace Football.Physics;

/// <summary>Which of the two kicks that reach a target to find.</summary>
public enum AimArc
{
    /// <summary>The one that is there first, mostly the flatter; the other where only that lies within the elevation bounds.</summary>
    Low = 0,

    /// <summary>The one that is there later, mostly the steeper; the other where only that lies within the elevation bounds.</summary>
    High = 1,
}
