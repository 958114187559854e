namespace Football.Physics;

/// <summary>How the crossing of the target's plane (up, left) moves with elevation and azimuth, m/rad.</summary>
internal struct CrossingJacobian
{
    private double _upByElevation;
    private double _upByAzimuth;
    private double _leftByElevation;
    private double _leftByAzimuth;

    public CrossingJacobian(double upByElevation, double upByAzimuth, double leftByElevation, double leftByAzimuth)
    {
        _upByElevation = upByElevation;
        _upByAzimuth = upByAzimuth;
        _leftByElevation = leftByElevation;
        _leftByAzimuth = leftByAzimuth;
    }

    /// <summary>How the height of the crossing moves with the elevation, m/rad.</summary>
    public readonly double UpByElevation => _upByElevation;

    /// <summary>How it moves with the azimuth.</summary>
    public readonly double UpByAzimuth => _upByAzimuth;

    /// <summary>How the distance to the left moves with the elevation.</summary>
    public readonly double LeftByElevation => _leftByElevation;

    /// <summary>How it moves with the azimuth.</summary>
    public readonly double LeftByAzimuth => _leftByAzimuth;

    /// <summary>
    /// Read off one flight: drag and Magnus force turn with the kick, so the whole way turns with it, but for the displacements by
    /// gravity and wind; then back along the velocity to the plane.
    /// </summary>
    /// <param name="kick">The kick.</param>
    /// <param name="crossing">Where it crossed the plane.</param>
    /// <param name="frame">The frame of the target.</param>
    /// <param name="wind">Wind, m/s.</param>
    /// <param name="upward">Upward acceleration by gravity and buoyancy, m/s².</param>
    public static CrossingJacobian Of(in Kick kick, in PlaneCrossing crossing, in TargetFrame frame, in Vector3d wind, double upward)
    {
        Vector3d p = crossing.Position - frame.From;
        Vector3d d = kick.Direction(in frame.Forward);

        // Damped by drag: the mean speed over the launch speed is about the damping of both displacements.
        double t = crossing.Time;
        double damping = 0.9;
        Vector3d byGravity = new(0, 0.5 * damping * upward * t * t, 0);
        Vector3d turning = p - byGravity - (0.3 * t * wind);
        Vector3d byElevation = Vector3d.Cross(new Vector3d(-d.Z, 0, d.X), in turning); // axis d × ŷ raises the kick
        Vector3d byAzimuth = Vector3d.Cross(Vector3d.Up, in turning);
        Elementary.SinCos(kick.Elevation, out double sine, out double cosine);
        if (kick.Side != 0 && cosine > 0.1)
        {
            // The axis of the side spin stays upright: its bend is that of the horizontal velocity alone, which a raised kick has less of.
            Vector3d across = new(d.Z, 0, -d.X); // ŷ × d
            byElevation -= sine / cosine * Vector3d.Dot(in turning, in across) * across;
        }

        double speed = Vector3d.Dot(crossing.Velocity, in frame.Forward);
        Vector3d slope = speed > 1e-3 ? crossing.Velocity / speed : frame.Forward;
        byElevation -= Vector3d.Dot(in byElevation, in frame.Forward) * slope;
        byAzimuth -= Vector3d.Dot(in byAzimuth, in frame.Forward) * slope;
        return new CrossingJacobian(
            byElevation.Y, byAzimuth.Y, Vector3d.Dot(in byElevation, in frame.Left), Vector3d.Dot(in byAzimuth, in frame.Left));
    }

    /// <summary>The changes of elevation and azimuth that bring a crossing to the target.</summary>
    /// <param name="up">How high above the target it is, m.</param>
    /// <param name="left">How far to its left, m.</param>
    /// <param name="elevation">Change of the elevation, rad.</param>
    /// <param name="azimuth">Change of the azimuth, rad.</param>
    /// <returns>False where the Jacobian is singular.</returns>
    public readonly bool Solve(double up, double left, out double elevation, out double azimuth)
    {
        double determinant = (_upByElevation * _leftByAzimuth) - (_upByAzimuth * _leftByElevation);
        elevation = ((_upByAzimuth * left) - (_leftByAzimuth * up)) / determinant;
        azimuth = ((_leftByElevation * up) - (_upByElevation * left)) / determinant;
        return double.IsFinite(elevation) && double.IsFinite(azimuth);
    }

    /// <summary>Broyden's update after a change of the angles moved the crossing: J += (Δr − J Δx) Δxᵀ / |Δx|².</summary>
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
