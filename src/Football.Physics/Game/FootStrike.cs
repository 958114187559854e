namespace FootballPhysics.Aiming;

/// <summary>A strike by a <see cref="Foot"/>: how it meets the ball, and what it does to both.</summary>
public readonly struct FootStrike
{
    internal FootStrike(
        in Vector3d footVelocity,
        in Vector3d normal,
        in Vector3d footVelocityAfter,
        in Vector3d velocity,
        in Vector3d spin,
        bool enoughFriction,
        double spinAlongImpulse)
    {
        FootVelocity = footVelocity;
        Normal = normal;
        FootVelocityAfter = footVelocityAfter;
        Velocity = velocity;
        Spin = spin;
        EnoughFriction = enoughFriction;
        FastEnough = true;
        SpinAlongImpulse = spinAlongImpulse;
    }

    /// <summary>A strike that is less than what was wanted, for want of speed.</summary>
    internal FootStrike(in FootStrike tooSlow)
    {
        this = tooSlow;
        FastEnough = false;
    }

    /// <summary>Velocity of the foot before, m/s.</summary>
    public Vector3d FootVelocity { get; }

    /// <summary>Unit normal from the point of contact to the ball's centre: the foot touches at −r n.</summary>
    public Vector3d Normal { get; }

    /// <summary>Velocity of the foot after, m/s.</summary>
    public Vector3d FootVelocityAfter { get; }

    /// <summary>Velocity of the ball after, m/s: for <see cref="Simulator.Kick"/>.</summary>
    public Vector3d Velocity { get; }

    /// <summary>Spin of the ball after, rad/s: for <see cref="Simulator.Kick"/>.</summary>
    public Vector3d Spin { get; }

    /// <summary>False where a wanted spin needs more friction than there is: then the strike gives as much of it as there is friction for.</summary>
    public bool EnoughFriction { get; }

    /// <summary>False where a wanted kick needs a faster foot than <see cref="Foot.MaximumSpeed"/>: then the strike is as fast as the leg can.</summary>
    public bool FastEnough { get; }

    /// <summary>Wanted change of spin about the direction of the impulse, rad/s: no touch gives that.</summary>
    public double SpinAlongImpulse { get; }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant($"foot at {FootVelocity:0.###} m/s against {Normal:0.###}: ball {Velocity:0.###} m/s, {Spin:0.###} rad/s");
}
