namespace FootballPhysics.Native;

/// <summary>The settings of a filter; fp_filter_default returns the defaults.</summary>
internal struct NativeFilterSettings
{
    /// <summary>The standard deviation of a measured coordinate, m; above 0, at most 100.</summary>
    public double Noise;

    /// <summary>The standard deviation of a pixel coordinate, pixels; above 0, at most 1000.</summary>
    public double PixelNoise;

    /// <summary>The standard deviation of each component of the velocity just after a kick, m/s; above 0, at most 300.</summary>
    public double KickVelocity;

    /// <summary>The standard deviation of each component of the spin just after a kick, rad/s; above 0, at most 1000.</summary>
    public double KickSpin;

    /// <summary>The expected number of kicks per second, 1e-6 ... 100.</summary>
    public double KicksPerSecond;

    /// <summary>The expected share of wrong points, 1e-6 ... 0.5.</summary>
    public double OutlierShare;

    /// <summary>The time over which the motion is fitted to the points themselves, s; 0.2 ... 20.</summary>
    public double Window;

    /// <summary>The longest gap that the filter bridges, s; 0.05 ... 20.</summary>
    public double MaximumGap;
}

/// <summary>The estimate of a filter at the time of its last point.</summary>
internal unsafe struct NativeEstimate
{
    /// <summary>The time of the last point, s.</summary>
    public double Time;

    /// <summary>The position, m.</summary>
    public fixed double Position[3];

    /// <summary>The velocity, m/s.</summary>
    public fixed double Velocity[3];

    /// <summary>The spin, rad/s.</summary>
    public fixed double Spin[3];

    /// <summary>The standard deviations of a component of position, velocity and spin: root mean squares of the three axes.</summary>
    public fixed double Deviations[3];

    /// <summary>The covariance of position, velocity and spin, row by row.</summary>
    public fixed double Covariance[81];

    /// <summary>The time of a kick within the last 0.5 s; NaN without one.</summary>
    public double KickTime;

    /// <summary>The standard deviation of that time, s.</summary>
    public double KickDeviation;

    /// <summary>The probability of that kick, 0 ... 1.</summary>
    public double KickProbability;

    /// <summary>The motion, an fp_motion.</summary>
    public int Motion;

    /// <summary>1 if the filter believes in the kick.</summary>
    public int HasKick;

    /// <summary>1 if the last point does not fit the motion.</summary>
    public int IsOutlier;

    /// <summary>1 if the ball seems to move with a player.</summary>
    public int IsHeld;
}
