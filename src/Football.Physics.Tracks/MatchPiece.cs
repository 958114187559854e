namespace FootballPhysics.Tracks;

/// <summary>A piece of a match's track: one flight, one impact, one touch, a time on the ground, or what could not be explained. Frame y up, SI units.</summary>
public sealed record MatchPiece
{
    /// <summary>Kind of the piece.</summary>
    public MatchPieceKind Kind { get; init; }

    /// <summary>When it begins, s; the instant of an impact or a touch.</summary>
    public double StartTime { get; init; }

    /// <summary>When it ends, s.</summary>
    public double EndTime { get; init; }

    /// <summary>Points of the track in it; none in an impact, a touch or a gap.</summary>
    public int Points { get; init; }

    /// <summary>Root of the mean square of the points' distances from <see cref="Fitted"/>, m; 0 without points.</summary>
    public double Rms { get; init; }

    /// <summary>The largest of those distances, m.</summary>
    public double MaximumResidual { get; init; }

    /// <summary>Where the ball's centre is at the beginning, m.</summary>
    public Vector3d Position { get; init; }

    /// <summary>Velocity at the beginning, m/s; of an impact or a touch the one just after.</summary>
    public Vector3d Velocity { get; init; }

    /// <summary>Spin at the beginning, rad/s; of an impact or a touch the one just after. Zero where nothing tells of it.</summary>
    public Vector3d Spin { get; init; }

    /// <summary>Velocity just before an impact or a touch, m/s.</summary>
    public Vector3d VelocityBefore { get; init; }

    /// <summary>Spin just before an impact or a touch, rad/s.</summary>
    public Vector3d SpinBefore { get; init; }

    /// <summary>Standard deviation of each component of <see cref="Velocity"/>, m/s.</summary>
    public Vector3d VelocityDeviation { get; init; }

    /// <summary>Standard deviation of each component of <see cref="Spin"/>, rad/s: that of what was known before where the track tells nothing.</summary>
    public Vector3d SpinDeviation { get; init; }

    /// <summary>Of an impact that a flight follows: speed off the ground by that towards it; else null.</summary>
    public double? Restitution { get; init; }

    /// <summary>Of an impact: speed along the ground after by that before; 1 where there was none, 0 where it is no impact.</summary>
    public double SpeedRetained { get; init; }

    /// <summary>The points of the track in it.</summary>
    public IReadOnlyList<TrackPoint> Observed { get; init; } = [];

    /// <summary>Where the fit has the ball at each of <see cref="Observed"/>, m: by the laws of flight, elsewhere by cubics in time.</summary>
    public IReadOnlyList<Vector3d> Fitted { get; init; } = [];

    /// <summary>How long it takes, s.</summary>
    public double Duration => EndTime - StartTime;
}

/// <summary>Kinds of pieces of a match's track.</summary>
public enum MatchPieceKind
{
    /// <summary>The ball flies; nothing but air touches it.</summary>
    Flight = 0,

    /// <summary>It bounces on the ground.</summary>
    Impact = 1,

    /// <summary>It rolls, slides or hops lower than the track tells.</summary>
    Ground = 2,

    /// <summary>Somebody or something else touches it: a kick, a header, a post.</summary>
    Touch = 3,

    /// <summary>A gap, a seam, or a motion that no law of a free ball explains.</summary>
    Lost = 4,
}
