namespace FootballPhysics.Batch;

/// <summary>One Newton iteration on the crossing of the target's plane for kicks of a batch, from a flight in SIMD lanes.</summary>
/// <remarks>The method is that of <see cref="PlaneNewton"/>.</remarks>
/// <param name="context">The scene, compiled for aiming.</param>
internal sealed class BatchAimNewton(AimContext context)
{
    /// <summary>The share to which an iteration must reduce the miss.</summary>
    private const double Progress = 0.7;

    /// <summary>The largest correction of elevation and azimuth, in rad.</summary>
    private const double LargestTurn = 0.2;

    /// <summary>The smallest share of the speed that must point towards the target.</summary>
    private const double LeastForward = 0.5;

    private readonly double _windUp = context.Scene.Air.Wind.Y;
    private readonly double _upward = context.Upward;

    /// <summary>Reads the crossing from a flight, and corrects the kick.</summary>
    /// <param name="s">The kick.</param>
    /// <param name="group">The flights.</param>
    /// <param name="i">The index of the kick's flight.</param>
    /// <param name="isFirst">True for the first flight of the kick.</param>
    /// <param name="tolerance">The miss that counts as a hit, in m.</param>
    public BatchAimOutcome Improve(ref BatchAimState s, LaneGroup group, int i, bool isFirst, double tolerance)
    {
        if (!group.Reached[i])
        {
            return BatchAimOutcome.Fails;
        }

        double t = group.EndTime[i];
        Vector3d path = group.EndPath[i];
        Vector3d velocity = group.EndVelocity[i];
        double up = path.X + (t * _windUp) - s.Rise;
        double left = (t * s.WindLeft) - path.Z;
        double miss = Math.Sqrt((up * up) + (left * left));
        double before = isFirst ? double.PositiveInfinity : s.Miss;
        s.Time = t;
        if (miss <= tolerance)
        {
            s.Miss = miss;
            return BatchAimOutcome.Hits;
        }

        if (!(miss < Progress * before))
        {
            return BatchAimOutcome.Fails;
        }

        if (isFirst)
        {
            s.Jacobian = Jacobian(in s, t, up, left, s.WindForward - velocity.Y, velocity.X + _windUp, s.WindLeft - velocity.Z);
        }
        else
        {
            s.Jacobian.Update(s.StepElevation, s.StepAzimuth, up - s.Up, left - s.Left);
        }

        s.Up = up;
        s.Left = left;
        s.Miss = miss;
        s.Jacobian.Solve(up, left, out s.StepElevation, out s.StepAzimuth);
        if (!(Math.Abs(s.StepElevation) < LargestTurn && Math.Abs(s.StepAzimuth) < LargestTurn))
        {
            return BatchAimOutcome.Fails;
        }

        s.Turn(s.StepElevation, s.StepAzimuth);
        if (!(s.DirectionForward > LeastForward))
        {
            return BatchAimOutcome.Fails;
        }

        if (Convergence.IsPlenty(miss, before, tolerance, out double contraction))
        {
            s.Miss *= contraction;
            return BatchAimOutcome.Hits;
        }

        return BatchAimOutcome.Corrected;
    }

    /// <summary>Returns the Jacobian as <see cref="CrossingJacobian.Of"/>, in scalars: the path turns with the kick, except for the displacements by gravity and wind.</summary>
    private CrossingJacobian Jacobian(in BatchAimState s, double t, double up, double left, double vf, double vu, double vl)
    {
        double flat = Math.Sqrt((s.DirectionForward * s.DirectionForward) + (s.DirectionLeft * s.DirectionLeft));
        double df = s.DirectionForward / flat;
        double dl = s.DirectionLeft / flat;
        double qf = s.Distance - (0.3 * t * s.WindForward);
        double qu = s.Rise + up - (0.45 * _upward * t * t) - (0.3 * t * _windUp);
        double ql = left - (0.3 * t * s.WindLeft);

        // Elevation rotates the plane of d and up; azimuth rotates forward to left.
        double ef = -(df * qu);
        double eu = (qf * df) + (ql * dl);
        double el = -(dl * qu);
        double af = -ql;
        double al = qf;

        // Project along the velocity back to the plane.
        double slopeUp = vf > 1e-3 ? vu / vf : 0;
        double slopeLeft = vf > 1e-3 ? vl / vf : 0;
        return new CrossingJacobian(eu - (ef * slopeUp), -(af * slopeUp), el - (ef * slopeLeft), al - (af * slopeLeft));
    }
}

/// <summary>The outcome of an iteration for a kick.</summary>
internal enum BatchAimOutcome
{
    /// <summary>The kick missed, and was corrected.</summary>
    Corrected = 0,

    /// <summary>The kick hits.</summary>
    Hits = 1,

    /// <summary>The iteration does not converge.</summary>
    Fails = 2,
}

/// <summary>The state of one search, in the frame of its target: forward, up, left.</summary>
internal struct BatchAimState
{
    /// <summary>The horizontal unit vector to the target, and the distance.</summary>
    public double ForwardX;
    public double ForwardZ;
    public double Distance;

    /// <summary>The height of the target above the ball.</summary>
    public double Rise;

    /// <summary>The wind along forward and left.</summary>
    public double WindForward;
    public double WindLeft;

    /// <summary>True if the ball lies on the ground.</summary>
    public bool OnGround;

    public double Speed;
    public double Top;
    public double Side;
    public double SpinRate;

    /// <summary>The unit vector of the kick.</summary>
    public double DirectionForward;
    public double DirectionUp;
    public double DirectionLeft;

    /// <summary>The time to the target.</summary>
    public double Time;

    /// <summary>The derivatives of the crossing by elevation and azimuth.</summary>
    public CrossingJacobian Jacobian;

    /// <summary>The crossing of the last flight, and the step that led to it.</summary>
    public double Up;
    public double Left;
    public double Miss;
    public double StepElevation;
    public double StepAzimuth;

    /// <summary>Rotates the kick by two small angles.</summary>
    public void Turn(double elevation, double azimuth)
    {
        // tan x = x + x³/3 within 2e-4 x for |x| ≤ 0.2; the next correction removes the error.
        double horizontal = Math.Sqrt((DirectionForward * DirectionForward) + (DirectionLeft * DirectionLeft));
        double e = elevation * (1.0 + (elevation * elevation * (1.0 / 3.0)));
        double a = azimuth * (1.0 + (azimuth * azimuth * (1.0 / 3.0)));
        double slope = DirectionUp / horizontal;
        slope = (slope + e) / (1.0 - (slope * e));
        double forward = DirectionForward - (a * DirectionLeft);
        double left = DirectionLeft + (a * DirectionForward);
        double scale = 1.0 / Math.Sqrt(1.0 + (slope * slope));
        double flat = scale / Math.Sqrt((forward * forward) + (left * left));
        DirectionForward = forward * flat;
        DirectionLeft = left * flat;
        DirectionUp = slope * scale;
    }
}
