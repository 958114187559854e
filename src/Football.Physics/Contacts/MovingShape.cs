using FootballPhysics.Scenes;

namespace FootballPhysics.Contacts;

/// <summary>A shape and its motion, relative to a start time.</summary>
internal readonly struct MovingShape
{
    private readonly IShape _shape;
    private readonly RigidMotion _motion;

    /// <summary>Describes a moving shape.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="motion">Its motion.</param>
    /// <param name="time">The start time, which becomes time 0.</param>
    public MovingShape(IShape shape, in RigidMotion motion, double time)
    {
        _shape = shape;
        _motion = motion;
        _motion.GoTo(time);
        _motion.Time = 0;
    }

    /// <summary>V, m/s.</summary>
    public Vector3d Velocity => _motion.Velocity;

    /// <summary>The pivot at time 0, m.</summary>
    public Vector3d Pivot => _motion.Pivot;

    /// <summary>|Ω|, rad/s.</summary>
    public double SpinRate => _motion.Spin.Length;

    /// <summary>The greatest speed that the rotation gives to any part of it, m/s.</summary>
    public double Swing => _motion.Swing;

    /// <summary>Returns the distance of a moving point from the shape, and its rate, m/s.</summary>
    public double Distance(in Vector3d position, in Vector3d velocity, double time, out double rate)
    {
        // Along n, this point of the rotating shape moves at the same speed as the shape's nearest point.
        ShapePoint at = _motion.At(_shape, in position, time);
        rate = Vector3d.Dot(velocity - _motion.SurfaceVelocity(in position, time), at.Normal);
        return at.Distance;
    }
}
