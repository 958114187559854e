namespace Football.Physics;

/// <summary>Where a camera saw a ball.</summary>
public readonly struct TrackPoint
{
    /// <summary>A point of a track.</summary>
    /// <param name="time">When, s.</param>
    /// <param name="position">Where the centre was seen, m.</param>
    /// <param name="noise">Standard deviation of each coordinate, m.</param>
    public TrackPoint(double time, Vector3d position, double noise = 0.02)
    {
        Time = time;
        Position = position;
        Noise = noise;
    }

    /// <summary>When, s.</summary>
    public double Time { get; }

    /// <summary>Where the centre was seen, m.</summary>
    public Vector3d Position { get; }

    /// <summary>Standard deviation of each coordinate, m.</summary>
    public double Noise { get; }
}
