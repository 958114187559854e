namespace FootballPhysics.Tracks;

/// <summary>A segment of a track that is one flight: its points, its launch, and its residuals.</summary>
internal sealed class FlightPath(int first, int end)
{
    /// <summary>The number of launch parameters: position, velocity, spin.</summary>
    public const int Launch = 9;

    /// <summary>The index of the first point.</summary>
    public int First { get; set; } = first;

    /// <summary>The index after the last point.</summary>
    public int End { get; set; } = end;

    /// <summary>The number of points.</summary>
    public int Count => End - First;

    /// <summary>The position, velocity and spin at the first point.</summary>
    public double[] Values { get; set; } = new double[Launch];

    /// <summary>The prior mean of the spin at the first point, in rad/s: zero, or the result of the preceding impact.</summary>
    public Vector3d LikelySpin { get; set; }

    /// <summary>The prior standard deviation of each component, in rad/s; 0 for the default of all flights.</summary>
    public Vector3d LikelySpinDeviation { get; set; }

    /// <summary>The covariance matrix of <see cref="Values"/>.</summary>
    public double[] Covariance { get; set; } = new double[Launch * Launch];

    /// <summary>The root mean square of the residuals, in m.</summary>
    public double Rms { get; set; }

    /// <summary>The largest residual, in m.</summary>
    public double Worst { get; set; }

    /// <summary>The state of the ball at the last point.</summary>
    public BallState Last { get; set; }

    public Vector3d Position => new(Values[0], Values[1], Values[2]);

    public Vector3d Velocity => new(Values[3], Values[4], Values[5]);

    public Vector3d Spin => new(Values[6], Values[7], Values[8]);
}
