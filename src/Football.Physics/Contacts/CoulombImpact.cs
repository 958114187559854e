namespace FootballPhysics.Contacts;

/// <summary>An impact by Coulomb's law: normal restitution, and a tangential impulse that grips, or slips if friction cannot hold
/// it.</summary>
/// <remarks>Without a friction limit, these are the four coefficients of restitution in the thesis (2.16 to 2.18).</remarks>
internal static class CoulombImpact
{
    /// <summary>Number of bisections that locate the share of a restitution to a billionth.</summary>
    private const int Halvings = 30;

    /// <summary>Computes velocity and spin just after an impact with an immovable object.</summary>
    /// <inheritdoc cref="Apply(BallProperties, in ContactMaterial, in GivingWay, in Vector3d, in Vector3d, in Vector3d, in Vector3d, out
    /// Vector3d, out Vector3d)"/>
    public static void Apply(
        BallProperties ball,
        in ContactMaterial material,
        in Vector3d n,
        in Vector3d surface,
        in Vector3d v,
        in Vector3d w,
        out Vector3d velocity,
        out Vector3d spin) =>
        Apply(ball, in material, default, in n, in surface, in v, in w, out velocity, out spin);

    /// <summary>Computes velocity and spin just after an impact.</summary>
    /// <remarks>The impulse on the ball is m (v' − v); the other object gets the opposite impulse.</remarks>
    /// <param name="ball">The ball.</param>
    /// <param name="material">The material of the other object.</param>
    /// <param name="other">The recoil of the other object.</param>
    /// <param name="n">Normal of the contact.</param>
    /// <param name="surface">Velocity of the surface there, m/s.</param>
    /// <param name="v">Velocity before, m/s; towards the surface.</param>
    /// <param name="w">Spin before, rad/s.</param>
    /// <param name="velocity">Velocity after, m/s.</param>
    /// <param name="spin">Spin after, rad/s.</param>
    public static void Apply(
        BallProperties ball,
        in ContactMaterial material,
        in GivingWay other,
        in Vector3d n,
        in Vector3d surface,
        in Vector3d v,
        in Vector3d w,
        out Vector3d velocity,
        out Vector3d spin) => Apply(ball, in material, in other, in n, in surface, in v, in w, 1.0, out velocity, out spin);

    /// <summary>Computes an impact with reduced restitution, so that the ball does not exceed the maximum speed; if necessary, with zero
    /// restitution.</summary>
    /// <remarks>Impulse, friction and spin obey the same laws.</remarks>
    /// <param name="ball">The ball.</param>
    /// <param name="material">The material of the other object.</param>
    /// <param name="other">The recoil of the other object.</param>
    /// <param name="n">Normal of the contact.</param>
    /// <param name="surface">Velocity of the surface there, m/s.</param>
    /// <param name="v">Velocity before, m/s; towards the surface.</param>
    /// <param name="w">Spin before, rad/s.</param>
    /// <param name="fastest">The allowed speed, m/s.</param>
    /// <param name="velocity">Velocity after, m/s.</param>
    /// <param name="spin">Spin after, rad/s.</param>
    public static void ApplySoftened(
        BallProperties ball,
        in ContactMaterial material,
        in GivingWay other,
        in Vector3d n,
        in Vector3d surface,
        in Vector3d v,
        in Vector3d w,
        double fastest,
        out Vector3d velocity,
        out Vector3d spin)
    {
        // Bisect the share of the restitution: because of friction's kink, the speed is not a polynomial of it. The lower bound is always valid.
        double low = 0;
        double high = 1;
        for (int i = 0; i < Halvings; i++)
        {
            double middle = 0.5 * (low + high);
            Apply(ball, in material, in other, in n, in surface, in v, in w, middle, out velocity, out spin);
            low = velocity.Length <= fastest ? middle : low;
            high = velocity.Length <= fastest ? high : middle;
        }

        Apply(ball, in material, in other, in n, in surface, in v, in w, low, out velocity, out spin);
    }

    /// <summary>Returns the energy that a bumper has added along the normal, J; 0 for other surfaces.</summary>
    /// <param name="ball">The ball.</param>
    /// <param name="material">The material of the other object.</param>
    /// <param name="other">The recoil of the other object.</param>
    /// <param name="before">(v − V)·n, m/s.</param>
    /// <param name="after">(v' − V')·n, m/s.</param>
    public static double Added(BallProperties ball, in ContactMaterial material, in GivingWay other, double before, double after) =>

        // The energy gain ½ m/(1 + m/M) (w'² − w²).
        material.IsBumper ? Math.Max(0, 0.5 * ball.Mass / (1.0 + other.Ratio) * ((after * after) - (before * before))) : 0;

    private static void Apply(
        BallProperties ball,
        in ContactMaterial material,
        in GivingWay other,
        in Vector3d n,
        in Vector3d surface,
        in Vector3d v,
        in Vector3d w,
        double share,
        out Vector3d velocity,
        out Vector3d spin)
    {
        double alpha = ball.InertiaFactor;
        double r = ball.Radius;
        Vector3d u = v - surface;
        double approach = -Vector3d.Dot(in u, in n);
        if (!(approach > 0))
        {
            // The surface recedes at least as fast as the ball approaches, so there is no impulse.
            velocity = v;
            spin = w;
            return;
        }

        // The normal impulse J_n/m = (1 + e) (−u·n)/(1 + m/M).
        Vector3d along = u + (approach * n);
        double restitution = material.RestitutionAt(approach, in along);
        double normal = material.IsBumper
            ? (approach + material.Bumped(approach, restitution, share)) / (1.0 + other.Ratio)
            : (1.0 + (share * restitution)) * approach / (1.0 + other.Ratio);

        // The slip s = u_t + r n × ω; a grip needs J/m = (1 + e_t) s/(1 + 1/α + m/M), limited to μ J_n/m.
        Vector3d slip = along + (r * Vector3d.Cross(in n, in w));
        double turning = alpha / (1.0 + alpha + (alpha * other.Ratio));
        double gripX = turning * (1.0 + material.TangentialX);
        var grip = new Vector3d(gripX * slip.X, gripX * slip.Y, turning * (1.0 + material.TangentialZ) * slip.Z);
        double size = grip.Length;
        double most = material.ImpactFriction * normal;
        Vector3d friction = size > most ? most / size * grip : grip;
        velocity = v + (normal * n) - friction;

        // ω' = ω + (r/(α r²)) n × J/m; about the normal, keep the share e_ω of the spin minus b μ_s J_n/I.
        double about = Vector3d.Dot(in w, in n);
        double kept = material.Spin * about;
        double drilled = material.DrillingLength * material.SlidingFriction * normal / (alpha * r * r);
        kept = kept > 0 ? Math.Max(0, kept - drilled) : Math.Min(0, kept + drilled);
        spin = w + (1.0 / (alpha * r) * Vector3d.Cross(in n, in friction)) + ((kept - about) * n);
    }
}

/// <summary>The recoil of the other object in an impact: the mass ratio m/M₂; 0 for an immovable object.</summary>
internal readonly struct GivingWay
{
    /// <summary>m/M₂.</summary>
    public readonly double Ratio;

    private GivingWay(double ratio) => Ratio = ratio;

    /// <summary>Creates the recoil of an object with a mass behind its surface, which moves without rotating.</summary>
    /// <param name="ball">The ball.</param>
    /// <param name="mass">M₂, kg; infinite for an immovable object.</param>
    public static GivingWay Of(BallProperties ball, double mass) => new(ball.Mass / mass);
}
