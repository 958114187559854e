namespace FootballPhysics.Contacts;

/// <summary>The law of every impact: of the ball with an object, a foot or another ball.</summary>
/// <remarks>
/// It is Coulomb's law: normal restitution, and a tangential impulse that grips, or slips if friction cannot hold it.
/// Without a friction limit, these are the four coefficients of restitution in the thesis (2.16 to 2.18).
/// </remarks>
internal static class ImpactLaw
{
    /// <summary>Computes velocity and spin of a ball just after an impact with an object.</summary>
    /// <remarks>The impulse on the ball is m (v' − v); the object gets the opposite impulse.</remarks>
    /// <param name="ball">The ball.</param>
    /// <param name="material">The material of the object.</param>
    /// <param name="n">Normal of the contact.</param>
    /// <param name="surface">Velocity of the surface there, m/s.</param>
    /// <param name="v">Velocity before, m/s; towards the surface.</param>
    /// <param name="w">Spin before, rad/s.</param>
    /// <param name="velocity">Velocity after, m/s.</param>
    /// <param name="spin">Spin after, rad/s.</param>
    /// <param name="recoil">The mass ratio m/M of the ball and the object; 0 for an immovable object.</param>
    /// <returns>True if friction holds the contact; false if it slips.</returns>
    public static bool Apply(
        BallProperties ball,
        in ContactMaterial material,
        in Vector3d n,
        in Vector3d surface,
        in Vector3d v,
        in Vector3d w,
        out Vector3d velocity,
        out Vector3d spin,
        double recoil = 0)
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
            return true;
        }

        // Per mass of the ball: 1/m + 1/M becomes 1 + m/M, and 1/κ, the slip that a unit of impulse removes, becomes 1/(1 + 1/α + m/M).
        // The slip is s = u_t + r n × ω, with the inertia factor α.
        Vector3d along = u + (approach * n);
        var law = new Impulse(in material, approach, in along, along + (r * Vector3d.Cross(in n, in w)), 1.0 + recoil, alpha / (1.0 + alpha + (alpha * recoil)));
        velocity = v + (law.Normal * n) - law.Friction;

        // The impulse J turns the ball: ω' = ω + (r/(α r²)) n × J/m, and the change about the normal.
        double about = Vector3d.Dot(in w, in n);
        double kept = law.SpinKept(in material, about, alpha * r * r);
        spin = w + (1.0 / (alpha * r) * Vector3d.Cross(in n, law.Friction)) + ((kept - about) * n);
        return law.Grips;
    }

    /// <summary>Computes the impact of two balls that touch and close.</summary>
    /// <remarks>The result is bit-identical if the two balls are swapped.</remarks>
    /// <param name="ball">The first ball.</param>
    /// <param name="other">The second ball.</param>
    /// <param name="material">The material of their contact.</param>
    /// <param name="n">Normal, from the second to the first.</param>
    /// <param name="first">The first ball before.</param>
    /// <param name="second">The second ball before.</param>
    /// <param name="a">The first ball's velocity and spin after.</param>
    /// <param name="b">The second ball's velocity and spin after.</param>
    /// <returns>True if friction holds the contact; false if it slips.</returns>
    public static bool Apply(
        BallProperties ball, BallProperties other, in ContactMaterial material, in Vector3d n, in BallState first, in BallState second, out Motion a, out Motion b)
    {
        // The slip velocity u = (v₁ − r₁ ω₁ × n) − (v₂ + r₂ ω₂ × n).
        Vector3d w1 = first.Spin;
        Vector3d w2 = second.Spin;
        Vector3d relative = first.Velocity - second.Velocity;
        Vector3d u = first.Velocity - (ball.Radius * Vector3d.Cross(in w1, in n)) - (second.Velocity + (other.Radius * Vector3d.Cross(in w2, in n)));
        double approach = -Vector3d.Dot(in relative, in n);
        if (!(approach > 0))
        {
            a = new Motion(first.Position, first.Velocity, in w1);
            b = new Motion(second.Position, second.Velocity, in w2);
            return true;
        }

        // A unit of impulse along the surface changes the slip by κ = 1/m₁ + 1/m₂ + r₁²/I₁ + r₂²/I₂.
        double yields = (1.0 / ball.Mass) + (1.0 / other.Mass);
        double turns = (ball.Radius * ball.Radius / ball.MomentOfInertia) + (other.Radius * other.Radius / other.MomentOfInertia);
        var law = new Impulse(in material, approach, relative + (approach * n), u - (Vector3d.Dot(in u, in n) * n), yields, 1.0 / (yields + turns));
        Vector3d impulse = (law.Normal * n) - law.Friction;

        // About the normal, only the relative spin matters.
        double eases = (1.0 / ball.MomentOfInertia) + (1.0 / other.MomentOfInertia);
        double about = Vector3d.Dot(w1 - w2, in n);
        double torque = (law.SpinKept(in material, about, 1.0 / eases) - about) / eases;

        // Apply the impulse to both balls: v₁ += J/m₁, ω₁ −= (r₁/I₁) n × J; v₂ −= J/m₂, ω₂ −= (r₂/I₂) n × J.
        Vector3d turning = Vector3d.Cross(in n, in impulse);
        a = new Motion(
            first.Position,
            first.Velocity + (impulse / ball.Mass),
            w1 - (ball.Radius / ball.MomentOfInertia * turning) + (torque / ball.MomentOfInertia * n));
        b = new Motion(
            second.Position,
            second.Velocity - (impulse / other.Mass),
            w2 - (other.Radius / other.MomentOfInertia * turning) - (torque / other.MomentOfInertia * n));
        return law.Grips;
    }

    /// <summary>Returns the energy that a bumper has added along the normal, J.</summary>
    /// <param name="ball">The ball.</param>
    /// <param name="recoil">The mass ratio m/M of the ball and the object.</param>
    /// <param name="before">(v − V)·n, m/s.</param>
    /// <param name="after">(v' − V')·n, m/s.</param>
    public static double Added(BallProperties ball, double recoil, double before, double after) =>

        // The energy gain ½ m/(1 + m/M) (w'² − w²), with the separation speeds w before and w' after, and the object's mass M.
        Math.Max(0, 0.5 * ball.Mass / (1.0 + recoil) * ((after * after) - (before * before)));

    /// <summary>The impulse of one impact, in units of the mass that the caller chooses.</summary>
    private readonly struct Impulse
    {
        /// <summary>J_n.</summary>
        public readonly double Normal;

        /// <summary>−J_t.</summary>
        public readonly Vector3d Friction;

        /// <summary>True if friction holds the contact.</summary>
        public readonly bool Grips;

        /// <param name="material">The material.</param>
        /// <param name="approach">−u·n, m/s; above 0.</param>
        /// <param name="along">u_t, m/s.</param>
        /// <param name="slip">s, m/s.</param>
        /// <param name="yields">1/m₁ + 1/m₂.</param>
        /// <param name="turning">1/κ.</param>
        public Impulse(in ContactMaterial material, double approach, in Vector3d along, in Vector3d slip, double yields, double turning)
        {
            // The normal impulse J_n = (1 + e) (−u·n)/(1/m₁ + 1/m₂), with the restitution e and the relative velocity u.
            double restitution = material.RestitutionAt(approach, in along);
            Normal = material.IsBumper
                ? (approach + material.Bumped(approach, restitution)) / yields
                : (1.0 + restitution) * approach / yields;

            // A grip needs J_t = −(1 + e_t) s/κ, with the tangential restitution e_t and the slip s. Friction limits it to μ J_n.
            double gripX = turning * (1.0 + material.TangentialX);
            var grip = new Vector3d(gripX * slip.X, gripX * slip.Y, turning * (1.0 + material.TangentialZ) * slip.Z);
            double size = grip.Length;
            double most = FrictionLaw.Limit(material.ImpactFriction, Normal);
            Grips = !(size > most);
            Friction = Grips ? grip : most / size * grip;
        }

        /// <summary>Returns the spin about the normal after the impact, rad/s: the share e_ω, minus the drilling friction b μ_s J_n/I.</summary>
        public double SpinKept(in ContactMaterial material, double about, double inertia)
        {
            double kept = material.Spin * about;
            double drilled = material.Resistance.MostDrilling(Normal) / inertia;
            return kept > 0 ? Math.Max(0, kept - drilled) : Math.Min(0, kept + drilled);
        }
    }
}
