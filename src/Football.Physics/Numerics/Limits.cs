namespace FootballPhysics;

/// <summary>The largest sizes that a scene, a launch or a step may have.</summary>
public static class Limits
{
    /// <summary>Largest speed, wind included, m/s.</summary>
    public const double Speed = 1000;

    /// <summary>Largest spin, rad/s.</summary>
    public const double Spin = 10_000;

    /// <summary>Largest length or coordinate, m.</summary>
    public const double Length = 1e6;

    /// <summary>Longest step, frame, run or look-ahead, s.</summary>
    public const double Time = 1e12;

    /// <summary>Last tick: that of 30 years in steps of a microsecond.</summary>
    internal const long Tick = 1_000_000_000_000_000;
}
