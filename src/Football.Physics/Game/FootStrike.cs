namespace FootballPhysics.Aiming;

/// <summary>A strike by a <see cref="Foot"/>: the foot's motion and its effect on the ball.</summary>
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

    /// <summary>Creates a strike that falls short because the foot is too slow.</summary>
    internal FootStrike(in FootStrike tooSlow)
    {
        this = tooSlow;
        FastEnough = false;
    }

    /// <summary>The velocity of the foot before the strike, in m/s.</summary>
    public Vector3d FootVelocity { get; }

    /// <summary>The unit normal from the point of contact to the ball's centre; the foot touches at −r n.</summary>
    public Vector3d Normal { get; }

    /// <summary>The velocity of the foot after the strike, in m/s.</summary>
    public Vector3d FootVelocityAfter { get; }

    /// <summary>The velocity of the ball after the strike, in m/s; pass it to <see cref="Simulator.Kick"/>.</summary>
    public Vector3d Velocity { get; }

    /// <summary>The spin of the ball after the strike, in rad/s; pass it to <see cref="Simulator.Kick"/>.</summary>
    public Vector3d Spin { get; }

    /// <summary>False if the wanted spin needs more friction than is available; the strike then gives as much spin as possible.</summary>
    public bool EnoughFriction { get; }

    /// <summary>False if the wanted kick needs a foot faster than <see cref="Foot.MaximumSpeed"/>; the strike then falls short.</summary>
    public bool FastEnough { get; }

    /// <summary>The wanted change of spin about the impulse direction, in rad/s; no strike can produce it.</summary>
    public double SpinAlongImpulse { get; }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant($"foot at {FootVelocity:0.###} m/s against {Normal:0.###}: ball {Velocity:0.###} m/s, {Spin:0.###} rad/s");
}
