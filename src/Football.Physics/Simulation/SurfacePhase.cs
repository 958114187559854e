using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Steps a ball that slides or rolls on any surface, piece by piece.</summary>
/// <remarks>
/// A piece ends at the first of these events: a jump in the drag law, a contact, the end of the slip, the loss of grip, the end of the
/// load, or rest.
/// </remarks>
internal sealed class SurfacePhase<TIntegrator>
    where TIntegrator : struct, IIntegrator
{
    /// <summary>The thesis' heuristic (2.28) treats a slip below this as zero, m/s.</summary>
    private const double HeuristicSlip = 1e-3;

    /// <summary>After this many pieces, the step no longer shortens pieces to follow a turning slip: it would gain no accuracy.</summary>
    private const int ManyPieces = 32;

    /// <summary>A ball creeps if rolling friction could change its velocity by more than this multiple within the step.</summary>
    /// <remarks>
    /// Its direction then turns to that of the push almost at once; in usual steps the ball moves less than 1e-8 m meanwhile.
    /// </remarks>
    private const double Creeping = 256;

    /// <summary>Above this share of the friction, the push delays the stop of a creeping ball, so that it would take many short pieces.</summary>
    private const double SlowStop = 0.1;

    /// <summary>The shortest part of a piece in a net, as a share of the piece.</summary>
    private const double ShortestPart = 0.02;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly PieceLength _length;
    private readonly DragJumpGuard _jump;
    private readonly WorldGuard _guard;
    private readonly WorldContact _contact;
    private readonly ContactSetPhase<TIntegrator> _set;
    private readonly NetGuard _nets;
    private readonly Rest _rest;
    private readonly SlideEnd _slideEnd;
    private readonly bool _endsSlipExactly;
    private readonly SurfaceHold _hold;
    private readonly OwnForceGuard? _own;

    public SurfacePhase(
        Scene scene, SolverSettings settings, Surroundings around, in StabilityLimit limit, DragJumpGuard jump, WorldGuard guard, WorldContact contact,
        ContactSetPhase<TIntegrator> set, OwnForceGuard? own)
    {
        _around = around;
        _endsSlipExactly = settings.RollingTransition == RollingTransition.Exact;
        _world = around.World;
        _length = new PieceLength(around, in limit);
        _jump = jump;
        _guard = guard;
        _contact = contact;
        _set = set;
        _own = own;
        _nets = new NetGuard(_world);
        _rest = new Rest(around);
        _hold = new SurfaceHold(scene, around);
        _slideEnd = new SlideEnd(around, jump, default(TIntegrator).Order);
    }

    /// <summary>Takes the next piece of a slide or a roll.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)] // its locals would be cleared in every step that has pieces
    public void Take(ref BallState s, ref StepRun run)
    {
        SurfacePiece piece = default;
        double time = s.Time;
        bool isProposed = Propose(ref s, ref run, ref piece);
        if (run.Probe is not null)
        {
            Look(in s, in run, in piece, time, isProposed);
            return;
        }

        if (!isProposed)
        {
            return;
        }

        // A net reacts within less than a step, so use RK4 substeps in a net. RK4 does not speed up a velocity that turns by up to 2.8 rad.
        _own?.Shorten(ref piece.Length, s.Nets != 0 ? piece.System.LongestPart(in piece.From, in piece.Start) : double.PositiveInfinity, ref run);
        if (s.Nets != 0 && _own is null)
        {
            Take<Substeps>(ref s, ref run, ref piece);
        }
        else if (run.Followed > 0 || !(run.Spirals ? Take<ClassicalRungeKutta>(ref s, ref run, ref piece) : Take<TIntegrator>(ref s, ref run, ref piece)))
        {
            Take<EighthOrder>(ref s, ref run, ref piece);
        }
    }

    /// <summary>Reports the forces at the start of a piece, or of a slip that ends in closed form.</summary>
    private static void Look(in BallState s, in StepRun run, in SurfacePiece piece, double time, bool isProposed)
    {
        if (isProposed || (run.Probe!.Found is null && run.Left < run.Length))
        {
            run.Probe!.Slide(in piece.System, in piece.From, in piece.Start.Acceleration, time, s.Carrier);
        }
    }

    /// <summary>Takes a piece up to its first event, moves the ball, and handles the event.</summary>
    /// <returns>False if the method does not follow the custom forces. The ball has not moved then.</returns>
    [SkipLocalsInit]
    private unsafe bool Take<TMethod>(ref BallState s, ref StepRun run, ref SurfacePiece piece)
        where TMethod : struct, IMotionMethod
    {
        ForceTrace trace;
        if (!Integrate(in s, ref run, in piece, &trace, out MotionSweep<SurfaceSystem, TMethod> sweep))
        {
            return false;
        }

        Shorten(ref sweep, ref s, ref run, ref piece);
        Move(ref s, ref run, ref sweep, in piece);
        Respond(ref s, ref run, in piece);
        return true;
    }

    /// <summary>Computes the forces at the start and the length of the piece.</summary>
    /// <returns>False if there was an event at the current position.</returns>
    private bool Propose(ref BallState s, ref StepRun run, ref SurfacePiece piece)
    {
        // First handle an immediate impact, then a contact set, which has its own phase.
        if (!_world.IsPlaneAlone && (_world.Engine is not null || run.Rattles || NearThings.TouchesOthers(_world, in s)))
        {
            if (_guard.HitsAtOnce(ref s, ref run))
            {
                return false;
            }

            // Another flush surface may become the carrier: update only the material and the surface velocity.
            _contact.HandOver(ref s, Flush.CarrierOf(_world, in s), ref run);
            if (_set.Take(ref s, ref run))
            {
                return false;
            }
        }

        // Compute the forces at the start, then check whether the ball leaves, rests, grips or slips.
        bool rolls = s.Motion == MotionState.Rolling;
        piece.From = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        System(in s, in piece.From, rolls, out piece.System);
        piece.System.CarrierGain = run.CarrierGain;
        piece.System.Look(s.Time, in piece.From);
        run.Log.Evaluations++;
        if (piece.System.Forces.FreeLoad <= ContactTolerances.LeastLoad)
        {
            _contact.Leave(ref s, s.Velocity, s.Spin, ref run);
            return false;
        }

        // The end of a net has no friction: a ball rests there as it rests in the net.
        if (piece.System.Carrier.IsNetEnd && _contact.RestsInNet(ref s, ref run))
        {
            return false;
        }

        piece.System.KeepsGrip = NetGuard.KeepsGrip(in s, in run);
        bool grips = piece.System.Grips(in piece.System.Forces) || piece.System.KeepsGrip;
        Vector3d moving = rolls ? piece.System.Forces.Rolling : piece.System.Forces.Slip;
        piece.Size = moving.Length;

        // A rolling ball that needs more traction than friction provides starts to slide.
        if (rolls && !grips)
        {
            run.Spent.Slips++;
            _contact.StartSliding(ref s, ref run);
            return false;
        }

        // A sliding ball without slip starts to roll if friction can hold it.
        if (!rolls && piece.Size < ContactTolerances.Rolling && grips)
        {
            _contact.StartRolling(ref s, ref run);
            return false;
        }

        Vector3d start = piece.System.Traction(in piece.System.Forces);
        if (rolls && Rests(ref s, ref run, ref piece, out start))
        {
            return false;
        }

        // The direction of the slip or the roll. Friction keeps this direction if a stage of the integrator passes zero.
        moving = piece.Size < ContactTolerances.Rolling ? start : rolls ? piece.System.Forces.Rolling : moving;
        double length = moving.Length;
        piece.System.Direction = length > 0 ? moving / length : Vector3d.Zero;
        piece.System.LocksDirection = piece.Size < ContactTolerances.Rolling;

        piece.System.FollowsPush = piece.System.LocksDirection && _world.SharesAir && SlowSlip.Follows(in piece.System, in piece.System.Forces, in piece.From);
        piece.System.LocksDirection &= !piece.System.FollowsPush;

        // Limit the piece by stability, nets, borders and the turning normal, then by the turning rate of the direction.
        piece.Length = _length.Longest(
            in s, in piece.From, piece.System.Material.Resistance.Damping, rolls ? 0 : piece.System.MostFriction(in piece.System.Forces), piece.System.Forces.Turning.Length, ref run);
        piece.Start = piece.System.RatesAt(in piece.From);
        piece.System.NetsSlack = _nets.SlackAt(in s, piece.Start.Acceleration);
        return piece.Size < ContactTolerances.Rolling || FollowsDirection(ref s, ref run, ref piece, in moving);
    }

    /// <summary>Brings a rolling ball to rest if it is held. Otherwise, it is pinned if rolling friction exceeds the push, or moves along the push
    /// from a standstill.</summary>
    private bool Rests(ref BallState s, ref StepRun run, ref SurfacePiece piece, out Vector3d drive)
    {
        ref SurfaceSystem system = ref piece.System;
        drive = system.Drive(in piece.System.Forces) - piece.System.Forces.MaterialRate;
        double friction = system.MostRolling(in piece.System.Forces, 0);
        bool held = drive.Length <= friction;
        if (system.Rests(in piece.System.Forces) && _rest.IsSlow(in piece.From, system.Carrier, s.Time))
        {
            _contact.Rest(ref s, ref run);
            return true;
        }

        // Friction aligns a creeping ball's velocity with the push long before the end of the step. If the push is just below friction, the
        // speed along the push then falls slowly to zero.
        bool creeps = drive.Length > SlowStop * friction && piece.Size >= ContactTolerances.Rolling && run.Length * friction > Creeping * piece.Size;
        if (creeps)
        {
            double along = Creep(ref s, in piece.System.Forces, in drive);
            piece.Size = held ? along : 0;
        }

        system.Pinned = piece.Size < ContactTolerances.Rolling && held;
        if (system.Pinned)
        {
            // Remove the remaining velocity, so that a pinned ball does not creep.
            s.Velocity = system.Carrier.MaterialVelocity(s.Position, s.Time);
        }

        if (system.Pinned || creeps)
        {
            piece.From = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
            system.Look(s.Time, in piece.From);
            run.Log.Evaluations++;
        }

        return false;
    }

    /// <summary>Shortens a piece so that the integrator can follow the turning direction of the slip or the roll.</summary>
    /// <returns>False if the slip ended instead.</returns>
    private bool FollowsDirection(ref BallState s, ref StepRun run, ref SurfacePiece piece, in Vector3d moving)
    {
        ref SurfaceSystem system = ref piece.System;
        bool rolls = system.Rolls;
        double turned = system.SlowingOf(in piece.System.Forces, piece.Size);
        Vector3d rate = rolls ? piece.Start.Acceleration + (piece.System.Forces.Centripetal * piece.System.Forces.Normal) - piece.System.Forces.MaterialRate
            : system.SlipRate(in piece.System.Forces, in piece.Start, in piece.From.Spin);

        // Near the end of a slip, its direction turns ever faster: use the closed form there.
        SlideStop stop = default;
        if (!rolls && _endsSlipExactly && turned > 0 && _slideEnd.Find(in s, ref run, in piece, in moving, out stop))
        {
            EndSlip(ref s, ref run, in piece, in stop);
            return false;
        }

        if (s.Nets != 0)
        {
            // The parts of the piece follow the direction, so only end the piece before the slip or the roll ends.
            system.Reference = rolls ? piece.From.Velocity - piece.System.Forces.Rolling : piece.System.Forces.Surface;
            system.Slowing = turned;
            piece.Length = stop.Before > 0 ? Math.Min(piece.Length, stop.Before) : TurnLimit.Close(piece.Length, system.Direction, piece.Size, in rate);
            system.ShortestPart = ShortestPart * piece.Length;
            return true;
        }

        if (TurnLimit.IsStiff(piece.Length, piece.Size, turned) && SlowSlip.Follows(in system, in piece.System.Forces, in piece.From))
        {
            system.FollowsPush = true;
            piece.Start = system.RatesAt(in piece.From);
            return true;
        }

        double h = TurnLimit.Follow(piece.Length, system.Direction, piece.Size, in rate, turned, out system.LocksDirection);
        h = turned > 0 && (rolls || _endsSlipExactly) ? TurnLimit.Shorten(h, run.Coarse, system.Direction, piece.Size, in rate, piece.System.Forces.Turning.Length) : h;
        piece.Length = run.Spent.Pieces > ManyPieces ? h : TurnLimit.ShortenStiff(h, run.Coarse, system.Direction, piece.Size, in rate, turned);
        piece.Start = system.LocksDirection ? system.RatesAt(in piece.From) : piece.Start;
        return true;
    }

    /// <summary>Integrates a piece.</summary>
    /// <returns>False if the method does not follow the custom forces.</returns>
    private unsafe bool Integrate<TMethod>(in BallState s, ref StepRun run, in SurfacePiece piece, ForceTrace* trace, out MotionSweep<SurfaceSystem, TMethod> sweep)
        where TMethod : struct, IMotionMethod
    {
        sweep = new MotionSweep<SurfaceSystem, TMethod>(in piece.System, s.Time, in piece.From, in piece.Start, _around.Wind, _around.Radius);
        if (_own is not null)
        {
            trace->Begin(_around.Radius);
            trace->Add(in piece.System.Forces.Own, in piece.System.Forces.OwnTorque);
            return _own.Take(ref sweep, piece.Length, trace, ref run);
        }

        sweep.Step(piece.Length);
        NetGuard.KeepFinite(ref sweep, in s);
        return true;
    }

    /// <summary>Ends a piece at the first event: edge of a surface, jump, load, grip, rest or spin, border, kink of a net, contact.</summary>
    private void Shorten<TMethod>(ref MotionSweep<SurfaceSystem, TMethod> sweep, ref BallState s, ref StepRun run, ref SurfacePiece piece)
        where TMethod : struct, IMotionMethod
    {
        int order = default(TMethod).Order;
        ref SurfaceSystem system = ref piece.System;
        if (system.IsFace)
        {
            FaceBorder.EndBeyond(ref sweep, in s, system.Carrier);
        }
        else
        {
            SurfacePath.Shorten(ref sweep, in s, system.Carrier, _around.Radius, order);
        }

        SlowSlip.EndPiece(ref sweep, in s);
        if (_jump.Acts)
        {
            // After a launch or an impact, the flow determined the branch: locate the crossing from that branch.
            s.Branch = system.Branch;
            _jump.EndAtCrossingOnGround(ref sweep, ref s.Branch, ref run);
        }

        double crossing = sweep.Length;
        EventMargin<SurfaceSystem, TMethod>.EndPiece(ref sweep, s.Time, out piece.OverEdge);
        SurfaceBorder.EndBeyond(ref sweep, in s, system.Carrier);
        _nets.EndWhereSlack(ref sweep, in s, system.NetsSlack);
        _nets.EndWhereBent(ref sweep, in s, in run, (int)s.Carrier - _world.FirstCollider);
        piece.Meets = _guard.EndAtFirst(ref sweep, in s, order, default, out piece.Met);

        // If the piece ends before the jump, keep the old branch.
        s.Branch = sweep.Length < crossing ? system.Branch : s.Branch;
        run.Log.Evaluations += sweep.Evaluations;
    }

    /// <summary>Moves the ball to the end of a piece, then projects it onto its carrier and onto the surface that it hits.</summary>
    private void Move<TMethod>(ref BallState s, ref StepRun run, ref MotionSweep<SurfaceSystem, TMethod> sweep, in SurfacePiece piece)
        where TMethod : struct, IMotionMethod
    {
        int order = default(TMethod).Order;
        BallState before = s;
        before.Branch = piece.System.Branch;
        sweep.MoveTo(ref s);
        run.Advance(ref s, sweep.Length);
        _hold.Hold(ref s, in piece.System, piece.Meets && piece.Met.What == SeparationKind.Contact ? piece.Met.Index : -1);
        if (piece.OverEdge && run.Log.IsWatched)
        {
            // Beyond the edge the forces differ: extrapolate the acceleration at the end instead of evaluating it there.
            Vector3d end = Extrapolate.Rate(before.Velocity, s.Velocity, sweep.StartAcceleration, sweep.Length);
            run.Log.Show(in before, in s, sweep.StartAcceleration, in end, order);
        }
        else
        {
            run.Show(in before, in s, ref sweep, order);
        }
    }

    /// <summary>Handles the contact at the end of a piece.</summary>
    private void Respond(ref BallState s, ref StepRun run, in SurfacePiece piece)
    {
        if (piece.Meets && !run.Log.Halted)
        {
            _guard.Meet(ref s, in piece.Met, ref run);
        }

        // The thesis' heuristic checks for the end of a slide only at the end of a piece.
        if (!_endsSlipExactly && piece.System.SlipFriction(in piece.System.Forces) > 0 && s.Motion == MotionState.Sliding && !piece.System.Rolls && !run.Log.Halted)
        {
            EndSlipByHeuristic(ref s, ref run, piece.Size);
        }
    }

    /// <summary>Keeps only the velocity component of a creeping ball along the push, and returns its size, m/s.</summary>
    private double Creep(ref BallState s, in SurfaceForces on, in Vector3d push)
    {
        Collider carrier = _world.CarrierOf(in s);
        Vector3d along = push.Normalized();
        double speed = Math.Max(0, Vector3d.Dot(on.Rolling, in along));
        s.Velocity += (speed * along) - on.Rolling;
        Vector3d surface = _world.SurfaceVelocity(carrier, s.Position, in on.Normal, s.Time);
        s.SpinAxis = Slip.RollingSpin(s.Velocity - surface, Vector3d.Dot(s.SpinAxis, on.Normal), in on.Normal, _around.Radius);
        return speed;
    }

    /// <summary>Ends a slide by the thesis' heuristic (2.27, 2.28): if the slip has grown or is small.</summary>
    private void EndSlipByHeuristic(ref BallState s, ref StepRun run, double before)
    {
        Collider carrier = _world.CarrierOf(in s);
        Vector3d n = carrier.At(s.Position, s.Time).Normal;
        double after = Slip.Of(s.Velocity - _world.SurfaceVelocity(carrier, s.Position, in n, s.Time), s.Spin, in n, _around.Radius).Length;
        if (after > before || after < HeuristicSlip)
        {
            _contact.EndSlip(ref s, ref run);
        }
    }

    /// <summary>Moves the ball to the end of its slip. It rolls if friction can hold it.</summary>
    private void EndSlip(ref BallState s, ref StepRun run, in SurfacePiece piece, in SlideStop stop)
    {
        BallState before = s;
        s.BaseOrientation = s.BaseOrientation.Turned(in stop.Turn);
        s.Position = stop.End.Position;
        s.Velocity = stop.End.Velocity;
        s.SpinAxis = stop.End.Spin;
        run.Advance(ref s, stop.Time);
        _hold.Hold(ref s, in piece.System, -1);
        if (run.Log.IsWatched)
        {
            Vector3d atEnd = Extrapolate.Rate(in piece.From.Velocity, s.Velocity, in piece.Start.Acceleration, stop.Time);
            run.Log.Show(in before, in s, in piece.Start.Acceleration, in atEnd, default(TIntegrator).Order);
        }

        if (!run.Log.Halted && (stop.Grips || NetGuard.KeepsGrip(in s, in run)))
        {
            _contact.StartRolling(ref s, ref run);
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void System(in BallState s, in Motion from, bool rolls, out SurfaceSystem system)
    {
        Collider carrier = _world.CarrierOf(in s);
        ShapePoint at = carrier.At(s.Position, s.Time);
        double about = Vector3d.Dot(from.Spin, at.Normal) - Vector3d.Dot(carrier.Spin, at.Normal);
        system = SurfaceSystem.On(_around, carrier, in s, _jump.OnSurface(s.Branch, in from));
        system.Rolls = rolls;
        system.StartSpin = from.Spin;
        system.IsFace = carrier.HasFaces && !carrier.Rotates && at.IsFlat;
        system.IsFlat = system.IsFace || (carrier.IsPlane && !carrier.Rotates);
        system.FaceNormal = at.Normal;
        system.SpinSign = about > ContactTolerances.Rolling ? 1.0 : about < -ContactTolerances.Rolling ? -1.0 : 0.0;
    }
}
