using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Labs.Stability;

/// <summary>Says of a frame, from the states before and after it, how much energy the ball gained and how much the method can have made.</summary>
/// <remarks>A frame that gains more than rounding is stepped again from the state before it, to see its pieces: the bound is the sum of theirs.</remarks>
internal sealed class EnergyCheck : PieceObserver
{
    /// <summary>Rounding of a sum, as a share.</summary>
    private const double Rounding = 2.3e-16;

    /// <summary>How close to contact height contact is found, m.</summary>
    private const double Touching = 1e-14;

    /// <summary>How closely the time of contact is bracketed, as a share of the step.</summary>
    private const double Bracket = 1e-15;

    /// <summary>The last correction of its time, s, is linear if it is shorter than this.</summary>
    private const double LinearCorrection = 1e-6;

    /// <summary>Slip that is left, m/s, when a ball is taken to roll.</summary>
    private const double LastSlip = 1e-9;

    private readonly Scene _scene;
    private readonly SolverSettings _settings;
    private readonly bool _windy;
    private readonly double _upward;
    private readonly Simulator _simulator;
    private readonly MethodError _method;
    private readonly MethodError _parts;
    private readonly StepLog _log = new();
    private readonly double _mass;
    private readonly double _inertiaFactor;
    private readonly double _radius;
    private readonly double _weight;
    private readonly double _damping;
    private double _slowSurface;
    private double _fastSurface;
    private int _seen;
    private double _dt;
    private double _made;
    private double _corrected;

    /// <param name="scene">The scene.</param>
    /// <param name="settings">Its method.</param>
    /// <param name="upward">Upward acceleration by gravity and buoyancy, m/s².</param>
    /// <param name="simulator">What steps it.</param>
    public EnergyCheck(Scene scene, SolverSettings settings, double upward, Simulator simulator)
    {
        _scene = scene;
        _settings = settings;
        _windy = scene.Air.Wind.Length > 0;
        _upward = upward;
        _simulator = simulator;
        _method = new MethodError(settings.Integrator, scene);
        _parts = new MethodError(Integrator.Rk4, scene);
        _mass = scene.Ball.Mass;
        _inertiaFactor = scene.Ball.InertiaFactor;
        _radius = scene.Ball.Radius;
        _weight = _mass * Math.Abs(upward);
        _damping = scene.Ground.Material.SpinDamping / scene.Ball.MomentOfInertia;
        _log.Observer = this;
    }

    public override bool WantsEndAcceleration => false;

    /// <summary>Wind, m/s.</summary>
    public Vector3d Wind => _scene.Air.Wind;

    /// <summary>Judges a frame.</summary>
    /// <param name="before">The ball before it.</param>
    /// <param name="dt">Its length, s.</param>
    /// <param name="after">The ball after it.</param>
    /// <param name="events">What happened in it.</param>
    /// <returns>Null where nothing is promised: where wind pushes a ball on the ground, and where the heuristic does not see the end of a slip.</returns>
    public FrameEnergy? Of(in BallState before, double dt, in BallState after, ReadOnlySpan<BallEvent> events)
    {
        // Air that presses a ball against the ground does work on it, as one sees it who goes with the wind.
        bool flies = before.Motion == MotionState.Airborne && after.Motion == MotionState.Airborne && events.Length == 0
            && !(_windy && after.Position.Y <= _simulator.ContactHeight + Touching);
        if (!flies && (_windy || (_settings.RollingTransition == RollingTransition.Heuristic && (before.Motion == MotionState.Sliding || Slides(events)))))
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

    /// <summary>A piece of the frame that is stepped again.</summary>
    public override bool Add(in PathSegment piece)
    {
        ReadOnlySpan<BallEvent> events = _log.Events.Span;
        if (events.Length > _seen)
        {
            _seen = events.Length;
            _slowSurface = _fastSurface = _radius * events[^1].Spin.Length;
        }

        // The length is what the clock says, which is rounded at both ends.
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
            // Friction may turn a sliding ball the faster, by r ω̇ = μ g/α; a rolling one has the spin of its speed, and inertia of it too.
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

    /// <summary>What a piece may make, J/kg: without the drag of a real ball a part of a divided step may have been taken by RK4.</summary>
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
        _simulator.Step(ref state, dt, _log);
    }

    /// <summary>What finding an event can make, J: the weight times the height by which contact is missed, or the end of the slip; or a slip so slow that the ball rolls.</summary>
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

    /// <summary>What rounding can make, J: of the speeds, the spin and the height, which are sums.</summary>
    private double OfRounding(in BallState before, double dt, in BallState after)
    {
        double speed = Math.Max(before.Velocity.Length, after.Velocity.Length) + Wind.Length + (Math.Abs(_upward) * dt);
        double surface = Math.Max(before.Spin.Length, after.Spin.Length) * _radius;
        double height = Math.Abs(before.Position.Y) + Math.Abs(after.Position.Y) + Math.Abs(_simulator.ContactHeight);
        return 8 * Rounding * ((_mass * ((speed * speed) + (_inertiaFactor * surface * surface))) + (_weight * height)) + 1e-300;
    }

    /// <summary>½ m u² + m g y as one sees it who goes with the wind, J: the air cannot make any, and spin has no way into it.</summary>
    private double InFlight(in BallState s, double time)
    {
        double climb = s.Position.Y - _simulator.ContactHeight - (Wind.Y * time);
        return (0.5 * _mass * (s.Velocity - Wind).LengthSquared) - (_mass * _upward * climb);
    }

    /// <summary>½ m v² + ½ I ω² + m g y, J.</summary>
    public double Total(in BallState s) =>
        (0.5 * ((_mass * s.Velocity.LengthSquared) + (_scene.Ball.MomentOfInertia * s.Spin.LengthSquared)))
        - (_mass * _upward * (s.Position.Y - _simulator.ContactHeight));

    /// <summary>Whether the ball has begun to slide, or has ended it.</summary>
    private static bool Slides(ReadOnlySpan<BallEvent> events)
    {
        foreach (ref readonly BallEvent item in events)
        {
            if (item.Kind is BallEventKind.Slide or BallEventKind.Roll)
            {
                return true;
            }
        }

        return false;
    }
}
