namespace FootballPhysics.Native;

/// <summary>A piece of a match track. The axes are those of the library: y is up.</summary>
internal unsafe struct NativePiece
{
    /// <summary>The kind, one of fp_piece_kind.</summary>
    public int Kind;

    /// <summary>The number of track points; 0 for an impact, a touch or a gap.</summary>
    public int Points;

    /// <summary>The start time, s; for an impact or a touch, its instant.</summary>
    public double StartTime;

    /// <summary>The end time, s.</summary>
    public double EndTime;

    /// <summary>The root mean square distance of the points from the fitted path, m; 0 without points.</summary>
    public double Rms;

    /// <summary>The largest distance of a point from the fitted path, m.</summary>
    public double MaximumResidual;

    /// <summary>The position of the ball's centre at the start, m.</summary>
    public fixed double Position[3];

    /// <summary>The velocity at the start, m/s; for an impact or a touch, just after it.</summary>
    public fixed double Velocity[3];

    /// <summary>The spin at the start, rad/s; for an impact or a touch, just after it. Zero if it is unknown.</summary>
    public fixed double Spin[3];

    /// <summary>The velocity just before an impact or a touch, m/s.</summary>
    public fixed double VelocityBefore[3];

    /// <summary>The spin just before an impact or a touch, rad/s.</summary>
    public fixed double SpinBefore[3];

    /// <summary>The standard deviation of each component of the velocity, m/s.</summary>
    public fixed double VelocityDeviation[3];

    /// <summary>The standard deviation of each component of the spin, rad/s.</summary>
    public fixed double SpinDeviation[3];

    /// <summary>The restitution of an impact; 0 unless has_restitution is 1.</summary>
    public double Restitution;

    /// <summary>The ratio of the horizontal speeds after and before an impact; 0 for other pieces.</summary>
    public double SpeedRetained;

    /// <summary>1 if the restitution is known; otherwise 0.</summary>
    public int HasRestitution;

    /// <summary>0.</summary>
    public int Reserved;
}
