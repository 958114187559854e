namespace Football.Physics;

/// <summary>Rolling on the ground, piece by piece: up to the drag law's jump, or to rest.</summary>
internal sealed class RollPhase<TAir, TIntegrator>
    where TAir : struct, IAir
    where TIntegrator : struct, IIntegrator
{
    private readonly Surroundings<TAir> _around;
    private readonly GroundLimit<TAir> _limit;
    private readonly DragJumpGuard<TAir> _jump;
    private readonly ContactPhase<TAir> _contact;
    private readonly ImplicitPhase<TAir> _implicit;
    private readonly RollingSystem<TAir> _system;
    private readonly TIntegrator _integrator;
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
        _restEnergy = scene.Ground.RestEnergy;
        _mass = scene.Ball.Mass;
        _momentOfInertia = scene.Ball.MomentOfInertia;
    }

    /// <summary>The next piece of a roll.</summary>
    public void Take(ref BallState s, ref StepRun run)
    {
        if (_contact.LeavesGround(ref s, ref run))
        {
            return;
        }

        double energy = KineticEnergy(s.Velocity, s.Spin);
        if (energy < _restEnergy)
        {
            _contact.Rest(ref s, ref run);
            return;
        }

        var from = new Motion(s.Position, s.Velocity, s.Spin);
        double speed = from.Velocity.Length;
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
            from = new Motion(s.Position, Vector3d.Zero, new Vector3d(0, from.Spin.Y, 0));
            Vector3d push = system.Pushed(s.Time, in from).Acceleration;
            run.Log.Evaluations++;
            double pushSize = push.Length;
            system.Pinned = pushSize <= _around.Ground.Rolling;
            system.Direction = pushSize > 0 ? push / pushSize : Vector3d.Zero;
        }
        else
        {
            system.Direction = from.Velocity / speed;
            double fastest = _around.Ground.Rolling + (airRate * airSpeed);
            if (_around.Custom.Act || fastest * h > GroundLimit<TAir>.Approach * speed)
            {
                system.Rates(s.Time, in from, out MotionRates rates);
                run.Log.Evaluations++;
                h = GroundLimit<TAir>.Shorten(h, run.Length, in system.Direction, speed, rates.Acceleration);
            }
        }

        var sweep = new MotionSweep<RollingSystem<TAir>, TIntegrator>(in system, s.Time, in from, in _around.Wind, _around.Radius);
        sweep.Step(h);
        _jump.EndAtCrossingOnGround(ref sweep, ref s.Branch, ref run);
        bool rests = KineticEnergy(in sweep.Taken.End.Velocity, in sweep.Taken.End.Spin) < _restEnergy;
        if (rests)
        {
            EndAtRest(ref sweep, energy);
        }

        run.Log.Evaluations += sweep.Evaluations;
        BallState before = s;
        sweep.MoveTo(ref s);
        run.Advance(ref s, sweep.Length);
        run.Show(in before, in s, ref sweep, _integrator.Order);
        if (rests && !run.Log.Halted)
        {
            _contact.Rest(ref s, ref run);
        }
    }

    /// <summary>Ends a piece where its kinetic energy falls to the rest energy.</summary>
    private void EndAtRest(ref MotionSweep<RollingSystem<TAir>, TIntegrator> sweep, double energy)
    {
        double low = 0;
        double high = sweep.Length;

        // Speeds fall about linearly, energies with their square.
        double startRoot = Math.Sqrt(energy);
        double endRoot = Math.Sqrt(KineticEnergy(in sweep.Taken.End.Velocity, in sweep.Taken.End.Spin));
        double tau = high * (startRoot - Math.Sqrt(_restEnergy)) / (startRoot - endRoot);
        for (int i = 0; i < 40; i++)
        {
            tau = tau > low && tau < high ? tau : 0.5 * (low + high);
            sweep.Step(tau);
            double excess = KineticEnergy(in sweep.Taken.End.Velocity, in sweep.Taken.End.Spin) - _restEnergy;
            MotionRates rates = sweep.EndRates();

            // dE/dt = m v·v̇ + I ω·ω̇
            double power = (_mass * Vector3d.Dot(in sweep.Taken.End.Velocity, in rates.Acceleration))
                + (_momentOfInertia * Vector3d.Dot(in sweep.Taken.End.Spin, in rates.SpinAcceleration));
            double correction = -excess / power;
            if (power < 0 && Math.Abs(correction) <= 1e-12)
            {
                return;
            }

            if (excess > 0)
            {
                low = tau;
            }
            else
            {
                high = tau;
            }

            if (high - low <= 1e-15 * high)
            {
                return;
            }

            tau = power < 0 ? tau + correction : 0;
        }
    }

    /// <summary>½ m v² + ½ I ω², J.</summary>
    private double KineticEnergy(in Vector3d v, in Vector3d w) => (0.5 * _mass * v.LengthSquared) + (0.5 * _momentOfInertia * w.LengthSquared);
}
