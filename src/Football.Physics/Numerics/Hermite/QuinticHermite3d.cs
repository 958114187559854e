namespace FootballPhysics.Numerics;

/// <summary>The quintic Hermite interpolant of a motion, from positions, velocities and accelerations at both ends.</summary>
internal readonly struct QuinticHermite3d
{
    private readonly Vector3d _start;
    private readonly Vector3d _startVelocity;
    private readonly Vector3d _startAcceleration;
    private readonly Vector3d _c3;
    private readonly Vector3d _c4;
    private readonly Vector3d _c5;
    private readonly double _length;

    /// <param name="start">The position at the start.</param>
    /// <param name="startVelocity">The velocity at the start.</param>
    /// <param name="startAcceleration">The acceleration at the start.</param>
    /// <param name="end">The position at the end.</param>
    /// <param name="endVelocity">The velocity at the end.</param>
    /// <param name="endAcceleration">The acceleration at the end.</param>
    /// <param name="length">The time from start to end; above 0.</param>
    public QuinticHermite3d(
        in Vector3d start,
        in Vector3d startVelocity,
        in Vector3d startAcceleration,
        in Vector3d end,
        in Vector3d endVelocity,
        in Vector3d endAcceleration,
        double length)
    {
        // The deviations from uniformly accelerated motion at the end, as lengths.
        double squared = length * length;
        Vector3d p = end - start - (length * startVelocity) - (0.5 * squared * startAcceleration);
        Vector3d v = (length * (endVelocity - startVelocity)) - (squared * startAcceleration);
        Vector3d a = squared * (endAcceleration - startAcceleration);
        _start = start;
        _startVelocity = startVelocity;
        _startAcceleration = startAcceleration;
        _c3 = (10.0 * p) - (4.0 * v) + (0.5 * a);
        _c4 = (-15.0 * p) + (7.0 * v) - a;
        _c5 = (6.0 * p) - (3.0 * v) + (0.5 * a);
        _length = length;
    }

    /// <summary>Returns p₀ + v₀ t + a₀ t²/2 + s³ (c₃ + s (c₄ + s c₅)), s = t / length.</summary>
    public Vector3d PositionAt(double t)
    {
        double s = t / _length;
        return _start + (t * (_startVelocity + (0.5 * t * _startAcceleration))) + (s * s * s * (_c3 + (s * (_c4 + (s * _c5)))));
    }

    /// <summary>Returns v₀ + a₀ t + s² (3 c₃ + s (4 c₄ + 5 s c₅))/length.</summary>
    public Vector3d VelocityAt(double t)
    {
        double s = t / _length;
        return _startVelocity + (t * _startAcceleration)
            + (s * s / _length * ((3.0 * _c3) + (s * ((4.0 * _c4) + (5.0 * s * _c5)))));
    }
}
