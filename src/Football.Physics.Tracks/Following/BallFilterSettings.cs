namespace FootballPhysics.Tracks;

/// <summary>The settings of a <see cref="BallFilter"/>.</summary>
public sealed record BallFilterSettings
{
    /// <summary>The standard deviation of a measured coordinate, in m. Above 0, at most 100; default 0.02.</summary>
    /// <remarks>If the points have unmodelled errors, such as a scene that differs from the real ball, include them.</remarks>
    public double Noise { get; init; } = 0.02;

    /// <summary>The standard deviation of a measured pixel coordinate, in pixels. Above 0, at most 1000; default 1.</summary>
    public double PixelNoise { get; init; } = 1;

    /// <summary>The standard deviation of each component of the velocity just after a kick, in m/s. Above 0, at most 300; default 13.</summary>
    public double KickVelocity { get; init; } = 13;

    /// <summary>The standard deviation of each component of the spin just after a kick, in rad/s. Above 0, at most 1000; default 20.</summary>
    public double KickSpin { get; init; } = 20;

    /// <summary>The expected number of kicks per second. 1e-6 … 100; default 0.3.</summary>
    public double KicksPerSecond { get; init; } = 0.3;

    /// <summary>The expected share of wrong points. 1e-6 … 0.5; default 0.02.</summary>
    public double OutlierShare { get; init; } = 0.02;

    /// <summary>The time over which the motion is fitted to the points themselves, in s. 0.2 … 20; default 3.</summary>
    /// <remarks>Older points are condensed into an estimate with a covariance. Points that come later than this are rejected.</remarks>
    public double Window { get; init; } = 3;

    /// <summary>The longest gap between points that the filter bridges, in s. 0.05 … 20; default 2.</summary>
    /// <remarks>After a longer gap, the filter starts again from the next point.</remarks>
    public double MaximumGap { get; init; } = 2;

    /// <summary>Throws if a value is out of range.</summary>
    internal void Check()
    {
        FootballPhysics.Numerics.Check.Within(nameof(Noise), Noise, 0, 100, exclusiveLow: true);
        FootballPhysics.Numerics.Check.Within(nameof(PixelNoise), PixelNoise, 0, 1000, exclusiveLow: true);
        FootballPhysics.Numerics.Check.Within(nameof(KickVelocity), KickVelocity, 0, 300, exclusiveLow: true);
        FootballPhysics.Numerics.Check.Within(nameof(KickSpin), KickSpin, 0, 1000, exclusiveLow: true);
        FootballPhysics.Numerics.Check.Within(nameof(KicksPerSecond), KicksPerSecond, 1e-6, 100);
        FootballPhysics.Numerics.Check.Within(nameof(OutlierShare), OutlierShare, 1e-6, 0.5);
        FootballPhysics.Numerics.Check.Within(nameof(Window), Window, 0.2, 20);
        FootballPhysics.Numerics.Check.Within(nameof(MaximumGap), MaximumGap, 0.05, 20);
    }
}
