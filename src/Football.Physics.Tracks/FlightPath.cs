namespace FootballPhysics.Tracks;

/// <summary>A piece of a track that is one flight: its points, its launch, and how that fits.</summary>
internal sealed class FlightPath
{
    /// <summary>Numbers of a launch: position, velocity, spin.</summary>
    public const int Launch = 9;

    public FlightPath(int first, int end)
    {
        First = first;
        End = end;
    }

    /// <summary>The first point.</summary>
    public int First { get; set; }

    /// <summary>The one behind the last.</summary>
    public int End { get; set; }

    /// <summary>How many points.</summary>
    public int Count => End - First;

    /// <summary>Position, velocity, spin at the first point.</summary>
    public double[] Values { get; set; } = new double[Launch];

    /// <summary>The spin at the first point that was likely before the points were seen, rad/s: none, or what an impact must have made of it.</summary>
    public Vector3d LikelySpin { get; set; }

    /// <summary>Standard deviation of each component of that, rad/s; 0 for what is known of any flight.</summary>
    public Vector3d LikelySpinDeviation { get; set; }

    /// <summary>Mean square of how far the truth may be from <see cref="Values"/>.</summary>
    public double[] Covariance { get; set; } = new double[Launch * Launch];

    /// <summary>JᵀWb of the heights b that are wrong near the ground.</summary>
    public double[] LowHeights { get; } = new double[Launch];

    /// <summary>Root of the mean square of the distances, m.</summary>
    public double Rms { get; set; }

    /// <summary>The largest distance, m.</summary>
    public double Worst { get; set; }

    /// <summary>The ball at the last point.</summary>
    public BallState Last { get; set; }

    public Vector3d Position => new(Values[0], Values[1], Values[2]);

    public Vector3d Velocity => new(Values[3], Values[4], Values[5]);

    public Vector3d Spin => new(Values[6], Values[7], Values[8]);
}
