using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>A kick as the solvers use it: two angles and two spins.</summary>
internal struct Kick
{
    /// <summary>The angle above the horizontal, in rad.</summary>
    public double Elevation;

    /// <summary>The angle from the direction to the target, counter-clockwise as seen from above, in rad.</summary>
    public double Azimuth;

    /// <summary>The topspin, in rad/s.</summary>
    public double Top;

    /// <summary>The sidespin, in rad/s.</summary>
    public double Side;

    /// <summary>The magnitude of the spin, in rad/s.</summary>
    public readonly double SpinRate => Math.Sqrt((Top * Top) + (Side * Side));

    /// <summary>Creates a kick with the spins of a request.</summary>
    public static Kick Of(AimRequest request, double elevation, double azimuth) =>
        new() { Elevation = elevation, Azimuth = azimuth, Top = request.TopSpin, Side = request.SideSpin };

    /// <summary>Returns the horizontal unit direction of the kick.</summary>
    /// <param name="forward">The horizontal unit direction of the target.</param>
    public readonly Vector3d Direction(in Vector3d forward) => KickVectors.Flat(Azimuth, in forward);

    /// <summary>Returns the velocity and spin, within the limits of a launch.</summary>
    public readonly void Vectors(double speed, in Vector3d forward, out Vector3d velocity, out Vector3d spin) =>
        KickVectors.FromAngles(speed, Elevation, Direction(in forward), Top, Side, out velocity, out spin);

    /// <summary>Returns the derivatives of velocity and spin with respect to the angles; the spin depends on the azimuth only.</summary>
    public readonly void Turns(double speed, in Vector3d forward, out Vector3d byElevation, out Vector3d byAzimuth, out Vector3d spinByAzimuth)
    {
        Vector3d d = Direction(in forward);
        var left = new Vector3d(d.Z, 0, -d.X);
        Elementary.SinCos(Elevation, out double sin, out double cos);

        // The velocity v = V (cos ε d + sin ε ŷ) has the speed V, the elevation ε and the horizontal direction d; the spin is ω = top ŷ × d + side ŷ.
        // By the azimuth φ: ∂d/∂φ = ŷ × d, ∂(ŷ × d)/∂φ = −d.
        byElevation = speed * new Vector3d(-sin * d.X, cos, -sin * d.Z);
        byAzimuth = speed * cos * left;
        spinByAzimuth = -(Top * d);
    }
}

/// <summary>The bounds of a kick's elevation, in rad.</summary>
internal readonly struct ElevationBounds(double lowest, double highest)
{
    private const double Degree = Math.PI / 180.0;

    public readonly double Lowest = lowest;
    public readonly double Highest = highest;

    /// <summary>Returns the bounds of a request.</summary>
    public static ElevationBounds Of(AimRequest request) => OfDegrees(request.MinimumElevationDegrees, request.MaximumElevationDegrees);

    /// <summary>Returns the bounds for two angles in degrees.</summary>
    public static ElevationBounds OfDegrees(double lowest, double highest) => new(lowest * Degree, highest * Degree);

    /// <summary>Clamps an elevation to the bounds.</summary>
    public double Clamp(double elevation) => Math.Min(Math.Max(elevation, Lowest), Highest);

    /// <summary>True if an elevation is within the bounds.</summary>
    public bool Contain(double elevation) => !(elevation < Lowest || elevation > Highest);
}

/// <summary>The coordinate frame of an aim: origin at the ball, axes horizontally to the target, to its left, and up.</summary>
internal readonly struct TargetFrame
{
    /// <summary>The position of the ball, in m.</summary>
    public readonly Vector3d From;

    /// <summary>The target, in m.</summary>
    public readonly Vector3d Target;

    /// <summary>The horizontal unit vector to the target; −z if the target is straight above, below or at the ball.</summary>
    public readonly Vector3d Forward;

    /// <summary>ŷ × forward.</summary>
    public readonly Vector3d Left;

    /// <summary>The horizontal distance of the target, in m.</summary>
    public readonly double Distance;

    /// <summary>The orientation of the ball at the kick.</summary>
    public readonly Quaterniond Orientation;

    public TargetFrame(in Vector3d from, in Vector3d target, in Quaterniond orientation)
    {
        Orientation = orientation;
        // If the target is straight above or below, it has no horizontal direction: use −z.
        Vector3d flat = (target - from).Horizontal;
        From = from;
        Target = target;
        Distance = flat.Length;
        Forward = Distance > 0 ? flat / Distance : new Vector3d(0, 0, -1);
        Left = new Vector3d(Forward.Z, 0, -Forward.X);
    }

    /// <summary>True if the target is at the ball, so that there is no direction to kick in.</summary>
    public bool IsDegenerate => Distance < 1e-6 && Math.Abs(Target.Y - From.Y) < 1e-6;

    /// <summary>The height at which a falling ball is abandoned, in m; far below both ends of any useful flight.</summary>
    public double Floor => Math.Min(From.Y, Target.Y) - (2.0 * Distance) - 10.0;

    /// <summary>Returns a kick turned to a direction, within the bounds.</summary>
    public Kick Turned(in Kick kick, in Vector3d direction, in ElevationBounds bounds)
    {
        Kick turned = kick;
        turned.Elevation = bounds.Clamp(Elementary.Atan2(direction.Y, direction.Horizontal.Length));
        turned.Azimuth = Elementary.Atan2(Vector3d.Dot(in direction, in Left), Vector3d.Dot(in direction, in Forward));
        return turned;
    }
}
