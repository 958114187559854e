namespace FootballPhysics;

/// <summary>A ball in flight with its full spin vector: for the game's own forces, and for the sliding modes of the drag law's jump.</summary>
internal struct FlightSystem : IMotionSystem
{
    public Surroundings Around;
    public DragBranch Branch;

    /// <summary>The nets that the ball is in, and on which side of each.</summary>
    public ulong Nets;
    public ulong NetSides;

    public readonly void Rates(double time, in Motion at, out MotionRates rates)
    {
        if (Branch is not (DragBranch.AlongCriticalSpeed or DragBranch.AlongCriticalSpin))
        {
            rates = On(Branch, time, in at);
            return;
        }

        // Filippov: on the surface the motion is the mean of both branches that stays on it.
        double share = SpinningShare(time, in at, out MotionRates spinning, out MotionRates noSpin);
        share = share < 0 ? 0 : share > 1 ? 1 : share;
        rates = new MotionRates(
            noSpin.Acceleration + (share * (spinning.Acceleration - noSpin.Acceleration)),
            noSpin.SpinAcceleration + (share * (spinning.SpinAcceleration - noSpin.SpinAcceleration)));
    }

    public readonly double LongestPart(in Motion at, double jerk) => Around.World.LongestPartInNets(Nets, NetSides, in at, jerk);

    public readonly void Move(ref BallState s, in Motion from, in MotionStep step)
    {
        s.Position = step.End.Position;
        s.Velocity = step.End.Velocity;
        s.AirDistance = step.End.AirDistance;
        s.BaseOrientation = (Quaterniond.FromRotationVector(in step.Rotation) * s.Orientation).Normalized();
        s.Angle = 0;

        // Decay never reverses a spin; a force of the game's own may.
        bool keeps = Around.Air.TurnsAxis || Nets != 0 || Vector3d.Dot(in step.End.Spin, in from.Spin) > 0;
        s.SetFlightSpin(keeps ? step.End.Spin : Vector3d.Zero);
    }

    /// <summary>The rates on one branch of the drag law.</summary>
    public readonly MotionRates On(DragBranch branch, double time, in Motion at)
    {
        Surroundings around = Around;
        Vector3d u = at.Velocity - around.Wind;
        var ball = new ForceContext(time, in at.Position, in at.Velocity, in u, in at.Spin, MotionState.Airborne, at.AirDistance);
        around.Air.Evaluate(in ball, branch, out AirFactors air);
        MotionRates rates = air.Rates(in at.Spin, in around.Weight, around.Air.Varies);
        if (Nets == 0)
        {
            return rates;
        }

        MotionRates nets = around.World.PushOfNets(Nets, NetSides, in at);
        return new MotionRates(rates.Acceleration + nets.Acceleration, rates.SpinAcceleration + nets.SpinAcceleration, rates.AirSpeed);
    }

    /// <summary>The share of the branch with spin for which the surface that <see cref="Branch"/> names is not left: outside 0 … 1 it is.</summary>
    public readonly double SpinningShare(double time, in Motion at, out MotionRates spinning, out MotionRates noSpin)
    {
        spinning = On(DragBranch.Spinning, time, in at);
        noSpin = On(DragBranch.NoSpin, time, in at);
        DragJump inside = JumpRate(in at, in spinning);
        DragJump outside = JumpRate(in at, in noSpin);
        bool speed = Branch == DragBranch.AlongCriticalSpeed;
        double a = speed ? inside.Speed : inside.Spin;
        double b = speed ? outside.Speed : outside.Spin;

        // s a + (1 − s) b = 0 at s = b/(b − a): between 0 and 1 where the two laws push towards the surface from both sides.
        return b > a ? b / (b - a) : a > 0 ? 2.0 : -1.0;
    }

    /// <summary>The jump's functions at a state.</summary>
    public readonly DragJump JumpAt(in Motion at) => DragJump.At(in at, in Around.Wind, Around.Radius);

    /// <summary>Their rates of change.</summary>
    public readonly DragJump JumpRate(in Motion at, in MotionRates rates) => DragJump.Rate(in at, in rates, in Around.Wind, Around.Radius);

    /// <summary>Scale of those rates, for velocity parallel to acceleration and spin to its change: |u| |a| and so on, in the same units.</summary>
    public readonly double JumpRateScale(in Motion at, in MotionRates rates) =>
        DragJump.RateScale(in at, in rates, in Around.Wind, Around.Radius);
}
