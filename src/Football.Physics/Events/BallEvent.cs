using System.Globalization;

namespace FootballPhysics;

/// <summary>Something that happened inside a step, at its exact time and place.</summary>
/// <remarks>
/// An impact carries the impulse's own velocity, before a ball that stays down has its vertical part set to zero; a rest carries
/// velocity and spin as they were when rest was declared.
/// </remarks>
public readonly struct BallEvent : IFormattable
{
    private readonly int _kind;
    private readonly int _other; // 0 for none, so that a default event has none

    internal BallEvent(
        BallEventKind kind,
        int thing,
        in Vector3d normal,
        double time,
        in Vector3d position,
        in Vector3d velocityBefore,
        in Vector3d spinBefore,
        in Vector3d velocity,
        in Vector3d spin)
    {
        _kind = (int)kind;
        ColliderIndex = thing;
        Normal = normal;
        Time = time;
        Position = position;
        VelocityBefore = velocityBefore;
        SpinBefore = spinBefore;
        Velocity = velocity;
        Spin = spin;
    }

    /// <summary>A copy of an event, as that of one of several balls.</summary>
    /// <param name="happened">The event.</param>
    /// <param name="ball">Index of the ball.</param>
    internal BallEvent(in BallEvent happened, int ball)
    {
        this = happened;
        Ball = ball;
    }

    /// <summary>An impact between two balls, of one of them.</summary>
    internal BallEvent(int otherBall, in Vector3d normal, double time, in BallState before, in Vector3d velocity, in Vector3d spin)
        : this(BallEventKind.Impact, -1, in normal, time, before.Position, before.Velocity, before.Spin, in velocity, in spin) => _other = otherBall + 1;

    /// <summary>The kind of the event.</summary>
    public BallEventKind Kind => (BallEventKind)_kind;

    /// <summary>
    /// What was hit, met or passed, or carries the ball: its index among the things of the scene; −1 for none. 0 is the ground, then
    /// come the obstacles in their order, the posts and bars of the goals, the bodies, all nets, the goals, the zones. An engine's collider has a number of its own, far beyond these, by its
    /// name alone. The simulator gives the name.
    /// </summary>
    public int ColliderIndex { get; internal init; }

    /// <summary>Which ball it happened to: its index among several that are stepped together; 0 where there is one.</summary>
    public int Ball { get; }

    /// <summary>The ball that was hit, where that is one of several; −1 for none. <see cref="ColliderIndex"/> is then −1.</summary>
    public int OtherBall => _other - 1;

    /// <summary>Normal of the contact, from the thing to the ball, of length 1; of a net or a goal that of its plane, towards where the ball came from; of a zone the outward normal of its shape. Zero for a rest or a leave.</summary>
    public Vector3d Normal { get; }

    /// <summary>When, s since the launch.</summary>
    public double Time { get; }

    /// <summary>Where the centre was, m.</summary>
    public Vector3d Position { get; }

    /// <summary>Velocity just before, m/s; differs from <see cref="Velocity"/> at impacts only.</summary>
    public Vector3d VelocityBefore { get; }

    /// <summary>Spin just before, rad/s; differs from <see cref="Spin"/> at impacts, and by a vanishing slip at a roll.</summary>
    public Vector3d SpinBefore { get; }

    /// <summary>Velocity just after, m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>Spin just after, rad/s.</summary>
    public Vector3d Spin { get; }

    /// <summary>Which tick of steps of one length it happened in, the first of which begins at time 0: the kick of a later tick does not change it.</summary>
    /// <param name="timeStep">Length of a step, s; above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="timeStep"/> is not above 0.</exception>
    public long TickAt(double timeStep)
    {
        Check.Positive(nameof(timeStep), timeStep);
        return (long)Math.Floor(Time / timeStep);
    }

    /// <summary>Speed against what was hit, along the normal, m/s: what a bounce sounds like. 0 for what is no impact.</summary>
    public double ApproachSpeed => Math.Abs(Vector3d.Dot(VelocityBefore, Normal));

    /// <summary>Linear speed that the event took away, m/s.</summary>
    public double SpeedLost => VelocityBefore.Length - Velocity.Length;

    /// <summary>Slip of the ball's lowest point over what it touches, just before, m/s, towards which it rubs.</summary>
    /// <param name="radius">Radius of the ball, m.</param>
    public Vector3d SlipBefore(double radius)
    {
        // v + ω × (−r n), without its part along n.
        Vector3d surface = VelocityBefore - (radius * Vector3d.Cross(SpinBefore, Normal));
        return surface - (Vector3d.Dot(in surface, Normal) * Normal);
    }

    /// <summary>Impulse on the ball, m (v' − v), N s; what was hit got the opposite. Zero for what is no impact.</summary>
    /// <param name="ball">The ball.</param>
    /// <exception cref="ArgumentNullException"><paramref name="ball"/> is null.</exception>
    public Vector3d Impulse(BallProperties ball)
    {
        Check.Given(nameof(ball), ball);
        return Kind == BallEventKind.Impact ? ball.Mass * (Velocity - VelocityBefore) : Vector3d.Zero;
    }

    /// <summary>
    /// Energy that a bumper has added, J: ½ m (w'² − w²) with w the speed relative to what was hit, along the normal; with m/(1 + m/M) where that has a mass. 0 for all else.
    /// </summary>
    public double AddedEnergy { get; internal init; }

    /// <summary>Energy that the event took away, of motion and of rotation, J.</summary>
    /// <param name="ball">The ball.</param>
    /// <exception cref="ArgumentNullException"><paramref name="ball"/> is null.</exception>
    public double EnergyLost(BallProperties ball)
    {
        if (ball is null)
        {
            throw new ArgumentNullException(nameof(ball));
        }

        // ½ m (|v|² − |v'|²) + ½ I (|ω|² − |ω'|²)
        double linear = VelocityBefore.LengthSquared - Velocity.LengthSquared;
        double angular = SpinBefore.LengthSquared - Spin.LengthSquared;
        return 0.5 * ((ball.Mass * linear) + (ball.MomentOfInertia * angular));
    }

    /// <summary>The event as text: kind, time and place.</summary>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>The event as text: kind, time and place, its numbers with a format each, such as "F2".</summary>
    /// <param name="format">A format of numbers; null or empty for three decimals at most, "R" for all digits.</param>
    /// <param name="formatProvider">The culture; default the invariant one.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"{Kind} at {Time.ToString(format, culture)} s, {Position.ToString(format, culture)}, {Velocity.ToString(format, culture)} m/s";
    }
}
