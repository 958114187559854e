using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;

namespace FootballPhysics.Simulation;

/// <summary>Whole steps of a ball that slips on two stationary surfaces at once (<see cref="SlideForces"/>), with the rules of <see cref="LineStep{TAir}"/>.</summary>
/// <typeparam name="TAir">The laws of the air.</typeparam>
internal sealed class SlideStep<TAir>
    where TAir : struct, IFlightAir
{
    private readonly World _world;
    private readonly StabilityLimit _limit;
    private readonly BallProperties _ball;
    private readonly int _order;
    private SetAir<TAir> _air;

    public SlideStep(World world, in SetAir<TAir> air, in StabilityLimit limit, int order)
    {
        _world = world;
        _limit = limit;
        _ball = world.Ball;
        _order = order;
        _air = air;
    }

    /// <summary>Tries a whole step, and completes it if no event is possible.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="end">End time, s.</param>
    /// <param name="room">Maximum distance the ball may travel, m.</param>
    /// <param name="one">The first surface.</param>
    /// <param name="two">The second surface.</param>
    /// <param name="log">Receives the counts.</param>
    /// <returns>False if an event is possible; the ball is then unchanged.</returns>
    [SkipLocalsInit]
    public bool TryWhole(ref BallState s, double dt, double end, double room, in Touched one, in Touched two, StepLog log)
    {
        if (!Proposes(in s, dt, in one, in two, out SlideForces forces, out Slide from, out SlideRates first))
        {
            return false;
        }

        // Evaluate the integrator's stages; each starts from the initial state, with the rates of the previous stage.
        double half = 0.5 * dt;
        Slide second = from.After(half, in first);
        RatesAt(in s, in forces, half, half * from.Speed, in second, out SlideRates rates);
        Slide middle = second;
        Slide last = second;
        Slide final;
        double way;
        double fastest = Math.Max(Math.Abs(from.Speed), Math.Abs(second.Speed));
        if (_order == 4)
        {
            SlideRates ofSecond = rates;
            Slide third = from.After(half, in ofSecond);
            RatesAt(in s, in forces, half, half * second.Speed, in third, out SlideRates ofThird);
            last = from.After(dt, in ofThird);
            RatesAt(in s, in forces, dt, dt * third.Speed, in last, out rates);
            way = ClassicalRungeKutta.Sum(dt, from.Speed, second.Speed, third.Speed, last.Speed);
            final.Speed = from.Speed + ClassicalRungeKutta.Sum(dt, first.Along, ofSecond.Along, ofThird.Along, rates.Along);
            final.Spin = from.Spin + ClassicalRungeKutta.Sum(dt, in first.Spin, in ofSecond.Spin, in ofThird.Spin, in rates.Spin);
            middle.Spin = 0.5 * (second.Spin + third.Spin);
            fastest = Math.Max(fastest, Math.Max(Math.Abs(third.Speed), Math.Abs(last.Speed)));
        }
        else
        {
            way = dt * second.Speed;
            final = from.After(dt, in rates);
        }

        // The same conservative checks as for a line. The last stage is at the end (RK4) or in the middle (RK2) of the step.
        double share = _order == 4 ? LineStep.Clear : 0.5 * (1.0 + LineStep.Clear);
        Vector3d position = s.Position + (way * forces.Along);
        if (!(dt * fastest <= room) || !Keeps(in forces, in from, in first, in last, in rates, share, one.Collider + _world.FirstCollider == s.Carrier)
            || !Touched.KeepsSurface(_world, in one, in s, in position) || !Touched.KeepsSurface(_world, in two, in s, in position))
        {
            return false;
        }

        // There is no event: move the ball.
        log.Evaluations += _order;
        log.Steps++;
        Vector3d turn = _order == 4 ? RotationVector.Of(in from.Spin, in middle.Spin, in final.Spin, dt) : RotationVector.OfMean(in middle.Spin, in from.Spin, in final.Spin, dt);
        if (log.IsWatched)
        {
            BallState before = s;
            Touched.Move(ref s, in position, final.Speed * forces.Along, in final.Spin, in turn, end);
            Show(log, in before, in s, in forces, first.Along, way, in final);
            return true;
        }

        Touched.Move(ref s, in position, final.Speed * forces.Along, in final.Spin, in turn, end);
        return true;
    }

    /// <summary>Computes the forces at the start, and checks that a whole step is possible.</summary>
    private bool Proposes(in BallState s, double dt, in Touched one, in Touched two, out SlideForces forces, out Slide from, out SlideRates rates)
    {
        Unsafe.SkipInit(out forces);
        Unsafe.SkipInit(out rates);
        from.Spin = s.Spin;
        from.Speed = 0;
        if (!one.IsFixed || !two.IsFixed || !forces.Prepare(in one, in two, _ball))
        {
            return false;
        }

        // Require a velocity along the line, with slip at both surfaces.
        from.Speed = Vector3d.Dot(s.Velocity, in forces.Along);
        Vector3d first = forces.FirstSlip(from.Speed, in from.Spin);
        Vector3d second = forces.SecondSlip(from.Speed, in from.Spin);
        double firstSize = first.Length;
        double secondSize = second.Length;
        if (!((s.Velocity - (from.Speed * forces.Along)).Length <= ContactTolerances.OffLine) || !(firstSize >= ContactTolerances.Sticking) || !(secondSize >= ContactTolerances.Sticking))
        {
            return false;
        }

        forces.FirstDirection = first / firstSize;
        forces.SecondDirection = second / secondSize;
        _air.At(s.Time, s.Position, s.Velocity, in from.Spin, out Vector3d push, out Vector3d torque);
        forces.Load(in push, in forces.FirstDirection, in forces.SecondDirection, out rates.First, out rates.Second);

        // The loads do not depend on the choice of bearer, so choose the bearer by load.
        bool isSecond = rates.Second > rates.First * (1.0 + ContactTolerances.SameLoad);
        forces.Bear(isSecond, isSecond ? two : one, ref from.Spin);
        forces.Evaluate(in push, in torque, from.Speed, in from.Spin, out rates);

        double gain = dt * ((one.Sliding * rates.First) + (two.Sliding * rates.Second));
        double airSpeed = (s.Velocity - _air.Wind).Length + _air.FastestWind + gain;
        return rates.First > ContactTolerances.LeastLoad && rates.Second > ContactTolerances.LeastLoad && rates.HoldSpin > 0 && Energy(in from) > _world.RestEnergy * (1.0 + ContactTolerances.AtRest)
            && dt * (_limit.RateAtMost(airSpeed, from.Spin.Length) + Math.Max(one.Damping, two.Damping)) <= StabilityLimit.LargestChange
            && IsShort(dt, in forces.FirstDirection, firstSize, forces.FirstSlip(rates.Along, in rates.Spin), one.Sliding)
            && IsShort(dt, in forces.SecondDirection, secondSize, forces.SecondSlip(rates.Along, in rates.Spin), two.Sliding);
    }

    /// <summary>True if the slip changes so little in the step that the integrator can follow it.</summary>
    private static bool IsShort(double dt, in Vector3d direction, double size, in Vector3d rate, double sliding) =>
        !(sliding > 0) || TurnLimit.Shorten(dt, dt, in direction, size, in rate, isFlat: true) >= dt;

    /// <summary>True if every quantity that could end a piece keeps a share of its value, and the carrier's load is still large
    /// enough.</summary>
    /// <remarks>The quantities: loads, slips, the bearer's lead in load, the spin about its normal, and the energy above rest.</remarks>
    private bool Keeps(in SlideForces forces, in Slide from, in SlideRates first, in Slide last, in SlideRates rates, double share, bool isFirstCarrier)
    {
        double carrier = isFirstCarrier ? rates.First : rates.Second;
        double other = isFirstCarrier ? rates.Second : rates.First;
        return rates.First > share * first.First && rates.Second > share * first.Second && carrier > ContactSet.AboutAsMuch * other
            && rates.HoldSpin > share * first.HoldSpin && Lead(in forces, in rates) > share * Lead(in forces, in first)
            && Vector3d.Dot(forces.FirstSlip(last.Speed, in last.Spin), in forces.FirstDirection) > share * Vector3d.Dot(forces.FirstSlip(from.Speed, in from.Spin), in forces.FirstDirection)
            && Vector3d.Dot(forces.SecondSlip(last.Speed, in last.Spin), in forces.SecondDirection) > share * Vector3d.Dot(forces.SecondSlip(from.Speed, in from.Spin), in forces.SecondDirection)
            && (!forces.Drills || forces.About(in last.Spin) / forces.About(in from.Spin) > share)
            && Energy(in last) - _world.RestEnergy > share * (Energy(in from) - _world.RestEnergy);
    }

    /// <summary>Difference between the bearer's load and the other load, m/s².</summary>
    private static double Lead(in SlideForces forces, in SlideRates rates) =>
        forces.IsSecondBearer ? (rates.Second * (1.0 + ContactTolerances.SameLoad)) - rates.First : (rates.First * (1.0 + ContactTolerances.SameLoad)) - rates.Second;

    /// <summary>½ m v² + ½ I ω², J.</summary>
    private double Energy(in Slide at) => (0.5 * _ball.Mass * at.Speed * at.Speed) + (0.5 * _ball.MomentOfInertia * at.Spin.LengthSquared);

    /// <summary>Computes the rates at a stage.</summary>
    private void RatesAt(in BallState s, in SlideForces forces, double after, double way, in Slide at, out SlideRates rates)
    {
        _air.At(s.Time + after, s.Position + (way * forces.Along), at.Speed * forces.Along, in at.Spin, out Vector3d push, out Vector3d torque);
        forces.Evaluate(in push, in torque, at.Speed, in at.Spin, out rates);
    }

    /// <summary>Reports the step to the observers.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Show(StepLog log, in BallState before, in BallState after, in SlideForces forces, double startAlong, double way, in Slide final)
    {
        SlideRates last = default;
        Vector3d start = startAlong * forces.Along;
        if (log.WantsEnd(in before, in after, in start))
        {
            RatesAt(in before, in forces, after.Time - before.Time, way, in final, out last);
            log.Evaluations++;
        }

        log.Show(in before, in after, in start, last.Along * forces.Along, _order);
    }

    /// <summary>The motion: speed along the line, m/s, and spin, rad/s.</summary>
    private struct Slide
    {
        public double Speed;
        public Vector3d Spin;

        public readonly Slide After(double h, in SlideRates rates) => new() { Speed = Speed + (h * rates.Along), Spin = Spin + (h * rates.Spin) };
    }
}
