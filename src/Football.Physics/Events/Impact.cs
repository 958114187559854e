using FootballPhysics.Events;

namespace FootballPhysics;

/// <summary>The outputs of an impact, for sound, haptics and looks: impulses, slip, duration, compression and peak force.</summary>
/// <remarks>
/// The impact itself takes no time in the simulation. Duration, compression and force follow from a linear spring: k = 0.55 · 2π r p + 6.7e3 N/m, fitted to the
/// contact time of 10.7 ms and the compression of 57 mm at 19.2 m/s (derived from Mills et al. 2026). The factors are a guess. Valid for 3 … 25 m/s, 0.6 … 1.1 bar
/// and hard surfaces: duration ±15 %, compression and force ±25 %. Below 10 m/s, the compression may be 40 % too small. On turf, the duration is a lower bound.
/// </remarks>
public readonly record struct Impact
{
    /// <summary>The share of the pressure's membrane force in the stiffness (guess).</summary>
    private const double PressureShare = 0.55;

    /// <summary>The stiffness of the shell without pressure, in N/m (guess).</summary>
    private const double ShellStiffness = 6.7e3;

    /// <summary>The share of the spring's compression that a ball reaches (guess).</summary>
    private const double CompressionShare = 0.85;

    /// <summary>The largest compression, in radii.</summary>
    private const double MostCompression = 1.2;

    /// <summary>The number of pascals in a bar.</summary>
    private const double Bar = 1e5;

    internal Impact(BallProperties ball, in BallEvent happened)
    {
        ref readonly ImpactContact contact = ref happened.Contact;
        Vector3d n = happened.Normal;
        Vector3d before = happened.VelocityBefore - contact.Surface;
        Vector3d after = happened.Velocity - contact.Surface;
        Impulse = ball.Mass * (happened.Velocity - happened.VelocityBefore);
        NormalImpulse = Math.Max(0, Vector3d.Dot(Impulse, in n));
        Vector3d friction = Impulse - (Vector3d.Dot(Impulse, in n) * n);
        TangentialImpulse = friction.Length;

        // The other object recoils by −J/M, and the surface of another ball turns too.
        double yields = contact.Yields + contact.Turns;
        SlipBefore = Slip(ball, in before, happened.SpinBefore, in n).Length;
        SlipAfter = (Slip(ball, in after, happened.Spin, in n) + (yields * friction)).Length;
        Grips = contact.Grips;
        double closing = Math.Max(0, -Vector3d.Dot(in before, in n));
        double stiffness = (PressureShare * 2.0 * Math.PI * ball.Radius * ball.Pressure * Bar) + ShellStiffness;
        ContactTime = Math.PI * Math.Sqrt(1.0 / (((1.0 / ball.Mass) + contact.Yields) * stiffness));
        Compression = Math.Min(CompressionShare * closing * ContactTime / Math.PI, MostCompression * ball.Radius);
        PeakForce = 2.0 * Math.PI / 3.0 * NormalImpulse / ContactTime;
        double linear = before.LengthSquared - after.LengthSquared;
        double angular = happened.SpinBefore.LengthSquared - happened.Spin.LengthSquared;

        // Another ball has its own loss; an object with a mass gains ½ J²/M.
        double other = contact.Turns > 0 ? contact.Lost : -0.5 * contact.Yields * Impulse.LengthSquared;
        EnergyLost = (0.5 * ((ball.Mass * linear) + (ball.MomentOfInertia * angular))) + other;
    }

    /// <summary>The impulse on the ball, m (v' − v), in N s. The object received the opposite impulse.</summary>
    public Vector3d Impulse { get; }

    /// <summary>J_n, the impulse along the normal, in N s; at least 0.</summary>
    public double NormalImpulse { get; }

    /// <summary>J_t, the impulse of friction, in N s; at least 0.</summary>
    public double TangentialImpulse { get; }

    /// <summary>The speed of the ball's contact point along the surface just before the impact, in m/s.</summary>
    public double SlipBefore { get; }

    /// <summary>The speed of the ball's contact point along the surface just after the impact, in m/s.</summary>
    public double SlipAfter { get; }

    /// <summary>True if friction held the contact; false if the ball slipped through the impact.</summary>
    public bool Grips { get; internal init; }

    /// <summary>T, the duration of a real impact, in s; about 0.0107 for a football on a hard surface.</summary>
    public double ContactTime { get; }

    /// <summary>The largest compression of the ball, in m; at most 1.2 radii.</summary>
    /// <remarks>The radius of the patch that touches the surface is √(2 r x − x²).</remarks>
    public double Compression { get; }

    /// <summary>The largest normal force, in N.</summary>
    public double PeakForce { get; }

    /// <summary>The kinetic energy lost, in J: translation relative to the surface, and rotation. An object with a mass and another ball count too.</summary>
    /// <remarks>It includes drilling friction. It is negative if a bumper adds energy.</remarks>
    public double EnergyLost { get; }

    /// <summary>Returns the slip of the contact point, v_t + r n × ω, in m/s.</summary>
    private static Vector3d Slip(BallProperties ball, in Vector3d velocity, in Vector3d spin, in Vector3d n)
    {
        Vector3d surface = velocity + (ball.Radius * Vector3d.Cross(in n, in spin));
        return surface - (Vector3d.Dot(in surface, in n) * n);
    }
}
