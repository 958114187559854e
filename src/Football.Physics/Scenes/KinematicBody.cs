namespace FootballPhysics;

/// <summary>
/// A thing that the game moves: a foot, a leg, a head, a keeper's hand. The game says before a step where it is and how fast it goes; within the step
/// it goes on so, rotates about its position, and hits the ball exactly when it is hit. One with a mass goes on with what the impact left it, until the game moves it again.
/// </summary>
/// <remarks>
/// Made by <see cref="KinematicBodies.Add(string, IShape, SurfaceMaterial?, double, int)"/>. Where a body is put over the ball, the next step pushes the ball out along the shortest way, without giving it a
/// speed; what hits it then is the body's own velocity. To a look-ahead a body goes on for ever as it goes now.
/// </remarks>
public sealed class KinematicBody
{
    /// <summary>A body that comes into play may be anywhere: farther than this it strays from no place, m.</summary>
    private const double Anywhere = 4.0 * Limits.Length;

    private readonly KinematicBodies _all;

    internal KinematicBody(KinematicBodies all, int index, string name, IShape shape, SurfaceMaterial surface, double mass, int layer)
    {
        _all = all;
        Index = index;
        Name = name;
        Shape = shape;
        Surface = surface;
        Mass = mass;
        Layer = layer;
        Placement = new Placement(shape.Bounds);
    }

    /// <summary>Its name, for events and messages.</summary>
    public string Name { get; }

    /// <summary>Its shape, in its own frame: the body's position is the shape's origin, and what it turns about.</summary>
    public IShape Shape { get; }

    /// <summary>The material of its surface.</summary>
    public SurfaceMaterial Surface { get; }

    /// <summary>
    /// Mass behind its surface, kg: an impact of the ball changes its <see cref="Velocity"/> by the impulse, without turning it. Infinite where nothing moves it.
    /// </summary>
    public double Mass { get; }

    /// <summary>Its layer: a ball that ignores it passes through. 0 … 31.</summary>
    public int Layer { get; }

    /// <summary>Where it is at <see cref="Time"/>, m. Default the origin.</summary>
    public Vector3d Position => Placement.Motion.Origin;

    /// <summary>How it is turned at <see cref="Time"/>, body to world. Default not at all.</summary>
    public Quaterniond Orientation => Placement.Motion.Orientation;

    /// <summary>Velocity, m/s. Default 0.</summary>
    public Vector3d Velocity => Placement.Motion.Velocity;

    /// <summary>Spin about its position, rad/s. Default 0.</summary>
    public Vector3d Spin => Placement.Motion.Spin;

    /// <summary>When it is there, on the clock of the ball, s. Default 0.</summary>
    public double Time => Placement.Motion.Time;

    /// <summary>True while it is out of play. Default false.</summary>
    public bool IsWithdrawn => Placement.Motion.IsWithdrawn;

    /// <summary>Its index among all.</summary>
    internal int Index { get; }

    internal Placement Placement { get; }

    /// <summary>Takes it out of play, from the next step on: nothing hits it, and a ball on it falls. Allocates nothing.</summary>
    /// <remarks>
    /// For a substitute who is not on yet, a player who was sent off, a cone that comes later. It keeps its position, without velocity and spin, until
    /// <see cref="MoveTo(Vector3d, Vector3d, double)"/> brings it into play. Rollbacks, recordings and look-aheads keep whether it is in play as they keep where it is. A
    /// withdrawn body costs a step nothing that can be measured.
    /// </remarks>
    public void Withdraw()
    {
        ref RigidMotion motion = ref Placement.Motion;
        RigidMotion before = motion;
        motion.Velocity = Vector3d.Zero;
        motion.Spin = Vector3d.Zero;
        motion.IsWithdrawn = true;

        // Nobody meets it sooner for that: it has strayed from nowhere.
        _all.Update(this, in before);
        _all.Told(this);
    }

    /// <summary>Says where it is and how fast it goes, and brings it into play. It keeps how it is turned.</summary>
    /// <inheritdoc cref="MoveTo(Vector3d, Quaterniond, Vector3d, Vector3d, double)"/>
    public void MoveTo(Vector3d position, Vector3d velocity, double time) => MoveTo(position, Orientation, velocity, Vector3d.Zero, time);

    /// <summary>Says where it is, how it is turned, and how fast it goes and turns, and brings it into play. Allocates nothing.</summary>
    /// <param name="position">Where it is, m; components within ±1e6.</param>
    /// <param name="orientation">How it is turned, body to world; normalised.</param>
    /// <param name="velocity">Velocity, m/s; at most 1000.</param>
    /// <param name="spin">Spin about its position, rad/s; at most 10 000. Within a step, the shape rotates with this spin.</param>
    /// <param name="time">When it is there: the ball's <see cref="Ball.Time"/> before the step, s; within ±1e12. The next step refuses one more than 0.25 s from that.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    public void MoveTo(Vector3d position, Quaterniond orientation, Vector3d velocity, Vector3d spin, double time)
    {
        Check.Place("position", position);
        Check.Rotation("orientation", orientation);
        Check.Size("velocity", velocity, Limits.Speed, "m/s");
        Check.Size("spin", spin, Limits.Spin, "rad/s");
        Check.Within("time", time, -Limits.Time, Limits.Time);

        // How far any point of it may be from where it was expected.
        ref RigidMotion motion = ref Placement.Motion;
        RigidMotion before = motion;
        double jump = motion.IsWithdrawn ? Anywhere : (position - motion.GoneBy(time)).Length + (KinematicBodies.Foresight * (velocity - motion.Velocity).Length);
        Quaterniond expected = motion.Orientation;
        if (motion.Rotates)
        {
            expected = expected.Turned((time - motion.Time) * motion.Spin);
        }

        // The same orientation as before keeps its bits: to normalise it again might change the last.
        Quaterniond turned = orientation == motion.Orientation ? orientation : orientation.Normalized();
        if (turned != expected)
        {
            // A turn by θ moves a point at r by 2 r sin(θ/2), and |q·q₀| = cos(θ/2).
            double cosine = (turned.X * expected.X) + (turned.Y * expected.Y) + (turned.Z * expected.Z) + (turned.W * expected.W);
            jump += 2.0 * Placement.Reach * Math.Sqrt(Math.Max(0, 1.0 - (cosine * cosine)));
        }

        if (turned != motion.Orientation)
        {
            Placement.Turn(in turned);
        }

        bool again = time == motion.Time;
        bool rotated = motion.Rotates;
        Vector3d change = spin - motion.Spin;
        motion.Origin = position;
        motion.Pivot = position;
        motion.Velocity = velocity;
        motion.Spin = spin;
        motion.Time = time;
        motion.IsWithdrawn = false;
        motion.Rotate(Shape);
        if ((rotated || motion.Rotates) && change != Vector3d.Zero)
        {
            // With another spin its points go elsewhere, but not beyond their circles.
            jump += Math.Min(KinematicBodies.Foresight * change.Length, 2.0) * Placement.Reach;
        }

        // Told last, when it is where it says: broad phase, and who records.
        _all.Moved(jump, time, again);
        _all.Update(this, in before);
        _all.Told(this, time);
    }

    /// <summary>An impact changes its velocity.</summary>
    internal void Push(in Vector3d velocity, double time)
    {
        _all.Moved(KinematicBodies.Foresight * (velocity - Velocity).Length, time, again: true);
        RigidMotion before = Placement.Motion;
        Placement.GoOn(in velocity, time);
        _all.Update(this, in before);
    }

    /// <summary>Where it is and how it goes; set from what was read there, and what a quick look needs is kept.</summary>
    internal RigidMotion Motion
    {
        get => Placement.Motion;
        set
        {
            // As MoveTo, but with the largest jump that a turn can be.
            double jump = (value.GoneBy(value.Time) - Placement.Motion.GoneBy(value.Time)).Length + (KinematicBodies.Foresight * (value.Velocity - Velocity).Length);
            ref RigidMotion motion = ref Placement.Motion;
            RigidMotion before = motion;
            bool turns = value.Orientation != motion.Orientation;
            bool rotatesElse = (motion.Rotates || value.Spin != Vector3d.Zero) && (value.Spin != motion.Spin || value.Time != motion.Time);
            _all.Moved(value.IsWithdrawn ? 0 : IsWithdrawn ? Anywhere : jump + (turns || rotatesElse ? 2.0 * Placement.Reach : 0), value.Time, again: true);
            motion = value;
            if (turns)
            {
                Placement.Turn(in value.Orientation);
            }

            // A motion that was read from a file does not say how fast that rotates the shape.
            motion.Rotate(Shape);

            _all.Update(this, in before);
        }
    }

    /// <summary>The count of checked steps when it was last moved.</summary>
    internal long ToldAt { get; set; } = -1;

    /// <summary>A box around it at a time.</summary>
    internal Bounds3d BoundsAt(double time) => Placement.BoundsAt(time);

    /// <summary>A box that is around it at a time, and stays around it for a duration if the box moves along with its velocity.</summary>
    internal Bounds3d BoundsDuring(double time, double duration) => Placement.BoundsDuring(time, duration);
}
