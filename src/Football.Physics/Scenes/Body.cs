namespace Football.Physics;

/// <summary>
/// A thing that the game moves: a foot, a leg, a head, a keeper's hand. The game says before a step where it is and how fast it goes; within the step
/// it goes on so, and hits the ball exactly when it is hit.
/// </summary>
/// <remarks>
/// Made by <see cref="Bodies.Add"/>. Where a body is put over the ball, the next step pushes the ball out along the shortest way, without giving it a
/// speed; what hits it then is the body's own velocity. To a look-ahead a body goes on for ever as it goes now.
/// </remarks>
public sealed class Body
{
    private readonly Bodies _all;
    private readonly Bounds3d _ownBounds;
    private readonly double _extent;
    private Bounds3d _bounds;
    private RigidMotion _motion;

    internal Body(Bodies all, int index, string name, IShape shape, Surface surface)
    {
        _all = all;
        Index = index;
        Name = name;
        Shape = shape;
        Surface = surface;
        _ownBounds = shape.Bounds;
        _extent = Math.Max(_ownBounds.Min.Length, _ownBounds.Max.Length);
        _motion.Orientation = Quaterniond.Identity;
        _bounds = _ownBounds;
    }

    /// <summary>Its name, for events and messages.</summary>
    public string Name { get; }

    /// <summary>Its shape, in its own frame: the body's position is the shape's origin, and what it turns about.</summary>
    public IShape Shape { get; }

    /// <summary>What it is made of.</summary>
    public Surface Surface { get; }

    /// <summary>Where it is at <see cref="Time"/>, m. Default the origin.</summary>
    public Vector3d Position => _motion.Origin;

    /// <summary>How it is turned, body to world. Default not at all.</summary>
    public Quaterniond Orientation => _motion.Orientation;

    /// <summary>Velocity, m/s. Default 0.</summary>
    public Vector3d Velocity => _motion.Velocity;

    /// <summary>Spin of its surface about its position, rad/s. Default 0.</summary>
    public Vector3d Spin => _motion.Spin;

    /// <summary>When it is there, on the clock of the ball, s. Default 0.</summary>
    public double Time => _motion.Time;

    /// <summary>Its index among all.</summary>
    internal int Index { get; }

    internal ref readonly RigidMotion Motion => ref _motion;

    /// <summary>Says where it is and how fast it goes. It keeps how it is turned.</summary>
    /// <inheritdoc cref="MoveTo(Vector3d, Quaterniond, Vector3d, Vector3d, double)"/>
    public void MoveTo(Vector3d position, Vector3d velocity, double time) => MoveTo(position, Orientation, velocity, Vector3d.Zero, time);

    /// <summary>Says where it is, how it is turned, and how fast it goes and turns. Allocates nothing.</summary>
    /// <param name="position">Where it is, m; components within ±1e6.</param>
    /// <param name="orientation">How it is turned, body to world; normalised.</param>
    /// <param name="velocity">Velocity, m/s; at most 1000.</param>
    /// <param name="spin">Spin of its surface, rad/s; at most 10 000. Within a step it moves the surface, not the shape.</param>
    /// <param name="time">When it is there: the ball's <see cref="Ball.Time"/> before the step, s; within ±1e12.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    public void MoveTo(Vector3d position, Quaterniond orientation, Vector3d velocity, Vector3d spin, double time)
    {
        Check.Place("position", position);
        Check.Rotation("orientation", orientation);
        Check.Size("velocity", velocity, Limits.Speed, "m/s");
        Check.Size("spin", spin, Limits.Spin, "rad/s");
        Check.Within("time", time, -Limits.Time, Limits.Time);

        // How far any point of it may be from where it was expected.
        double jump = (position - _motion.GoneBy(time)).Length + (Bodies.Foresight * (velocity - _motion.Velocity).Length);
        Quaterniond turned = orientation == _motion.Orientation ? orientation : orientation.Normalized();
        if (turned != _motion.Orientation)
        {
            double cosine = (turned.X * _motion.Orientation.X) + (turned.Y * _motion.Orientation.Y)
                + (turned.Z * _motion.Orientation.Z) + (turned.W * _motion.Orientation.W);
            jump += 2.0 * _extent * Math.Sqrt(Math.Max(0, 1.0 - (cosine * cosine)));
            _motion.Orientation = turned;
            _motion.IsTurned = turned != Quaterniond.Identity;
            _bounds = _motion.Turned(in _ownBounds);
        }

        bool again = time == _motion.Time;
        _motion.Origin = position;
        _motion.Pivot = position;
        _motion.Velocity = velocity;
        _motion.Spin = spin;
        _motion.Time = time;
        _all.Moved(jump, time, again);
        _all.Update(this);
    }

    /// <summary>A box around it at a time.</summary>
    internal Bounds3d BoundsAt(double time) => _bounds.Moved(_motion.GoneBy(time));
}
