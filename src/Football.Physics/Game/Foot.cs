using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>A foot, head or hand that strikes a ball. Computes the kick from the foot's motion, and the motion for a wanted kick.</summary>
/// <remarks>
/// The foot touches the ball at −r n, where n is the unit normal into the ball. It has velocity U and effective mass M. With 1/m_n = 1/m + 1/M, 1/m_t
/// = (1 + 1/α)/m + 1/M, c = v − U and the slip s = c_t + r n × ω of the ball on the foot, the impulse on the ball is J = J_n n − J_t ŝ with J_n = −(1
/// + e) m_n (c·n), J_t = min(μ J_n, (1 + e_t) m_t |s|).
/// </remarks>
public sealed class Foot
{
    /// <summary>The number of fractions of a kick to try if the full kick needs too fast a foot.</summary>
    private const int Shares = 16;

    private const int MostHalvings = 60;

    /// <summary>The effective mass M, in kg. Above 0; default 1.9 (guess, 1.5 … 3).</summary>
    public double Mass { get; init; } = 1.9;

    /// <summary>The normal restitution e. 0 … 1; default 0.6 (guess, 0.5 … 0.6).</summary>
    public double Restitution { get; init; } = 0.6;

    /// <summary>The tangential restitution e_t of a gripping contact. 0 … 1; default 0 (guess): no slip after contact.</summary>
    public double TangentialRestitution { get; init; }

    /// <summary>The friction coefficient μ. Not negative; default 0.9.</summary>
    /// <remarks>
    /// Measured values for leather are 0.37 … 0.63. The default is higher to allow for the deformation of the ball (guess). Spin then depends only
    /// weakly on friction, as measured by Asai et al. 2002.
    /// </remarks>
    public double Friction { get; init; } = 0.9;

    /// <summary>The maximum speed of the foot, in m/s. At least 0.01; default infinite: no limit.</summary>
    /// <remarks><see cref="StrikeFor"/> respects this limit; <see cref="Strike"/> ignores it.</remarks>
    public double MaximumSpeed { get; init; } = double.PositiveInfinity;

    /// <summary>Computes the velocities of ball and foot, and the spin of the ball, after a strike.</summary>
    /// <param name="ball">The ball.</param>
    /// <param name="velocity">The velocity v of the ball before the strike, in m/s.</param>
    /// <param name="spin">The spin ω of the ball before the strike, in rad/s.</param>
    /// <param name="footVelocity">The velocity U of the foot, in m/s.</param>
    /// <param name="normal">The direction n from the point of contact to the ball's centre; any length except zero.</param>
    /// <returns>The strike; it has no effect if the foot does not move towards the ball.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="ball"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public FootStrike Strike(BallProperties ball, Vector3d velocity, Vector3d spin, Vector3d footVelocity, Vector3d normal)
    {
        Validate(ball, in velocity, in spin);
        Check.Size("foot.velocity", footVelocity, Limits.Speed, "m/s");

        // Treat the strike as a collision with a movable mass, under the impact law of all contacts.
        Vector3d n = Direction(normal);
        ImpactLaw.Apply(ball, Material, in n, in footVelocity, in velocity, in spin, out Vector3d after, out Vector3d spinAfter, ball.Mass / Mass);

        // U is the foot's velocity before the strike, J the impulse on the ball, and M the foot's mass.
        // The foot's velocity after the strike: U' = U − J/M.
        return new FootStrike(
            in footVelocity,
            in n,
            footVelocity - (ball.Mass / Mass * (after - velocity)),
            in after,
            in spinAfter,
            enoughFriction: true,
            spinAlongImpulse: 0);
    }

    /// <summary>Computes the strike that gives the ball the wanted velocity and spin, or the closest possible ones.</summary>
    /// <remarks>
    /// The ball reaches the wanted velocity if the foot is fast enough. No strike can change the spin about the impulse direction (see
    /// <see cref="FootStrike.SpinAlongImpulse"/>), and friction limits all other changes in spin (see <see cref="FootStrike.EnoughFriction"/>).
    /// <see cref="FootStrike.Spin"/> is the resulting spin. If the foot would have to exceed <see cref="MaximumSpeed"/>, the ball leaves in the direction of
    /// <paramref name="wantedVelocity"/> at the highest possible speed. The change in spin is then proportionally smaller. If no speed is possible in this
    /// direction, the foot makes the same swing at its maximum speed. <see cref="FootStrike.FastEnough"/> is false in both cases.
    /// </remarks>
    /// <param name="ball">The ball.</param>
    /// <param name="velocity">The velocity v of the ball before the strike, in m/s.</param>
    /// <param name="spin">The spin ω of the ball before the strike, in rad/s.</param>
    /// <param name="wantedVelocity">The velocity v' after the strike, in m/s; different from <paramref name="velocity"/>.</param>
    /// <param name="wantedSpin">The spin ω' after the strike, in rad/s.</param>
    /// <exception cref="ArgumentNullException"><paramref name="ball"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public FootStrike StrikeFor(BallProperties ball, Vector3d velocity, Vector3d spin, Vector3d wantedVelocity, Vector3d wantedSpin)
    {
        Validate(ball, in velocity, in spin);
        Check.Size("kick.velocity", wantedVelocity, Limits.Speed, "m/s");
        Check.Size("kick.spin", wantedSpin, Limits.Spin, "rad/s");

        // An impulse of zero has no direction.
        if (!((wantedVelocity - velocity).Length > 0))
        {
            throw Check.Refusal("kick.velocity", wantedVelocity.ToString(), "a velocity that differs from the ball's");
        }

        // Use the closed-form strike if the foot can reach its speed.
        FootStrike wanted = Inverse(ball, in velocity, in spin, in wantedVelocity, in wantedSpin);
        if (wanted.FootVelocity.Length <= MaximumSpeed)
        {
            return wanted;
        }

        // Find the largest fraction of the kick within the speed limit.
        var part = new Part(this, ball, velocity, spin, wantedVelocity, wantedSpin);
        for (int i = Shares - 1; i >= 0; i--)
        {
            // Scan downwards from the full kick: the first feasible fraction brackets the largest feasible one.
            double low = (double)i / Shares;
            if (part.Takes(low).Length <= MaximumSpeed)
            {
                double high = (i + 1.0) / Shares;
                Roots.Bisect(ref part, ref low, ref high, MostHalvings);
                if (part.Changes(low))
                {
                    return new FootStrike(part.Of(low));
                }
            }
        }

        // No fraction is feasible, for instance because the incoming ball is fast: make the same swing at maximum speed.
        Vector3d swing = MaximumSpeed / wanted.FootVelocity.Length * wanted.FootVelocity;
        return new FootStrike(Strike(ball, velocity, spin, swing, wanted.Normal));
    }

    /// <summary>Returns the strike that produces a kick, without a limit on the foot's speed.</summary>
    private FootStrike Inverse(BallProperties ball, in Vector3d velocity, in Vector3d spin, in Vector3d wantedVelocity, in Vector3d wantedSpin)
    {
        double r = ball.Radius;

        // The impulse J = m (v' − v).
        Vector3d impulse = ball.Mass * (wantedVelocity - velocity);
        double size = impulse.Length;
        Vector3d direction = impulse / size;

        // The impulse changes only the spin perpendicular to it: Δω = (r/I) J × n. The spin along the impulse stays the same.
        Vector3d turn = wantedSpin - spin;
        double lost = Vector3d.Dot(in turn, in direction);
        Vector3d across = turn - (lost * direction);
        double rate = across.Length;

        // ψ is the angle between the normal n and the impulse J, Δω⊥ the change of spin across the impulse, and μ the friction.
        // sin ψ = I |Δω⊥|/(r |J|), limited by friction to tan ψ = μ;  n = cos ψ Ĵ + sin ψ (Δω⊥/|Δω⊥| × Ĵ)
        double sine = ball.MomentOfInertia * rate / (r * size);
        double most = Friction / Math.Sqrt(1.0 + (Friction * Friction));
        bool enough = sine <= most * (1.0 + 1e-12);
        sine = enough ? sine : most;
        double cosine = Math.Sqrt(Math.Max(0, 1.0 - (sine * sine)));
        Vector3d lever = rate > 0 ? Vector3d.Cross(across / rate, in direction) : Vector3d.Zero;
        Vector3d n = (cosine * direction) + (sine * lever);

        // U is the foot's velocity; n and t mark parts along and across the normal: m_n and m_t are effective masses, e and e_t restitutions.
        // U·n = v·n + J_n/(m_n (1 + e)),  U_t = v_t + r n × ω + (J − J_n n)/(m_t (1 + e_t))
        double pressed = cosine * size;
        Vector3d rubbed = impulse - (pressed * n);
        Vector3d surface = velocity - (Vector3d.Dot(in velocity, in n) * n) + (r * Vector3d.Cross(in n, in spin));
        double speed = Vector3d.Dot(in velocity, in n) + (pressed / (NormalMass(ball) * (1.0 + Restitution)));
        Vector3d footVelocity = (speed * n) + surface + (rubbed / (TangentialMass(ball) * (1.0 + TangentialRestitution)));
        return new FootStrike(
            in footVelocity,
            in n,
            footVelocity - (impulse / Mass),
            in wantedVelocity,
            spin - (r / ball.MomentOfInertia * Vector3d.Cross(in n, in impulse)),
            enough,
            lost);
    }

    private static Vector3d Direction(in Vector3d normal)
    {
        double length = normal.Length;
        return length > 0 && double.IsFinite(length) ? normal / length : throw Check.Refusal("foot.normal", normal.ToString(), "finite components, not all zero");
    }

    private ContactMaterial Material => new(Restitution, TangentialRestitution, Friction);

    /// <summary>The normal effective mass m_n.</summary>
    private double NormalMass(BallProperties ball) => 1.0 / ((1.0 / ball.Mass) + (1.0 / Mass));

    /// <summary>The tangential effective mass m_t.</summary>
    private double TangentialMass(BallProperties ball) => 1.0 / (((1.0 + (1.0 / ball.InertiaFactor)) / ball.Mass) + (1.0 / Mass));

    private void Validate(BallProperties ball, in Vector3d velocity, in Vector3d spin)
    {
        Check.Given(nameof(ball), ball);
        ball.Validate();
        Check.Positive("foot.mass", Mass);
        Check.Within("foot.restitution", Restitution, 0, 1);
        Check.Within("foot.tangentialRestitution", TangentialRestitution, 0, 1);
        Check.NotNegative("foot.friction", Friction);
        Check.Within("foot.maximumSpeed", MaximumSpeed, 0.01, double.PositiveInfinity);
        Check.Size("ball.velocity", velocity, Limits.Speed, "m/s");
        Check.Size("ball.spin", spin, Limits.Spin, "rad/s");
    }

    /// <summary>A fraction of a wanted kick: its speed and its change of spin are scaled.</summary>
    private readonly struct Part(Foot foot, BallProperties ball, Vector3d velocity, Vector3d spin, Vector3d wantedVelocity, Vector3d wantedSpin) : ICondition
    {
        /// <summary>Returns the strike for a fraction.</summary>
        public FootStrike Of(double share) =>
            foot.Inverse(ball, in velocity, in spin, share * wantedVelocity, spin + (share * (wantedSpin - spin)));

        /// <summary>True if a fraction needs an impulse; false if the ball already has the velocity.</summary>
        public bool Changes(double share) => ((share * wantedVelocity) - velocity).Length > 0;

        /// <summary>Returns the foot velocity for a fraction; zero without an impulse.</summary>
        public Vector3d Takes(double share) => Changes(share) ? Of(share).FootVelocity : Vector3d.Zero;

        public bool Evaluate(double x, out bool holds)
        {
            // True if the foot's speed would be too high or is NaN.
            holds = !(Takes(x).Length <= foot.MaximumSpeed);
            return false;
        }
    }
}
