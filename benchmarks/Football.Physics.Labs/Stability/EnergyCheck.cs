using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Labs.Stability;

/// <summary>Computes the energy that the ball gained in a frame, and the most that the method can have created, from the states before and after it.</summary>
/// <remarks>A frame that gains more than rounding is stepped again from the state before it, to observe its pieces. The bound is the sum of their bounds.</remarks>
/// <param name="stress">The scene, and its method.</param>
/// <param name="simulator">Its simulator.</param>
internal sealed class EnergyCheck(StressScene stress, Simulator simulator) : PieceObserver
{
    /// <summary>Rounding of a sum, as a share.</summary>
    private const double Rounding = 2.3e-16;

    /// <summary>The tolerance in height with which contact is found, m.</summary>
    private const double Touching = 1e-14;

    /// <summary>The tolerance in time with which contact is bracketed, as a share of the step.</summary>
    private const double Bracket = 1e-15;

    /// <summary>The last correction of the contact time, s, is linear if it is shorter than this.</summary>
    private const double LinearCorrection = 1e-6;

    /// <summary>The slip that remains, m/s, when a ball is taken to roll.</summary>
    private const double LastSlip = 1e-9;

    private readonly Scene _scene = stress.Scene;
    private readonly SolverSettings _settings = stress.Settings;
    private readonly double _upward = stress.Upward;
    private readonly MethodError _method = new(stress.Integrator, stress.Scene);
    private readonly MethodError _parts = new(Integrator.Rk4, stress.Scene);
    private readonly StepLog _log = new();
    private readonly double _mass = stress.Scene.Ball.Mass;
    private readonly double _inertiaFactor = stress.Scene.Ball.InertiaFactor;
    private readonly double _radius = stress.Scene.Ball.Radius;
    private readonly double _weight = stress.Scene.Ball.Mass * Math.Abs(stress.Upward);
    private readonly double _damping = stress.Scene.Ground.Material.SpinDamping / stress.Scene.Ball.MomentOfInertia;
    private double _slowSurface;
    private double _fastSurface;
    private int _seen;
    private double _dt;
    private double _made;
    private double _corrected;

    public override bool WantsEndAcceleration => false;

    /// <summary>Wind, m/s.</summary>
    public Vector3d Wind => _scene.Air.Wind;

    /// <summary>Judges a frame.</summary>
    /// <param name="before">The ball before the frame.</param>
    /// <param name="dt">The length of the frame, s.</param>
    /// <param name="after">The ball after the frame.</param>
    /// <param name="events">The events of the frame.</param>
    /// <returns>Null if nothing is guaranteed: if wind pushes a ball on the ground, or if the heuristic does not detect the end of a slip.</returns>
    public FrameEnergy? Of(in BallState before, double dt, in BallState after, ReadOnlySpan<BallEvent> events)
    {
        // In the frame of the wind, air that presses a ball against the ground does work on it.
        bool flies = before.Motion == MotionState.Airborne && after.Motion == MotionState.Airborne && events.Length == 0
            && !(stress.Windy && after.Position.Y <= simulator.ContactHeight + Touching);
        if (!flies && (stress.Windy || (_settings.RollingTransition == RollingTransition.Heuristic && (before.Motion == MotionState.Sliding || Slides(events)))))
        {
            return null;
        }

        double gained = flies ? InFlight(in after, after.Time - before.Time) - InFlight(in before, 0) : Total(in after) - Total(in before);
        double rounding = OfRounding(in before, dt, in after);
        if (gained <= rounding)
        {
            return new FrameEnergy(gained, 0, 0, rounding);
        }

        Again(in before, dt);
        return new FrameEnergy(gained, _made, OfContact(in before, events, dt) + (_log.Steps > 1 ? _corrected : 0), rounding * (1 + _log.Steps));
    }

    /// <summary>Adds a piece of the frame that is stepped again.</summary>
    public override bool Add(in PathSegment piece)
    {
        ReadOnlySpan<BallEvent> events = _log.Events.Span;
        if (events.Length > _seen)
        {
            _seen = events.Length;
            _slowSurface = _fastSurface = _radius * events[^1].Spin.Length;
        }

        // The clock gives the length, and rounds it at both ends.
        double length = piece.Length + (2 * Rounding * piece.EndTime);
        if (piece.Motion == MotionState.Airborne)
        {
            double speed = (piece.StartVelocity - Wind).Length;
            double g = Math.Abs(_upward);
            _made += _mass * Method(length, g, speed, 0);
            _corrected += _mass * _method.OfCorrection(LinearCorrection, length, g, speed, _slowSurface, _fastSurface);
        }
        else
        {
            // Friction may speed up the spin of a sliding ball, by r ω̇ = μ g/α. A rolling ball has the spin of its speed, and the corresponding inertia.
            double speed = piece.StartVelocity.Length;
            bool rolls = piece.Motion == MotionState.Rolling;
            double faster = _scene.Ground.Material.SlidingFriction * Math.Abs(_upward) / _inertiaFactor * length;
            _slowSurface = 0;
            _fastSurface = rolls ? Math.Max(_fastSurface, speed) : _fastSurface + faster;
            if (_scene.Ground.Aerodynamics == GroundAerodynamics.Horizontal)
            {
                _made += (rolls ? 1 + _inertiaFactor : 1) * _mass * Method(length, 0, speed, _damping);
            }
        }

        double lost = _method.SpinLoss(length, piece.StartVelocity.Length, _fastSurface);
        _slowSurface = Math.Max(0, _slowSurface - lost);
        return false;
    }

    /// <summary>Returns the most energy that a piece may create, J/kg. Without the drag of a real ball, RK4 may have taken a part of a divided step.</summary>
    private double Method(double length, double g, double speed, double damping)
    {
        double made = _method.Of(length, g, speed, _slowSurface, _fastSurface, damping);
        return length < 0.75 * _dt && _scene.Forces.Drag != ForceLaw.Empirical ? Math.Max(made, _parts.Of(length, g, speed, _slowSurface, _fastSurface, damping)) : made;
    }

    private void Again(in BallState before, double dt)
    {
        _dt = dt;
        BallState state = before;
        _seen = 0;
        _made = 0;
        _corrected = 0;
        _slowSurface = _fastSurface = _radius * before.Spin.Length;
        _log.Clear();
        _log.Observer = this;
        simulator.Step(ref state, dt, _log);
    }

    /// <summary>
    /// Returns the most energy that finding an event can create, J: the weight times the height by which contact is missed, the end of the slip, or a slip so
    /// slow that the ball rolls.
    /// </summary>
    private double OfContact(in BallState before, ReadOnlySpan<BallEvent> events, double dt)
    {
        double slip = before.Motion == MotionState.Rolling ? Slip.Of(before.Velocity, before.Spin, Vector3d.Up, _radius).Length : 0;
        double made = slip <= LastSlip ? _inertiaFactor * _mass * slip * ((_radius * before.Spin.Length) + slip) : 0;
        foreach (ref readonly BallEvent item in events)
        {
            made += item.Kind == BallEventKind.Roll ? _inertiaFactor * _mass * LastSlip * ((_radius * item.Spin.Length) + LastSlip)
                : item.Kind != BallEventKind.Impact ? 0
                : _settings.CollisionTiming == CollisionTiming.Bisection ? _weight * _settings.CollisionTolerance * Math.Abs(item.VelocityBefore.Y)
                : _weight * (Touching + (Bracket * dt * Math.Abs(item.VelocityBefore.Y)) + (0.5 * Math.Abs(_upward) * LinearCorrection * LinearCorrection));
        }

        return made;
    }

    /// <summary>Returns the most energy that rounding can create, J: from the speeds, the spin and the height, which are sums.</summary>
    private double OfRounding(in BallState before, double dt, in BallState after)
    {
        double speed = Math.Max(before.Velocity.Length, after.Velocity.Length) + Wind.Length + (Math.Abs(_upward) * dt);
        double surface = Math.Max(before.Spin.Length, after.Spin.Length) * _radius;
        double height = Math.Abs(before.Position.Y) + Math.Abs(after.Position.Y) + Math.Abs(simulator.ContactHeight);
        return 8 * Rounding * ((_mass * ((speed * speed) + (_inertiaFactor * surface * surface))) + (_weight * height)) + 1e-300;
    }

    /// <summary>Returns ½ m u² + m g y in the frame of the wind, J: the air cannot increase it, and spin energy cannot enter it.</summary>
    private double InFlight(in BallState s, double time)
    {
        double climb = s.Position.Y - simulator.ContactHeight - (Wind.Y * time);
        return (0.5 * _mass * (s.Velocity - Wind).LengthSquared) - (_mass * _upward * climb);
    }

    /// <summary>Returns ½ m v² + ½ I ω² + m g y, J.</summary>
    public double Total(in BallState s) =>
        (0.5 * ((_mass * s.Velocity.LengthSquared) + (_scene.Ball.MomentOfInertia * s.Spin.LengthSquared)))
        - (_mass * _upward * (s.Position.Y - simulator.ContactHeight));

    /// <summary>True if the ball has started or ended a slide.</summary>
    private static bool Slides(ReadOnlySpan<BallEvent> events) => events.ToArray().Any(item => item.Kind is BallEventKind.Slide or BallEventKind.Roll);
}

/// <summary>The energy that a ball gained in a frame, and the part of it that the method's own error and rounding can explain.</summary>
/// <param name="Gained">Energy at the end less energy at the start, J.</param>
/// <param name="ByMethod">The most that the method creates in its pieces, J.</param>
/// <param name="ByContact">The most that finding contact, and the slip at its end, creates, J.</param>
/// <param name="ByRounding">The most that rounding creates, J.</param>
internal readonly record struct FrameEnergy(double Gained, double ByMethod, double ByContact, double ByRounding)
{
    /// <summary>A larger gain, J, was created from nothing.</summary>
    public double Allowed => ByMethod + ByContact + ByRounding;

    public bool Holds => Gained <= Allowed;

    /// <summary>The share of the method's allowance that it used; 0 if rounding alone could create as much.</summary>
    public double Share => ByMethod > ByContact + ByRounding ? Gained / Allowed : 0;
}
