namespace Football.Physics;

/// <summary>
/// Flies a kick among all there is, step by step, and tells how close it comes to a target that may move, and to a point on the way: before its first impact, or, where it
/// is to meet some things first, after those and before the next.
/// </summary>
internal sealed class KickFlight : PieceObserver
{
    /// <summary>Nothing but the ground was met.</summary>
    public const int NoThing = -1;

    /// <summary>A ball that has been in a net, slower than this, for so long only creeps on, m/s and s: no more than twice as fast.</summary>
    private const double Slow = 0.3;
    private const double Long = 0.4;

    private readonly Simulator _simulator;
    private readonly StepLog _log = new();
    private readonly StepLog _watched = new();
    private readonly bool _stillAir;
    private Vector3d _target;
    private Vector3d _targetVelocity;
    private Vector3d? _through;
    private int[] _things = [];
    private int _met;
    private double _best;
    private double _bestThrough;
    private double _time;
    private double _start;
    private double _last;
    private double _fast;

    /// <param name="simulator">The scene.</param>
    public KickFlight(Simulator simulator)
    {
        _simulator = simulator;
        _stillAir = simulator.Scene.Air.IsStill;
        _watched.Observer = this;
    }

    public override bool WantsEndAcceleration => true;

    /// <summary>Whether it met all that it was to meet, in order, before anything else.</summary>
    public bool HasMetAll => _met == _things.Length;

    /// <summary>Distance of the closest approach to the target, m.</summary>
    public double Miss => Math.Sqrt(_best);

    /// <summary>Distance of that to the point on the way, m; null without one.</summary>
    public double? ThroughMiss => _through is null ? null : Math.Sqrt(_bestThrough);

    /// <summary>When it is closest to the target, s after the kick.</summary>
    public double Time => _time - _start;

    /// <summary>Where it is then, m.</summary>
    public Vector3d Position { get; private set; }

    /// <summary>How fast it is then, m/s.</summary>
    public Vector3d Velocity { get; private set; }

    /// <summary>The first thing but the ground that it met, as events number them; <see cref="NoThing"/> where it met none.</summary>
    public int Blocker { get; private set; }

    /// <summary>Flies a kick.</summary>
    /// <param name="state">The ball.</param>
    /// <param name="timeStep">Length of a step, s.</param>
    /// <param name="duration">How long it is followed, s.</param>
    /// <param name="target">The target at time 0, m.</param>
    /// <param name="targetVelocity">Its velocity, m/s.</param>
    /// <param name="through">The point on the way, m; null without one.</param>
    /// <param name="things">What it is to meet first.</param>
    public void Fly(BallState state, double timeStep, double duration, in Vector3d target, in Vector3d targetVelocity, Vector3d? through, int[] things)
    {
        // A step in the air that nobody watches is the fastest. Where the ball passes a point in it, or ends with an impact, it is taken again and looked at closely, as
        // every step on the ground is.
        Begin(in state, duration, in target, in targetVelocity, through, things);
        bool goesOn = true;
        long pieces = 0;
        double last = _last - (1e-9 * timeStep);
        while (goesOn && state.Time < last && pieces < AimContext.MostPieces)
        {
            BallState before = state;
            double step = Math.Min(timeStep, _last - state.Time);
            bool measures = HasMetAll;
            bool watches = measures && state.Motion != MotionState.Airborne;
            bool ended = false;
            StepLog log = _log;
            if (!watches)
            {
                log.Clear();
                ended = _simulator.StepToImpact(ref state, step, log);
                pieces += log.Steps;
                watches = measures && (ended || Passes(in before, in state));
            }

            if (watches)
            {
                state = before;
                log = _watched;
                log.Clear();
                ended = _simulator.StepToImpact(ref state, step, log);
                pieces += log.Steps;
            }
            else if (measures)
            {
                TakeEnd(in state);
            }

            goesOn = Meet(log.Events, in state, ref ended) && !ended && (_things.Length == 0 || !IsOver(in state));
        }
    }

    public override bool Add(in PathPiece piece)
    {
        PathPiece relative = _targetVelocity == Vector3d.Zero ? piece : piece.SeenFrom(in _targetVelocity);
        double squared = relative.ClosestApproach(in _target, out double time);
        Take(squared, time, piece.PositionAt(time), piece.VelocityAt(time));
        if (_through is { } point)
        {
            _bestThrough = Math.Min(_bestThrough, piece.ClosestApproach(in point, out _));
        }

        return piece.Motion != MotionState.Airborne && _targetVelocity == Vector3d.Zero
            && IsPast(in piece, in _target, _best) && (_through is not { } way || IsPast(in piece, in way, _bestThrough));
    }

    private void Begin(in BallState state, double duration, in Vector3d target, in Vector3d targetVelocity, Vector3d? through, int[] things)
    {
        _target = target;
        _targetVelocity = targetVelocity;
        _through = through;
        _things = things;
        _met = 0;
        _start = state.Time;
        _last = _start + duration;
        _fast = _start;
        Blocker = NoThing;
        _best = double.PositiveInfinity;
        _bestThrough = double.PositiveInfinity;
        if (HasMetAll)
        {
            TakeEnd(in state);
        }
    }

    /// <summary>Looks at what the ball met in a step.</summary>
    /// <returns>False where it was what was not to be met, or the next after all that was.</returns>
    private bool Meet(EventBuffer events, in BallState state, ref bool ended)
    {
        for (int i = 0; i < events.Count; i++)
        {
            ref readonly BallEvent e = ref events[i];
            Blocker = Blocker == NoThing && e.Thing > 0 && e.Kind is BallEventKind.Impact or BallEventKind.Net ? e.Thing : Blocker;
            if (e.Kind != BallEventKind.Impact)
            {
                continue;
            }

            if (HasMetAll || e.Thing != _things[_met])
            {
                return false;
            }

            ended = false;
            _met++;
            if (HasMetAll)
            {
                TakeEnd(in state);
            }
        }

        return true;
    }

    /// <summary>Whether a ball that came closer to the target, or the point on the way, leaves it again.</summary>
    private bool Passes(in BallState before, in BallState after) =>
        Passes(in before, in after, in _target, in _targetVelocity) || (_through is { } point && Passes(in before, in after, in point, Vector3d.Zero));

    private static bool Passes(in BallState before, in BallState after, in Vector3d point, in Vector3d velocity) =>
        Vector3d.Dot(before.Position - point - (before.Time * velocity), before.Velocity - velocity) < 0
        && Vector3d.Dot(after.Position - point - (after.Time * velocity), after.Velocity - velocity) > 0;

    private void TakeEnd(in BallState state)
    {
        Take((state.Position - _target - (state.Time * _targetVelocity)).LengthSquared, state.Time, state.Position, state.Velocity);
        if (_through is { } point)
        {
            _bestThrough = Math.Min(_bestThrough, (state.Position - point).LengthSquared);
        }
    }

    private void Take(double squared, double time, in Vector3d position, in Vector3d velocity)
    {
        if (squared < _best)
        {
            _best = squared;
            _time = time;
            Position = position;
            Velocity = velocity;
        }
    }

    /// <summary>Whether a ball on the ground comes no closer: it is too far below, or rolls away, and no wind brings it back.</summary>
    private bool IsPast(in PathPiece piece, in Vector3d point, double best)
    {
        Vector3d gap = piece.EndPosition - point;
        return gap.Y * gap.Y >= best || (_stillAir && piece.Motion == MotionState.Rolling && Vector3d.Dot(in gap, piece.EndVelocity) > 0);
    }

    /// <summary>Whether a ball that was to meet something comes no closer, meets nothing more, or gets nowhere in time.</summary>
    private bool IsOver(in BallState state)
    {
        if (!HasMetAll)
        {
            bool staysDown = state.Motion is MotionState.Sliding or MotionState.Rolling && state.Carrier == 0 && _things[_met] == 0;
            return staysDown || state.Motion == MotionState.Stopped || Creeps(in state);
        }

        // In the air it goes away for good where it is farther off by its way over the ground alone.
        Vector3d gap = state.Position - _target;
        bool isPast = state.Motion != MotionState.Airborne ? Vector3d.Dot(in gap, state.Velocity) > 0
            : _stillAir && gap.Horizontal.LengthSquared > _best && Vector3d.Dot(gap.Horizontal, state.Velocity) > 0;
        return isPast || state.Motion == MotionState.Stopped || Creeps(in state);
    }

    /// <summary>Whether the ball creeps down a net, and gets nowhere in time.</summary>
    private bool Creeps(in BallState state)
    {
        double speed = state.Velocity.Length;
        if (state.Nets == 0 || speed > Slow)
        {
            _fast = state.Time;
            return false;
        }

        if (state.Time - _fast < Long)
        {
            return false;
        }

        World world = _simulator.World;
        double gap = HasMetAll ? (state.Position - _target).Length - Miss
            : world.Colliders[_things[_met] - world.FirstCollider].At(state.Position, state.Time).Distance - world.Ball.Radius;
        return gap > 2.0 * speed * (_last - state.Time);
    }
}
