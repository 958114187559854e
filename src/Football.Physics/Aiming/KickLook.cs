using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>Estimates the closest approach of a kick before its first impact, in long steps.</summary>
/// <param name="simulator">The scene.</param>
internal class KickLook(Simulator simulator) : ApproachFlight(simulator)
{
    /// <summary>Steps on the ground as a share of those in the air, and their maximum, in s; a longer step of sliding would be split and save nothing.</summary>
    private const double GroundShare = 0.2;
    private const double LongestOnGround = 0.08;

    /// <summary>The difference in height, in m, beyond which a ball on level ground cannot hit the target: it then needs no short steps.</summary>
    private const double OutOfReach = 0.05;

    private readonly bool _isLevel = simulator.World.Ground is { IsLevelGround: true };
    private Vector3d _gap;
    private bool _approaches;

    /// <summary>The positions of the ball and the target.</summary>
    protected TargetFrame Frame { get; private set; }

    /// <summary>Estimates the closest approach of a kick.</summary>
    /// <param name="frame">Ball and target.</param>
    /// <param name="targetVelocity">The velocity of the target, in m/s.</param>
    /// <param name="kick">The kick.</param>
    /// <param name="speed">The speed of the kick, in m/s.</param>
    /// <param name="timeStep">The step of the flight, in s.</param>
    public virtual Approach Fly(in TargetFrame frame, in Vector3d targetVelocity, in Kick kick, double speed, double timeStep)
    {
        // Simulate until the ball no longer approaches; the start counts as an approach.
        kick.Vectors(speed, in frame.Forward, out Vector3d velocity, out Vector3d spin);
        BallState state = Simulator.LaunchAt(in frame.From, in velocity, in spin, 0, in frame.Orientation);
        Frame = frame;
        Begin(in state, timeStep, AimContext.LongestFlight, in frame.Target, in targetVelocity);
        TakeGap(in state, state.Velocity);
        TakeEnd(in state, in _gap, state.Velocity);
        Fly(ref state);
        var approach = new Approach { Kick = kick, Miss = Miss, Time = Time, Gap = Gap(Position, Time) };
        approach.Above = IsAbove(approach.Gap, kick.Direction(in frame.Forward));
        return approach;
    }

    public override double StepFrom(in BallState state, out bool watches)
    {
        watches = false;
        bool isOutOfReach = _isLevel && state.Motion != MotionState.Airborne && Math.Abs(state.Position.Y - Target.Y) > OutOfReach;
        double step = state.Motion == MotionState.Airborne || isOutOfReach ? TimeStep : Math.Min(GroundShare * TimeStep, LongestOnGround);
        return Math.Min(step, Last - state.Time);
    }

    public override bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended)
    {
        // If the ball passes the target in a step with one segment, a cubic between its ends is sufficient. At an impact, use the velocity before the impact.
        Vector3d velocity = ended ? BeforeImpact(log.Events) : after.Velocity;
        bool stops = after.Motion == MotionState.Rest;
        bool approached = _approaches;
        double rate = TakeGap(in after, in velocity);
        if (!stops && !(approached && rate > 0))
        {
            TakeEnd(in after, in _gap, in velocity);
            return false;
        }

        // A ball that stops may have passed the target before, and its velocity does not show it.
        if (stops || ended || log.Steps != 1)
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

        return after.Motion == MotionState.Airborne ? Leaves(in after, in _gap) : IsPast(after.Motion, in _gap, after.Velocity, Squared);
    }

    /// <summary>True if an airborne ball can come no closer; false in wind or for a moving target, because it may still do so.</summary>
    protected virtual bool Leaves(in BallState state, in Vector3d gap) => false;

    /// <summary>True if the ball passes above the target, in the vertical plane of the motion.</summary>
    protected bool IsAbove(in Vector3d gap, in Vector3d ahead)
    {
        // The target's side of the path: the sign of the cross product of velocity and gap.
        Vector3d moving = Velocity - TargetVelocity;
        return (Vector3d.Dot(in moving, in ahead) * gap.Y) - (moving.Y * Vector3d.Dot(in gap, in ahead)) > 0;
    }

    /// <summary>Stores the gap at the end of a step, and whether it shrinks there.</summary>
    /// <returns>Half the rate of change of the squared gap, in m²/s.</returns>
    private double TakeGap(in BallState state, in Vector3d velocity)
    {
        _gap = Gap(state.Position, state.Time);
        double rate = Vector3d.Dot(in _gap, velocity - TargetVelocity);
        _approaches = rate < 0;
        return rate;
    }

    /// <summary>Returns the velocity with which the ball hit the ground.</summary>
    private static Vector3d BeforeImpact(EventBuffer events)
    {
        int last = events.Count - 1;
        return events[events[last].Kind == BallEventKind.Impact ? last : last - 1].VelocityBefore;
    }
}

/// <summary>Estimates the closest approach in still air, for a target at rest, independent of the azimuth.</summary>
/// <remarks>
/// In still air, rotating the azimuth rotates the whole flight. So rotate the target to the ball's bearing instead: only the target's distance
/// and height matter, and one flight yields the azimuth that hits.
/// </remarks>
/// <param name="simulator">The scene.</param>
internal sealed class TurningLook(Simulator simulator) : KickLook(simulator)
{
    private bool _isBeyond;

    public override Approach Fly(in TargetFrame frame, in Vector3d targetVelocity, in Kick kick, double speed, double timeStep)
    {
        _isBeyond = false;
        Approach approach = base.Fly(in frame, in targetVelocity, in kick, speed, timeStep);

        // The target was rotated to the ball's bearing. Rotate the kick back by this bearing, so that the ball reaches the target.
        Vector3d went = (Position - frame.From).Horizontal;
        double length = went.Length;
        Vector3d ahead = length > 1e-9 ? went / length : kick.Direction(in frame.Forward);
        approach.Kick.Azimuth -= length > 0 ? Elementary.Atan2(Vector3d.Dot(in went, in frame.Left), Vector3d.Dot(in went, in frame.Forward)) : 0;

        // A path that ends before it has covered the target's distance passes below the target, whatever its final direction.
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
        // The target rotates with the ball: start with the ball's position at the midpoint, and iterate to the closest approach.
        time = piece.Time + (0.5 * piece.Length);
        for (int i = 0; i < 2; i++)
        {
            piece.ClosestApproach(TargetFor(piece.PositionAt(time)), out time);
        }

        return Gap(piece.PositionAt(time), time).LengthSquared;
    }

    protected override bool Leaves(in BallState state, in Vector3d gap)
    {
        // The horizontal distance exceeds that of the best approach, or the ball falls beyond and below the target.
        Vector3d flat = gap.Horizontal;
        return Vector3d.Dot(in flat, state.Velocity) > 0 && Vector3d.Dot(state.Position - Frame.From, in flat) > 0
            && (flat.LengthSquared > Squared || (gap.Y < 0 && state.Velocity.Y < 0));
    }
}
