using System.Globalization;
using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;
using FootballPhysics.State;

namespace FootballPhysics;

/// <summary>The complete state of a ball: an unmanaged value.</summary>
/// <remarks>
/// A copy is a snapshot, and equal bytes mean equal states. A step depends on no mutable data of the ball except this state.
/// Create a state with <see cref="Simulator.Launch(Vector3d, Vector3d, Vector3d)"/>; all zero bytes are not a valid state.
/// </remarks>
public struct BallState : IFormattable
{
    /// <summary>The spin below which the axis is undefined, in rad/s: the squares of its components underflow.</summary>
    private const double NoSpin = 1e-140;

    /// <summary>The maximum number of repeated launches until the spins repeat: of 100 million random spins, none needed more than 17.</summary>
    private const int MostLaunches = 32;

    /// <summary>The time since the launch, in s.</summary>
    public double Time { get; internal set; }

    /// <summary>The position of the centre, in m.</summary>
    public Vector3d Position { get; internal set; }

    /// <summary>The velocity of the centre, in m/s.</summary>
    public Vector3d Velocity
    {
        readonly get => Flight.Velocity;
        internal set => Flight.Velocity = value;
    }

    /// <summary>The velocity and spin.</summary>
    internal FlightMotion Flight;

    /// <summary>The motion of the ball: in flight, sliding, rolling, at rest or pinned.</summary>
    public MotionState Motion { get; internal set; }

    /// <summary>The active branch of the drag law. It follows <see cref="Motion"/>, so that there is no padding between fields.</summary>
    internal DragBranch Branch;

    /// <summary>The angular velocity in the world frame, in rad/s.</summary>
    public readonly Vector3d Spin => Flight.Axis * Flight.SpinRate;

    /// <summary>The orientation, body to world.</summary>
    /// <remarks>The value is computed on each access; steps in flight do not update it.</remarks>
    public readonly Quaterniond Orientation => Angle == 0
        ? BaseOrientation
        : (Quaterniond.FromAxisAngle(Flight.Axis, Angle) * BaseOrientation).Normalized();

    /// <summary>In flight, the constant unit axis of rotation; on the ground, the spin itself.</summary>
    internal Vector3d SpinAxis
    {
        readonly get => Flight.Axis;
        set => Flight.Axis = value;
    }

    /// <summary>In flight, the magnitude of the spin, in rad/s; on the ground, 1.</summary>
    internal double SpinRate
    {
        readonly get => Flight.SpinRate;
        set => Flight.SpinRate = value;
    }

    /// <summary>The angle of rotation about <see cref="SpinAxis"/> since <see cref="BaseOrientation"/>, in rad.</summary>
    internal double Angle;

    /// <summary>The orientation when <see cref="Angle"/> was last zero.</summary>
    internal Quaterniond BaseOrientation;

    /// <summary>The index of the object that supports a sliding, rolling or resting ball; 0 is the ground.</summary>
    internal long Carrier;

    /// <summary>The nets in contact with the ball, one bit per net.</summary>
    internal ulong Nets;

    /// <summary>The side of each net from which the ball came: the bit is set for the side of the normal.</summary>
    internal ulong NetSides;

    /// <summary>The goals whose mouth the ball has passed but not the line, one bit per goal.</summary>
    internal ulong GoalsEntered;

    /// <summary>The goals whose line the ball has passed since it was placed or kicked, one bit per goal.</summary>
    internal ulong GoalsPassed;

    /// <summary>The time until which the flight is known to hit nothing but level ground, in s; 0 if unknown.</summary>
    internal double ClearUntil;

    /// <summary>An odd key identifies the scene for which <see cref="ClearUntil"/> holds; an even key, the balls touched in a pile.</summary>
    internal ulong ClearIn;

    /// <summary>True if the ball came to rest in a pile.</summary>
    internal readonly bool RestsInPile => Motion == MotionState.Rest && ClearIn != 0 && (ClearIn & 1) == 0;

    /// <summary>The value of <see cref="ClearIn"/> if several surfaces supported the ball at the end of the last step.</summary>
    /// <remarks>The next step can then skip the search for a free path.</remarks>
    internal const ulong TouchesSeveral = 2;

    /// <summary>The distance through the air since the kick, in m, if a knuckle force depends on it; otherwise 0.</summary>
    internal double AirDistance;

    /// <summary>Always 0: keeps the size of a state and of its bytes. Earlier versions stored limits of the next contact here.</summary>
    internal ulong Reserved;

    /// <summary>Always 0, like <see cref="Reserved"/>.</summary>
    internal ulong ReservedToo;

    /// <inheritdoc/>
    public override readonly string ToString() => ToString(null, CultureInfo.InvariantCulture);

    /// <summary>Formats the motion, time, position, velocity and spin.</summary>
    /// <param name="format">The format of the numbers, such as "F2"; null or empty for up to three decimals, "R" for full precision.</param>
    /// <param name="formatProvider">The culture; default: the invariant culture.</param>
    public readonly string ToString(string? format, IFormatProvider? formatProvider = null)
    {
        format = NumberFormat.OrShort(format);
        IFormatProvider culture = formatProvider ?? CultureInfo.InvariantCulture;
        return $"{Motion} at {Time.ToString(format, culture)} s, {Position.ToString(format, culture)}, {Velocity.ToString(format, culture)} m/s, {Spin.ToString(format, culture)} rad/s";
    }

    /// <summary>Sets the spin of a ball in flight.</summary>
    internal void SetFlightSpin(in Vector3d spin)
    {
        // The current angle refers to the old axis.
        FoldRotation();
        double rate = spin.Length;

        // A spin that is too small to have an axis becomes 0. The axis remains a unit vector.
        bool spins = rate > NoSpin;
        Flight.Axis = spins ? spin / rate : Vector3d.Up;
        Flight.SpinRate = spins ? rate : 0;
    }

    /// <summary>Sets the spin of a ball that is launched or kicked.</summary>
    /// <remarks>A ball that is launched with the <see cref="Spin"/> of this ball gets the same bits.</remarks>
    internal void SetLaunchSpin(in Vector3d spin)
    {
        // Rounding changes the last bits of about 5 % of all spins. Most repeated launches soon keep them.
        SetFlightSpin(in spin);
        for (int i = 0; i < MostLaunches; i++)
        {
            FlightMotion before = Flight;
            SetFlightSpin(Spin);
            if (HasSpinOf(in before))
            {
                return;
            }
        }

        // The others lead to a short cycle: choose its smallest member.
        FlightMotion first = Flight;
        FlightMotion least = Flight;
        for (int i = 0; i < MostLaunches; i++)
        {
            SetFlightSpin(Spin);
            if (HasSpinOf(in first))
            {
                break;
            }

            least = IsSmallerSpin(in Flight, in least) ? Flight : least;
        }

        Flight = least;
    }

    private readonly bool HasSpinOf(in FlightMotion other) => Flight.SpinRate == other.SpinRate && Flight.Axis == other.Axis;

    private static bool IsSmallerSpin(in FlightMotion a, in FlightMotion b) =>
        (a.SpinRate, a.Axis.X, a.Axis.Y, a.Axis.Z).CompareTo((b.SpinRate, b.Axis.X, b.Axis.Y, b.Axis.Z)) < 0;

    /// <summary>Sets the spin of a ball on the ground.</summary>
    internal void SetGroundSpin(in Vector3d spin)
    {
        FoldRotation();

        // On the ground, SpinAxis stores the spin itself, with a rate of 1.
        Flight.Axis = spin;
        Flight.SpinRate = 1;
    }

    /// <summary>Applies the angle to the base orientation, before the axis changes.</summary>
    internal void FoldRotation()
    {
        BaseOrientation = Orientation;
        Angle = 0;
    }

    /// <summary>False if the state was never launched: all its bytes are zero.</summary>
    /// <remarks>A comparison of bits costs one instruction; nearly every launched ball has a W other than 0.</remarks>
    internal readonly bool IsLaunched => BitConverter.DoubleToInt64Bits(BaseOrientation.W) != 0 || BaseOrientation.X != 0 || BaseOrientation.Y != 0 || BaseOrientation.Z != 0;

    /// <summary>Returns the exception for a state that was never launched.</summary>
    internal static ArgumentException NeverLaunched() => new("The state was never launched. Create it with Simulator.Launch or copy it from a Ball.", "state");

    /// <summary>Throws if a state was never launched.</summary>
    internal static void Launched(in BallState state)
    {
        if (!state.IsLaunched)
        {
            throw NeverLaunched();
        }
    }
}

/// <summary>The position, velocity, spin, air distance and turn that a general step integrates.</summary>
internal readonly struct Motion
{
    public readonly Vector3d Position;
    public readonly Vector3d Velocity;
    public readonly Vector3d Spin;

    /// <summary>The distance through the air, in m, if the scene's air needs it.</summary>
    public readonly double AirDistance;

    /// <summary>The rotation vector since the start of the step, in rad, if the scene's air needs the orientation.</summary>
    public readonly Vector3d Turn;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Motion(in Vector3d position, in Vector3d velocity, in Vector3d spin, double airDistance = 0, in Vector3d turn = default)
    {
        Position = position;
        Velocity = velocity;
        Spin = spin;
        AirDistance = airDistance;
        Turn = turn;
    }

    /// <summary>Returns the motion after a time h at constant rates: a stage of an integrator.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Motion After(double h, in Vector3d velocity, in MotionRates rates) =>
        new(Position + (h * velocity), Velocity + (h * rates.Acceleration), Spin + (h * rates.SpinAcceleration), AirDistance + (h * rates.AirSpeed), Turn + (h * rates.Turning));
}

/// <summary>The rates of change of velocity, spin, air distance and turn.</summary>
internal readonly struct MotionRates
{
    public readonly Vector3d Acceleration;
    public readonly Vector3d SpinAcceleration;

    /// <summary>The speed relative to the air, in m/s, if the scene's air needs it.</summary>
    public readonly double AirSpeed;

    /// <summary>The rate of the turn, in rad/s, if the scene's air needs the orientation.</summary>
    public readonly Vector3d Turning;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public MotionRates(in Vector3d acceleration, in Vector3d spinAcceleration, double airSpeed = 0, in Vector3d turning = default)
    {
        Acceleration = acceleration;
        SpinAcceleration = spinAcceleration;
        AirSpeed = airSpeed;
        Turning = turning;
    }

    /// <summary>Returns these rates with that of the turn.</summary>
    /// <param name="at">The motion.</param>
    public MotionRates Turned(in Motion at) => new(in Acceleration, in SpinAcceleration, AirSpeed, RotationVector.Rate(in at.Turn, in at.Spin));
}
