using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Rolling on the ground, piece by piece: up to the drag law's jump, or to rest.</summary>
internal sealed class RollPhase<TAir, TIntegrator>
    where TAir : struct, IAir
    where TIntegrator : struct, IIntegrator
{
    /// <summary>A correction of the instant of rest, s, that is no longer worth a step.</summary>
    private const double Located = 1e-12;

    private readonly Surroundings<TAir> _around;
    private readonly GroundLimit<TAir> _limit;
    private readonly DragJumpGuard<TAir> _jump;
    private readonly ContactPhase<TAir> _contact;
    private readonly ImplicitPhase<TAir> _implicit;
    private readonly RollingSystem<TAir> _system;
    private readonly TIntegrator _integrator;
    private readonly double _rolling;
    private readonly double _restEnergy;
    private readonly double _mass;
    private readonly double _momentOfInertia;

    public RollPhase(
        Scene scene,
        Surroundings<TAir> around,
        in GroundLimit<TAir> limit,
        DragJumpGuard<TAir> jump,
        ContactPhase<TAir> contact,
        ImplicitPhase<TAir> implicitPhase)
    {
        _around = around;
        _limit = limit;
        _jump = jump;
        _contact = contact;
        _implicit = implicitPhase;
        _system = new RollingSystem<TAir> { Around = around };
        _integrator = default;
        _rolling = around.Ground.Rolling;
        _restEnergy = scene.Ground.RestEnergy;
        _mass = scene.Ball.Mass;
        _momentOfInertia = scene.Ball.MomentOfInertia;
    }

    /// <summary>
    /// A whole step of rolling, done if nothing happens in it: nearly every step on the ground. It is the piece that <see cref="Take"/> would
    /// take, in one body, so that the motion stays in registers.
    /// </summary>
    /// <returns>False where something may happen; then nothing is done.</returns>
    [MethodImpl(Hot.Path)]
    public bool TryWhole(ref BallState s, double dt, StepLog log)
    {
        // Propose: the whole step, if the direction does not turn too fast in it, and the air is not too strong.
        var from = new PlanarMotion(in s);
        DragBranch branch = _jump.OnGround(s.Branch, in from);
        double speedSquared = from.SpeedSquared;
        double speed = Math.Sqrt(speedSquared);
        double airRate = _limit.RateAtMost(in from, out double airSpeed);
        if (!(dt * airRate <= StabilityLimit.LargestChange) || !(speed >= Slip.Rolling)
            || (_rolling + (airRate * airSpeed)) * dt > GroundLimit<TAir>.Approach * speed
            || KineticEnergy(speedSquared, from.SpinSquared) < _restEnergy)
        {
            return false;
        }

        // Take it.
        RollingSystem<TAir> system;
        system.Around = _around;
        system.Branch = branch;
        system.DirectionX = from.VX / speed;
        system.DirectionZ = from.VZ / speed;
        system.Pinned = false;
        TIntegrator integrator = default;
        integrator.Advance(ref system, s.Time, in from, dt, out PlanarStep taken);

        // Guards: the drag law's jump, rest.
        if (_jump.MayCrossOnGround(branch, in from, in taken, dt) || KineticEnergy(taken.End.SpeedSquared, taken.End.SpinSquared) < _restEnergy)
        {
            return false;
        }

        // Nothing happened: move the ball.
        log.Evaluations += integrator.Stages;
        log.Steps++;
        s.Branch = branch;
        if (log.Observer is null)
        {
            system.Move(ref s, in taken);
            s.Time += dt;
        }
        else
        {
            log.MoveAndShow(ref s, ref system, in taken, dt, integrator.Order);
        }

        return true;
    }

    /// <summary>The next piece of a roll.</summary>
    public void Take(ref BallState s, ref StepRun run)
    {
        if (_contact.LeavesGround(ref s, ref run))
        {
            return;
        }

        var from = new PlanarMotion(in s);
        double energy = KineticEnergy(from.SpeedSquared, from.SpinSquared);
        if (energy < _restEnergy)
        {
            _contact.Rest(ref s, ref run);
            return;
        }

        double speed = Math.Sqrt(from.SpeedSquared);
        s.Branch = _jump.OnGround(s.Branch, in from);
        RollingSystem<TAir> system = _system;
        system.Branch = s.Branch;
        double asked = run.Next;
        double airRate = _limit.RateAtMost(in from, out double airSpeed);
        double h = _limit.PartOf(asked, airRate, in from, s.Branch);
        if (h <= 0)
        {
            _implicit.Slow(ref s, ref run);
            return;
        }

        run.Keep(h, asked);
        if (speed < Slip.Rolling)
        {
            from.VX = 0;
            from.VZ = 0;
            from.WX = 0;
            from.WZ = 0;
            GroundPush.On(_around, s.Branch, MotionState.Rolling, s.Time, in from, out GroundPush push);
            run.Log.Evaluations++;
            double pushSize = Math.Sqrt((push.X * push.X) + (push.Z * push.Z));
            system.Pinned = pushSize <= _around.Ground.Rolling;
            system.DirectionX = pushSize > 0 ? push.X / pushSize : 0;
            system.DirectionZ = pushSize > 0 ? push.Z / pushSize : 0;
        }
        else
        {
            system.DirectionX = from.VX / speed;
            system.DirectionZ = from.VZ / speed;
            double fastest = _around.Ground.Rolling + (airRate * airSpeed);
            if (_around.Air.Varies || fastest * h > GroundLimit<TAir>.Approach * speed)
            {
                system.Rates(s.Time, in from, out PlanarRates rates);
                run.Log.Evaluations++;
                var direction = new Vector3d(system.DirectionX, 0, system.DirectionZ);
                h = GroundLimit<TAir>.Shorten(h, run.Length, in direction, speed, rates.Acceleration);
            }
        }

        var sweep = new PlanarSweep<RollingSystem<TAir>, TIntegrator>(in system, s.Time, in from, _around.ContactHeight, in _around.Wind, _around.Radius);
        sweep.Step(h);
        _jump.EndAtCrossingOnGround(ref sweep, ref s.Branch, ref run);
        bool rests = KineticEnergy(sweep.Taken.End.SpeedSquared, sweep.Taken.End.SpinSquared) < _restEnergy;
        if (rests)
        {
            EndAtRest(ref sweep, energy);
        }

        run.Log.Evaluations += sweep.Evaluations;
        BallState before = s;
        before.Branch = system.Branch;
        sweep.MoveTo(ref s);
        run.Advance(ref s, sweep.Length);
        run.Show(in before, in s, ref sweep, _integrator.Order);
        if (rests && !run.Log.Halted)
        {
            _contact.Rest(ref s, ref run);
        }
    }

    /// <summary>Ends a piece where its kinetic energy falls to the rest energy.</summary>
    private void EndAtRest(ref PlanarSweep<RollingSystem<TAir>, TIntegrator> sweep, double energy)
    {
        // Speeds fall about linearly, energies with their square.
        double startRoot = Math.Sqrt(energy);
        double endRoot = Math.Sqrt(KineticEnergy(sweep.Taken.End.SpeedSquared, sweep.Taken.End.SpinSquared));
        double tau = sweep.Length * (startRoot - Math.Sqrt(_restEnergy)) / (startRoot - endRoot);
        tau = tau > 0 && tau < sweep.Length ? tau : 0.5 * sweep.Length;
        EventLocator.Locate(ref sweep, new EnergyLeft(this), tau);
    }

    /// <summary>½ m v² + ½ I ω², J.</summary>
    private double KineticEnergy(double speedSquared, double spinSquared) => (0.5 * _mass * speedSquared) + (0.5 * _momentOfInertia * spinSquared);

    /// <summary>The kinetic energy above the rest energy.</summary>
    private readonly struct EnergyLeft : IEventFunction<PlanarSweep<RollingSystem<TAir>, TIntegrator>>
    {
        private readonly RollPhase<TAir, TIntegrator> _phase;

        public EnergyLeft(RollPhase<TAir, TIntegrator> phase) => _phase = phase;

        public bool Evaluate(ref PlanarSweep<RollingSystem<TAir>, TIntegrator> sweep, double tau, out double value, out double correction)
        {
            PlanarMotion end = sweep.Taken.End;
            value = _phase.KineticEnergy(end.SpeedSquared, end.SpinSquared) - _phase._restEnergy;
            PlanarRates rates = sweep.EndRates();

            // dE/dt = m v·v̇ + I ω·ω̇
            double power = (_phase._mass * Vector3d.Dot(end.Velocity, rates.Acceleration))
                + (_phase._momentOfInertia * Vector3d.Dot(end.Spin, rates.SpinAcceleration));
            correction = power < 0 ? -value / power : double.NaN;
            return Math.Abs(correction) <= Located;
        }
    }
}
