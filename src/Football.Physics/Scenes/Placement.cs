namespace FootballPhysics.Scenes;

/// <summary>The motion of an object that the game or an impact moves, with a bounding box in its orientation.</summary>
internal sealed class Placement
{
    /// <summary>The motion since the last change.</summary>
    public RigidMotion Motion;

    private Bounds3d _own;
    private Bounds3d _turned;

    /// <summary>Creates a placement at the origin.</summary>
    /// <param name="own">A bounding box of the shape, in the shape's frame.</param>
    public Placement(in Bounds3d own)
    {
        Motion.Orientation = Quaterniond.Identity;
        _own = own;
        _turned = own;
        Reach = ReachOf(in own);
    }

    /// <summary>The greatest distance of any point of the shape from its origin, in m.</summary>
    public double Reach { get; private set; }

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

    /// <summary>Returns a box that bounds the object at any rotation, if the box moves with the object's velocity.</summary>
    public Bounds3d BoundsAlways(double time) => BoundsDuring(time, double.PositiveInfinity);

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

    /// <summary>Returns a bound on the distance from the origin: the distance of the farthest possible corner.</summary>
    private static double ReachOf(in Bounds3d own) =>
        new Vector3d(Math.Max(-own.Min.X, own.Max.X), Math.Max(-own.Min.Y, own.Max.Y), Math.Max(-own.Min.Z, own.Max.Z)).Length;
}
