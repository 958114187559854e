namespace Football.Physics;

/// <summary>The contact of two balls: how near they are, and the impulse that both get.</summary>
internal static class BallContact
{
    /// <summary>Slower than this, m/s, two balls press each other: no bounce, and no impact that is told.</summary>
    public const double Gentle = 0.01;

    /// <summary>Distance between the surfaces of two balls, m, and how fast it grows, m/s.</summary>
    public static double Gap(in BallState first, double firstRadius, in BallState second, double secondRadius, out Vector3d normal, out double rate)
    {
        Vector3d apart = first.Position - second.Position;
        double distance = apart.Length;
        normal = distance > 0 ? apart / distance : Vector3d.Up;
        rate = Vector3d.Dot(first.Velocity - second.Velocity, in normal);
        return distance - firstRadius - secondRadius;
    }

    /// <summary>The impact of two balls that touch and come closer.</summary>
    /// <param name="ball">The first ball.</param>
    /// <param name="other">The second one.</param>
    /// <param name="material">Their contact.</param>
    /// <param name="n">Normal, from the second to the first.</param>
    /// <param name="first">The first ball before.</param>
    /// <param name="second">The second ball before.</param>
    /// <param name="a">The first ball's velocity and spin after.</param>
    /// <param name="b">The second ball's velocity and spin after.</param>
    public static void Impact(
        BallProperties ball, BallProperties other, in ContactMaterial material, in Vector3d n, in BallState first, in BallState second, out Motion a, out Motion b)
    {
        // The surface of the second at the contact, p₂ + r₂ n: V_c = v₂ + r₂ ω₂ × n
        Vector3d spin = second.Spin;
        Vector3d surface = second.Velocity + (other.Radius * Vector3d.Cross(in spin, in n));
        CoulombImpact.Apply(
            ball, in material, GivingWay.Of(ball, other), in n, in surface, first.Velocity, first.Spin, out Vector3d v, out Vector3d w);

        // v₂ −= J/m₂,  ω₂ −= (r₂ n) × J/I₂
        Vector3d impulse = ball.Mass * (v - first.Velocity);
        a = new Motion(first.Position, in v, in w);
        b = new Motion(
            second.Position,
            second.Velocity - (impulse / other.Mass),
            spin - (other.Radius / other.MomentOfInertia * Vector3d.Cross(in n, in impulse)));
    }
}
