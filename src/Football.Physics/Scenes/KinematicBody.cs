using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics;

/// <summary>A body that your game moves: a foot, a leg, a head, a keeper's hand.</summary>
/// <remarks>
/// Create it with <see cref="KinematicBodies.Add(string, IShape, SurfaceMaterial?, double, int)"/>. Before a step, pass its position and velocity to
/// <see cref="MoveTo(Vector3d, Vector3d, double)"/>. Within the step it keeps this velocity and rotates about its position. The ball hits it at the exact time
/// of contact.
/// <para>If it has a mass, an impact changes its velocity until you move it again. If the body overlaps the ball after a move, the next step pushes the ball
/// out along the shortest path, without adding speed. The impact then depends on <see cref="Velocity"/>. Look-aheads extrapolate its current motion without
/// limit.</para>
/// </remarks>
public sealed class KinematicBody
{
    private readonly KinematicBodies _all;

    internal KinematicBody(KinematicBodies all, string name, IShape shape, SurfaceMaterial surface, double mass, int layer, MovingLane lane)
    {
        _all = all;
        Name = name;
        Shape = shape;
        Surface = surface;
        Mass = mass;
        Layer = layer;
        Placement = new Placement(shape.Bounds, lane);
        Placement.Complete(in Placement.Motion);
    }

    /// <summary>The name used in events and messages.</summary>
    public string Name { get; }

    /// <summary>The shape, in the body's frame. Its origin is the body's position and centre of rotation.</summary>
    public IShape Shape { get; }

    /// <summary>The material of its surface.</summary>
    public SurfaceMaterial Surface { get; }

    /// <summary>The effective mass at the surface, in kg; infinite if the ball does not move the body.</summary>
    /// <remarks>When the ball hits the body, <see cref="Velocity"/> changes by the impulse divided by the mass. The impact does not rotate the body.</remarks>
    public double Mass { get; }

    /// <summary>The layer; a ball that ignores this layer passes through. 0 … 31.</summary>
    public int Layer { get; }

    /// <summary>The position at <see cref="Time"/>, in m. Default: the origin.</summary>
    public Vector3d Position => Placement.Lane.Origin;

    /// <summary>The rotation from body to world coordinates at <see cref="Time"/>. The default is the identity.</summary>
    public Quaterniond Orientation => Placement.Orientation;

    /// <summary>The velocity, in m/s. Default 0.</summary>
    public Vector3d Velocity => Placement.Lane.Velocity;

    /// <summary>The spin about the position, in rad/s. Default 0.</summary>
    public Vector3d Spin => Placement.Motion.Spin;

    /// <summary>The time of <see cref="Position"/> on the clock of the ball, in s. Default 0.</summary>
    public double Time => Placement.Lane.At;

    /// <summary>True while the body is out of play. Default false.</summary>
    public bool IsWithdrawn => Placement.IsWithdrawn;

    internal Placement Placement { get; }

    /// <summary>Takes the body out of play from the next step on: the ball no longer collides with it.</summary>
    /// <remarks>
    /// Use it for a substitute who is not on yet, a player who was sent off, or a cone that you need later. A ball on top of it falls. The body keeps its
    /// position, without velocity and spin, until <see cref="MoveTo(Vector3d, Vector3d, double)"/> brings it back.
    /// <para>Rollbacks, recordings and look-aheads store whether a body is in play. A withdrawn body adds no measurable cost to a step. Does not allocate.</para>
    /// </remarks>
    public void Withdraw()
    {
        ref RigidMotion motion = ref Placement.Motion;
        RigidMotion before = motion;
        motion.Velocity = Vector3d.Zero;
        motion.Spin = Vector3d.Zero;
        motion.Swing = 0;
        motion.IsWithdrawn = true;

        Placement.Complete(in before);
        _all.RecordWithdrawal(this);
    }

    /// <summary>Sets the position and velocity, and brings the body into play. The orientation stays the same.</summary>
    /// <inheritdoc cref="MoveTo(Vector3d, Quaterniond, Vector3d, Vector3d, double)"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void MoveTo(Vector3d position, Vector3d velocity, double time)
    {
        if (_all.IsTimeOfLast(time) && Placement.MayMove(in position, in velocity))
        {
            Placement.Move(in position, in velocity, time);
            MovedAt = _all.Steps;
        }
        else
        {
            MoveTo(position, Orientation, velocity, Vector3d.Zero, time);
        }
    }

    /// <summary>Sets position, orientation, velocity and spin, and brings the body into play. Does not allocate.</summary>
    /// <param name="position">The position, in m; components within ±1e6.</param>
    /// <param name="orientation">The orientation, body to world; it is normalized.</param>
    /// <param name="velocity">The velocity, in m/s; at most 1000.</param>
    /// <param name="spin">The spin about the position, in rad/s; at most 10 000. The shape rotates with it within a step.</param>
    /// <param name="time">The time of this position: <see cref="Ball.Time"/> before the step, in s; within ±1e12. The next step throws if they differ by more than 0.25 s.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; nothing has changed.</exception>
    [MethodImpl(MethodImplOptions.NoInlining)] // the other overload is inlined
    public void MoveTo(Vector3d position, Quaterniond orientation, Vector3d velocity, Vector3d spin, double time)
    {
        // Most bodies have no spin. The rest is then computed when the ball comes near, so a body far from it costs little.
        if (RigidMotion.IsPlusZero(in spin) && Placement.MayMove(in position, in velocity) && Check.IsRotation(in orientation) && Math.Abs(time) <= Limits.Time)
        {
            Turn(in orientation);
            Placement.Move(in position, in velocity, time);
            _all.RecordMove(this, time);
            return;
        }

        Check.Place("position", position);
        Check.Rotation("orientation", orientation);
        Check.Size("velocity", velocity, Limits.Speed, "m/s");
        Check.Size("spin", spin, Limits.Spin, "rad/s");
        Check.Within("time", time, -Limits.Time, Limits.Time);
        ref RigidMotion motion = ref Placement.Motion;
        RigidMotion before = motion;

        Turn(in orientation);
        motion.Origin = position;
        motion.Pivot = position;
        motion.Velocity = velocity;
        motion.Spin = spin;
        motion.Time = time;
        motion.IsWithdrawn = false;
        motion.Rotate(Shape);

        // Notify the broad phase and recorders last, when the new motion is complete.
        Placement.Complete(in before);
        _all.RecordMove(this, time);
    }

    private void Turn(in Quaterniond orientation)
    {
        // Most bodies keep their orientation: do not normalize it again.
        if (!Placement.Has(in orientation) && orientation.Unit() is var turned && !Placement.Has(in turned))
        {
            Placement.Turn(in turned);
        }
    }

    /// <summary>Returns the time for which a ball on a straight path does not reach the box of this body, in s; infinite if it never does.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    internal double FreeFor(in Vector3d from, in Vector3d velocity, double time, double duration, double around)
    {
        // The exact sphere decides first, then the box. The sphere in the broad phase may still be rough: test the exact one.
        double half = 0.5 * duration;
        if (Placement.Refine() && Placement.Lane.IsFar(from + (half * velocity), (half * velocity.Length) + around, time + half, half))
        {
            return double.PositiveInfinity;
        }

        var way = new StraightWay(in from, velocity - Velocity, time, duration, around);
        return way.Meets(BoundsDuring(time, duration));
    }

    /// <summary>Changes the velocity in an impact.</summary>
    internal void Push(in Vector3d velocity, double time)
    {
        RigidMotion before = Placement.Motion;
        Placement.GoOn(in velocity, time);

        // The rotation may have changed the last bits of Swing. A restored motion has the new ones.
        Placement.Motion.Rotate(Shape);
        Placement.Complete(in before);
        _all.CountMove();
    }

    /// <summary>The motion; the setter restores a saved motion and updates the broad phase.</summary>
    internal RigidMotion Motion
    {
        get => Placement.Motion;
        set
        {
            ref RigidMotion motion = ref Placement.Motion;
            if (value.IsSame(in motion) && value.Time.Equals(motion.Time) && value.IsTurned == motion.IsTurned)
            {
                // Searches for bodies near the ball remain valid.
                return;
            }

            RigidMotion before = motion;
            motion = value;
            if (value.Orientation != before.Orientation)
            {
                Placement.Turn(in value.Orientation);
            }

            // A motion read from a file does not include Swing, so compute it.
            motion.Rotate(Shape);
            Placement.Complete(in before);
            _all.CountMove();
        }
    }

    /// <summary>The number of steps checked before the last move.</summary>
    internal long MovedAt { get; set; } = -1;

    /// <summary>Returns a bounding box at a time.</summary>
    internal Bounds3d BoundsAt(double time) => Placement.BoundsAt(time);

    /// <summary>Returns a box that bounds the body for a duration if the box moves with the body's velocity.</summary>
    internal Bounds3d BoundsDuring(double time, double duration) => Placement.BoundsDuring(time, duration);
}
