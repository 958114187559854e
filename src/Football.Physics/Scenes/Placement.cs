using System.Runtime.CompilerServices;

namespace FootballPhysics.Scenes;

/// <summary>The motion of an object that the game or an impact moves, with a bounding box in its orientation.</summary>
internal sealed class Placement
{
    /// <summary>The limit of a coordinate in m, which is also that of the square of a speed in m²/s².</summary>
    private const double PlainLimit = Limits.Length < Limits.Speed * Limits.Speed ? Limits.Length : Limits.Speed * Limits.Speed;

    private readonly MovingLane _lane;
    private RigidMotion _motion;
    private Bounds3d _own;
    private Bounds3d _turned;
    private double _plainLimit = -1;
    private bool _isBehind;
    private bool _isBoxBehind;
    private bool _isRough;
    private long _changes;

    /// <summary>Creates a placement at the origin.</summary>
    /// <param name="own">A bounding box of the shape, in the shape's frame.</param>
    /// <param name="lane">For a body of the game: its lane in the broad phase, which <see cref="Complete"/> updates.</param>
    public Placement(in Bounds3d own, MovingLane lane = default)
    {
        _motion.Orientation = Quaterniond.Identity;
        _own = own;
        _turned = own;
        _lane = lane;
        Reach = ReachOf(in own);
    }

    /// <summary>The motion since the last change.</summary>
    public ref RigidMotion Motion
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            if (_isBehind)
            {
                CatchUp();
            }

            return ref _motion;
        }
    }

    /// <summary>The position and velocity, without the rest of the motion.</summary>
    public MovingLane Lane => _lane;

    /// <summary>The orientation, which <see cref="Move"/> keeps.</summary>
    public Quaterniond Orientation => _motion.Orientation;

    /// <summary>True if it has this orientation, bit for bit.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Has(in Quaterniond orientation) => RigidMotion.Same(in orientation, in _motion.Orientation);

    /// <summary>True if the object is out of play.</summary>
    public bool IsWithdrawn => _motion.IsWithdrawn;

    /// <summary>The number of changes of the motion that <see cref="RigidMotion.IsSame"/> sees.</summary>
    public long Changes
    {
        get
        {
            _ = Motion;
            return _changes;
        }
    }

    /// <summary>The greatest distance of any point of the shape from its origin, in m.</summary>
    public double Reach { get; private set; }

    /// <summary>True if <see cref="Move"/> may set a position and velocity: the object is in play and has no spin, and both are within their limits.</summary>
    /// <remarks>The sum is within the smallest limit only if all numbers are within theirs. A NaN is within no limit.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool MayMove(in Vector3d position, in Vector3d velocity) =>
        Math.Abs(position.X) + Math.Abs(position.Y) + Math.Abs(position.Z) + velocity.LengthSquared <= _plainLimit;

    /// <summary>Sets position and velocity; everything else is computed when it is needed.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Move(in Vector3d position, in Vector3d velocity, double time)
    {
        _lane.Move(in position, in velocity, time);
        _isBehind = true;
    }

    /// <summary>Completes a change of the motion: updates the broad phase.</summary>
    /// <param name="before">The motion before the change.</param>
    public void Complete(in RigidMotion before)
    {
        _changes += _motion.IsSame(in before) ? 0 : 1;
        _plainLimit = !_motion.IsWithdrawn && RigidMotion.IsPlusZero(in _motion.Spin) ? PlainLimit : -1;
        _lane.Move(in _motion.Origin, in _motion.Velocity, _motion.Time);
        if (_motion.IsWithdrawn)
        {
            _lane.Remove();
            _isRough = false;
        }
        else if (_motion.Rotates)
        {
            // The box at any rotation, if it moves with the object's velocity.
            _lane.Bound(Swept(_motion.Time, double.PositiveInfinity).Translated(-_motion.Origin));
            _isRough = false;
        }
        else
        {
            BoundLane();
        }
    }

    /// <summary>Replaces the rough sphere of an object that was turned by the sphere of its box.</summary>
    /// <remarks>Every search that depends on the sphere calls this first, so that its result does not depend on earlier searches.</remarks>
    /// <returns>False if the sphere was not rough.</returns>
    public bool Refine()
    {
        if (!_isRough)
        {
            return false;
        }

        _lane.Bound(in Turned);
        _isRough = false;
        return true;
    }

    /// <summary>Sets the orientation of an object, which differs from its last one.</summary>
    /// <param name="orientation">The new orientation, a unit quaternion.</param>
    public void Turn(in Quaterniond orientation)
    {
        _motion.Orientation = orientation;
        _motion.IsTurned = orientation != Quaterniond.Identity;
        _isBoxBehind = true;
        _changes++;
        if (_lane.IsNone)
        {
            _ = Turned;
        }
        else
        {
            BoundLane();
        }
    }

    /// <summary>Sets another shape, with the identity as its orientation.</summary>
    /// <param name="own">A bounding box of the shape.</param>
    public void Reshape(in Bounds3d own)
    {
        _own = own;
        Reach = ReachOf(in own);
        Turn(Quaterniond.Identity);
    }

    /// <summary>Changes the velocity in an impact.</summary>
    public void GoOn(in Vector3d velocity, double time)
    {
        Motion.GoOn(in velocity, time);
        _isBoxBehind |= Motion.Rotates;
    }

    /// <summary>Returns a bounding box at a time.</summary>
    public Bounds3d BoundsAt(double time) => BoundsDuring(time, 0);

    /// <summary>Returns a box that bounds the object for a duration if the box moves with the object's velocity.</summary>
    /// <remarks>The box of a withdrawn object intersects nothing.</remarks>
    public Bounds3d BoundsDuring(double time, double duration) =>
        Motion.IsWithdrawn ? Bounds3d.Nowhere : Motion.Rotates ? Swept(time, duration) : Turned.Translated(Motion.GoneBy(time));

    private Bounds3d Swept(double time, double duration)
    {
        // A point moves at most Swing × time, and keeps its distance from the pivot.
        double longest = Math.Max(Math.Abs(time - Motion.Time), Math.Abs(time + duration - Motion.Time));
        double swept = Motion.Swing * longest;
        double reach = Reach + (Motion.Origin - Motion.Pivot).Length;
        var whole = Bounds3d.Around(Motion.Pivot + ((time - Motion.Time) * Motion.Velocity), reach, reach, reach);

        // Intersect both, so that a shorter time never has a larger box.
        return swept < reach ? whole.Common(Turned.Translated(Motion.GoneBy(time)).Expanded(swept)) : whole;
    }

    /// <summary>The bounding box in the current orientation, rotated once; queries then only translate it.</summary>
    private ref readonly Bounds3d Turned
    {
        get
        {
            if (_isBoxBehind)
            {
                _isBoxBehind = false;
                _turned = _motion.Turned(in _own);
            }

            return ref _turned;
        }
    }

    private void BoundLane()
    {
        // A turned box costs more than a sphere that contains it at any rotation, and few objects come near the ball.
        _isRough = _isBoxBehind;
        if (_isRough)
        {
            _lane.BoundAlways(in _own);
        }
        else
        {
            _lane.Bound(in _turned);
        }
    }

    /// <summary>Completes the motion after <see cref="Move"/>.</summary>
    private void CatchUp()
    {
        RigidMotion before = _motion;
        _isBehind = false;
        _motion.Origin = _lane.Origin;
        _motion.Pivot = _motion.Origin;
        _motion.Velocity = _lane.Velocity;
        _motion.Time = _lane.At;
        _changes += _motion.IsSame(in before) ? 0 : 1;
    }

    /// <summary>Returns a bound on the distance from the origin: the distance of the farthest possible corner.</summary>
    private static double ReachOf(in Bounds3d own) =>
        new Vector3d(Math.Max(-own.Min.X, own.Max.X), Math.Max(-own.Min.Y, own.Max.Y), Math.Max(-own.Min.Z, own.Max.Z)).Length;
}
