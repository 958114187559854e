using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;

namespace FootballPhysics.Simulation;

/// <summary>Whole steps of a ball that rolls or spins between stationary surfaces with no other object near: along a board, in a gutter, in
/// a corner.</summary>
/// <remarks>
/// The surfaces leave one speed and one spin free (<see cref="LineForces"/>). <see cref="TryWhole"/> takes the step, checks it for
/// events, and moves the ball. If an event is possible, it changes nothing, and <see cref="ContactSetPhase{TIntegrator}"/> takes the step
/// in pieces with the general law.
/// </remarks>
/// <typeparam name="TAir">The laws of the air.</typeparam>
internal sealed unsafe class LineStep<TAir> : LineStep
    where TAir : struct, IFlightAir
{
    /// <summary>The search radius is this multiple of the distance covered at the current speed, plus <see cref="ContactTolerances.LineRoom"/>.</summary>
    /// <remarks>No other object may be nearer.</remarks>
    private const double Faster = 1.5;

    /// <summary>Maximum share of a slip that one step may remove: on surfaces with a constant normal, and on other surfaces.</summary>
    private const double MostOfSlip = 0.75;
    private const double MostOfSlipOnCurve = 0.125;

    private readonly World _world;
    private readonly StabilityLimit _limit;
    private readonly BallProperties _ball;
    private readonly int _order;
    private readonly double _radius;
    private readonly SlideStep<TAir> _slide;
    private SetAir<TAir> _air;

    public LineStep(Surroundings around, in TAir air, in StabilityLimit limit, int order)
    {
        _world = around.World;
        _limit = limit;
        _ball = _world.Ball;
        _order = order;
        _radius = around.Radius;
        _air = new SetAir<TAir>(around, in air);
        _slide = new SlideStep<TAir>(_world, in _air, in limit, order);
    }

    /// <summary>True if this class covers the scene: all air forces act on the ground, and the drag law does not jump.</summary>
    public static bool Covers(Surroundings around, int order) =>
        order is 2 or 4 && !around.World.IsBare && around.World.SharesAir && !around.Air.Laws.Jumps && !around.Air.HasOwnForces;

    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    public override bool TryWhole(ref BallState s, double dt, double end, StepLog log)
    {
        if (!(s.Motion is MotionState.Rolling or MotionState.Sliding) || s.Nets != 0 || s.GoalsEntered != 0)
        {
            return false;
        }

        // Find the touched surfaces, with no other object within reach.
        double room = ContactTolerances.LineRoom + (Faster * dt * s.Velocity.Length);
        Touched* set = stackalloc Touched[Touched.Most];
        int count = Touched.Find(_world, in s, dt, room, set);
        if (s.Motion == MotionState.Sliding)
        {
            return count == 2 && _slide.TryWhole(ref s, dt, end, room, in set[0], in set[1], log);
        }

        if (count < 2 || !Proposes(in s, dt, set, count, out Line line, out LineForces forces))
        {
            return false;
        }

        Integrate(in s, in forces, in line, dt, out LineEnd step);

        // Reject the step if a load, friction cone, slip, roll or spin may end, the ball may rest, or the carrier or material may change. The last
        // stage is at the end (RK4) or in the middle (RK2) of the step.
        double share = _order == 4 ? Clear : 0.5 * (1.0 + Clear);
        if (!step.Rates.Keeps(in line.Rates, share) || !line.Keeps(in forces, step.Speed, step.About, share) || !(Math.Abs(step.Way) <= room) || !IsCarried(in line, in step.Rates)
            || (line.ComparesLoads && !(HeavierBy(in step.Rates) > share * HeavierBy(in line.Rates)))
            || !(Energy(in forces, step.Speed, step.About) - _world.RestEnergy > share * (line.Energy - _world.RestEnergy)))
        {
            return false;
        }

        Vector3d position = forces.Pinned ? s.Position : s.Position + (step.Way * forces.Along);
        for (int i = 0; i < count && !forces.Pinned; i++)
        {
            if (!Touched.KeepsSurface(_world, in set[i], in s, in position))
            {
                return false;
            }
        }

        // There is no event: move the ball.
        log.Evaluations += _order;
        log.Steps++;
        Vector3d middleSpin = SpinOf(in forces, step.MiddleSpeed, step.MiddleAbout);
        Vector3d endSpin = SpinOf(in forces, step.EndSpeed, step.EndAbout);
        Vector3d startSpin = SpinOf(in forces, line.Speed, line.About);
        Vector3d turn = _order == 4 ? RotationVector.Of(in startSpin, in middleSpin, in endSpin, dt) : RotationVector.OfMean(in middleSpin, in startSpin, in endSpin, dt);
        if (log.IsWatched)
        {
            BallState before = s;
            Touched.Move(ref s, in position, step.EndSpeed * forces.Along, in endSpin, in turn, end);
            Show(log, in before, in s, in forces, in line.Rates, step.Way, step.EndSpeed, step.EndAbout);
            return true;
        }

        Touched.Move(ref s, in position, step.EndSpeed * forces.Along, in endSpin, in turn, end);
        return true;
    }

    /// <summary>Evaluates the integrator's stages; each starts from the initial state, with the rates of the previous stage.</summary>
    private void Integrate(in BallState s, in LineForces forces, in Line line, double dt, out LineEnd step)
    {
        LineRates first = line.Rates;
        double half = 0.5 * dt;
        step.MiddleSpeed = line.Speed + (half * first.Along);
        step.MiddleAbout = line.About + (half * first.About);
        RatesAt(in s, in forces, half, half * line.Speed, step.MiddleSpeed, step.MiddleAbout, out LineRates second);
        if (_order == 4)
        {
            double thirdSpeed = line.Speed + (half * second.Along);
            double thirdAbout = line.About + (half * second.About);
            RatesAt(in s, in forces, half, half * step.MiddleSpeed, thirdSpeed, thirdAbout, out LineRates third);
            step.Speed = line.Speed + (dt * third.Along);
            step.About = line.About + (dt * third.About);
            RatesAt(in s, in forces, dt, dt * thirdSpeed, step.Speed, step.About, out step.Rates);
            step.Way = ClassicalRungeKutta.Sum(dt, line.Speed, step.MiddleSpeed, thirdSpeed, step.Speed);
            step.EndSpeed = line.Speed + ClassicalRungeKutta.Sum(dt, first.Along, second.Along, third.Along, step.Rates.Along);
            step.EndAbout = line.About + ClassicalRungeKutta.Sum(dt, first.About, second.About, third.About, step.Rates.About);
            step.MiddleSpeed = 0.5 * (step.MiddleSpeed + thirdSpeed);
            step.MiddleAbout = 0.5 * (step.MiddleAbout + thirdAbout);
        }
        else
        {
            step.Rates = second;
            step.Speed = step.MiddleSpeed;
            step.About = step.MiddleAbout;
            step.Way = dt * step.Speed;
            step.EndSpeed = line.Speed + (dt * second.Along);
            step.EndAbout = line.About + (dt * second.About);
        }
    }

    /// <summary>Reports the step to the observers.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Show(StepLog log, in BallState before, in BallState after, in LineForces forces, in LineRates first, double way, double speed, double about)
    {
        LineRates last = default;
        Vector3d start = first.Along * forces.Along;
        if (log.WantsEnd(in before, in after, in start))
        {
            RatesAt(in before, in forces, after.Time - before.Time, way, speed, about, out last);
            log.Evaluations++;
        }

        log.Show(in before, in after, in start, last.Along * forces.Along, _order);
    }

    /// <summary>Determines the contact modes at the start. Modes that need a search are left to the general law.</summary>
    [SkipLocalsInit]
    private bool Proposes(in BallState s, double dt, Touched* set, int count, out Line line, out LineForces forces)
    {
        Unsafe.SkipInit(out forces);
        forces.Modes = LineModes.Roll;
        line = default;
        int bearer = 0;
        while (bearer < count && set[bearer].Collider + _world.FirstCollider != s.Carrier)
        {
            bearer++;
        }

        if (bearer == count)
        {
            return false;
        }

        Vector3d spin = s.Spin;
        _air.At(s.Time, s.Position, s.Velocity, in spin, out Vector3d push, out Vector3d torque);
        int other = bearer == 0 ? 1 : 0;
        int idle = -1;
        double about = Vector3d.Dot(in spin, in set[bearer].Normal);
        if (count > 2 && !ChooseOfThree(set, in push, in torque, about, bearer, ref other, out idle, ref forces))
        {
            return false;
        }

        ref readonly Touched first = ref set[bearer];
        ref readonly Touched second = ref set[other];
        if (forces.Modes != LineModes.Spot && !forces.Prepare(in first, in second, _ball))
        {
            return false;
        }

        // The ball must move along the line, without slip at the bearer.
        double speed = Vector3d.Dot(s.Velocity, in forces.Along);
        if (!((s.Velocity - (speed * forces.Along)).Length + (_radius * (spin - SpinOf(in forces, speed, about)).Length) <= ContactTolerances.OffLine))
        {
            return false;
        }

        double slip = forces.Slip(speed, about);
        forces.SpinSign = about > ContactTolerances.Rolling ? 1.0 : about < -ContactTolerances.Rolling ? -1.0 : 0.0;
        forces.HoldsSpin = forces.SpinSign == 0 && forces.Drills;
        forces.Direction = speed < 0 ? -1.0 : 1.0;
        forces.SlipSign = slip < 0 ? -1.0 : 1.0;
        line.Slips = second.Sliding > 0;
        bool stands = !(Math.Abs(speed) >= ContactTolerances.Rolling);
        if (Math.Abs(slip) < ContactTolerances.Sticking && line.Slips)
        {
            if (count > 2 || stands || Math.Abs(slip) > ContactTolerances.OffLine || !FindBearer(set, in push, in torque, speed, bearer, other, ref line, ref forces))
            {
                return false;
            }

            speed = line.Speed;
            about = 0;
            line.Slips = false;
        }
        else
        {
            // At a standstill, rolling resistance must hold the ball in place.
            forces.Pinned = stands;
            speed = stands ? 0 : speed;
            about = forces.HoldsSpin ? 0 : about;
            forces.Evaluate(in push, in torque, speed, about, out line.Rates);
            if (forces.Modes == LineModes.Roll && stands && !forces.Holds(in push, line.Rates.Load))
            {
                return false;
            }
        }

        // If the ball stays in one spot, an unloaded surface stays unloaded, and the normal of a curved surface is constant.
        line.HasThird = forces.Modes == LineModes.Spot;
        bool areFixed = first.IsFixed && second.IsFixed && idle < 0;
        line.Speed = speed;
        line.About = about;
        line.Energy = Energy(in forces, speed, about);
        return line.Rates.IsValid && (forces.Pinned || areFixed) && line.Energy > _world.RestEnergy * (1.0 + ContactTolerances.AtRest) && IsShort(in s, dt, set, count, in line, in forces, in second, areFixed);
    }

    /// <summary>Chooses the active contacts among three surfaces.</summary>
    /// <remarks>
    /// It keeps all three if each has a load. Otherwise it drops the most negative load, or the one that the push does not press against.
    /// </remarks>
    private bool ChooseOfThree(Touched* set, in Vector3d push, in Vector3d torque, double about, int bearer, ref int other, out int idle, ref LineForces forces)
    {
        int third = 3 - bearer - other;
        idle = third;
        Vector3d* normals = stackalloc Vector3d[3] { set[0].Normal, set[1].Normal, set[2].Normal };
        if (PushProjection.ArePlanar(normals))
        {
            PushProjection free = PushProjection.Of(normals, 3, in push);
            idle = free.Bears(other) ? third : other;
            other = free.Bears(other) ? other : third;
            return PushProjection.Surround(normals) && free.Second >= 0 && free.Bears(bearer);
        }

        // A ball that spins in one spot slips at both other surfaces. The sign of their loads does not depend on rolling resistance.
        double sign = about < 0 ? -1.0 : 1.0;
        forces.SpinSign = sign;
        if (!forces.Prepare(in set[bearer], in set[other], _ball) || !forces.Close(in set[third], sign) || !(forces.ThirdSlip(about) >= ContactTolerances.Sticking))
        {
            return false;
        }

        forces.Evaluate(in push, in torque, 0, about, out LineRates rates);
        double least = Math.Min(rates.Other, rates.Third);
        if (least > ContactTolerances.LeastLoad)
        {
            idle = -1;
            return true;
        }

        forces.Modes = LineModes.Roll;
        idle = rates.Third <= rates.Other ? third : other;
        other = rates.Third <= rates.Other ? other : third;
        return rates.Load > least;
    }

    /// <summary>Chooses the bearer if both surfaces stick: the one with the greater load.</summary>
    /// <remarks>If each surface is the bearer under its own resistance, keep the current carrier. If the loads are equal, take the first
    /// surface.</remarks>
    private bool FindBearer(Touched* set, in Vector3d push, in Vector3d torque, double speed, int bearer, int other, ref Line line, ref LineForces forces)
    {
        Prepare(set, in push, in torque, speed, bearer, other, ref line, ref forces);
        bool isBearer = !IsHeavier(in line.Rates, other < bearer);
        line.ComparesLoads = true;
        if (isBearer)
        {
            return forces.SpinSign != 0 || !forces.Drills;
        }

        Prepare(set, in push, in torque, speed, other, bearer, ref line, ref forces);
        line.CarrierIsOther = true;
        if (IsHeavier(in line.Rates, bearer < other))
        {
            line.ComparesLoads = false;
            if (bearer < other)
            {
                Prepare(set, in push, in torque, speed, bearer, other, ref line, ref forces);
                line.CarrierIsOther = false;
            }
        }

        return forces.SpinSign != 0 || !forces.Drills;
    }

    /// <summary>Computes the forces with two sticking contacts.</summary>
    private void Prepare(Touched* set, in Vector3d push, in Vector3d torque, double speed, int bearer, int other, ref Line line, ref LineForces forces)
    {
        Vector3d along = forces.Along;
        forces.Prepare(in set[bearer], in set[other], _ball);
        forces.StickBoth();
        line.Speed = Vector3d.Dot(in along, in forces.Along) < 0 ? -speed : speed;
        forces.Direction = line.Speed < 0 ? -1.0 : 1.0;
        double about = forces.AboutNormal(line.Speed, 0);
        forces.SpinSign = about > ContactTolerances.Rolling ? 1.0 : about < -ContactTolerances.Rolling ? -1.0 : 0.0;
        forces.Evaluate(in push, in torque, line.Speed, 0, out line.Rates);
    }

    /// <summary>True if the other surface is the bearer: its load is greater, or equal and it comes first.</summary>
    private static bool IsHeavier(in LineRates rates, bool otherIsFirst) =>
        otherIsFirst ? !(rates.Load > rates.Other * (1.0 + ContactTolerances.SameLoad)) : rates.Other > rates.Load * (1.0 + ContactTolerances.SameLoad);

    private static double HeavierBy(in LineRates rates) => (rates.Load * (1.0 + ContactTolerances.SameLoad)) - rates.Other;

    /// <summary>True if the current carrier keeps enough load to stay the carrier (<see cref="ContactSet.Named"/>).</summary>
    private static bool IsCarried(in Line line, in LineRates rates)
    {
        double carrier = line.CarrierIsOther ? rates.Other : rates.Load;
        double other = line.CarrierIsOther ? rates.Load : rates.Other;
        return carrier > ContactSet.AboutAsMuch * other && (!line.HasThird || carrier > ContactSet.AboutAsMuch * rates.Third);
    }

    /// <summary>True if a step is short enough for the forces and for the change of the slip.</summary>
    private bool IsShort(in BallState s, double dt, Touched* set, int count, in Line line, in LineForces forces, in Touched other, bool areFixed)
    {
        double damping = 0;
        for (int i = 0; i < count; i++)
        {
            damping = Math.Max(damping, set[i].Damping);
        }

        double gain = dt * other.Sliding * (line.Rates.Other + (line.HasThird ? line.Rates.Third : 0));
        double airSpeed = (s.Velocity - _air.Wind).Length + _air.FastestWind + gain;
        double slip = forces.Slip(line.Speed, line.About);
        double closing = -dt * forces.Slip(line.Rates.Along, line.Rates.About);
        return dt * (_limit.RateAtMost(airSpeed, s.Spin.Length) + damping) <= StabilityLimit.LargestChange
            && (!line.Slips || (slip < 0 ? -closing : closing) <= (areFixed ? MostOfSlip : MostOfSlipOnCurve) * Math.Abs(slip));
    }

    /// <summary>½ m v² + ½ I ω², J.</summary>
    private double Energy(in LineForces forces, double speed, double about) =>
        (0.5 * _ball.Mass * speed * speed) + (0.5 * _ball.MomentOfInertia * SpinOf(in forces, speed, about).LengthSquared);

    private static Vector3d SpinOf(in LineForces forces, double speed, double about) => (speed * forces.SpinPerSpeed) + (about * forces.Normal);

    /// <summary>Computes the rates at a stage.</summary>
    private void RatesAt(in BallState s, in LineForces forces, double after, double way, double speed, double about, out LineRates rates)
    {
        _air.At(s.Time + after, s.Position + (way * forces.Along), speed * forces.Along, SpinOf(in forces, speed, about), out Vector3d push, out Vector3d torque);
        forces.Evaluate(in push, in torque, speed, about, out rates);
    }

    /// <summary>The motion at the start of a step.</summary>
    private struct Line
    {
        /// <summary>Speed along the line, m/s; spin about the normal, rad/s; energy, J.</summary>
        public double Speed;
        public double About;
        public double Energy;
        public LineRates Rates;

        /// <summary>True if the other surface has friction.</summary>
        public bool Slips;

        /// <summary>True if three surfaces have a load.</summary>
        public bool HasThird;

        /// <summary>True if the current carrier has less load than the other surface.</summary>
        public bool CarrierIsOther;

        /// <summary>True if the bearer is the surface with the greater load.</summary>
        public bool ComparesLoads;

        /// <summary>True if the slip, the roll and the spin about the normal keep a share of their values.</summary>
        public readonly bool Keeps(in LineForces forces, double speed, double about, double share)
        {
            double slip = forces.Modes == LineModes.Wedge ? 0 : forces.Slip(Speed, About);
            return (!Slips || slip == 0 || forces.Slip(speed, about) / slip > share)
                && (forces.Pinned || speed / Speed > share)
                && (forces.SpinSign == 0 || !forces.Drills || forces.AboutNormal(speed, about) / forces.AboutNormal(Speed, About) > share);
        }
    }

    /// <summary>The end of a step: its length, and the motion at the middle, at the last stage and at the end.</summary>
    private struct LineEnd
    {
        public double Way;
        public double MiddleSpeed;
        public double MiddleAbout;

        /// <summary>The last stage.</summary>
        public double Speed;
        public double About;
        public LineRates Rates;
        public double EndSpeed;
        public double EndAbout;
    }
}
