using System.Globalization;
using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>The whole state of a ball: an unmanaged value.</summary>
/// <remarks>
/// Copying it is a snapshot, comparing its bytes is equality, and a step depends on nothing else that changes.
/// Make one with <see cref="Simulator.Launch(Vector3d, Vector3d, Vector3d)"/>; all zero bytes are not a valid state.
/// </remarks>
public struct BallState : IFormattable
{
    /// <summary>A spin without an axis, rad/s: the squares of its components vanish, and with them its direction.</summary>
    private const double NoSpin = 1e-140;

    /// <summary>Time since the launch, s.</summary>
    public double Time { get; internal set; }

    /// <summary>Position of the centre, m.</summary>
    public Vector3d Position { get; internal set; }

    /// <summary>Velocity of the centre, m/s.</summary>
    public Vector3d Velocity
    {
        readonly get => Flight.Velocity;
        internal set => Flight.Velocity = value;
    }

    /// <summary>Velocity and spin.</summary>
    internal FlightMotion Flight;

    /// <summary>The motion of the ball: in the air, sliding, rolling or at rest.</summary>
    public MotionState Motion { get; internal set; }

    /// <summary>The branch of the drag law that the ball is on. Beside <see cref="Motion"/>, so that there is no padding between fields.</summary>
    internal DragBranch Branch;

    /// <summary>Angular velocity in the world frame, rad/s.</summary>
    public readonly Vector3d Spin => SpinAxis * SpinRate;

    /// <summary>Orientation, body to world. Put together when asked for: in flight it costs nothing until then.</summary>
    public readonly Quaterniond Orientation => Angle == 0
        ? BaseOrientation
        : (Quaterniond.FromAxisAngle(SpinAxis, Angle) * BaseOrientation).Normalized();

    /// <summary>In flight the unit axis of rotation, which is constant there; on the ground the spin itself.</summary>
    internal Vector3d SpinAxis
    {
        readonly get => Flight.Axis;
        set => Flight.Axis = value;
    }

    /// <summary>In flight the size of the spin, rad/s; on the ground 1.</summary>
    internal double SpinRate
    {
        readonly get => Flight.SpinRate;
        set => Flight.SpinRate = value;
    }

    /// <summary>Angle turned about <see cref="SpinAxis"/> since <see cref="BaseOrientation"/>, rad.</summary>
    internal double Angle;

    /// <summary>Orientation when <see cref="Angle"/> was last zero.</summary>
    internal Quaterniond BaseOrientation;

    /// <summary>Index, among the things of the scene, of the carrier of a ball that slides, rolls or rests; 0 is the ground.</summary>
    internal long Carrier;

    /// <summary>The nets that the ball is in, a bit each.</summary>
    internal ulong Nets;

    /// <summary>On which side of its plane it met each of them: a bit is set for the side that the normal points to.</summary>
    internal ulong NetSides;

    /// <summary>The goals whose mouth the ball has come through, and whose line it has not passed, a bit each.</summary>
    internal ulong GoalsEntered;

    /// <summary>The goals whose line the ball has passed since it was placed or kicked, a bit each.</summary>
    internal ulong GoalsPassed;

    /// <summary>Until this time, s, the flight was found to meet nothing but level ground; 0 where that is not known.</summary>
    internal double ClearUntil;

    /// <summary>A key of the scene for which that was found, which is odd; of a ball that rests in a pile, a key of the balls that it touches, which is even.</summary>
    internal ulong ClearIn;

    /// <summary><see cref="ClearIn"/> of a ball that several surfaces bore at the end of the last step: the next one need not look whether the way is free.</summary>
    internal const ulong TouchesSeveral = 2;

    /// <summary>Distance flown through the air since the kick, m, where a knuckle force depends on it; else 0.</summary>
    internal double AirDistance;

    /// <summary>
    /// Until <see cref="SqueezeUntil"/> things that move may make the ball no faster than this, m/s: the fastest that has touched it, times 1 + e, or as fast as
    /// it came.
    /// </summary>
    internal double SqueezeSpeed;

    /// <summary>So long, s, what touched the ball lately, and moved, counts for what touches it next; 0 where nothing did.</summary>
    internal double SqueezeUntil;

    /// <inheritdoc/>
    public override readonly string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>The state as text: motion, time, place and speed, its numbers with a format each, such as "F2".</summary>
    /// <param name="format">A format of numbers; null or empty for three decimals at most, "R" for all digits.</param>
    /// <param name="formatProvider">The culture; default the invariant one.</param>
    public readonly string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"{Motion} at {Time.ToString(format, culture)} s, {Position.ToString(format, culture)}, {Velocity.ToString(format, culture)} m/s, {Spin.ToString(format, culture)} rad/s";
    }

    /// <summary>Sets the spin of a ball in the air.</summary>
    internal void SetFlightSpin(in Vector3d spin)
    {
        // The angle turned so far is about the old axis.
        FoldRotation();
        double rate = spin.Length;

        // What is too small to have an axis is no spin; an axis there is nevertheless, of length 1.
        bool spins = rate > NoSpin;
        SpinAxis = spins ? spin / rate : Vector3d.Up;
        SpinRate = spins ? rate : 0;
    }

    /// <summary>Sets the spin of a ball on the ground.</summary>
    internal void SetGroundSpin(in Vector3d spin)
    {
        FoldRotation();

        // On the ground the axis is the spin itself, and its size 1.
        SpinAxis = spin;
        SpinRate = 1;
    }

    /// <summary>Moves the angle turned so far into the base orientation, before the axis changes.</summary>
    internal void FoldRotation()
    {
        BaseOrientation = Orientation;
        Angle = 0;
    }

    /// <summary>A state, refused where it never was one of a ball.</summary>
    internal static BallState Launched(in BallState state) =>
        state.BaseOrientation == default
            ? throw new ArgumentException("The state is uninitialised. Create it with Simulator.Launch or copy it from a Ball.", nameof(state))
            : state;
}

/// <summary>Position, velocity and spin, and the distance flown: what a general step advances.</summary>
internal readonly struct Motion
{
    public readonly Vector3d Position;
    public readonly Vector3d Velocity;
    public readonly Vector3d Spin;

    /// <summary>Distance flown through the air, m, where the air of the scene asks for it.</summary>
    public readonly double AirDistance;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Motion(in Vector3d position, in Vector3d velocity, in Vector3d spin, double airDistance = 0)
    {
        Position = position;
        Velocity = velocity;
        Spin = spin;
        AirDistance = airDistance;
    }

    /// <summary>The motion after h with constant rates: a stage.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Motion After(double h, in Vector3d velocity, in MotionRates rates) =>
        new(Position + (h * velocity), Velocity + (h * rates.Acceleration), Spin + (h * rates.SpinAcceleration), AirDistance + (h * rates.AirSpeed));
}

/// <summary>Rates of change of velocity, spin and the distance flown.</summary>
internal readonly struct MotionRates
{
    public readonly Vector3d Acceleration;
    public readonly Vector3d SpinAcceleration;

    /// <summary>Speed relative to the air, m/s, where the air of the scene asks for it.</summary>
    public readonly double AirSpeed;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public MotionRates(in Vector3d acceleration, in Vector3d spinAcceleration, double airSpeed = 0)
    {
        Acceleration = acceleration;
        SpinAcceleration = spinAcceleration;
        AirSpeed = airSpeed;
    }
}
