namespace FootballPhysics.Aiming;

/// <summary>A foot, or a head or a hand, that strikes a ball: from its motion to the kick, and from the kick back to its motion.</summary>
/// <remarks>
/// It touches the ball at −r n, n the unit normal into the ball, with velocity U and an effective mass M. With 1/m_n = 1/m + 1/M,
/// 1/m_t = (1 + 1/α)/m + 1/M, c = v − U and the slip s = c_t + r n × ω of the ball on the foot, the impulse on the ball is J = J_n n − J_t ŝ with
/// J_n = −(1 + e) m_n (c·n), J_t = min(μ J_n, (1 + e_t) m_t |s|).
/// </remarks>
public sealed record Foot
{
    /// <summary>Shares of a kick that are tried where the whole of it is too fast for the leg.</summary>
    private const int Shares = 16;

    private const int MostHalvings = 60;

    /// <summary>Effective mass M, kg. Above 0; default 1.9 (guess, 1.5 … 3).</summary>
    public double Mass { get; init; } = 1.9;

    /// <summary>Normal restitution e. 0 … 1; default 0.6 (guess, 0.5 … 0.6).</summary>
    public double Restitution { get; init; } = 0.6;

    /// <summary>Tangential restitution e_t of a grip. 0 … 1; default 0 (guess): the ball leaves without slip.</summary>
    public double TangentialRestitution { get; init; }

    /// <summary>
    /// Friction μ. Not negative; default 0.9 (leather measured, 0.37 … 0.63; 0.5 for the dent in the ball, a guess, so that spin depends weakly on friction as
    /// Asai et al. 2002 measured).
    /// </summary>
    public double Friction { get; init; } = 0.9;

    /// <summary>How fast the foot can be, m/s: the limit of the leg. At least 0.01; default infinite, no limit. <see cref="Strike"/> does not ask for it.</summary>
    public double MaximumSpeed { get; init; } = double.PositiveInfinity;

    /// <summary>Computes what a strike does to a ball: its velocity and spin after it, and the foot's.</summary>
    /// <param name="ball">The ball.</param>
    /// <param name="velocity">Its velocity v before, m/s.</param>
    /// <param name="spin">Its spin ω before, rad/s.</param>
    /// <param name="footVelocity">Velocity U of the foot, m/s.</param>
    /// <param name="normal">Direction n from the point of contact to the ball's centre; not zero, need not be a unit vector.</param>
    /// <returns>The strike; where the foot does not move towards the ball, nothing happens.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="ball"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public FootStrike Strike(BallProperties ball, Vector3d velocity, Vector3d spin, Vector3d footVelocity, Vector3d normal)
    {
        Validate(ball, in velocity, in spin);
        Check.Size("foot.velocity", footVelocity, Limits.Speed, "m/s");

        // The ball is met by a mass that gives way, by the impact law that all contacts have.
        Vector3d n = Direction(normal);
        CoulombImpact.Apply(ball, Material, GivingWay.Of(ball, Mass), in n, in footVelocity, in velocity, in spin, out Vector3d after, out Vector3d spinAfter);

        // U' = U − J/M
        return new FootStrike(
            in footVelocity,
            in n,
            footVelocity - (ball.Mass / Mass * (after - velocity)),
            in after,
            in spinAfter,
            enoughFriction: true,
            spinAlongImpulse: 0);
    }

    /// <summary>The strike that gives a ball a velocity and a spin, or comes nearest to them.</summary>
    /// <remarks>
    /// The velocity is given as far as the leg is fast enough. Spin about the direction of the impulse cannot be given, and friction limits the rest:
    /// <see cref="FootStrike.SpinAlongImpulse"/> and <see cref="FootStrike.EnoughFriction"/> say so, <see cref="FootStrike.Spin"/> is what the ball gets.
    /// Where the foot would have to be faster than <see cref="MaximumSpeed"/>, the ball goes the wanted way as fast as the leg can make it, with as much less
    /// of the wanted spin; where no share of the speed is within its reach, the foot swings the wanted way as fast as it can. <see cref="FootStrike.FastEnough"/> says so.
    /// </remarks>
    /// <param name="ball">The ball.</param>
    /// <param name="velocity">Its velocity v before, m/s.</param>
    /// <param name="spin">Its spin ω before, rad/s.</param>
    /// <param name="wantedVelocity">Its velocity v' after, m/s; not the one before.</param>
    /// <param name="wantedSpin">Its spin ω' after, rad/s.</param>
    /// <exception cref="ArgumentNullException"><paramref name="ball"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public FootStrike StrikeFor(BallProperties ball, Vector3d velocity, Vector3d spin, Vector3d wantedVelocity, Vector3d wantedSpin)
    {
        Validate(ball, in velocity, in spin);
        Check.Size("kick.velocity", wantedVelocity, Limits.Speed, "m/s");
        Check.Size("kick.spin", wantedSpin, Limits.Spin, "rad/s");

        // Without an impulse there is no direction to strike in.
        if (!((wantedVelocity - velocity).Length > 0))
        {
            throw Check.Refusal("kick.velocity", wantedVelocity.ToString(), "a velocity that differs from the ball's");
        }

        // The strike in closed form; where the leg is fast enough for it, that is all.
        FootStrike wanted = Inverse(ball, in velocity, in spin, in wantedVelocity, in wantedSpin);
        if (wanted.FootVelocity.Length <= MaximumSpeed)
        {
            return wanted;
        }

        // The greatest share of the speed that the leg can give: from there on it is too fast.
        var part = new Part(this, ball, in velocity, in spin, in wantedVelocity, in wantedSpin);
        for (int i = Shares - 1; i >= 0; i--)
        {
            // From the whole kick downwards: the first share that the leg can give brackets the greatest.
            double low = (double)i / Shares;
            if (part.Takes(low).Length <= MaximumSpeed)
            {
                double high = (i + 1.0) / Shares;
                Roots.Bisect(ref part, ref low, ref high, MostHalvings);
                return new FootStrike(part.Of(low));
            }
        }

        // Not even a small share, as where the ball itself comes fast: the same swing, as fast as the leg can.
        Vector3d swing = MaximumSpeed / wanted.FootVelocity.Length * wanted.FootVelocity;
        return new FootStrike(Strike(ball, velocity, spin, swing, wanted.Normal));
    }

    /// <summary>The strike that gives a kick, however fast the foot must be.</summary>
    private FootStrike Inverse(BallProperties ball, in Vector3d velocity, in Vector3d spin, in Vector3d wantedVelocity, in Vector3d wantedSpin)
    {
        double r = ball.Radius;

        // J = m (v' − v)
        Vector3d impulse = ball.Mass * (wantedVelocity - velocity);
        double size = impulse.Length;
        Vector3d direction = impulse / size;

        // A touch turns the ball about axes across the impulse alone: Δω = (r/I) J × n. What lies along it stays as it was.
        Vector3d turn = wantedSpin - spin;
        double lost = Vector3d.Dot(in turn, in direction);
        Vector3d across = turn - (lost * direction);
        double rate = across.Length;

        // sin ψ = I |Δω⊥|/(r |J|), where friction allows no more than tan ψ = μ;  n = cos ψ Ĵ + sin ψ (Δω⊥/|Δω⊥| × Ĵ)
        double sine = ball.MomentOfInertia * rate / (r * size);
        double most = Friction / Math.Sqrt(1.0 + (Friction * Friction));
        bool enough = sine <= most * (1.0 + 1e-12);
        sine = enough ? sine : most;
        double cosine = Math.Sqrt(Math.Max(0, 1.0 - (sine * sine)));
        Vector3d lever = rate > 0 ? Vector3d.Cross(across / rate, in direction) : Vector3d.Zero;
        Vector3d n = (cosine * direction) + (sine * lever);

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

    /// <summary>m_n.</summary>
    private double NormalMass(BallProperties ball) => 1.0 / ((1.0 / ball.Mass) + (1.0 / Mass));

    /// <summary>m_t.</summary>
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

    /// <summary>A share of a wanted kick: its speed, and its change of the spin.</summary>
    private readonly struct Part : ICondition
    {
        private readonly Foot _foot;
        private readonly BallProperties _ball;
        private readonly Vector3d _velocity;
        private readonly Vector3d _spin;
        private readonly Vector3d _wantedVelocity;
        private readonly Vector3d _wantedSpin;

        public Part(Foot foot, BallProperties ball, in Vector3d velocity, in Vector3d spin, in Vector3d wantedVelocity, in Vector3d wantedSpin)
        {
            _foot = foot;
            _ball = ball;
            _velocity = velocity;
            _spin = spin;
            _wantedVelocity = wantedVelocity;
            _wantedSpin = wantedSpin;
        }

        /// <summary>The strike for it.</summary>
        public FootStrike Of(double share) =>
            _foot.Inverse(_ball, in _velocity, in _spin, share * _wantedVelocity, _spin + (share * (_wantedSpin - _spin)));

        /// <summary>The velocity of the foot that it takes; none where the ball has that velocity already.</summary>
        public Vector3d Takes(double share) => ((share * _wantedVelocity) - _velocity).Length > 0 ? Of(share).FootVelocity : Vector3d.Zero;

        public bool Evaluate(double x, out bool holds)
        {
            // True where the foot would have to be too fast, or the number is none.
            holds = !(Takes(x).Length <= _foot.MaximumSpeed);
            return false;
        }
    }
}
