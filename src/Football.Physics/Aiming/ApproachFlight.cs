using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Aiming;

/// <summary>Finds the closest approach of a kick to a target that may move.</summary>
internal abstract class ApproachFlight : PieceObserver, IKickObserver
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

    /// <summary>The distance of the closest approach to the target, in m.</summary>
    public double Miss => Math.Sqrt(Squared);

    /// <summary>The time of the closest approach, in s after the kick.</summary>
    public double Time => _time - _start;

    /// <summary>The position of the ball at the closest approach, in m.</summary>
    public Vector3d Position { get; private set; }

    /// <summary>The velocity of the ball at the closest approach, in m/s.</summary>
    public Vector3d Velocity { get; private set; }

    /// <summary>The number of path segments of the last flight.</summary>
    public long Pieces => _flight.Pieces;

    protected Simulator Simulator { get; }

    /// <summary>True if there is no wind that could bring the ball back.</summary>
    protected bool IsStill { get; }

    /// <summary>The target at time 0, in m.</summary>
    protected Vector3d Target { get; private set; }

    /// <summary>The velocity of the target, in m/s.</summary>
    protected Vector3d TargetVelocity { get; private set; }

    /// <summary>The length of a step in the air, in s.</summary>
    protected double TimeStep { get; private set; }

    /// <summary>The time at which the flight ends, in s.</summary>
    protected double Last { get; private set; }

    /// <summary>The square of the closest approach so far, in m².</summary>
    protected double Squared { get; private set; }

    public abstract double StepFrom(in BallState state, out bool watches);

    public abstract bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended);

    public abstract bool IsOver(in BallState before, in BallState after, EventBuffer events, bool ended);

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

    protected void Fly(ref BallState state) => _flight.Fly(ref state, Last - (ContactTolerances.StepRounding * TimeStep));

    /// <summary>Returns the target's position at time 0, which may depend on the ball's position.</summary>
    protected virtual Vector3d TargetFor(in Vector3d position) => Target;

    /// <summary>Returns the squared distance of a segment's closest approach, in m², and its time.</summary>
    protected virtual double ClosestApproach(in PathSegment piece, out double time) =>
        (TargetVelocity == Vector3d.Zero ? piece : piece.SeenFrom(TargetVelocity)).ClosestApproach(Target, out time);

    /// <summary>Returns the vector from the target to the ball.</summary>
    protected Vector3d Gap(in Vector3d position, double time) => position - TargetFor(in position) - (time * TargetVelocity);

    /// <summary>True if the ball approaches the target at the start of a step, and recedes from it at the end.</summary>
    protected bool Passes(in BallState before, in BallState after, in Vector3d velocity) =>
        Rate(in before, before.Velocity) < 0 && Rate(in after, in velocity) > 0;

    /// <summary>Updates the closest approach with the state at the end of a step, in m and m/s.</summary>
    protected void TakeEnd(in BallState state, in Vector3d gap, in Vector3d velocity) => Take(gap.LengthSquared, state.Time, state.Position, in velocity);

    /// <summary>True if a ball on the ground comes no closer, because it is too far below the target, or rolls away in still air.</summary>
    protected bool IsPast(MotionState motion, in Vector3d gap, in Vector3d velocity, double best) =>
        motion != MotionState.Airborne && TargetVelocity == Vector3d.Zero
        && (gap.Y * gap.Y >= best || (IsStill && motion == MotionState.Rolling && Vector3d.Dot(in gap, in velocity) > 0));

    /// <summary>Returns half the rate of change of the squared distance, in m²/s.</summary>
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

/// <summary>Measures the closest approach of a kick to a target and a waypoint, before the first impact.</summary>
/// <remarks>
/// If the kick must hit given objects first, the measurement begins after the last of them and ends at the next impact.
/// </remarks>
/// <param name="simulator">The scene.</param>
internal sealed class MeasuredFlight(Simulator simulator) : ApproachFlight(simulator)
{
    /// <summary>The value of <see cref="Blocker"/> if the ball hit only the ground.</summary>
    public const int NoThing = -1;

    /// <summary>A ball in a net creeps if it stays below this speed, in m/s, for this time, in s; it then at most doubles its speed.</summary>
    private const double Slow = 0.3;
    private const double Long = 0.4;

    /// <summary>The length of a step of rolling on a plane, in s. The measured miss is then accurate to a millionth of itself; in steps of 0.1 s it is not.</summary>
    private const double RollStep = 0.04;

    private readonly double _longestRollStep = MeasuringStep.IsUneven(simulator) ? 0 : RollStep;
    private readonly StepLog _log = new() { IgnoresZones = true };
    private Vector3d? _through;
    private double _throughSquared;
    private int[] _things = [];
    private int _met;
    private double _fast;

    /// <summary>True if the ball hit all required objects, in order, before any other.</summary>
    public bool HasMetAll => _met == _things.Length;

    /// <summary>The distance of the closest approach to the waypoint, in m; null without one.</summary>
    public double? ThroughMiss => _through is null ? null : Math.Sqrt(_throughSquared);

    /// <summary>The first object except the ground that the ball hit, numbered as in events; <see cref="NoThing"/> if there is none.</summary>
    public int Blocker { get; private set; }

    /// <summary>Simulates a kick and measures its closest approach.</summary>
    /// <param name="state">The ball.</param>
    /// <param name="timeStep">The length of a step, in s.</param>
    /// <param name="duration">The duration of the flight, in s.</param>
    /// <param name="target">The target at time 0, in m.</param>
    /// <param name="targetVelocity">The velocity of the target, in m/s.</param>
    /// <param name="through">The waypoint, in m; null without one.</param>
    /// <param name="things">The objects that the ball must hit first.</param>
    public void Fly(BallState state, double timeStep, double duration, in Vector3d target, in Vector3d targetVelocity, Vector3d? through, int[] things)
    {
        Begin(in state, timeStep, duration, in target, in targetVelocity);
        _through = through;
        _throughSquared = double.PositiveInfinity;
        _things = things;
        _met = 0;
        _fast = state.Time;
        Blocker = NoThing;

        // If no objects are required, the start counts as an approach, because the ball may move away at once.
        if (HasMetAll)
        {
            TakeEnd(in state, state.Velocity);
        }

        Fly(ref state);
    }

    /// <summary>Simulates a kick for a duration, or until its first impact.</summary>
    /// <returns>The first object except the ground that the ball hit; <see cref="NoThing"/> if there is none.</returns>
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
        // On the ground, friction curves the path within a step, so inspect every step. A roll on a plane changes slowly.
        watches = HasMetAll && state.Motion != MotionState.Airborne;
        double step = state.Motion == MotionState.Rolling ? Math.Max(TimeStep, _longestRollStep) : TimeStep;
        return Math.Min(step, Last - state.Time);
    }

    public override bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended)
    {
        if (!HasMetAll)
        {
            return false;
        }

        // Inspect the segments if the step contains an impact, or passes the target or waypoint. Otherwise, the end of the step is sufficient.
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

        // Stop only if the ball approaches neither the target nor the waypoint.
        return isPast && IsPast(piece.Motion, piece.EndPosition - point, piece.EndVelocity, _throughSquared);
    }

    public override bool IsOver(in BallState before, in BallState after, EventBuffer events, bool ended)
    {
        // 1. An impact ends the flight, unless the kick must hit that object. 2. While required objects remain, end if the ball is stuck. 3. After
        // that, end when the ball no longer approaches.
        for (int i = 0; i < events.Count; i++)
        {
            ref readonly BallEvent e = ref events[i];
            NoteBlocker(in e);

            // A net slows the ball, but does not end the flight.
            if (e.Kind != BallEventKind.Impact)
            {
                continue;
            }

            if (HasMetAll || e.ColliderIndex != _things[_met])
            {
                return true;
            }

            // After a required impact, the flight continues. After the last one, the approach begins.
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
            // A ball that stays on the ground cannot bounce off the ground again. A ball that is at rest, or creeps down a net, hits nothing more.
            bool staysDown = after.Motion is MotionState.Sliding or MotionState.Rolling && after.Carrier == 0 && _things[_met] == 0;
            return staysDown || after.Motion == MotionState.Rest || Creeps(in after);
        }

        bool isAtRest = after.Motion == MotionState.Rest && TargetVelocity == Vector3d.Zero;
        return isAtRest || (_things.Length > 0 && (Leaves(in after) || Creeps(in after)));
    }

    private void TakeEnd(in BallState state, in Vector3d velocity)
    {
        TakeEnd(in state, Gap(state.Position, state.Time), in velocity);
        if (_through is { } point)
        {
            _throughSquared = Math.Min(_throughSquared, (state.Position - point).LengthSquared);
        }
    }

    /// <summary>True if the ball moves away for good; in the air, if its horizontal distance alone exceeds the best.</summary>
    private bool Leaves(in BallState state)
    {
        Vector3d gap = Gap(state.Position, state.Time);
        Vector3d flat = gap.Horizontal;
        return state.Motion != MotionState.Airborne ? Vector3d.Dot(in gap, state.Velocity) > 0
            : IsStill && Vector3d.Dot(in flat, state.Velocity) > 0 && flat.LengthSquared > Squared;
    }

    private void NoteBlocker(in BallEvent e) =>
        Blocker = Blocker == NoThing && e.ColliderIndex > 0 && e.Kind is BallEventKind.Impact or BallEventKind.Net ? e.ColliderIndex : Blocker;

    /// <summary>True if the ball creeps down a net and cannot reach anything in time.</summary>
    private bool Creeps(in BallState state)
    {
        // A ball in a net swings for a long time. Stop if it stays slow for a while, and would not reach the target in time even at twice its speed.
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
            : world.ByIndex[_things[_met] - world.FirstCollider].At(state.Position, state.Time).Distance - world.Ball.Radius;
        return gap > 2.0 * speed * (Last - state.Time);
    }
}
