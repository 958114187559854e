using System.Globalization;
using FootballPhysics.Events;
using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>An event within a step, with its exact time and position.</summary>
/// <remarks>
/// For an impact, the velocity is that just after the impulse. If the ball then stays on the surface, it loses the normal component of this velocity. A rest
/// event reports the velocity and spin at which the ball came to rest.
/// </remarks>
public readonly struct BallEvent : IFormattable
{
    private readonly int _kind;
    private readonly int _other; // Index + 1, so that a default event has no other ball.

    /// <summary>The object of an impact, for <see cref="Impact"/>.</summary>
    internal readonly ImpactContact Contact;

    internal BallEvent(
        BallEventKind kind,
        int thing,
        in Vector3d normal,
        double time,
        in Vector3d position,
        in Vector3d velocityBefore,
        in Vector3d spinBefore,
        in Vector3d velocity,
        in Vector3d spin,
        in ImpactContact contact = default)
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
        Contact = contact;
    }

    /// <summary>Copies an event for one of several balls.</summary>
    /// <param name="happened">The event.</param>
    /// <param name="ball">The index of the ball.</param>
    internal BallEvent(in BallEvent happened, int ball)
    {
        this = happened;
        Ball = ball;
    }

    /// <summary>Copies an event, with another object of the impact.</summary>
    internal BallEvent(in BallEvent happened, in ImpactContact contact)
    {
        this = happened;
        Contact = contact;
    }

    /// <summary>Creates the event of one ball in an impact between two.</summary>
    internal BallEvent(int otherBall, in Vector3d normal, double time, in BallState before, in Vector3d velocity, in Vector3d spin, in ImpactContact contact)
        : this(BallEventKind.Impact, -1, in normal, time, before.Position, before.Velocity, before.Spin, in velocity, in spin)
    {
        _other = otherBall + 1;
        Contact = contact;
    }

    /// <summary>The kind of the event.</summary>
    public BallEventKind Kind => (BallEventKind)_kind;

    /// <summary>The index of the object that the ball hit or passed, or that supports the ball; −1 if there is none.</summary>
    /// <remarks>
    /// Index 0 is the ground, followed by the obstacles in order, the posts and crossbars of the goals, the bodies, all nets, the goals and the zones. The
    /// index of an engine collider is much larger: a hash of its name. The simulator returns the name for an index.
    /// </remarks>
    public int ColliderIndex { get; internal init; }

    /// <summary>The index of the ball, if several are stepped together; otherwise 0.</summary>
    public int Ball { get; }

    /// <summary>The index of the other ball in an impact between two balls; otherwise −1.</summary>
    /// <remarks>If it is not −1, <see cref="ColliderIndex"/> is −1.</remarks>
    public int OtherBall => _other - 1;

    /// <summary>The unit normal of the contact, from the object to the ball.</summary>
    /// <remarks>Zero for a rest or the end of a contact. For a net or a goal, it is the normal of the plane, towards the side that the ball came from. For a zone, it is the outward normal of the shape.</remarks>
    public Vector3d Normal { get; }

    /// <summary>The time since the launch, in s.</summary>
    public double Time { get; }

    /// <summary>The position of the ball's centre, in m.</summary>
    public Vector3d Position { get; }

    /// <summary>The velocity just before the event, in m/s. It differs from <see cref="Velocity"/> only at impacts.</summary>
    public Vector3d VelocityBefore { get; }

    /// <summary>The spin just before the event, in rad/s.</summary>
    /// <remarks>This value differs from <see cref="Spin"/> at impacts and, by a negligible amount, at the start of a roll.</remarks>
    public Vector3d SpinBefore { get; }

    /// <summary>The velocity just after the event, in m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>The spin just after the event, in rad/s.</summary>
    public Vector3d Spin { get; }

    /// <summary>Returns the index of the tick that contains the event.</summary>
    /// <remarks>The first tick begins at time 0, and all ticks have the same length. A kick in a later tick does not change the result.</remarks>
    /// <param name="timeStep">The length of a tick, in s; above 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="timeStep"/> is not above 0.</exception>
    public long TickAt(double timeStep)
    {
        Check.Positive(nameof(timeStep), timeStep);
        return (long)Math.Floor(Time / timeStep);
    }

    /// <summary>The speed of the ball along the normal just before the event, in m/s.</summary>
    /// <remarks>The velocity of the object is ignored. <see cref="Simulator.ImpactOf"/> computes the strength of an impact.</remarks>
    public double ApproachSpeed => Math.Abs(Vector3d.Dot(VelocityBefore, Normal));

    /// <summary>The speed that the ball's centre lost in the event, in m/s.</summary>
    public double SpeedLost => VelocityBefore.Length - Velocity.Length;

    /// <summary>The energy that a bumper added, in J; 0 for all other events.</summary>
    /// <remarks>The energy is ½ m (w'² − w²), where w is the speed along the normal relative to the bumper. If the bumper has a mass M, m/(1 + m/M) replaces
    /// m.</remarks>
    public double AddedEnergy { get; internal init; }

    /// <summary>Formats the kind, time, position and velocity.</summary>
    public override string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>Formats the kind, time, position and velocity, using the given number format.</summary>
    /// <param name="format">The format of the numbers, such as "F2"; null or empty for up to three decimals, "R" for full precision.</param>
    /// <param name="formatProvider">The culture; default: the invariant culture.</param>
    public string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"{Kind} at {Time.ToString(format, culture)} s, {Position.ToString(format, culture)}, {Velocity.ToString(format, culture)} m/s";
    }
}
