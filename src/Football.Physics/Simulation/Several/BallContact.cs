using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>The contact of two balls: their gap, and the impulse between them.</summary>
internal static class BallContact
{
    /// <summary>Two balls that close more slowly than this are in sustained contact, m/s: no bounce, and no impact event.</summary>
    public const double Gentle = 0.01;

    /// <summary>Returns the gap between the surfaces of two balls, m, and its rate, m/s.</summary>
    public static double Gap(in BallState first, double firstRadius, in BallState second, double secondRadius, out Vector3d normal, out double rate)
    {
        Vector3d apart = first.Position - second.Position;
        double distance = apart.Length;
        normal = distance > 0 ? apart / distance : Vector3d.Up;
        rate = Vector3d.Dot(first.Velocity - second.Velocity, in normal);
        return distance - (firstRadius + secondRadius);
    }

    /// <summary>Computes the impact of two balls that touch and close.</summary>
    /// <remarks>
    /// <c>J_n = (1 + e) (−u·n)/(1/m₁ + 1/m₂)</c>, <c>J_t = −(1 + e_t) s/κ</c>, at most μ J_n, with <c>κ = 1/m₁ + 1/m₂ + r₁²/I₁ +
    /// r₂²/I₂</c>.
    /// The result is bit-identical if the two balls are swapped.
    /// </remarks>
    /// <param name="ball">The first ball.</param>
    /// <param name="other">The second ball.</param>
    /// <param name="material">The material of their contact.</param>
    /// <param name="n">Normal, from the second to the first.</param>
    /// <param name="first">The first ball before.</param>
    /// <param name="second">The second ball before.</param>
    /// <param name="a">The first ball's velocity and spin after.</param>
    /// <param name="b">The second ball's velocity and spin after.</param>
    public static void Impact(
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
            return;
        }

        // J_n = (1 + e)(−u·n)/(1/m₁ + 1/m₂); the tangential impulse is −(1 + e_t) s/κ, at most μ J_n.
        double givesWay = (1.0 / ball.Mass) + (1.0 / other.Mass);
        double firstTurns = ball.Radius * ball.Radius / ball.MomentOfInertia;
        double secondTurns = other.Radius * other.Radius / other.MomentOfInertia;
        double normal = (1.0 + material.RestitutionAt(approach, relative + (approach * n))) * approach / givesWay;
        Vector3d grip = (1.0 + material.TangentialX) / (givesWay + (firstTurns + secondTurns)) * (u - (Vector3d.Dot(in u, in n) * n));
        double size = grip.Length;
        double most = material.ImpactFriction * normal;
        Vector3d impulse = (normal * n) - (size > most ? most / size * grip : grip);

        // About the normal, only the relative spin matters: keep the share e_ω, minus the drilling friction b μ_s J_n of each ball.
        double eases = (1.0 / ball.MomentOfInertia) + (1.0 / other.MomentOfInertia);
        double about = Vector3d.Dot(w1 - w2, in n);
        double drilled = material.DrillingLength * material.SlidingFriction * normal * eases;
        double kept = material.Spin * about;
        kept = kept > 0 ? Math.Max(0, kept - drilled) : Math.Min(0, kept + drilled);
        double torque = (kept - about) / eases;

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
    }
}
