using FootballPhysics.Contacts;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>Steps a single ball of a pile: the forces without contacts, its path through nets and goals, and its state after the
/// pile.</summary>
internal sealed class PilePhase
{
    /// <summary>Below this speed no change of the carrier alone is reported, m/s: in a pile, the load may alternate between two surfaces.</summary>
    private const double ReportedSpeed = 0.05;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly WorldGuard _guard;
    private readonly WorldContact _contact;
    private readonly PartForces _forces;

    public PilePhase(Surroundings around, WorldGuard guard, WorldContact contact)
    {
        _around = around;
        _world = around.World;
        _guard = guard;
        _contact = contact;
        _forces = new PartForces(around);
    }

    /// <summary>True if custom forces act.</summary>
    public bool HasOwnForces => _around.Air.HasOwnForces;

    /// <summary>Computes the forces on the ball without contacts, for a part of a step.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="h">Length of the part, s.</param>
    /// <param name="looksAhead">Whether to evaluate the change of the custom forces, and to reduce those that are too stiff for the part.</param>
    /// <param name="ownChange">The change of the custom forces as a share of them; above 1 they were reduced.</param>
    public MotionRates Free(in BallState s, double h, bool looksAhead, out double ownChange)
    {
        // In the middle of its path, a custom force that depends on the position gives the ball no energy.
        double after = HasOwnForces ? 0.5 * h : 0;
        var at = new Motion(s.Position + (after * s.Velocity), s.Velocity, s.Spin, s.AirDistance);
        ownChange = 0;
        return looksAhead ? _forces.FreeLimited(in s, s.Time + after, in at, IsCarried(in s), h, out ownChange)
            : _forces.Free(in s, s.Time + after, in at, IsCarried(in s), h);
    }

    /// <summary>Computes the forces on a ball at rest, without contacts.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="h">Length of the part, s.</param>
    public MotionRates FreeAtRest(in BallState s, double h) => _forces.AtRest(in s, IsCarried(in s), h);

    private bool IsCarried(in BallState s) => s.Motion != MotionState.Airborne && _world.IsCollider(_world.ColliderOf(s.Carrier, s.Position, s.Time));

    /// <summary>Moves the ball in a straight line, through the nets and goals on its path.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="duration">The duration, s.</param>
    /// <param name="way">Its mean velocity, m/s.</param>
    /// <param name="v">Its velocity at the end, m/s.</param>
    /// <param name="w">Its spin at the end, rad/s.</param>
    /// <param name="airSpeed">Its air speed, m/s, if it is needed.</param>
    /// <param name="log">Receives events and counts.</param>
    public void Move(ref BallState s, double duration, in Vector3d way, in Vector3d v, in Vector3d w, double airSpeed, StepLog log)
    {
        double end = s.Time + duration;
        s.AirDistance += duration * airSpeed;
        s.BaseOrientation = s.BaseOrientation.Turned((0.5 * duration) * (s.Spin + w));
        s.Velocity = v;
        s.SpinAxis = w;
        var run = new StepRun(0, s.Time, log);
        _guard.MoveAlong(ref s, in way, duration, passes: 1, ref run);
        s.Time = end;
        log.Steps++;
    }

    /// <summary>Releases the ball from the pile: the surface with the greatest load becomes its carrier; otherwise it flies.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="carrier">The collider with the greatest load; −1 if there is none.</param>
    /// <param name="log">Receives the events.</param>
    public void Release(ref BallState s, int carrier, StepLog log)
    {
        Vector3d w = s.Spin;
        int mover = _world.Moves ? Covering(in s) : -1;
        if (mover >= 0)
        {
            StaySqueezed(ref s, mover, log);
            return;
        }

        // The ball may have left the net in its last part.
        carrier = _world.IsNetEnd(carrier) && !_world.ActsOn(carrier, in s) ? -1 : carrier;
        bool wasCarried = s.Motion is MotionState.Rolling or MotionState.Sliding or MotionState.Rest;
        s.ClearUntil = 0;
        s.Branch = DragBranch.Unknown;
        Report(in s, BallEventKind.Pinned, -1, Vector3d.Zero, in w, s.Motion == MotionState.Pinned, log);
        if (carrier < 0)
        {
            Report(in s, BallEventKind.ContactEnd, -1, Vector3d.Zero, in w, wasCarried, log);
            s.Motion = MotionState.Airborne;
            s.Carrier = 0;
            s.SetFlightSpin(in w);
            return;
        }

        // Project the ball exactly onto the surface. If there is no slip, set the spin of pure rolling.
        Collider on = _world.ByIndex[carrier];
        MotionState before = s.Motion;
        bool same = _world.ColliderOf(s.Carrier, s.Position, s.Time) == carrier;
        s.Carrier = carrier + _world.FirstCollider;
        _world.Exit(ref s);
        Vector3d n = _world.Hold(ref s, on);
        Vector3d relative = s.Velocity - _world.SurfaceVelocity(on, s.Position, in n, s.Time);
        bool rolls = Slip.Of(in relative, in w, in n, _around.Radius).Length < ContactTolerances.SolvedSlip;
        s.Motion = rolls ? MotionState.Rolling : MotionState.Sliding;
        s.SetGroundSpin(rolls ? Slip.RollingSpin(in relative, Vector3d.Dot(in w, in n), in n, _around.Radius) : w);
        bool changed = before != s.Motion || (!same && s.Velocity.Length > ReportedSpeed);
        Report(in s, rolls ? BallEventKind.Roll : BallEventKind.Slide, (int)s.Carrier, in n, in w, changed, log);
    }

    /// <summary>Returns the moving object that overlaps the ball most, if it is too deep to support the ball; −1 if there is none.</summary>
    private int Covering(in BallState s)
    {
        BallState free = s;
        free.Motion = MotionState.Airborne;
        int deepest = NearThings.Deepest(_world, in free, out _);
        return deepest >= 0 && _world.ByIndex[deepest].Moves && _around.Radius - _world.ByIndex[deepest].At(s.Position, s.Time).Distance > ContactTolerances.BallOverlap ? deepest : -1;
    }

    /// <summary>Keeps a ball squeezed that a moving object still overlaps: if projected onto it at once, the ball would enter another
    /// object.</summary>
    /// <remarks>It leaves the object at the speed allowed for a squeezed ball.</remarks>
    private void StaySqueezed(ref BallState s, int carrier, StepLog log)
    {
        Vector3d w = s.Spin;
        Vector3d n = _world.ByIndex[carrier].At(s.Position, s.Time).Normal;
        bool begins = s.Motion != MotionState.Pinned;
        s.Motion = MotionState.Pinned;
        s.Carrier = carrier + _world.FirstCollider;
        _world.Exit(ref s);
        s.SetGroundSpin(in w);
        s.ClearUntil = 0;
        s.Branch = DragBranch.Unknown;
        Report(in s, BallEventKind.Pinned, (int)s.Carrier, in n, in w, begins, log);
    }

    /// <summary>Brings the ball to rest in the pile.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="carrier">The collider with the greatest load; −1 if only other balls support it.</param>
    /// <param name="log">Receives the event.</param>
    public void Rest(ref BallState s, int carrier, StepLog log)
    {
        var run = new StepRun(0, s.Time, log);
        if (carrier >= 0)
        {
            _world.Hold(ref s, _world.ByIndex[carrier]);
        }

        s.Carrier = Math.Max(0, carrier + _world.FirstCollider);
        _world.Exit(ref s);
        s.ClearUntil = 0;
        s.Branch = DragBranch.Unknown;
        _contact.Rest(ref s, ref run);
        s.Velocity = Vector3d.Zero;
    }

    private void Report(in BallState s, BallEventKind kind, int thing, in Vector3d n, in Vector3d w, bool reports, StepLog log)
    {
        if (reports)
        {
            log.Report(new BallEvent(kind, (int)_world.Reported(thing), in n, s.Time, s.Position, s.Velocity, in w, s.Velocity, s.Spin));
        }
    }
}
