using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>
/// Steps a ball at rest: checks that its contacts still hold it (contact.md, Rest), and moves it along with its carrier up to
/// the first hit.
/// </summary>
internal sealed class RestPhase
{
    /// <summary>Maximum rotation of the ball by its carrier per piece, rad. The ends of the piece then determine the path.</summary>
    private const double LargestTurn = 0.25;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly WorldGuard _guard;
    private readonly WorldContact _contact;
    private readonly Rest _rest;
    private readonly bool _airMayWake;
    private bool? _isHeldByGround;

    public RestPhase(Surroundings around, WorldGuard guard, WorldContact contact)
    {
        _around = around;
        _world = around.World;
        _guard = guard;
        _contact = contact;
        _rest = new Rest(around);

        // In the published profile, air never wakes a ball.
        _airMayWake = around.Air.HasOwnForces || (_world.SharesAir && around.Air.ChangesInTime);
        bool turns = Array.Exists(_world.ByIndex, collider => !collider.Moves && !collider.StandsStill);
        MayWake = _world.Moves || turns || _airMayWake;
        IsWokenByMotion = MayWake && !turns && !_airMayWake && _world.Engine is null;
    }

    /// <summary>True if a ball at rest may move or wake without a kick: by objects that move or turn, a custom force or a changing wind.</summary>
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
            bool holds = _rest.IsHeld(in s, run.PerStep, ref evaluations);
            run.Log.Evaluations += evaluations;
            if (!holds)
            {
                Wake(ref s, ref run);
                return;
            }

            FollowCarrier(ref s);
        }

        // Move the ball along with its carrier until the first impact.
        double h = run.Left;
        PathCubic path = Way(in s, ref h, out Vector3d turn);
        double at = new ContactSearch(_world, in path, s.Time).First(in s, (int)s.Carrier - _world.FirstCollider, out Separation met);
        bool meets = at <= h;
        BallState before = s;
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
        if (run.Log.IsWatched && s.Position != before.Position)
        {
            Show(in before, in s, in path, run.Log);
        }

        if (meets && !run.Log.Halted)
        {
            _guard.Meet(ref s, in met, ref run);
        }
    }

    /// <summary>Reports the path of a ball that moves along with its carrier. It is a cubic with every integrator, so its order is not that of the integrator.</summary>
    private static void Show(in BallState before, in BallState after, in PathCubic path, StepLog log)
    {
        BallState start = before;
        BallState end = after;
        double h = after.Time - before.Time;
        start.Velocity = path.VelocityAt(0);
        end.Velocity = path.VelocityAt(h);
        log.Show(in start, in end, path.AccelerationAt(0), path.AccelerationAt(h), order: 4);
    }

    /// <summary>True if rolling friction holds a ball anywhere on a plane ground. The result is computed once per scene.</summary>
    private bool IsHeldByGround(in BallState s)
    {
        if (_isHeldByGround is null && s.Nets == 0)
        {
            bool isPlain = _world.Ground is { IsPlane: true, HasPatches: false } && !_around.Air.Varies;
            int evaluations = 0;
            _isHeldByGround = isPlain && _rest.IsHeldBy(_world.Ground!, in s, new Motion(s.Position, Vector3d.Zero, Vector3d.Zero), Vector3d.Zero, Vector3d.Zero, ref evaluations);
        }

        return s.Nets == 0 && _isHeldByGround!.Value;
    }

    /// <summary>Gives a held ball the velocity and the spin of its carrier.</summary>
    private void FollowCarrier(ref BallState s)
    {
        if (!_world.HangsInNet(in s))
        {
            Collider carrier = _world.CarrierOf(in s);
            s.Velocity = carrier.MaterialVelocity(s.Position, s.Time);
            s.SpinAxis = carrier.Spin;
        }
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

        // Rotate the position p about the pivot o: p' = o + V h + R(Ω h) (p − o). R rotates by the carrier's spin Ω times h; V is its velocity.
        double rate = carrier.Spin.Length;
        h = Math.Min(h, LargestTurn / rate);
        turn = h * carrier.Spin;
        Vector3d end = carrier.CarriedTo(s.Position, s.Time, h);
        return PathCubic.Between(s.Position, in velocity, in end, carrier.MaterialVelocity(in end, s.Time + h), h);
    }
}
