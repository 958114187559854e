namespace FootballPhysics;

/// <summary>The maximum values of a scene, a launch or a step.</summary>
public static class Limits
{
    /// <summary>The maximum speed, including wind speed, in m/s.</summary>
    public const double Speed = 1000;

    /// <summary>The maximum spin, in rad/s.</summary>
    public const double Spin = 10_000;

    /// <summary>The maximum length or coordinate, in m.</summary>
    public const double Length = 1e6;

    /// <summary>The maximum duration of a step, frame, run or look-ahead, in s.</summary>
    public const double Time = 1e12;

    /// <summary>The maximum stated stiffness of a custom force, in 1/s.</summary>
    internal const double Stiffness = 1e6;

    /// <summary>The last tick: 30 years in steps of a microsecond.</summary>
    internal const long Tick = 1_000_000_000_000_000;
}
