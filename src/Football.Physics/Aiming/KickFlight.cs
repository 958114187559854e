namespace Football.Physics;

/// <summary>
/// Flies a kick step by step, and tells how close it comes to a target that may move, and to a point on the way: before its first impact, or, where it is to meet some things
/// first, after those and before the next. It is measured so that no doubt is left, or looked at, in long steps that end where it can come no closer.
/// </summary>
/// <remarks>
/// In still air a flight turns with its azimuth as it is. A look at a target at rest turns the target to where the ball is instead: distance and height of the way count
/// alone, and the azimuth that goes with them is known after one flight.
/// </remarks>
internal sealed class KickFlight : PieceObserver
{
    /// <summary>Nothing but the ground was met.</summary>
    public const int NoThing = -1;

    /// <summary>A ball that has been in a net, slower than this, for so long only creeps on, m/s and s: no more than twice as fast.</summary>
    private const double Slow = 0.3;
    private const double Long = 0.4;

    /// <summary>Steps of a look on the ground are this share of those in the air, s, and no longer than this: longer ones are taken in pieces, which cost as much each.</summary>
    private const double GroundShare = 0.2;
    private const double LongestRoll = 0.08;

    private readonly Simulator _simulator;
    private readonly StepLog _log = new();
    private readonly StepLog _watched = new();
    private readonly bool _stillAir;
    private Vector3d _target;
    private Vector3d _targetVelocity;
    private Vector3d? _through;
    private TargetFrame _frame;
    private bool _looks;
    private bool _turns;
    private bool _isBeyond;
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

    /// <summary>Pieces of motion of the last flight.</summary>
    public long Pieces { get; private set; }

    /// <summary>Whether flights of a kick for a target with a velocity turn with their azimuth.</summary>
    public bool Turns(in Vector3d targetVelocity) => _stillAir && targetVelocity == Vector3d.Zero;

    /// <summary>Flies a kick, and measures.</summary>
    /// <param name="state">The ball.</param>
    /// <param name="timeStep">Length of a step, s.</param>
    /// <param name="duration">How long it is followed, s.</param>
    /// <param name="target">The target at time 0, m.</param>
    /// <param name="targetVelocity">Its velocity, m/s.</param>
    /// <param name="through">The point on the way, m; null without one.</param>
    /// <param name="things">What it is to meet first.</param>
    public void Fly(BallState state, double timeStep, double duration, in Vector3d target, in Vector3d targetVelocity, Vector3d? through, int[] things)
    {
        _looks = false;
        _turns = false;
        Begin(in state, duration, in target, in targetVelocity, through, things);
        Fly(ref state, timeStep);
    }

    /// <summary>Flies a kick until a time or its first impact.</summary>
    /// <returns>What but the ground it met first; <see cref="NoThing"/> where it met nothing.</returns>
    public int FlyTo(ref BallState state, double timeStep, double duration)
    {
        _log.Clear();
        _simulator.Run(ref state, timeStep, duration, StopAt.Impact, _log, null);
        Blocker = NoThing;
        for (int i = 0; i < _log.Events.Count; i++)
        {
            NoteBlocker(in _log.Events[i]);
        }

        return Blocker;
    }

    /// <summary>Looks how close a kick comes until it can come no closer.</summary>
    /// <param name="frame">Ball and target.</param>
    /// <param name="targetVelocity">Velocity of the target, m/s.</param>
    /// <param name="kick">The kick.</param>
    /// <param name="speed">Its speed, m/s.</param>
    /// <param name="timeStep">Step of the flight, s.</param>
    public Approach Look(in TargetFrame frame, in Vector3d targetVelocity, in Kick kick, double speed, double timeStep)
    {
        kick.Vectors(speed, in frame.Forward, out Vector3d velocity, out Vector3d spin);
        BallState state = _simulator.Launch(frame.From, velocity, spin);
        _frame = frame;
        _looks = true;
        _turns = Turns(in targetVelocity);
        Begin(in state, AimContext.LongestFlight, in frame.Target, in targetVelocity, null, []);
        Fly(ref state, timeStep);

        // The target is below the way where it lies to the right of the motion, seen in the plane of way and height.
        Vector3d gap = Gap(Position, _time);
        Vector3d moving = Velocity - targetVelocity;
        Vector3d went = (Position - frame.From).Horizontal;
        double length = went.Length;
        Vector3d ahead = _turns && length > 1e-9 ? went / length : kick.Direction(in frame.Forward);
        var approach = new Approach { Kick = kick, Miss = Miss, Time = Time, Gap = gap };
        approach.Kick.Azimuth -= _turns && length > 0 ? Elementary.Atan2(Vector3d.Dot(in went, in frame.Left), Vector3d.Dot(in went, in frame.Forward)) : 0;
        approach.Above = (_isBeyond || !_turns) && (Vector3d.Dot(in moving, in ahead) * gap.Y) - (moving.Y * Vector3d.Dot(in gap, in ahead)) > 0;
        return approach;
    }

    public override bool Add(in PathPiece piece)
    {
        PathPiece relative = _targetVelocity == Vector3d.Zero ? piece : piece.SeenFrom(in _targetVelocity);
        double time = piece.Time + (0.5 * piece.Length);
        double squared = 0;
        for (int i = 0; i < (_turns ? 2 : 1); i++)
        {
            squared = relative.ClosestApproach(Target(piece.PositionAt(time)), out time);
        }

        Vector3d position = piece.PositionAt(time);
        Take(_turns ? Gap(in position, time).LengthSquared : squared, time, in position, piece.VelocityAt(time));
        if (_through is { } point)
        {
            _bestThrough = Math.Min(_bestThrough, piece.ClosestApproach(in point, out _));
        }

        return IsPast(piece.Motion, Gap(piece.EndPosition, 0), piece.EndVelocity, _best)
            && (_through is not { } way || IsPast(piece.Motion, piece.EndPosition - way, piece.EndVelocity, _bestThrough));
    }

    private void Fly(ref BallState state, double timeStep)
    {
        // A step in the air that nobody watches is the fastest. Where the ball passes a point in it, or ends with an impact, it is taken again and looked at closely, as
        // every step on the ground is; for a look the cubic of a whole step will do.
        bool goesOn = true;
        double last = _last - (1e-9 * timeStep);
        Pieces = 0;
        while (goesOn && state.Time < last && Pieces < AimContext.MostPieces)
        {
            BallState before = state;
            bool measures = HasMetAll;
            bool isFlying = state.Motion == MotionState.Airborne;
            bool watches = measures && !isFlying && !_looks;
            double step = Math.Min(_looks && !isFlying ? Math.Min(GroundShare * timeStep, LongestRoll) : timeStep, _last - state.Time);
            bool ended = false;
            StepLog log = _log;
            if (!watches)
            {
                ended = Step(ref state, step, log);
                Vector3d velocity = _looks && ended ? BeforeImpact(log.Events) : state.Velocity;
                watches = measures && ((ended && !_looks) || Passes(in before, in state, in velocity));
                if (watches && _looks && !ended && log.Steps == 1)
                {
                    watches = false;
                    Add(PathPiece.Cubic(in before, in state));
                }
                else if (measures && !watches)
                {
                    TakeEnd(in state, in velocity);
                }
            }

            if (watches)
            {
                state = before;
                log = _watched;
                ended = Step(ref state, step, log);
            }

            _isBeyond |= isFlying && (state.Position - _frame.From).Horizontal.LengthSquared >= _frame.Distance * _frame.Distance;
            goesOn = Meet(log.Events, in state, ref ended) && !ended && !IsOver(in state);
        }
    }

    private bool Step(ref BallState state, double step, StepLog log)
    {
        log.Clear();
        bool ended = _simulator.StepToImpact(ref state, step, log);
        Pieces += log.Steps;
        return ended;
    }

    /// <summary>The velocity with which the ball met the ground.</summary>
    private static Vector3d BeforeImpact(EventBuffer events)
    {
        int last = events.Count - 1;
        return events[events[last].Kind == BallEventKind.Impact ? last : last - 1].VelocityBefore;
    }

    /// <summary>The target at time 0; or turned to the direction in which the ball is.</summary>
    private Vector3d Target(in Vector3d position)
    {
        Vector3d went = (position - _frame.From).Horizontal;
        double length = _turns ? went.Length : 0;
        return length > 1e-9 ? new Vector3d(_frame.From.X, _target.Y, _frame.From.Z) + (_frame.Distance / length * went) : _target;
    }

    /// <summary>From the target to a ball.</summary>
    private Vector3d Gap(in Vector3d position, double time) => position - Target(in position) - (time * _targetVelocity);

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
        _isBeyond = false;
        Blocker = NoThing;
        _best = double.PositiveInfinity;
        _bestThrough = double.PositiveInfinity;
        if (HasMetAll)
        {
            TakeEnd(in state, state.Velocity);
        }
    }

    /// <summary>Looks at what the ball met in a step.</summary>
    /// <returns>False where it was what was not to be met, or the next after all that was.</returns>
    private bool Meet(EventBuffer events, in BallState state, ref bool ended)
    {
        for (int i = 0; i < events.Count; i++)
        {
            ref readonly BallEvent e = ref events[i];
            NoteBlocker(in e);
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
                TakeEnd(in state, state.Velocity);
            }
        }

        return true;
    }

    private void NoteBlocker(in BallEvent e) =>
        Blocker = Blocker == NoThing && e.Thing > 0 && e.Kind is BallEventKind.Impact or BallEventKind.Net ? e.Thing : Blocker;

    /// <summary>Whether a ball that came closer to the target, or the point on the way, leaves it again.</summary>
    private bool Passes(in BallState before, in BallState after, in Vector3d velocity) =>
        (Rate(in before, before.Velocity) < 0 && Rate(in after, in velocity) > 0)
        || (_through is { } point && Vector3d.Dot(before.Position - point, before.Velocity) < 0 && Vector3d.Dot(after.Position - point, in velocity) > 0);

    /// <summary>Half the rate of change of the squared distance, m²/s.</summary>
    private double Rate(in BallState state, in Vector3d velocity) => Vector3d.Dot(Gap(state.Position, state.Time), velocity - _targetVelocity);

    private void TakeEnd(in BallState state, in Vector3d velocity)
    {
        Take(Gap(state.Position, state.Time).LengthSquared, state.Time, state.Position, in velocity);
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
    private bool IsPast(MotionState motion, in Vector3d gap, in Vector3d velocity, double best) =>
        motion != MotionState.Airborne && _targetVelocity == Vector3d.Zero
        && (gap.Y * gap.Y >= best || (_stillAir && motion == MotionState.Rolling && Vector3d.Dot(in gap, in velocity) > 0));

    /// <summary>Whether a ball comes no closer, meets nothing more that it is to meet, or gets nowhere in time.</summary>
    private bool IsOver(in BallState state)
    {
        if (!HasMetAll)
        {
            bool staysDown = state.Motion is MotionState.Sliding or MotionState.Rolling && state.Carrier == 0 && _things[_met] == 0;
            return staysDown || state.Motion == MotionState.Stopped || Creeps(in state);
        }

        bool isAtRest = state.Motion == MotionState.Stopped && _targetVelocity == Vector3d.Zero;
        if (isAtRest || (_things.Length == 0 && !_looks))
        {
            return isAtRest;
        }

        // In the air it goes away for good where it is farther off by its way over the ground alone, or falls beyond.
        Vector3d gap = Gap(state.Position, state.Time);
        Vector3d flat = gap.Horizontal;
        bool leaves = Vector3d.Dot(in flat, state.Velocity) > 0;
        bool isPast = state.Motion != MotionState.Airborne ? (_looks ? IsPast(state.Motion, in gap, state.Velocity, _best) : Vector3d.Dot(in gap, state.Velocity) > 0)
            : (_turns || _things.Length > 0) && _stillAir && leaves && (!_turns || Vector3d.Dot(state.Position - _frame.From, in flat) > 0)
                && (flat.LengthSquared > _best || (_turns && gap.Y < 0 && state.Velocity.Y < 0));
        return isPast || (!_looks && Creeps(in state));
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
