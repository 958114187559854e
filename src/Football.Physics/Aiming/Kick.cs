namespace Football.Physics;

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
    public readonly Vector3d Direction(in Vector3d forward)
    {
        Elementary.SinCos(Azimuth, out double sin, out double cos);

        // d = f cos φ + (ŷ × f) sin φ
        return new Vector3d((forward.X * cos) + (forward.Z * sin), 0, (forward.Z * cos) - (forward.X * sin));
    }

    /// <summary>Velocity and spin vectors, which a launch does not refuse: at their limits they are not above them by rounding.</summary>
    public readonly void Vectors(double speed, in Vector3d forward, out Vector3d velocity, out Vector3d spin)
    {
        Vector3d d = Direction(in forward);
        Elementary.SinCos(Elevation, out double sin, out double cos);
        velocity = Limited(new Vector3d(speed * cos * d.X, speed * sin, speed * cos * d.Z), Limits.Speed);
        spin = Limited(new Vector3d(Top * d.Z, Side, -(Top * d.X)), Limits.Spin);
    }

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

    /// <summary>A vector that is not longer than a limit, by rounding neither.</summary>
    public static Vector3d Limited(in Vector3d vector, double limit)
    {
        double squared = vector.LengthSquared;
        return squared < limit * limit * (1.0 - 1e-14) ? vector : (1.0 - 1e-14) * Math.Min(1.0, limit / Math.Sqrt(squared)) * vector;
    }
}
