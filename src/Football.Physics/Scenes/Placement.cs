namespace FootballPhysics;

/// <summary>Where a thing is that somebody else moves: its motion, and a box around it as it is turned.</summary>
internal sealed class Placement
{
    /// <summary>How it goes on from where it was put last.</summary>
    public RigidMotion Motion;

    private Bounds3d _own;
    private Bounds3d _turned;

    /// <summary>A thing at the origin.</summary>
    /// <param name="own">A box around its shape, in the shape's own frame.</param>
    public Placement(in Bounds3d own)
    {
        Motion.Orientation = Quaterniond.Identity;
        _own = own;
        _turned = own;
        Reach = ReachOf(in own);
    }

    /// <summary>The greatest distance of any point of the shape from its origin, m.</summary>
    public double Reach { get; private set; }

    /// <summary>Turns it.</summary>
    /// <param name="orientation">How it is turned now, of length 1.</param>
    public void Turn(in Quaterniond orientation)
    {
        Motion.Orientation = orientation;
        Motion.IsTurned = orientation != Quaterniond.Identity;

        // Turned once, not at each look: in between it is only moved.
        _turned = Motion.Turned(in _own);
    }

    /// <summary>Gives it another shape, which is not turned.</summary>
    /// <param name="own">A box around that.</param>
    public void Reshape(in Bounds3d own)
    {
        _own = own;
        Reach = ReachOf(in own);
        Turn(Quaterniond.Identity);
    }

    /// <summary>An impact changes its velocity.</summary>
    public void GoOn(in Vector3d velocity, double time)
    {
        Motion.GoOn(in velocity, time);
        if (Motion.Rotates)
        {
            _turned = Motion.Turned(in _own);
        }
    }

    /// <summary>A box around it at a time.</summary>
    public Bounds3d BoundsAt(double time) => BoundsDuring(time, 0);

    /// <summary>A box that is around it at a time, or one that touches nothing while it is out of play, and stays around it for a duration if the box moves along with its velocity.</summary>
    public Bounds3d BoundsDuring(double time, double duration) =>
        Motion.IsWithdrawn ? Bounds3d.Nowhere : Motion.Rotates ? Swept(time, duration) : _turned.Translated(Motion.GoneBy(time));

    /// <summary>A box around it at a time, however far it has rotated by then.</summary>
    public Bounds3d BoundsAlways(double time) => BoundsDuring(time, double.PositiveInfinity);

    private Bounds3d Swept(double time, double duration)
    {
        // No part has moved farther than its speed allows, nor farther from the pivot than it is.
        double longest = Math.Max(Math.Abs(time - Motion.Time), Math.Abs(time + duration - Motion.Time));
        double swept = Motion.Swing * longest;
        double reach = Reach + (Motion.Origin - Motion.Pivot).Length;
        return swept < reach
            ? _turned.Translated(Motion.GoneBy(time)).Expanded(swept)
            : Bounds3d.Around(Motion.Pivot + ((time - Motion.Time) * Motion.Velocity), reach, reach, reach);
    }

    /// <summary>No point of a box is farther from the origin than its farthest corner.</summary>
    private static double ReachOf(in Bounds3d own) =>
        new Vector3d(Math.Max(-own.Min.X, own.Max.X), Math.Max(-own.Min.Y, own.Max.Y), Math.Max(-own.Min.Z, own.Max.Z)).Length;
}
