namespace FootballPhysics.Aiming;

/// <summary>The closest approach of a kick to a target that may move.</summary>
internal abstract class ApproachFlight : KickObserver
{
    private readonly KickFlight _flight;
    private double _time;
    private double _start;

    protected ApproachFlight(Simulator simulator)
    {
        Simulator = simulator;
        IsStill = simulator.Scene.Air.IsStill;
        _flight = new KickFlight(simulator, this);
    }

    public override bool WantsEndAcceleration => true;

    /// <summary>Distance of the closest approach to the target, m.</summary>
    public double Miss => Math.Sqrt(Squared);

    /// <summary>When it is closest to the target, s after the kick.</summary>
    public double Time => _time - _start;

    /// <summary>Where it is then, m.</summary>
    public Vector3d Position { get; private set; }

    /// <summary>How fast it is then, m/s.</summary>
    public Vector3d Velocity { get; private set; }

    /// <summary>Pieces of motion of the last flight.</summary>
    public long Pieces => _flight.Pieces;

    protected Simulator Simulator { get; }

    /// <summary>True when there is no wind, which could bring a ball back.</summary>
    protected bool IsStill { get; }

    /// <summary>The target at time 0, m.</summary>
    protected Vector3d Target { get; private set; }

    /// <summary>Its velocity, m/s.</summary>
    protected Vector3d TargetVelocity { get; private set; }

    /// <summary>Length of a step in the air, s.</summary>
    protected double TimeStep { get; private set; }

    /// <summary>When the flight is no longer followed, s.</summary>
    protected double Last { get; private set; }

    /// <summary>Square of the closest approach so far, m².</summary>
    protected double Squared { get; private set; }

    public override bool Add(in PathSegment piece)
    {
        double squared = ClosestApproach(in piece, out double time);
        Take(squared, time, piece.PositionAt(time), piece.VelocityAt(time));
        return IsPast(piece.Motion, Gap(piece.EndPosition, 0), piece.EndVelocity, Squared);
    }

    /// <summary>Prepares for a flight.</summary>
    protected void Begin(in BallState state, double timeStep, double duration, in Vector3d target, in Vector3d targetVelocity)
    {
        Target = target;
        TargetVelocity = targetVelocity;
        TimeStep = timeStep;
        _start = state.Time;
        Last = _start + duration;
        Squared = double.PositiveInfinity;
    }

    protected void Fly(ref BallState state) => _flight.Fly(ref state, Last - (1e-9 * TimeStep));

    /// <summary>The target at time 0, for a ball at a place.</summary>
    protected virtual Vector3d TargetFor(in Vector3d position) => Target;

    /// <summary>The square of a piece's closest approach, m², and its time.</summary>
    protected virtual double ClosestApproach(in PathSegment piece, out double time) =>
        (TargetVelocity == Vector3d.Zero ? piece : piece.SeenFrom(TargetVelocity)).ClosestApproach(Target, out time);

    /// <summary>From the target to a ball.</summary>
    protected Vector3d Gap(in Vector3d position, double time) => position - TargetFor(in position) - (time * TargetVelocity);

    /// <summary>True when a ball that came closer to the target leaves it again.</summary>
    protected bool Passes(in BallState before, in BallState after, in Vector3d velocity) =>
        Rate(in before, before.Velocity) < 0 && Rate(in after, in velocity) > 0;

    /// <summary>Takes the end of a step, m and m/s.</summary>
    protected virtual void TakeEnd(in BallState state, in Vector3d velocity) =>
        Take(Gap(state.Position, state.Time).LengthSquared, state.Time, state.Position, in velocity);

    /// <summary>True when a ball on the ground comes no closer: it is too far below, or rolls away, and no wind brings it back.</summary>
    protected bool IsPast(MotionState motion, in Vector3d gap, in Vector3d velocity, double best) =>
        motion != MotionState.Airborne && TargetVelocity == Vector3d.Zero
        && (gap.Y * gap.Y >= best || (IsStill && motion == MotionState.Rolling && Vector3d.Dot(in gap, in velocity) > 0));

    /// <summary>Half the rate of change of the squared distance, m²/s.</summary>
    private double Rate(in BallState state, in Vector3d velocity) => Vector3d.Dot(Gap(state.Position, state.Time), velocity - TargetVelocity);

    private void Take(double squared, double time, in Vector3d position, in Vector3d velocity)
    {
        if (squared < Squared)
        {
            Squared = squared;
            _time = time;
            Position = position;
            Velocity = velocity;
        }
    }
}

/// <summary>
/// Measures so that no doubt is left how close a kick comes to a target, and to a point on the way: before its first impact, or, where it is to meet some things first,
/// after those and before the next.
/// </summary>
internal sealed class MeasuredFlight : ApproachFlight
{
    /// <summary>Nothing but the ground was met.</summary>
    public const int NoThing = -1;

    /// <summary>A ball that has been in a net, slower than this, for so long only creeps on, m/s and s: no more than twice as fast.</summary>
    private const double Slow = 0.3;
    private const double Long = 0.4;

    private readonly StepLog _log = new() { IgnoresZones = true };
    private Vector3d? _through;
    private double _throughSquared;
    private int[] _things = [];
    private int _met;
    private double _fast;

    /// <param name="simulator">The scene.</param>
    public MeasuredFlight(Simulator simulator)
        : base(simulator)
    {
    }

    /// <summary>True when it met all that it was to meet, in order, before anything else.</summary>
    public bool HasMetAll => _met == _things.Length;

    /// <summary>Distance of the closest approach to the point on the way, m; null without one.</summary>
    public double? ThroughMiss => _through is null ? null : Math.Sqrt(_throughSquared);

    /// <summary>The first thing but the ground that it met, as events number them; <see cref="NoThing"/> where it met none.</summary>
    public int Blocker { get; private set; }

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
        Begin(in state, timeStep, duration, in target, in targetVelocity);
        _through = through;
        _throughSquared = double.PositiveInfinity;
        _things = things;
        _met = 0;
        _fast = state.Time;
        Blocker = NoThing;

        // Where nothing is to be met first, the start is an approach too: a kick may lead away at once.
        if (HasMetAll)
        {
            TakeEnd(in state, state.Velocity);
        }

        Fly(ref state);
    }

    /// <summary>Flies a kick until a time or its first impact.</summary>
    /// <returns>What but the ground it met first; <see cref="NoThing"/> where it met nothing.</returns>
    public int FlyTo(ref BallState state, double timeStep, double duration)
    {
        _log.Clear();
        Simulator.RunChecked(ref state, timeStep, duration, StopAt.Impact, _log, null);
        Blocker = NoThing;
        for (int i = 0; i < _log.Events.Count; i++)
        {
            NoteBlocker(in _log.Events[i]);
        }

        return Blocker;
    }

    public override double StepFrom(in BallState state, out bool watches)
    {
        // On the ground friction turns a way within a step: there each is watched.
        watches = HasMetAll && state.Motion != MotionState.Airborne;
        return Math.Min(TimeStep, Last - state.Time);
    }

    public override bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended)
    {
        if (!HasMetAll)
        {
            return false;
        }

        // An impact, or a passing of the target or of the point on the way, lies within the step: its pieces are looked at. Else the end will do.
        bool doubts = ended || Passes(in before, in after, after.Velocity)
            || (_through is { } point && Vector3d.Dot(before.Position - point, before.Velocity) < 0 && Vector3d.Dot(after.Position - point, after.Velocity) > 0);
        if (!doubts)
        {
            TakeEnd(in after, after.Velocity);
        }

        return doubts;
    }

    public override bool Add(in PathSegment piece)
    {
        bool isPast = base.Add(in piece);
        if (_through is not { } point)
        {
            return isPast;
        }

        _throughSquared = Math.Min(_throughSquared, piece.ClosestApproach(in point, out _));

        // Over only where it comes no closer to either.
        return isPast && IsPast(piece.Motion, piece.EndPosition - point, piece.EndVelocity, _throughSquared);
    }

    public override bool IsOver(in BallState before, in BallState after, EventBuffer events, bool ended)
    {
        // 1. An impact ends it, but for those that are asked for. 2. Until all of those were met: where the ball gets nowhere. 3. After them: where it comes no closer.
        for (int i = 0; i < events.Count; i++)
        {
            ref readonly BallEvent e = ref events[i];
            NoteBlocker(in e);

            // A net slows the ball, but ends nothing.
            if (e.Kind != BallEventKind.Impact)
            {
                continue;
            }

            if (HasMetAll || e.ColliderIndex != _things[_met])
            {
                return true;
            }

            // One of those asked for: the flight goes on, and after the last of them the approach begins.
            ended = false;
            _met++;
            if (HasMetAll)
            {
                TakeEnd(in after, after.Velocity);
            }
        }

        if (ended)
        {
            return true;
        }

        if (!HasMetAll)
        {
            // A ball that stays on the ground bounces off it no more; one at rest, or that creeps down a net, meets nothing more.
            bool staysDown = after.Motion is MotionState.Sliding or MotionState.Rolling && after.Carrier == 0 && _things[_met] == 0;
            return staysDown || after.Motion == MotionState.Rest || Creeps(in after);
        }

        bool isAtRest = after.Motion == MotionState.Rest && TargetVelocity == Vector3d.Zero;
        return isAtRest || (_things.Length > 0 && (Leaves(in after) || Creeps(in after)));
    }

    protected override void TakeEnd(in BallState state, in Vector3d velocity)
    {
        base.TakeEnd(in state, in velocity);
        if (_through is { } point)
        {
            _throughSquared = Math.Min(_throughSquared, (state.Position - point).LengthSquared);
        }
    }

    /// <summary>True when the ball goes away for good: in the air where it is farther off by its way over the ground alone.</summary>
    private bool Leaves(in BallState state)
    {
        Vector3d gap = Gap(state.Position, state.Time);
        Vector3d flat = gap.Horizontal;
        return state.Motion != MotionState.Airborne ? Vector3d.Dot(in gap, state.Velocity) > 0
            : IsStill && Vector3d.Dot(in flat, state.Velocity) > 0 && flat.LengthSquared > Squared;
    }

    private void NoteBlocker(in BallEvent e) =>
        Blocker = Blocker == NoThing && e.ColliderIndex > 0 && e.Kind is BallEventKind.Impact or BallEventKind.Net ? e.ColliderIndex : Blocker;

    /// <summary>True when the ball creeps down a net, and gets nowhere in time.</summary>
    private bool Creeps(in BallState state)
    {
        // A ball in a net swings for long: given up where it is slow for a while, and twice its speed would not bring it there in time.
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

        World world = Simulator.World;
        double gap = HasMetAll ? (state.Position - Target).Length - Miss
            : world.Colliders[_things[_met] - world.FirstCollider].At(state.Position, state.Time).Distance - world.Ball.Radius;
        return gap > 2.0 * speed * (Last - state.Time);
    }
}

/// <summary>Looks in long steps how close a kick comes to a target before its first impact, until it can come no closer.</summary>
internal class KickLook : ApproachFlight
{
    /// <summary>Steps on the ground are this share of those in the air, s, and no longer than this: longer ones are taken in pieces, which cost as much each.</summary>
    private const double GroundShare = 0.2;
    private const double LongestRoll = 0.08;

    /// <param name="simulator">The scene.</param>
    public KickLook(Simulator simulator)
        : base(simulator)
    {
    }

    /// <summary>Ball and target.</summary>
    protected TargetFrame Frame { get; private set; }

    /// <summary>Looks how close a kick comes.</summary>
    /// <param name="frame">Ball and target.</param>
    /// <param name="targetVelocity">Velocity of the target, m/s.</param>
    /// <param name="kick">The kick.</param>
    /// <param name="speed">Its speed, m/s.</param>
    /// <param name="timeStep">Step of the flight, s.</param>
    public virtual Approach Fly(in TargetFrame frame, in Vector3d targetVelocity, in Kick kick, double speed, double timeStep)
    {
        // Flown until it comes no closer; the start counts as an approach.
        kick.Vectors(speed, in frame.Forward, out Vector3d velocity, out Vector3d spin);
        BallState state = Simulator.Launch(frame.From, velocity, spin);
        Frame = frame;
        Begin(in state, timeStep, AimContext.LongestFlight, in frame.Target, in targetVelocity);
        TakeEnd(in state, state.Velocity);
        Fly(ref state);
        var approach = new Approach { Kick = kick, Miss = Miss, Time = Time, Gap = Gap(Position, Time) };
        approach.Above = IsAbove(approach.Gap, kick.Direction(in frame.Forward));
        return approach;
    }

    public override double StepFrom(in BallState state, out bool watches)
    {
        watches = false;
        double step = state.Motion == MotionState.Airborne ? TimeStep : Math.Min(GroundShare * TimeStep, LongestRoll);
        return Math.Min(step, Last - state.Time);
    }

    public override bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended)
    {
        // Where it passes the target in a step of one piece, the cubic between the ends will do. What an impact did to the velocity comes after the approach.
        Vector3d velocity = ended ? BeforeImpact(log.Events) : after.Velocity;
        if (!Passes(in before, in after, in velocity))
        {
            TakeEnd(in after, in velocity);
            return false;
        }

        if (ended || log.Steps != 1)
        {
            return true;
        }

        Add(PathSegment.Cubic(in before, in after));
        return false;
    }

    public override bool IsOver(in BallState before, in BallState after, EventBuffer events, bool ended)
    {
        if (ended || (after.Motion == MotionState.Rest && TargetVelocity == Vector3d.Zero))
        {
            return true;
        }

        Vector3d gap = Gap(after.Position, after.Time);
        return after.Motion == MotionState.Airborne ? Leaves(in after, in gap) : IsPast(after.Motion, in gap, after.Velocity, Squared);
    }

    /// <summary>True when a ball in the air can come no closer: in a wind, or to a target that moves, it may.</summary>
    protected virtual bool Leaves(in BallState state, in Vector3d gap) => false;

    /// <summary>True when the target is below the way: to the right of the motion as seen in the plane of way and height.</summary>
    protected bool IsAbove(in Vector3d gap, in Vector3d ahead)
    {
        // The side of the way on which the target lies, in the vertical plane: the sign of the cross product of way and gap.
        Vector3d moving = Velocity - TargetVelocity;
        return (Vector3d.Dot(in moving, in ahead) * gap.Y) - (moving.Y * Vector3d.Dot(in gap, in ahead)) > 0;
    }

    /// <summary>The velocity with which the ball met the ground.</summary>
    private static Vector3d BeforeImpact(EventBuffer events)
    {
        int last = events.Count - 1;
        return events[events[last].Kind == BallEventKind.Impact ? last : last - 1].VelocityBefore;
    }
}

/// <summary>
/// The same in still air, for a target at rest. There a flight turns with its azimuth as it is, so the target is turned to where the ball is instead: distance and height of
/// the way count alone, and the azimuth that goes with them is known after one flight.
/// </summary>
internal sealed class TurningLook : KickLook
{
    private bool _isBeyond;

    /// <param name="simulator">The scene.</param>
    public TurningLook(Simulator simulator)
        : base(simulator)
    {
    }

    public override Approach Fly(in TargetFrame frame, in Vector3d targetVelocity, in Kick kick, double speed, double timeStep)
    {
        _isBeyond = false;
        Approach approach = base.Fly(in frame, in targetVelocity, in kick, speed, timeStep);

        // The target was turned to where the ball is; turning the kick back by that bearing brings the ball to the target.
        Vector3d went = (Position - frame.From).Horizontal;
        double length = went.Length;
        Vector3d ahead = length > 1e-9 ? went / length : kick.Direction(in frame.Forward);
        approach.Kick.Azimuth -= length > 0 ? Elementary.Atan2(Vector3d.Dot(in went, in frame.Left), Vector3d.Dot(in went, in frame.Forward)) : 0;

        // A way that ends before the target's distance passes below it, whatever its last direction says.
        approach.Above = _isBeyond && IsAbove(approach.Gap, in ahead);
        return approach;
    }

    public override bool IsOver(in BallState before, in BallState after, EventBuffer events, bool ended)
    {
        _isBeyond |= before.Motion == MotionState.Airborne && (after.Position - Frame.From).Horizontal.LengthSquared >= Frame.Distance * Frame.Distance;
        return base.IsOver(in before, in after, events, ended);
    }

    protected override Vector3d TargetFor(in Vector3d position)
    {
        Vector3d went = (position - Frame.From).Horizontal;
        double length = went.Length;
        return length > 1e-9 ? new Vector3d(Frame.From.X, Target.Y, Frame.From.Z) + (Frame.Distance / length * went) : Target;
    }

    protected override double ClosestApproach(in PathSegment piece, out double time)
    {
        // The target turns with the ball: from where the ball is in the middle to where it was closest.
        time = piece.Time + (0.5 * piece.Length);
        for (int i = 0; i < 2; i++)
        {
            piece.ClosestApproach(TargetFor(piece.PositionAt(time)), out time);
        }

        return Gap(piece.PositionAt(time), time).LengthSquared;
    }

    protected override bool Leaves(in BallState state, in Vector3d gap)
    {
        // It is farther off by its way over the ground alone, or falls beyond.
        Vector3d flat = gap.Horizontal;
        return Vector3d.Dot(in flat, state.Velocity) > 0 && Vector3d.Dot(state.Position - Frame.From, in flat) > 0
            && (flat.LengthSquared > Squared || (gap.Y < 0 && state.Velocity.Y < 0));
    }
}
