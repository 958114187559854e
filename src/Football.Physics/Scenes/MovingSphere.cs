using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A sphere around a thing that moves, for a quick look: most are too far to be met.</summary>
internal readonly struct MovingSphere
{
    private readonly Vector3d _center;
    private readonly Vector3d _velocity;
    private readonly double _radius;
    private readonly double _speed;

    /// <summary>Around a box that is there at time 0.</summary>
    public MovingSphere(in Bounds3d box, in Vector3d velocity)
    {
        _center = 0.5 * (box.Min + box.Max);
        _radius = 0.5 * (box.Max - box.Min).Length;
        _velocity = velocity;
        _speed = Math.Abs(velocity.X) + Math.Abs(velocity.Y) + Math.Abs(velocity.Z);
    }

    /// <summary>Whether it may be met on a way.</summary>
    /// <param name="middle">The middle of the way, m.</param>
    /// <param name="reach">How far the way goes from there, and what lies around it, m.</param>
    /// <param name="time">When the ball is in the middle, s.</param>
    /// <param name="half">How long it goes from there, s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool MayMeet(in Vector3d middle, double reach, double time, double half)
    {
        double x = _center.X + (time * _velocity.X) - middle.X;
        double y = _center.Y + (time * _velocity.Y) - middle.Y;
        double z = _center.Z + (time * _velocity.Z) - middle.Z;
        double near = reach + _radius + (half * _speed);
        return !((x * x) + (y * y) + (z * z) > near * near);
    }
}
