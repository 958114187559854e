using System.Globalization;

namespace FootballPhysics.Labs.Stability;

/// <summary>Plays a scene of the stress matrix and checks, frame by frame, what must always hold.</summary>
internal sealed class StressRun
{
    /// <summary>Deepest penetration, m.</summary>
    public const double Deepest = 1e-9;

    /// <summary>How exact a contact is for a ball that goes beyond <see cref="Limits.Length"/>, as a share of how far it goes.</summary>
    private const double FarShare = 1e-7;

    private readonly StressScene _scene;
    private readonly Simulator _simulator;
    private readonly EnergyCheck _energy;
    private readonly AirBounds _air;
    private readonly StepLog _log = new();
    private BallState _state;
    private long _steps;
    private long _frames;
    private long _stalled;
    private long _impacts;
    private double _energyShare;
    private double _deepest = Deepest;

    private StressRun(StressScene scene)
    {
        _scene = scene;
        _simulator = new Simulator(scene.Scene, scene.Settings);
        _energy = new EnergyCheck(scene.Scene, scene.Settings, scene.Upward, _simulator);
        _air = new AirBounds(scene.Scene);
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

        return new StressOutcome(failure, run?._steps ?? 0, run?._frames ?? 0, run?._stalled ?? 0, run?._impacts ?? 0, run?._energyShare ?? 0);
    }

    private StressFailure? Check()
    {
        _state = _simulator.Launch(_scene.Position, _scene.Velocity, _scene.Spin);
        if (_scene.RestsBy is { } by)
        {
            while (_state.Motion != MotionState.Rest && _state.Time < by)
            {
                if (Frame(_scene.Frames[0]) is { } failure)
                {
                    return failure;
                }
            }

            return _state.Motion == MotionState.Rest ? null : Fail("rest", $"{_state.Motion} at {by} s, v {_state.Velocity}, spin {_state.Spin}");
        }

        foreach (double dt in _scene.Frames)
        {
            if (Frame(dt) is { } failure)
            {
                return failure;
            }
        }

        return null;
    }

    /// <summary>A frame, and what must hold after it.</summary>
    private StressFailure? Frame(double dt)
    {
        BallState before = _state;
        _log.Clear();
        _simulator.Step(ref _state, dt, _log);
        Count();
        double farthest = Math.Max(Farthest(in before, dt), Farthest(in _state, dt));
        _deepest = farthest > Limits.Length ? FarShare * farthest : Deepest;
        return Finite() ?? Clock(in before, dt) ?? Events(before.Time, dt) ?? Energy(in before, dt) ?? Reversal(in before);
    }

    /// <summary>A bound of the height in a frame that begins or ends with a state, m.</summary>
    private static double Farthest(in BallState s, double dt) => Math.Abs(s.Position.Y) + (s.Velocity.Length * dt);

    private void Count()
    {
        _frames++;
        _steps += _log.Steps;
        _stalled += _log.StalledSteps;
        foreach (ref readonly BallEvent item in _log.Events)
        {
            _impacts += item.Kind == BallEventKind.Impact ? 1 : 0;
        }
    }

    private StressFailure? Finite() =>
        !(_state.Position.IsFinite && _state.Velocity.IsFinite && _state.Spin.IsFinite && _state.Orientation.IsFinite && double.IsFinite(_state.Time))
            ? Fail("finite", $"p {_state.Position}, v {_state.Velocity}, spin {_state.Spin}")
        : Math.Abs(_state.Orientation.LengthSquared - 1) > 1e-9 ? Fail("orientation", $"size² {_state.Orientation.LengthSquared}")
        : _state.Position.Y < _simulator.ContactHeight - _deepest ? Fail("penetration", $"{_simulator.ContactHeight - _state.Position.Y} m at the end of a frame")
        : null;

    private StressFailure? Clock(in BallState before, double dt) =>
        Math.Abs(_state.Time - before.Time - dt) <= 1e-12 * Math.Max(1, _state.Time) ? null : Fail("clock", $"{before.Time} + {dt} is {_state.Time}");

    private StressFailure? Events(double start, double dt)
    {
        double last = start;
        double mass = _scene.Scene.Ball.Mass;
        double inertia = _scene.Scene.Ball.MomentOfInertia;
        double notBefore = start;
        double rise = 0;
        int others = 0;
        foreach (ref readonly BallEvent item in _log.Events)
        {
            if (!(item.Time >= last && item.Time <= Math.Max(_state.Time, start + dt) + 1e-12))
            {
                return Fail("order", $"{item.Kind} at {item.Time} after {last}");
            }

            last = item.Time;
            if (!(Math.Abs(item.Position.Y - _simulator.ContactHeight) <= _deepest))
            {
                return Fail("penetration", $"{item.Kind} at height {item.Position.Y - _simulator.ContactHeight} m");
            }

            others += item.Kind == BallEventKind.Impact ? 0 : 1;
            if (item.Kind == BallEventKind.Impact)
            {
                if (!(item.Time >= notBefore))
                {
                    return Fail("hop", $"impact at {item.Time} after a rise at {rise} m/s, not possible before {notBefore}");
                }

                notBefore = item.Time + ShortestHop(in item);
                rise = item.Velocity.Y;
                double before = (mass * item.VelocityBefore.LengthSquared) + (inertia * item.SpinBefore.LengthSquared);
                double after = (mass * item.Velocity.LengthSquared) + (inertia * item.Spin.LengthSquared);
                if (!(after <= before * (1 + 1e-12)) && after > 1e-300)
                {
                    return Fail("impact energy", $"{0.5 * before} J to {0.5 * after} J");
                }
            }
        }

        // A ball that is heavier than the air slides, rolls and rests once, if no lift takes it off the ground again; the air alone moves one without weight.
        bool leaves = _scene.Scene.Ground.Aerodynamics == GroundAerodynamics.Full;
        return others <= 3 || _scene.Upward >= 0 || leaves ? null : Fail("events", $"{others} of a ball on the ground");
    }

    /// <summary>How long a hop lasts at least: 2 v/a with the largest downward acceleration; semi-implicit Euler, which falls before it rises, half as long.</summary>
    private double ShortestHop(in BallEvent impact)
    {
        // One that rises more slowly than a bounce has to stays down, and lift may take it off the ground again at any time: that is no hop.
        if (impact.Velocity.Y < _scene.Scene.Ground.MinimumBounceSpeed)
        {
            return 0;
        }

        // Forward again as fast as it came, and explicit Euler a little faster.
        double speed = 1.5 * (impact.Velocity - _scene.Scene.Air.Wind).Length;
        double down = Math.Max(0, -_scene.Upward) + _air.Size(speed, _scene.Scene.Ball.Radius * impact.Spin.Length);
        double tolerance = _scene.Settings.CollisionTiming == CollisionTiming.Bisection ? 2 * _scene.Settings.CollisionTolerance : 1e-12;
        return ((1 - 1e-6) * impact.Velocity.Y / Math.Max(down, 1e-300)) - tolerance;
    }

    private StressFailure? Energy(in BallState before, double dt)
    {
        // What a method's own error can do by the measured laws is bounded nowhere: of their frames the impacts alone are judged.
        if (_scene.Measured || _energy.Of(in before, dt, in _state, _log.Events.Span) is not { } frame)
        {
            return null;
        }

        _energyShare = Math.Max(_energyShare, frame.Share);
        return frame.Holds ? null : Fail("energy", $"gained {frame.Gained} J in {dt} s; method {frame.ByMethod} J, contact {frame.ByContact} J, rounding {frame.ByRounding} J; {_log.Steps} pieces, {_log.Events.Count} events, {before.Motion} to {_state.Motion}");
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

        // What is left of a spin that has ended is rounding.
        if (before.Spin.Y * spin.Y < -1e-15 * before.Spin.Y * before.Spin.Y)
        {
            return Fail("reversal", $"spin about the vertical {before.Spin.Y} to {spin.Y}, {_state.Motion}");
        }

        bool straight = !_scene.Windy && (_scene.Scene.Forces.Magnus == ForceLaw.None || _scene.Scene.Ground.Aerodynamics == GroundAerodynamics.None);
        Vector3d velocity = _state.Velocity;
        return _state.Motion == MotionState.Rolling && straight && Vector3d.Dot(before.Velocity, in velocity) < -1e-20
            ? Fail("reversal", $"velocity in a roll {before.Velocity} to {velocity}")
            : null;
    }

    private static StressFailure Fail(string check, FormattableString detail) => new(check, detail.ToString(CultureInfo.InvariantCulture));
}
