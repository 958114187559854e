namespace FootballPhysics.Tracks;

/// <summary>A piece of a match track: a flight, an impact, a touch, ground contact, or an unexplained part.</summary>
/// <remarks>The y axis points up, and units are SI.</remarks>
public sealed class MatchPiece
{
    internal MatchPiece()
    {
    }

    /// <summary>The kind of the piece.</summary>
    public MatchPieceKind Kind { get; internal init; }

    /// <summary>The start time, in s; for an impact or a touch, its instant.</summary>
    public double StartTime { get; internal init; }

    /// <summary>The end time, in s.</summary>
    public double EndTime { get; internal init; }

    /// <summary>The number of track points; 0 for an impact, a touch or a gap.</summary>
    public int Points { get; internal init; }

    /// <summary>The root mean square distance of the points from <see cref="Fitted"/>, in m; 0 without points.</summary>
    public double Rms { get; internal init; }

    /// <summary>The largest distance of a point from <see cref="Fitted"/>, in m.</summary>
    public double MaximumResidual { get; internal init; }

    /// <summary>The position of the ball's centre at the start, in m.</summary>
    public Vector3d Position { get; internal init; }

    /// <summary>The velocity at the start, in m/s; for an impact or a touch, the velocity just after it.</summary>
    public Vector3d Velocity { get; internal init; }

    /// <summary>The spin at the start, in rad/s; for an impact or a touch, the spin just after it.</summary>
    /// <remarks>Zero if it is unknown.</remarks>
    public Vector3d Spin { get; internal init; }

    /// <summary>The velocity just before an impact or a touch, in m/s.</summary>
    public Vector3d VelocityBefore { get; internal init; }

    /// <summary>The spin just before an impact or a touch, in rad/s.</summary>
    public Vector3d SpinBefore { get; internal init; }

    /// <summary>The standard deviation of each component of <see cref="Velocity"/>, in m/s.</summary>
    public Vector3d VelocityDeviation { get; internal init; }

    /// <summary>The standard deviation of each component of <see cref="Spin"/>, in rad/s.</summary>
    /// <remarks>If the track does not determine the spin, this is the prior deviation.</remarks>
    public Vector3d SpinDeviation { get; internal init; }

    /// <summary>The restitution of an impact: the ratio of the normal speeds after and before.</summary>
    /// <remarks>Null for other pieces, and for an impact without a flight after it.</remarks>
    public double? Restitution { get; internal init; }

    /// <summary>The ratio of the speeds along the ground after and before an impact; 0 for other pieces.</summary>
    /// <remarks>1 if the ball had no such speed before the impact.</remarks>
    public double SpeedRetained { get; internal init; }

    /// <summary>The track points of the piece.</summary>
    public IReadOnlyList<TrackPoint> Observed { get; internal init; } = [];

    /// <summary>The fitted positions at each of <see cref="Observed"/>, in m.</summary>
    /// <remarks>Flights are fitted by the laws of flight, other pieces by cubics in time.</remarks>
    public IReadOnlyList<Vector3d> Fitted { get; internal init; } = [];

    /// <summary>The duration, in s.</summary>
    public double Duration => EndTime - StartTime;
}

/// <summary>The kinds of pieces of a match track.</summary>
public enum MatchPieceKind
{
    /// <summary>The ball flies; only the air acts on it.</summary>
    Flight = 0,

    /// <summary>The ball bounces on the ground.</summary>
    Impact = 1,

    /// <summary>The ball rolls, slides, or hops lower than the track resolves.</summary>
    Ground = 2,

    /// <summary>A player or another object touches the ball: a kick, a header, a post.</summary>
    Touch = 3,

    /// <summary>A gap, a track error, or a motion that no law of a free ball explains.</summary>
    Lost = 4,
}
