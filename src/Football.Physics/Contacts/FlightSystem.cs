using FootballPhysics.Integration;
using FootballPhysics.State;

namespace FootballPhysics.Contacts;

/// <summary>The equations of flight with the full spin vector: for custom forces, and for the sliding modes at the jump in the drag
/// law.</summary>
internal unsafe struct FlightSystem : IMotionSystem
{
    public Surroundings Around;
    public DragBranch Branch;

    /// <summary>The orientation at the start of the piece; set only if a knuckle force acts.</summary>
    public Quaterniond Orientation;

    /// <summary>The nets that the ball is in, and its side of each.</summary>
    public ulong Nets;
    public ulong NetSides;

    /// <summary>The nets that stay slack for the entire piece; the others stay taut. If null, the velocity decides at each instant.</summary>
    public ulong? NetsSlack;

    public ForceTrace* Trace { get; set; }

    public readonly void Rates(double time, in Motion at, out MotionRates rates)
    {
        if (Branch is not (DragBranch.AlongCriticalSpeed or DragBranch.AlongCriticalSpin))
        {
            rates = On(Branch, time, in at);
            return;
        }

        // Filippov: on the surface of the jump, the weighted mean of both branches keeps the ball on the surface.
        int stages = Trace == null ? 0 : Trace->Count + 1;
        double share = SpinningShare(time, in at, out MotionRates spinning, out MotionRates noSpin);
        if (Trace != null)
        {
            Trace->Count = stages; // both branches have the same custom forces
        }

        share = share < 0 ? 0 : share > 1 ? 1 : share;
        rates = new MotionRates(
            noSpin.Acceleration + (share * (spinning.Acceleration - noSpin.Acceleration)),
            noSpin.SpinAcceleration + (share * (spinning.SpinAcceleration - noSpin.SpinAcceleration)),
            noSpin.AirSpeed,
            in noSpin.Turning);
    }

    public readonly double LongestPart(in Motion at, in MotionRates rates) => Around.World.NetForces.Longest(Nets, NetSides, in at.Position, in at.Velocity);

    public readonly void Move(ref BallState s, in Motion from, in MotionStep step)
    {
        s.Position = step.End.Position;
        s.Velocity = step.End.Velocity;
        s.AirDistance = step.End.AirDistance;
        s.BaseOrientation = (Quaterniond.FromRotationVector(in step.Rotation) * s.Orientation).Normalized();
        s.Angle = 0;

        // Decay never reverses a spin, but a custom force can.
        bool keeps = Around.Air.HasOwnForces || Nets != 0 || Vector3d.Dot(in step.End.Spin, in from.Spin) > 0;
        s.SetFlightSpin(keeps ? step.End.Spin : Vector3d.Zero);
    }

    /// <summary>Returns the rates on one branch of the drag law.</summary>
    public readonly MotionRates On(DragBranch branch, double time, in Motion at)
    {
        MotionRates rates = new FreeForces(Around, branch, MotionState.Airborne, time, in at, Trace, in Orientation).InFlight;
        if (Around.Air.HasSide)
        {
            rates = rates.Turned(in at);
        }

        if (Nets == 0)
        {
            return rates;
        }

        MotionRates nets = Around.World.NetForces.Push(Nets, NetSides, NetsSlack, in at);
        return new MotionRates(rates.Acceleration + nets.Acceleration, rates.SpinAcceleration + nets.SpinAcceleration, rates.AirSpeed, in rates.Turning);
    }

    /// <summary>Returns the share of the spinning branch that keeps the ball on the surface <see cref="Branch"/>.</summary>
    /// <remarks>Outside 0 … 1 the ball leaves it.</remarks>
    public readonly double SpinningShare(double time, in Motion at, out MotionRates spinning, out MotionRates noSpin)
    {
        spinning = On(DragBranch.Spinning, time, in at);
        noSpin = On(DragBranch.NoSpin, time, in at);
        DragJump inside = JumpRate(in at, in spinning);
        DragJump outside = JumpRate(in at, in noSpin);
        bool speed = Branch == DragBranch.AlongCriticalSpeed;
        double a = speed ? inside.Speed : inside.Spin;
        double b = speed ? outside.Speed : outside.Spin;

        // Mix the rates a and b of the two branches so that the ball stays on the jump: s a + (1 − s) b = 0 at s = b/(b − a), which is between 0 and
        // 1 if both branches lead towards the surface.
        return b > a ? b / (b - a) : a > 0 ? 2.0 : -1.0;
    }

    /// <summary>Returns the functions of the jump at a state.</summary>
    public readonly DragJump JumpAt(in Motion at) => DragJump.At(in at, in Around.Wind, Around.Radius);

    /// <summary>Returns the rates of change of these functions.</summary>
    public readonly DragJump JumpRate(in Motion at, in MotionRates rates) => DragJump.Rate(in at, in rates, in Around.Wind, Around.Radius);

    /// <summary>Returns the scale of these rates, |u| |a| and so on: their values if all vectors were parallel.</summary>
    public readonly double JumpRateScale(in Motion at, in MotionRates rates) =>
        DragJump.RateScale(in at, in rates, in Around.Wind, Around.Radius);
}
