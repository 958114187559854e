namespace Football.Physics;

/// <summary>How the crossing of the target's plane (up, left) moves with elevation and azimuth.</summary>
internal struct Jacobian
{
    private double _upByElevation;
    private double _upByAzimuth;
    private double _leftByElevation;
    private double _leftByAzimuth;

    /// <summary>
    /// Read off one flight: drag and Magnus force turn with the kick, so the whole way turns with it, but for the displacements by
    /// gravity and wind; then back along the velocity to the plane.
    /// </summary>
    public static Jacobian Of(
        in Probe flown, in Vector3d from, in Vector3d forward, in Vector3d left, AimContext context, in Vector3d target, in Vector3d targetVelocity)
    {
        Vector3d p = target + (flown.Time * targetVelocity) + (flown.Up * Vector3d.Up) + (flown.Left * left) - from;
        Vector3d d = flown.Kick.Direction(in forward);

        // Damped by drag: the mean speed over the launch speed is about the damping of both displacements.
        Vector3d wind = context.Scene.Air.Wind;
        double t = flown.Time;
        double damping = 0.9;
        Vector3d byGravity = new(0, 0.5 * damping * context.Upward * t * t, 0);
        Vector3d turning = p - byGravity - (0.3 * t * wind);
        Vector3d byElevation = Vector3d.Cross(new Vector3d(-d.Z, 0, d.X), in turning); // axis d × ŷ raises the kick
        Vector3d byAzimuth = Vector3d.Cross(Vector3d.Up, in turning);
        Elementary.SinCos(flown.Kick.Elevation, out double sine, out double cosine);
        if (flown.Kick.Side != 0 && cosine > 0.1)
        {
            // The axis of the side spin stays upright: its bend is that of the horizontal velocity alone, which a raised kick has less of.
            Vector3d across = new(d.Z, 0, -d.X); // ŷ × d
            byElevation -= sine / cosine * Vector3d.Dot(in turning, in across) * across;
        }

        double speed = Vector3d.Dot(in flown.Velocity, in forward);
        Vector3d slope = speed > 1e-3 ? flown.Velocity / speed : forward;
        byElevation -= Vector3d.Dot(in byElevation, in forward) * slope;
        byAzimuth -= Vector3d.Dot(in byAzimuth, in forward) * slope;
        return new Jacobian
        {
            _upByElevation = byElevation.Y,
            _upByAzimuth = byAzimuth.Y,
            _leftByElevation = Vector3d.Dot(in byElevation, in left),
            _leftByAzimuth = Vector3d.Dot(in byAzimuth, in left),
        };
    }

    /// <summary>The changes of elevation and azimuth that bring the crossing to the target.</summary>
    /// <returns>False where the Jacobian is singular.</returns>
    public readonly bool Solve(in Probe at, out double elevation, out double azimuth)
    {
        double determinant = (_upByElevation * _leftByAzimuth) - (_upByAzimuth * _leftByElevation);
        elevation = -((_leftByAzimuth * at.Up) - (_upByAzimuth * at.Left)) / determinant;
        azimuth = -((_upByElevation * at.Left) - (_leftByElevation * at.Up)) / determinant;
        return double.IsFinite(elevation) && double.IsFinite(azimuth);
    }

    /// <summary>Broyden's update after a change of the angles moved the crossing.</summary>
    public void Update(double elevation, double azimuth, double up, double left)
    {
        double squared = (elevation * elevation) + (azimuth * azimuth);
        if (!(squared > 0))
        {
            return;
        }

        double moreUp = (up - (_upByElevation * elevation) - (_upByAzimuth * azimuth)) / squared;
        double moreLeft = (left - (_leftByElevation * elevation) - (_leftByAzimuth * azimuth)) / squared;
        _upByElevation += moreUp * elevation;
        _upByAzimuth += moreUp * azimuth;
        _leftByElevation += moreLeft * elevation;
        _leftByAzimuth += moreLeft * azimuth;
    }
}
