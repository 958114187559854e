using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Numerics;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>
/// Steps a ball at rest: checks that its contacts still hold it (world.md, Rest is a condition), and moves it along with its carrier up to
/// the first hit.
/// </summary>
internal sealed unsafe class RestPhase
{
    /// <summary>Maximum rotation of the ball by its carrier per piece, rad. The ends of the piece then determine the path.</summary>
    private const double LargestTurn = 0.25;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly WorldGuard _guard;
    private readonly WorldContact _contact;
    private readonly DragJumpGuard _jump;
    private readonly bool _airMayWake;
    private bool? _isHeldByGround;

    public RestPhase(Surroundings around, WorldGuard guard, WorldContact contact, DragJumpGuard jump)
    {
        _around = around;
        _world = around.World;
        _guard = guard;
        _contact = contact;
        _jump = jump;

        // In the published profile, air never wakes a ball.
        _airMayWake = around.Air.HasOwnForces || (_world.SharesAir && around.Air.ChangesInTime);
        MayWake = _world.Moves || _airMayWake;
        IsWokenByMotion = MayWake && !_airMayWake && _world.Engine is null;
    }

    /// <summary>True if a ball at rest may wake without a kick: by moving objects, a custom force or a changing wind.</summary>
    public bool MayWake { get; }

    /// <summary>True if only moving bodies and pushed obstacles may wake a ball at rest.</summary>
    public bool IsWokenByMotion { get; }

    /// <summary>Advances to the end of the step, or to the event that wakes the ball.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Take(ref BallState s, ref StepRun run)
    {
        // The ground alone holds the ball in any wind, and no object moves: only advance the time.
        if (_world.Engine is null && !_airMayWake && s.Carrier == 0 && IsHeldByGround(in s) && !(_world.FastestMover > 0))
        {
            run.Advance(ref s, run.Left);
            run.Log.Steps--;
            return;
        }

        if (_guard.HitsAtOnce(ref s, ref run))
        {
            return;
        }

        // Objects or the wind may have changed since the last step: check again that the ball is held. For a ball in a pile, the group checks this.
        if (run.Left == run.Length && MayWake && !s.RestsInPile)
        {
            int evaluations = 0;
            bool holds = IsHeld(ref s, run.PerStep, ref evaluations);
            run.Log.Evaluations += evaluations;
            if (!holds)
            {
                Wake(ref s, ref run);
                return;
            }
        }

        // Move the ball along with its carrier until the first impact.
        double h = run.Left;
        PathCubic path = Way(in s, ref h, out Vector3d turn);
        double at = new ContactSearch(_world, in path, s.Time).First(in s, (int)s.Carrier - _world.FirstCollider, out Separation met);
        bool meets = at <= h;
        if (turn != Vector3d.Zero)
        {
            s.BaseOrientation = s.BaseOrientation.Turned((meets ? at / h : 1.0) * turn);
        }

        h = meets ? at : h;
        s.Position = path.At(h);
        run.Advance(ref s, h);
        if (turn != Vector3d.Zero && !_world.HangsInNet(in s))
        {
            s.Velocity = _world.CarrierOf(in s).MaterialVelocity(s.Position, s.Time);
        }

        // Do not count the time at rest as an integrated piece.
        run.Log.Steps--;
        if (meets)
        {
            _guard.Meet(ref s, in met, ref run);
        }
    }

    /// <summary>True if rolling friction holds a ball anywhere on a plane ground. The result is computed once per scene.</summary>
    private bool IsHeldByGround(in BallState s)
    {
        if (_isHeldByGround is null && s.Nets == 0)
        {
            bool isPlain = _world.Ground is { IsPlane: true, HasPatches: false } && !_around.Air.Varies;
            int evaluations = 0;
            _isHeldByGround = isPlain && Grips(in s, _world.Ground!, Vector3d.Zero, Vector3d.Zero, Vector3d.Zero, ref evaluations);
        }

        return s.Nets == 0 && _isHeldByGround!.Value;
    }

    /// <summary>True if a ball with zero relative velocity stays at its position, on its carrier or in a net.</summary>
    /// <remarks>Custom forces are not evaluated here; the next step checks them.</remarks>
    public bool Holds(in BallState s)
    {
        if (_around.Air.HasOwnForces)
        {
            return true;
        }

        // The game may have moved the ball to another net since the ball came to rest.
        if (_world.HangsInNet(in s))
        {
            return _contact.Load.HangsStill(in s);
        }

        BallState copy = s;
        int evaluations = 0;
        return IsHeld(ref copy, 0, ref evaluations);
    }

    /// <summary>True if a ball at rest stays at rest.</summary>
    /// <remarks>
    /// A carrier whose velocity jumped takes the ball along if rolling friction holds it.
    /// <paramref name="perStep"/> is 1/length of the step, or 0 to ignore jumps.
    /// </remarks>
    private bool IsHeld(ref BallState s, double perStep, ref int evaluations)
    {
        if (_world.HangsInNet(in s))
        {
            evaluations++;
            return !_around.Air.Varies || _contact.Load.HangsStill(in s);
        }

        Collider carrier = _world.CarrierOf(in s);
        ShapePoint point = carrier.At(s.Position, s.Time);
        if (!(point.Distance - _around.Radius <= ContactTolerances.Touching))
        {
            return false;
        }

        // V̇ at the ball's centre, and Ω̇: the carrier's velocity jumps divided by the step.
        Vector3d velocity = carrier.MaterialVelocity(s.Position, s.Time);
        Vector3d gained = perStep * (velocity - s.Velocity);
        Vector3d turned = perStep * (carrier.Spin - s.Spin);
        if (!Grips(in s, carrier, in velocity, in gained, in turned, ref evaluations) && !IsHeldByAll(in s, in velocity, in gained, ref evaluations))
        {
            return false;
        }

        s.Velocity = velocity;
        s.SpinAxis = carrier.Spin;
        return true;
    }

    /// <summary>True if rolling friction of the carrier alone holds the ball: |a_b,t (+ a_air,t) − A_s,t − α r Ω̇ × n|/(1 + α) ≤ c₀
    /// N/m.</summary>
    private bool Grips(in BallState s, Collider carrier, in Vector3d velocity, in Vector3d gained, in Vector3d turned, ref int evaluations)
    {
        var still = new Motion(s.Position, in velocity, carrier.Spin);
        var system = SurfaceSystem.On(_around, carrier, in s, _jump.OnSurface(DragBranch.Unknown, in still));
        system.Rolls = true;
        SurfaceForces on = system.ForcesOn(s.Time, in still);
        evaluations++;
        double alpha = _world.Ball.InertiaFactor;
        Vector3d n = on.Normal;
        Vector3d push = system.PushFromRest(in on)
            - ((SurfaceSystem.Tangential(in gained, in n) + (alpha * _around.Radius * Vector3d.Cross(in turned, in n))) / (1.0 + alpha));
        on.Load += Vector3d.Dot(in gained, in n);
        return on.FreeLoad > ContactTolerances.LeastLoad && push.Length <= system.RollingFriction(in on, 0);
    }

    /// <summary>True if all contacts together hold the ball, and none of them moves relative to the carrier.</summary>
    [SkipLocalsInit]
    private bool IsHeldByAll(in BallState s, in Vector3d velocity, in Vector3d gained, ref int evaluations)
    {
        Contact* room = stackalloc Contact[ContactSet.Room];
        BallState moved = s;
        moved.Velocity = velocity;
        Span<Contact> set = ContactSet.Touching(_world, in moved, new Span<Contact>(room, ContactSet.Room), _world.Room);
        if (set.Length < 2 || set.Length > ContactSystem.Most)
        {
            return false;
        }

        var still = new Motion(s.Position, in velocity, Vector3d.Zero);
        return RestingSet.HoldAtRest(_around, set, in moved, in still, _jump.OnSurface(DragBranch.Unknown, in still), in gained, ref evaluations);
    }

    /// <summary>Wakes the ball with its current velocity and spin, which may differ from the carrier's.</summary>
    private void Wake(ref BallState s, ref StepRun run)
    {
        if (_world.HangsInNet(in s))
        {
            _contact.Leave(ref s, s.Velocity, s.Spin, ref run);
            return;
        }

        Collider carrier = _world.CarrierOf(in s);
        ShapePoint at = carrier.At(s.Position, s.Time);
        if (!(at.Distance - _around.Radius <= ContactTolerances.Touching))
        {
            _contact.Leave(ref s, s.Velocity, s.Spin, ref run);
            return;
        }

        Vector3d surface = _world.SurfaceVelocity(carrier, s.Position, at.Normal, s.Time);
        Vector3d slip = Slip.Of(s.Velocity - surface, s.Spin, at.Normal, _around.Radius);
        bool rolls = slip.Length < ContactTolerances.Rolling;
        s.Motion = rolls ? MotionState.Rolling : MotionState.Sliding;
        run.CarrierGain = rolls ? run.CarrierGain : -run.PerStep * slip;
        run.Report(rolls ? BallEventKind.Roll : BallEventKind.Slide, _world.Reported(s.Carrier), at.Normal, in s, s.Velocity, s.Spin);
    }

    /// <summary>Returns the path of a ball that moves along with its carrier, and the rotation on it, rad.</summary>
    private PathCubic Way(in BallState s, ref double h, out Vector3d turn)
    {
        turn = default;
        if (_world.HangsInNet(in s))
        {
            return PathCubic.Line(s.Position, Vector3d.Zero, h);
        }

        Collider carrier = _world.CarrierOf(in s);
        Vector3d velocity = carrier.MaterialVelocity(s.Position, s.Time);
        if (carrier.Spin == Vector3d.Zero)
        {
            return PathCubic.Line(s.Position, in velocity, h);
        }

        // Rotate the position about the pivot: p' = o + V h + R(Ω h) (p − o).
        double rate = carrier.Spin.Length;
        h = Math.Min(h, LargestTurn / rate);
        turn = h * carrier.Spin;
        Vector3d end = carrier.CarriedTo(s.Position, s.Time, h);
        return PathCubic.Between(s.Position, in velocity, in end, carrier.MaterialVelocity(in end, s.Time + h), h);
    }
}
