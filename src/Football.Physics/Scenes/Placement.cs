namespace Football.Physics;

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
    }

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
        Turn(Quaterniond.Identity);
    }

    /// <summary>A box around it at a time; one that touches nothing while it is out of play.</summary>
    public Bounds3d BoundsAt(double time) => Motion.IsWithdrawn ? Bounds3d.Nowhere : _turned.Moved(Motion.GoneBy(time));
}
