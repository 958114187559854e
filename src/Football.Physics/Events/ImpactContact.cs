namespace FootballPhysics.Events;

/// <summary>The object of an impact, as an event carries it.</summary>
/// <param name="surface">V, the velocity of the object's material at the contact, in m/s.</param>
/// <param name="yields">1/M, the object's yield along the normal, in 1/kg; 0 if it is immovable.</param>
/// <param name="turns">The object's additional yield along its surface, r²/I of another ball, in 1/kg.</param>
/// <param name="lost">The kinetic energy that another ball lost relative to V, in J.</param>
/// <param name="grips">True if friction held the contact.</param>
internal readonly struct ImpactContact(in Vector3d surface, bool grips, double yields = 0, double turns = 0, double lost = 0)
{
    public readonly Vector3d Surface = surface;
    public readonly double Yields = yields;
    public readonly double Turns = turns;
    public readonly double Lost = lost;

    // Not a bool: events have no padding, so that equal events have equal bytes.
    private readonly long _grips = grips ? 1 : 0;

    public bool Grips => _grips != 0;

    /// <summary>Returns the contact of a ball with another ball.</summary>
    /// <param name="other">The other ball.</param>
    /// <param name="before">Its state before the impact.</param>
    /// <param name="after">Its motion after the impact.</param>
    /// <param name="normal">The normal, from the contact to the centre of the other ball.</param>
    /// <param name="grips">True if friction held the contact.</param>
    public static ImpactContact With(BallProperties other, in BallState before, in Motion after, in Vector3d normal, bool grips)
    {
        Vector3d spin = before.Spin;
        Vector3d surface = before.Velocity - (other.Radius * Vector3d.Cross(in spin, in normal));
        double lost = 0.5 * other.Mass * ((before.Velocity - surface).LengthSquared - (after.Velocity - surface).LengthSquared);
        lost += 0.5 * other.MomentOfInertia * (spin.LengthSquared - after.Spin.LengthSquared);
        return new ImpactContact(in surface, grips, 1.0 / other.Mass, other.Radius * other.Radius / other.MomentOfInertia, lost);
    }
}
