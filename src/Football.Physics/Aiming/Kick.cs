namespace FootballPhysics.Aiming;

/// <summary>A kick as the predictors see it: two angles and two spins.</summary>
internal struct Kick
{
    /// <summary>Angle above the horizontal, rad.</summary>
    public double Elevation;

    /// <summary>Angle from the direction of the target, counter-clockwise seen from above, rad.</summary>
    public double Azimuth;

    /// <summary>Topspin, rad/s.</summary>
    public double Top;

    /// <summary>Sidespin, rad/s.</summary>
    public double Side;

    /// <summary>Size of the spin, rad/s.</summary>
    public readonly double SpinRate => Math.Sqrt((Top * Top) + (Side * Side));

    /// <summary>A kick with the spin of a request.</summary>
    public static Kick Of(AimRequest request, double elevation, double azimuth) =>
        new() { Elevation = elevation, Azimuth = azimuth, Top = request.TopSpin, Side = request.SideSpin };

    /// <summary>Horizontal unit direction of the kick.</summary>
    /// <param name="forward">Horizontal unit direction of the target.</param>
    public readonly Vector3d Direction(in Vector3d forward) => KickVectors.Flat(Azimuth, in forward);

    /// <summary>Velocity and spin vectors, which a launch does not refuse.</summary>
    public readonly void Vectors(double speed, in Vector3d forward, out Vector3d velocity, out Vector3d spin) =>
        KickVectors.FromAngles(speed, Elevation, Direction(in forward), Top, Side, out velocity, out spin);

    /// <summary>How they change with the two angles; the spin with the azimuth alone.</summary>
    public readonly void Turns(double speed, in Vector3d forward, out Vector3d byElevation, out Vector3d byAzimuth, out Vector3d spinByAzimuth)
    {
        Vector3d d = Direction(in forward);
        var left = new Vector3d(d.Z, 0, -d.X);
        Elementary.SinCos(Elevation, out double sin, out double cos);

        // v = V (cos ε d + sin ε ŷ), ω = top ŷ × d + side ŷ;  ∂d/∂φ = ŷ × d, ∂(ŷ × d)/∂φ = −d
        byElevation = speed * new Vector3d(-sin * d.X, cos, -sin * d.Z);
        byAzimuth = speed * cos * left;
        spinByAzimuth = -(Top * d);
    }
}

/// <summary>The elevations that a kick may have, rad.</summary>
internal readonly struct ElevationBounds
{
    private const double Degree = Math.PI / 180.0;

    public readonly double Lowest;
    public readonly double Highest;

    public ElevationBounds(double lowest, double highest)
    {
        Lowest = lowest;
        Highest = highest;
    }

    /// <summary>Those of a request.</summary>
    public static ElevationBounds Of(AimRequest request) => OfDegrees(request.MinimumElevationDegrees, request.MaximumElevationDegrees);

    /// <summary>Those of two angles in degrees.</summary>
    public static ElevationBounds OfDegrees(double lowest, double highest) => new(lowest * Degree, highest * Degree);

    /// <summary>The nearest elevation within the bounds.</summary>
    public double Clamp(double elevation) => Math.Min(Math.Max(elevation, Lowest), Highest);

    /// <summary>True when an elevation lies within the bounds.</summary>
    public bool Contain(double elevation) => !(elevation < Lowest || elevation > Highest);
}

/// <summary>The frame in which a kick is sought: from the ball, horizontally forward to the target, to the left of that, and up.</summary>
internal readonly struct TargetFrame
{
    /// <summary>Where the ball is, m.</summary>
    public readonly Vector3d From;

    /// <summary>Where it is to go, m.</summary>
    public readonly Vector3d Target;

    /// <summary>Horizontal unit vector to the target; a fixed one where the target is straight above, below or at the ball.</summary>
    public readonly Vector3d Forward;

    /// <summary>ŷ × forward.</summary>
    public readonly Vector3d Left;

    /// <summary>Horizontal distance of the target, m.</summary>
    public readonly double Distance;

    public TargetFrame(in Vector3d from, in Vector3d target)
    {
        // Straight above or below there is no direction: then it is −z.
        Vector3d flat = (target - from).Horizontal;
        From = from;
        Target = target;
        Distance = flat.Length;
        Forward = Distance > 0 ? flat / Distance : new Vector3d(0, 0, -1);
        Left = new Vector3d(Forward.Z, 0, -Forward.X);
    }

    /// <summary>True when the target is at the ball, so that there is no direction to kick in.</summary>
    public bool IsDegenerate => Distance < 1e-6 && Math.Abs(Target.Y - From.Y) < 1e-6;

    /// <summary>Height at which a ball that falls is given up, m: far below both ends of any flight that is of use.</summary>
    public double Floor => Math.Min(From.Y, Target.Y) - (2.0 * Distance) - 10.0;

    /// <summary>A kick turned into a direction, as far as the bounds allow.</summary>
    public Kick Turned(in Kick kick, in Vector3d direction, in ElevationBounds bounds)
    {
        Kick turned = kick;
        turned.Elevation = bounds.Clamp(Elementary.Atan2(direction.Y, direction.Horizontal.Length));
        turned.Azimuth = Elementary.Atan2(Vector3d.Dot(in direction, in Left), Vector3d.Dot(in direction, in Forward));
        return turned;
    }
}
