using System.Globalization;

namespace Football.Physics.Headless.Lab.Stability;

/// <summary>Plays a scene of the stress matrix and checks, frame by frame, what must always hold.</summary>
internal sealed class StressRun
{
    /// <summary>Deepest penetration, m.</summary>
    public const double Deepest = 1e-9;

    private readonly StressScene _scene;
    private readonly Simulator _simulator;
    private readonly StepLog _log = new();
    private BallState _before;
    private BallState _state;
    private long _steps;
    private long _frames;
    private long _relaxed;
    private long _impacts;

    private StressRun(StressScene scene)
    {
        _scene = scene;
        _simulator = new Simulator(scene.Scene, scene.Settings);
    }

    /// <summary>Plays it to its end or to the first broken invariant.</summary>
    public static StressOutcome Play(StressScene scene)
    {
        StressRun? run = null;
        StressFailure? failure;
        try
        {
            run = new StressRun(scene);
            failure = run.Check();
        }
        catch (Exception e)
        {
            failure = new StressFailure("exception", $"{e.GetType().Name}: {e.Message}");
        }

        return new StressOutcome(failure, run?._steps ?? 0, run?._frames ?? 0, run?._relaxed ?? 0, run?._impacts ?? 0);
    }

    private StressFailure? Check()
    {
        _state = _simulator.Launch(_scene.Position, _scene.Velocity, _scene.Spin);
        if (_scene.RestsBy is { } by)
        {
            bool rests = _simulator.Run(ref _state, _scene.Frames[0], by, StopAt.Rest, _log);
            Count();
            return Finite() ?? Events(0, by) ?? (rests || _state.Motion == MotionState.Stopped ? null : Fail("rest", $"{_state.Motion} at {by} s, v {_state.Velocity}, spin {_state.Spin}"));
        }

        foreach (double dt in _scene.Frames)
        {
            BallState before = _state;
            _before = before;
            _log.Clear();
            _simulator.Step(ref _state, dt, _log);
            Count();
            StressFailure? failure = Finite() ?? Clock(in before, dt) ?? Events(before.Time, dt) ?? Energy(in before, dt) ?? Reversal(in before);
            if (failure is not null)
            {
                return failure;
            }
        }

        return null;
    }

    private void Count()
    {
        _frames++;
        _steps += _log.Steps;
        _relaxed += _log.Relaxed;
        foreach (ref readonly BallEvent item in _log.Events)
        {
            _impacts += item.Kind == BallEventKind.Impact ? 1 : 0;
        }
    }

    private StressFailure? Finite() =>
        !(_state.Position.IsFinite && _state.Velocity.IsFinite && _state.Spin.IsFinite && _state.Orientation.IsFinite && double.IsFinite(_state.Time))
            ? Fail("finite", $"p {_state.Position}, v {_state.Velocity}, spin {_state.Spin}")
        : Math.Abs(_state.Orientation.LengthSquared - 1) > 1e-9 ? Fail("orientation", $"size² {_state.Orientation.LengthSquared}")
        : _state.Position.Y < _simulator.ContactHeight - Deepest ? Fail("penetration", $"{_simulator.ContactHeight - _state.Position.Y} m at the end of a frame")
        : null;

    private StressFailure? Clock(in BallState before, double dt) =>
        Math.Abs(_state.Time - before.Time - dt) <= 1e-12 * Math.Max(1, _state.Time) ? null : Fail("clock", $"{before.Time} + {dt} is {_state.Time}");

    private StressFailure? Events(double start, double dt)
    {
        double last = start;
        double mass = _scene.Scene.Ball.Mass;
        double inertia = _scene.Scene.Ball.MomentOfInertia;
        int count = 0;
        foreach (ref readonly BallEvent item in _log.Events)
        {
            count++;
            if (!(item.Time >= last && item.Time <= Math.Max(_state.Time, start + dt) + 1e-12))
            {
                return Fail("order", $"{item.Kind} at {item.Time} after {last}");
            }

            last = item.Time;
            if (!(Math.Abs(item.Position.Y - _simulator.ContactHeight) <= Deepest))
            {
                return Fail("penetration", $"{item.Kind} at height {item.Position.Y - _simulator.ContactHeight} m");
            }

            if (item.Kind == BallEventKind.Impact)
            {
                double before = (mass * item.VelocityBefore.LengthSquared) + (inertia * item.SpinBefore.LengthSquared);
                double after = (mass * item.Velocity.LengthSquared) + (inertia * item.Spin.LengthSquared);
                if (!(after <= before * (1 + 1e-12)) && after > 1e-300)
                {
                    return Fail("impact energy", $"{0.5 * before} J to {0.5 * after} J");
                }
            }
        }

        // Each impact but the last begins a hop of at least 2 v/a; two more events may follow the last one, and rest.
        double most = 5 + (2 * dt / ShortestHop());
        return count <= most ? null : Fail("event rate", $"{count} events in {dt} s, at most {most}");
    }

    /// <summary>The stated bound: a hop lasts at least 2 v_min/a with the largest downward acceleration of gravity and air, and never less than a microsecond.</summary>
    private double ShortestHop()
    {
        double speed = Math.Max(_state.Velocity.Length, 250) + _scene.Scene.Air.Wind.Length;
        double down = Math.Max(0, -_scene.Upward) + (AirAcceleration(speed) * (_scene.Windy ? 1 : 0.2));
        down = double.IsFinite(down) ? down : 1e300;
        return Math.Max(_scene.Windy ? 0 : 5e-7, 2 * _scene.Scene.Ground.MinimumBounceSpeed / Math.Max(down, 1e-300));
    }

    private StressFailure? Energy(in BallState before, double dt)
    {
        if (_scene.Windy || (_scene.Settings.RollingTransition == RollingTransition.Heuristic && _log.Events.Count > 0))
        {
            return null;
        }

        double start = EnergyOf(in before);
        double end = EnergyOf(in _state);
        double mass = _scene.Scene.Ball.Mass;
        double scale = 0.5 * mass * (Math.Max(before.Velocity.LengthSquared, _state.Velocity.LengthSquared) + (_scene.Upward * _scene.Upward * dt * dt));
        scale += 0.5 * _scene.Scene.Ball.MomentOfInertia * Math.Max(before.Spin.LengthSquared, _state.Spin.LengthSquared);
        scale += Math.Abs(mass * _scene.Upward) * Math.Max(before.Position.Y - _simulator.ContactHeight, _state.Position.Y - _simulator.ContactHeight);
        double allowed = (scale * (1e-9 + MethodError(in before, dt))) + 1e-300;

        // The height is a double, and so is the ground's.
        allowed += 1e-15 * Math.Abs(mass * _scene.Upward) * (Math.Abs(before.Position.Y) + Math.Abs(_state.Position.Y));
        if (_scene.Settings.CollisionTiming == CollisionTiming.Bisection)
        {
            // Found to a microsecond, an impact is off by that much of fall.
            double fastest = Math.Max(before.Velocity.Length, _state.Velocity.Length) + (Math.Abs(_scene.Upward) * dt);
            allowed += 2 * _scene.Settings.CollisionTolerance * mass * Math.Abs(_scene.Upward) * fastest * (1 + _log.Events.Count);
        }

        return end <= start + allowed ? null : Fail("energy", $"{start} J to {end} J, allowed {allowed}, {before.Motion} to {_state.Motion}");
    }

    /// <summary>How much energy, as a share, a method of its order may make in a frame: z to the order and one more, z = its largest relative change.</summary>
    private double MethodError(in BallState before, double dt)
    {
        long pieces = Math.Max(1, _log.Steps);
        double speed = Math.Max(before.Velocity.Length, _state.Velocity.Length);
        double fall = Math.Abs(_scene.Upward) * dt;
        double air = speed + fall > 0 ? AirAcceleration(speed + fall) * dt / (speed + fall) : 0;
        double z = Math.Min(1, 6 * air);

        // What the air turns may be what gravity gave in the same frame, h g.
        double share = speed + fall > 0 ? fall / (speed + fall) : 0;
        double byAir = _scene.Integrator switch
        {
            Integrator.Rk2 => z * ((z * (z + share)) + (share * SpinLoss())),
            Integrator.Rk4 => z * z * z * z * (z + share),
            _ => z * z,
        };

        // Euler gains ½ m g² h² a piece even in vacuum.
        double byGravity = _scene.Integrator is Integrator.Euler or Integrator.SemiImplicitEuler ? 2 : 0;
        return Math.Max(byAir * pieces, byAir) + byGravity;
    }

    /// <summary>Which share of its spin the ball lost in the frame: so much the lift of the midpoint is not that of the frame.</summary>
    private double SpinLoss()
    {
        double before = _before.Spin.Length;
        return before > 0 ? Math.Min(1, (_before.Spin - _state.Spin).Length / before) : 1;
    }

    /// <summary>A bound for the air's acceleration at a speed.</summary>
    private double AirAcceleration(double speed)
    {
        Scene scene = _scene.Scene;
        double r = scene.Ball.Radius;
        double area = 0.5 * scene.Air.Density * Math.PI * r * r / scene.Ball.Mass;
        double fastest = Math.Max(Math.Max(_before.Spin.Length, _state.Spin.Length), _scene.Spin.Length);
        foreach (ref readonly BallEvent item in _log.Events)
        {
            // The next impact of a frame may take away what the one before gave.
            fastest = Math.Max(fastest, item.Spin.Length);
        }

        double surface = r * fastest;
        double drag = scene.Forces.Drag switch
        {
            ForceLaw.None => 0,
            ForceLaw.Constant => scene.Forces.DragCoefficient * speed,
            _ => (0.8 * speed) + (0.2 * surface),
        };
        double lift = scene.Forces.Magnus switch
        {
            ForceLaw.None => 0,
            ForceLaw.Constant => 2 * Math.Abs(scene.Forces.MagnusCoefficient) * surface,
            _ => 1.7 * ((0.2 * speed) + (0.83 * surface)),
        };
        return drag + lift > 0 ? area * (drag + lift) * speed : 0;
    }

    private StressFailure? Reversal(in BallState before)
    {
        if (_log.Events.Count > 0 || _state.Motion != before.Motion)
        {
            return null;
        }

        Vector3d spin = _state.Spin;
        if (_state.Motion == MotionState.Airborne)
        {
            return Vector3d.Dot(before.Spin, in spin) >= 0 ? null : Fail("reversal", $"spin in flight {before.Spin} to {spin}");
        }

        if (before.Spin.Y * spin.Y < 0)
        {
            return Fail("reversal", $"spin about the vertical {before.Spin.Y} to {spin.Y}, {_state.Motion}");
        }

        bool straight = !_scene.Windy && (_scene.Scene.Forces.Magnus == ForceLaw.None || _scene.Scene.Ground.Aerodynamics == GroundAerodynamics.None);
        Vector3d velocity = _state.Velocity;
        return _state.Motion == MotionState.Rolling && straight && Vector3d.Dot(before.Velocity, in velocity) < -1e-20
            ? Fail("reversal", $"velocity in a roll {before.Velocity} to {velocity}")
            : null;
    }

    private double EnergyOf(in BallState s) =>
        (0.5 * ((_scene.Scene.Ball.Mass * s.Velocity.LengthSquared) + (_scene.Scene.Ball.MomentOfInertia * s.Spin.LengthSquared)))
        - (_scene.Scene.Ball.Mass * _scene.Upward * (s.Position.Y - _simulator.ContactHeight));

    private static StressFailure Fail(string check, FormattableString detail) => new(check, detail.ToString(CultureInfo.InvariantCulture));
}
