namespace FootballPhysics.Numerics;

/// <summary>The cubic Hermite interpolant of a motion, from positions and velocities at both ends.</summary>
internal readonly struct CubicHermite3d
{
    private readonly Vector3d _start;
    private readonly Vector3d _startVelocity;
    private readonly Vector3d _c2;
    private readonly Vector3d _c3;
    private readonly double _length;

    /// <param name="start">The position at the start.</param>
    /// <param name="startVelocity">The velocity at the start.</param>
    /// <param name="end">The position at the end.</param>
    /// <param name="endVelocity">The velocity at the end.</param>
    /// <param name="length">The time from start to end.</param>
    public CubicHermite3d(in Vector3d start, in Vector3d startVelocity, in Vector3d end, in Vector3d endVelocity, double length)
    {
        // The deviations from uniform motion at the end, as lengths.
        Vector3d miss = end - start - (length * startVelocity);
        Vector3d turn = length * (endVelocity - startVelocity);
        _start = start;
        _startVelocity = startVelocity;
        _c2 = (3.0 * miss) - turn;
        _c3 = turn - (2.0 * miss);
        _length = length;
    }

    /// <summary>Returns p₀ + v₀ t + s² (c₂ + s c₃), s = t / length.</summary>
    public Vector3d PositionAt(double t)
    {
        double s = Share(t);
        return _start + (t * _startVelocity) + (s * s * (_c2 + (s * _c3)));
    }

    /// <summary>Returns v₀ + s (2 c₂ + 3 s c₃)/length.</summary>
    public Vector3d VelocityAt(double t)
    {
        double s = Share(t);
        double perLength = _length > 0 ? s / _length : 0;
        return _startVelocity + (perLength * ((2.0 * _c2) + (3.0 * s * _c3)));
    }

    private double Share(double t) => _length > 0 ? t / _length : 0;
}
