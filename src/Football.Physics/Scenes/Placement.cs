using System.Runtime.CompilerServices;

namespace FootballPhysics.Scenes;

/// <summary>The motion of an object that the game or an impact moves, with a bounding box in its orientation.</summary>
internal sealed class Placement
{
    private readonly MovingLane _lane;
    private RigidMotion _motion;
    private Bounds3d _own;
    private Bounds3d _turned;
    private bool _isPlain;
    private bool _isBehind;
    private long _changes;

    /// <summary>Creates a placement at the origin.</summary>
    /// <param name="own">A bounding box of the shape, in the shape's frame.</param>
    /// <param name="lane">For a body of the game: its lane in the broad phase, which <see cref="Tell"/> updates.</param>
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
    public ref readonly MovingLane Lane => ref _lane;

    /// <summary>The orientation, which <see cref="TryMove"/> keeps.</summary>
    public Quaterniond Orientation => _motion.Orientation;

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

    /// <summary>Sets position and velocity of an object in play without spin; computes everything else when it is needed.</summary>
    /// <returns>False if the object is not like this.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool TryMove(in Vector3d position, in Vector3d velocity, double time)
    {
        if (_isPlain)
        {
            _lane.Move(in position, in velocity, time);
            _isBehind = true;
        }

        return _isPlain;
    }

    /// <summary>Completes a change of the motion: updates the broad phase.</summary>
    /// <param name="before">The motion before the change.</param>
    public void Tell(in RigidMotion before)
    {
        _changes += _motion.IsSame(in before) ? 0 : 1;
        _isPlain = !_motion.IsWithdrawn && RigidMotion.IsPlusZero(in _motion.Spin);
        _lane.Move(in _motion.Origin, in _motion.Velocity, _motion.Time);
        if (_motion.IsWithdrawn)
        {
            _lane.Remove();
        }
        else
        {
            // The box at any rotation, if it moves with the object's velocity.
            _lane.Bound(_motion.Rotates ? Swept(_motion.Time, double.PositiveInfinity).Translated(-_motion.Origin) : _turned);
        }
    }

    /// <summary>Sets the orientation.</summary>
    /// <param name="orientation">The new orientation, a unit quaternion.</param>
    public void Turn(in Quaterniond orientation)
    {
        Motion.Orientation = orientation;
        Motion.IsTurned = orientation != Quaterniond.Identity;

        // Rotate the box here once; queries then only translate it.
        _turned = Motion.Turned(in _own);
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
        if (Motion.Rotates)
        {
            _turned = Motion.Turned(in _own);
        }
    }

    /// <summary>Returns a bounding box at a time.</summary>
    public Bounds3d BoundsAt(double time) => BoundsDuring(time, 0);

    /// <summary>Returns a box that bounds the object for a duration if the box moves with the object's velocity.</summary>
    /// <remarks>The box of a withdrawn object intersects nothing.</remarks>
    public Bounds3d BoundsDuring(double time, double duration) =>
        Motion.IsWithdrawn ? Bounds3d.Nowhere : Motion.Rotates ? Swept(time, duration) : _turned.Translated(Motion.GoneBy(time));

    private Bounds3d Swept(double time, double duration)
    {
        // A point moves at most Swing × time, and keeps its distance from the pivot.
        double longest = Math.Max(Math.Abs(time - Motion.Time), Math.Abs(time + duration - Motion.Time));
        double swept = Motion.Swing * longest;
        double reach = Reach + (Motion.Origin - Motion.Pivot).Length;
        return swept < reach
            ? _turned.Translated(Motion.GoneBy(time)).Expanded(swept)
            : Bounds3d.Around(Motion.Pivot + ((time - Motion.Time) * Motion.Velocity), reach, reach, reach);
    }

    /// <summary>Completes the motion after <see cref="TryMove"/>.</summary>
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
