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
    /// <summary>Upper bound of the tolerance of a closed-form end, as a share of the step.</summary>
    private const double LargestSlideEnd = 1e-3;

    /// <summary>The closed form requires the squared push to be below this share of the squared friction.</summary>
    /// <remarks>Otherwise the slip may never end.</remarks>
    private const double LargestPush = 0.9999;

    /// <summary>The thesis' heuristic (2.28) treats a slip below this as zero, m/s.</summary>
    private const double HeuristicSlip = 1e-3;

    /// <summary>Maximum number of times a ball in a net may lose its grip per step.</summary>
    /// <remarks>
    /// A net that goes slack and taut makes the ball grip and slip in turn, ever faster. After this many times, the ball grips for the rest
    /// of the step, which adds no energy.
    /// </remarks>
    private const int MostSlips = 2;

    /// <summary>After this many pieces, the step no longer shortens pieces to follow a turning slip: it would gain no accuracy.</summary>
    private const int ManyPieces = 32;

    /// <summary>Maximum number of iterations that move a ball onto a second surface.</summary>
    private const int MostPuts = 16;

    /// <summary>Maximum rotation of the normal per piece, rad.</summary>
    private const double LargestTurn = 0.05;

    /// <summary>A ball creeps if rolling friction could change its velocity by more than this multiple within the rest of the
    /// step.</summary>
    /// <remarks>
    /// Its direction then turns to that of the push almost at once; in usual steps the ball moves less than 1e-8 m meanwhile.
    /// </remarks>
    private const double Creeping = 256;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly StabilityLimit _limit;
    private readonly DragJumpGuard _jump;
    private readonly WorldGuard _guard;
    private readonly WorldContact _contact;
    private readonly ContactSetPhase<TIntegrator> _set;
    private readonly NetGuard _nets;
    private readonly TIntegrator _integrator;
    private readonly double _alpha;
    private readonly double _inertia;
    private readonly bool _endsSlipExactly;
    private readonly bool _isFlat;

    public SurfacePhase(
        Scene scene, SolverSettings settings, Surroundings around, in StabilityLimit limit, DragJumpGuard jump, WorldGuard guard, WorldContact contact,
        ContactSetPhase<TIntegrator> set)
    {
        _around = around;
        _isFlat = scene.Ground.Heights is null;
        _endsSlipExactly = settings.RollingTransition == RollingTransition.Exact;
        _world = around.World;
        _limit = limit;
        _jump = jump;
        _guard = guard;
        _contact = contact;
        _set = set;
        _nets = new NetGuard(_world);
        _integrator = default;
        _alpha = _world.Ball.InertiaFactor;
        _inertia = _world.Ball.MomentOfInertia;
    }

    /// <summary>Takes the next piece of a slide or a roll.</summary>
    public void Take(ref BallState s, ref StepRun run)
    {
        // First handle an immediate impact, then a contact set, which has its own phase.
        if (!_world.IsPlaneAlone)
        {
            if (_guard.HitsAtOnce(ref s, ref run))
            {
                return;
            }

            // Another flush surface may become the carrier: update only the material and the surface velocity.
            _contact.HandOver(ref s, Flush.CarrierOf(_world, in s), ref run);
            if (_set.Take(ref s, ref run))
            {
                return;
            }
        }

        // Compute the forces at the start, then check whether the ball leaves, rests, grips or slips.
        bool rolls = s.Motion == MotionState.Rolling;
        var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        SurfaceSystem system = System(in s, in from, rolls);
        system.CarrierGain = run.CarrierGain;
        SurfaceForces on = system.ForcesOn(s.Time, in from);
        run.Log.Evaluations++;
        if (on.FreeLoad <= ContactTolerances.LeastLoad)
        {
            _contact.Leave(ref s, s.Velocity, s.Spin, ref run);
            return;
        }

        double sliding = system.SlidingFriction(in on);
        Vector3d traction = system.Traction(in on);
        bool grips = system.Grips(in on) || KeepsGrip(in s, in run);
        Vector3d moving = rolls ? on.Rolling : system.SlipOf(in from, in on);
        double size = moving.Length;

        // A rolling ball that needs more traction than friction provides starts to slide.
        if (rolls && !grips)
        {
            run.Slips++;
            _contact.StartSliding(ref s, ref run);
            return;
        }

        // A sliding ball without slip starts to roll if friction can hold it.
        if (!rolls && size < ContactTolerances.Rolling && grips)
        {
            _contact.StartRolling(ref s, ref run);
            return;
        }

        // A rolling ball may come to rest, or be pinned if rolling friction exceeds the push. From a standstill it moves along the push.
        if (rolls)
        {
            Vector3d drive = system.Drive(in on) - on.MaterialRate;
            bool held = drive.Length <= system.RollingFriction(in on, 0);
            if (system.Rests(in on) && _world.Energy(in from, system.Carrier, s.Time) <= _world.RestEnergy * (1.0 + ContactTolerances.AtRest))
            {
                _contact.Rest(ref s, ref run);
                return;
            }

            system.Pinned = size < ContactTolerances.Rolling && held;
            if (system.Pinned)
            {
                // Remove the remaining velocity, so that a pinned ball does not creep.
                s.Velocity = system.Carrier.MaterialVelocity(s.Position, s.Time);
                from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
                on = system.ForcesOn(s.Time, in from);
                run.Log.Evaluations++;
            }

            // Friction aligns a creeping ball's velocity with the push long before the end of the step.
            bool creeps = !held && run.Next * system.RollingFriction(in on, 0) > Creeping * size;
            if (creeps && size >= ContactTolerances.Rolling)
            {
                Creep(ref s, in on, in drive);
                from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
                on = system.ForcesOn(s.Time, in from);
                run.Log.Evaluations++;
                size = 0;
            }

            moving = size < ContactTolerances.Rolling ? drive : moving;
        }
        else
        {
            moving = size < ContactTolerances.Rolling ? traction : moving;
        }

        // The direction of the slip or the roll. Friction keeps this direction if a stage of the integrator passes zero.
        double length = moving.Length;
        system.Direction = length > 0 ? moving / length : Vector3d.Zero;

        system.LocksDirection = size < ContactTolerances.Rolling;

        // Limit the piece by stability, nets, borders and the turning normal, then by the turning rate of the direction.
        double h = LongestPiece(in s, in from, in on, ref run);
        MotionRates rates = system.RatesUnder(in on, s.Time, in from);
        if (size >= ContactTolerances.Rolling)
        {
            double most = rolls ? system.RollingFriction(in on, size) : sliding;
            Vector3d rate = rolls ? rates.Acceleration + (on.Centripetal * on.Normal) - on.MaterialRate : SlipRate(in on, in rates, in from.Spin);

            // Near the end of a slip, its direction turns ever faster: use the closed form there.
            if (!rolls && _endsSlipExactly && sliding > 0 && EndSlip(ref s, ref run, ref system, in from, in on, in moving, h))
            {
                return;
            }

            double turned = most * (rolls ? 1.0 : 1.0 + (1.0 / _alpha));
            h = TurnLimit.Follow(h, system.Direction, size, in rate, turned, out system.LocksDirection);
            h = most > 0 && (rolls || _endsSlipExactly) ? TurnLimit.Shorten(h, run.Length, system.Direction, size, in rate, on.Turning == Vector3d.Zero) : h;
            h = run.Pieces > ManyPieces ? h : TurnLimit.ShortenStiff(h, run.Length, system.Direction, size, in rate, turned);
            rates = system.LocksDirection ? system.RatesUnder(in on, s.Time, in from) : rates;
        }

        // Take the piece. A net reacts within less than a step, so use RK4 substeps in a net.
        if (s.Nets != 0)
        {
            TakePiece<Substeps>(ref s, ref run, ref system, in from, in rates, h);
        }
        else if (run.Spirals)
        {
            // RK4 does not speed up a velocity that turns by up to 2.8 rad.
            TakePiece<ClassicalRungeKutta>(ref s, ref run, ref system, in from, in rates, h);
        }
        else
        {
            TakePiece<TIntegrator>(ref s, ref run, ref system, in from, in rates, h);
        }

        // The thesis' heuristic checks for the end of a slide only at the end of a piece.
        if (!_endsSlipExactly && sliding > 0 && s.Motion == MotionState.Sliding && !rolls && !run.Log.Halted)
        {
            EndSlipByHeuristic(ref s, ref run, size);
        }
    }

    /// <summary>True for a ball in a net that has lost its grip too often in this step.</summary>
    private static bool KeepsGrip(in BallState s, in StepRun run) => s.Nets != 0 && run.Slips >= MostSlips;

    /// <summary>Returns the tolerance for the end of a slide in a step of a given length, s.</summary>
    private double SlideEndIn(double step)
    {
        double squared = TurnLimit.Coarseness(step) * TurnLimit.Coarseness(step);
        return Math.Min(LargestSlideEnd * step, _integrator.Order >= 4 ? ContactTolerances.SlideEnd * squared * squared : ContactTolerances.CoarseSlideEnd * squared);
    }

    /// <summary>Keeps only the velocity component of a creeping ball along the push.</summary>
    private void Creep(ref BallState s, in SurfaceForces on, in Vector3d push)
    {
        Collider carrier = _world.CarrierOf(in s);
        Vector3d along = push / push.Length;
        s.Velocity += (Math.Max(0, Vector3d.Dot(on.Rolling, in along)) * along) - on.Rolling;
        Vector3d surface = _world.SurfaceVelocity(carrier, s.Position, in on.Normal, s.Time);
        s.SpinAxis = Slip.RollingSpin(s.Velocity - surface, Vector3d.Dot(s.SpinAxis, on.Normal), in on.Normal, _around.Radius);
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

    /// <summary>Takes a piece, ends it at the first event within it, and moves the ball.</summary>
    private void TakePiece<TMethod>(ref BallState s, ref StepRun run, ref SurfaceSystem system, in Motion from, in MotionRates start, double h)
        where TMethod : struct, IIntegrator
    {
        int order = default(TMethod).Order;
        var sweep = new MotionSweep<SurfaceSystem, TMethod>(in system, s.Time, in from, in start, _around.Wind, _around.Radius);
        sweep.Step(h);

        // End the piece at the first event: edge of a surface, jump, load, grip, rest or spin, border, kink of a net, contact.
        if (system.IsFace)
        {
            FaceBorder.EndBeyond(ref sweep, in s, system.Carrier);
        }
        else
        {
            SurfacePath.Shorten(ref sweep, in s, system.Carrier, _around.Radius, order);
        }

        if (_jump.Acts)
        {
            // After a launch or an impact, the flow determined the branch: locate the crossing from that branch.
            s.Branch = system.Branch;
            _jump.EndAtCrossingOnGround(ref sweep, ref s.Branch, ref run);
        }

        double crossing = sweep.Length;
        bool overEdge = SurfaceMargin<TMethod>.EndPiece(ref sweep, in s, system.Rolls, KeepsGrip(in s, in run));
        SurfaceBorder.EndBeyond(ref sweep, in s, system.Carrier);
        _nets.EndWhereSlack(ref sweep, in s);
        _nets.EndWhereBent(ref sweep, in s, (int)s.Carrier - _world.FirstCollider);
        bool meets = _guard.EndAtFirst(ref sweep, in s, order, out Separation met);

        // The piece ends before the jump: keep the old branch.
        s.Branch = sweep.Length < crossing ? system.Branch : s.Branch;
        run.Log.Evaluations += sweep.Evaluations;

        // Move the ball, then project it onto its carrier and onto the surface that it hits.
        BallState before = s;
        before.Branch = system.Branch;
        sweep.MoveTo(ref s);
        run.Advance(ref s, sweep.Length);
        Hold(ref s, in system, meets && met.What == SeparationKind.Contact ? met.Index : -1);
        if (overEdge && run.Log.IsWatched)
        {
            // Beyond the edge the forces differ: extrapolate the acceleration at the end instead of evaluating it there.
            Vector3d end = Extrapolate.Rate(before.Velocity, s.Velocity, sweep.StartAcceleration, sweep.Length);
            run.Log.Show(in before, in s, sweep.StartAcceleration, in end, order);
        }
        else
        {
            run.Show(in before, in s, ref sweep, order);
        }

        if (meets && !run.Log.Halted)
        {
            _guard.Meet(ref s, in met, ref run);
        }
    }

    /// <summary>Ends a slide in closed form, which is valid however the slip turns.</summary>
    /// <remarks>Near the end the push and the load are almost constant, so it uses their means.</remarks>
    /// <returns>False if the end is not near, or if friction cannot hold the ball afterwards.</returns>
    private bool EndSlip(
        ref BallState s, ref StepRun run, ref SurfaceSystem system, in Motion from, in SurfaceForces on, in Vector3d slip, double longest)
    {
        // First estimate: use the push and the friction at the start.
        double perLoad = (1.0 + (1.0 / _alpha)) * system.Material.SlidingFriction;
        Vector3d push = system.SlipPush(in on, in from.Spin);
        double friction = perLoad * on.Load;

        // In a net or on a curved surface, the push changes with the position: allow only a very short end.
        double most = s.Nets == 0 && on.Turning == Vector3d.Zero ? longest : Math.Min(longest, ContactTolerances.CurvedSlideEnd);

        // |s| < k t: the slide may end in this piece. |c|² < k²: friction outweighs the push, so it does end.
        if (!(slip.Length < friction * most) || !(push.LengthSquared < LargestPush * friction * friction))
        {
            return false;
        }

        double about = Vector3d.Dot(from.Spin, on.Normal);
        double turning = system.AboutRate(in on, in from);
        Vector3d start = on.Body + on.Air - (on.Centripetal * on.Normal);
        var decay = new SlipDecay(in slip, in push, friction);
        Motion end = SlipEnd(in system, s.Time, in from, in decay, system.SlidingFriction(in on), in start, in start, about + (decay.Time * turning), in on.Normal);

        // Second estimate: use the means of both ends, which leave only a higher-order error in the end time.
        SurfaceForces there = system.ForcesOn(s.Time + decay.Time, in end);
        run.Log.Evaluations++;
        Vector3d endPush = system.SlipPush(in there, in end.Spin);
        double endFriction = perLoad * there.Load;
        double change = (endPush - push).Length * (endPush.Length + push.Length);
        double loadChange = endFriction - friction;

        // If the means neglect too much, take an ordinary piece first.
        if (!(decay.Time * (change + (loadChange * loadChange)) <= SlideEndIn(run.Length) * friction * friction))
        {
            return false;
        }

        decay = new SlipDecay(in slip, 0.5 * (push + endPush), 0.5 * (friction + endFriction));
        double t = decay.Time;
        if (!(t > 0 && t <= longest))
        {
            return false;
        }

        Vector3d last = there.Body + there.Air - (there.Centripetal * there.Normal);
        double sliding = 0.5 * system.Material.SlidingFriction * (on.Load + there.Load);
        double lastTurning = system.AboutRate(in there, in end);
        about += 0.5 * t * (turning + lastTurning);
        end = SlipEnd(in system, s.Time, in from, in decay, sliding, in start, in last, about, in on.Normal);

        // Reject the result if the spin about the normal ends, or the ball reaches another surface, before the slip ends.
        if (system.SpinSign * (about - Vector3d.Dot(system.Carrier.Spin, in on.Normal)) < 0 || system.Carrier.PatchAt(s.Position) != system.Carrier.PatchAt(in end.Position)
            || (system.IsFace && system.Carrier.FaceMargin(in end.Position, s.Time + t) < 0))
        {
            return false;
        }

        // Reject the result if the drag law jumps first, because a piece must end at the jump.
        if (_jump.Acts && _around.BranchAt(in end) != system.Branch)
        {
            return false;
        }

        // Reject the result if the ball hits another object on its path.
        var path = PathCubic.Line(s.Position, (end.Position - s.Position) / t, t);
        if (new ContactSearch(_world, in path, s.Time).First(in s, (int)s.Carrier - _world.FirstCollider, out _) <= t)
        {
            return false;
        }

        // ∫ω dt, plus the Magnus term for the turning axis, t²/12 ω(t) × ω(0).
        Vector3d torque = SurfaceSystem.Tangential(on.Torque, on.Normal) + (turning * on.Normal);
        Vector3d lastTorque = SurfaceSystem.Tangential(there.Torque, on.Normal) + (lastTurning * on.Normal);
        Vector3d turn = (t * from.Spin) + ((t * t / 6.0) * ((2.0 * torque) + lastTorque))
            + ((sliding / (_alpha * _around.Radius)) * Vector3d.Cross(on.Normal, decay.Twice))
            + ((t * t / 12.0) * Vector3d.Cross(end.Spin, from.Spin));

        // Move the ball to its state at the end of the slip.
        BallState before = s;
        s.BaseOrientation = s.BaseOrientation.Turned(in turn);
        s.Position = end.Position;
        s.Velocity = end.Velocity;
        s.SpinAxis = end.Spin;
        run.Advance(ref s, t);
        Hold(ref s, in system, -1);
        if (run.Log.IsWatched)
        {
            Vector3d acceleration = start - (system.SlidingFriction(in on) * system.Direction);
            Vector3d atEnd = Extrapolate.Rate(from.Velocity, s.Velocity, in acceleration, t);
            run.Log.Show(in before, in s, in acceleration, in atEnd, _integrator.Order);
        }

        // The slip has ended: the ball rolls if friction can hold it.
        if (!run.Log.Halted && (system.Grips(in there) || KeepsGrip(in s, in run)))
        {
            _contact.StartRolling(ref s, ref run);
        }

        return true;
    }

    /// <summary>
    /// Returns the motion at the end of a slip: v = v₀ + ∫a − μ_s N/m ∫ŝ, p = p₀ + v₀ t + ∫∫a − μ_s N/m ∫∫ŝ, with a linear in time, and the
    /// spin of a roll.
    /// </summary>
    private Motion SlipEnd(
        in SurfaceSystem system, double time, in Motion from, in SlipDecay decay, double sliding, in Vector3d first, in Vector3d last, double about, in Vector3d normal)
    {
        double t = decay.Time;
        Vector3d velocity = from.Velocity + ((0.5 * t) * (first + last)) - (sliding * decay.Direction);
        Vector3d position = from.Position + (t * from.Velocity) + ((t * t / 6.0) * ((2.0 * first) + last)) - (sliding * decay.Twice);
        Vector3d surface = _world.SurfaceVelocity(system.Carrier, in position, in normal, time + t);
        Vector3d spin = Slip.RollingSpin(velocity - surface, about, in normal, _around.Radius);
        return new Motion(in position, in velocity, in spin);
    }

    /// <summary>The rate of the slip: ṡ = v̇_t − A_t + r (ṅ × ω)_t + r n × ω̇.</summary>
    private Vector3d SlipRate(in SurfaceForces on, in MotionRates rates, in Vector3d spin) =>
        SurfaceSystem.Tangential(in rates.Acceleration, on.Normal)
        + (_around.Radius * (Vector3d.Cross(on.Normal, in rates.SpinAcceleration) + SurfaceSystem.SlipTurn(in on, in spin))) - on.SurfaceRate;

    /// <summary>Returns the longest piece that stability, nets, borders and the turning normal allow, s.</summary>
    private double LongestPiece(in BallState s, in Motion from, in SurfaceForces on, ref StepRun run)
    {
        double asked = run.Next;
        Collider carrier = _world.CarrierOf(in s);
        ref readonly ContactMaterial material = ref carrier.MaterialAt(s.Position);
        double gain = s.Motion == MotionState.Sliding ? asked * material.SlidingFriction * on.Load : 0;
        double h = _limit.PartOf(
            ref _around.Air, asked, (from.Velocity - _around.Wind).Length, from.Spin.Length, s.Branch, ref run.Spirals, material.SpinDamping / _inertia, gain);

        // |ṅ| h bounds the rotation of the normal. Nets and the narrowest material border also limit the piece.
        double turning = on.Turning.Length;
        h = turning * h > LargestTurn ? LargestTurn / turning : h;
        h = Math.Min(h, _nets.LongestPiece(in s, h));
        h = SurfaceBorder.LongestPiece(carrier, on.Velocity.Length, h);
        run.Keep(h, asked);
        return h;
    }

    /// <summary>Projects the ball onto all surfaces that it touches, to remove the integrator's error.</summary>
    private void Hold(ref BallState s, in SurfaceSystem system, int met)
    {
        // Just beyond the edge of a flat face, the ball is still on the plane of that face.
        bool beyond = system.IsFace && system.Carrier.FaceMargin(s.Position, s.Time) <= 0;
        Vector3d n = beyond ? system.FaceNormal : _world.Hold(ref s, system.Carrier);
        if (met < 0 && !_world.IsPlaneAlone)
        {
            // The projection may have pushed the ball into a surface that it was leaving or touched without load.
            met = NearThings.Deepest(_world, in s, out _);
        }

        if (met >= 0)
        {
            n = PutOnto(ref s, system.Carrier, met);
        }

        Vector3d spin = s.SpinAxis;
        double about = Vector3d.Dot(in spin, in n);
        double carried = Vector3d.Dot(system.Carrier.Spin, in n);

        // Friction, damping and decay end the spin about the normal relative to the carrier, but never reverse it.
        bool brakesAlone = system.Material.DrillingLength > 0 || (!_around.Air.Varies && _isFlat && system.Carrier == _world.Ground);
        double kept = system.AboutCarrier(in system.StartSpin, in n) * (about - carried) < 0 && brakesAlone ? carried : about;
        Vector3d surface = _world.SurfaceVelocity(system.Carrier, s.Position, in n, s.Time);
        s.SpinAxis = system.Rolls ? Slip.RollingSpin(s.Velocity - surface, kept, in n, _around.Radius)
            : kept == about ? spin : spin - ((about - kept) * n);
    }

    /// <summary>Moves the ball along its carrier onto a second surface that it touches, and iterates if the surfaces are curved.</summary>
    /// <remarks>
    /// A flush surface, with a nearly equal normal, is skipped: it becomes the next carrier instead.
    /// </remarks>
    /// <returns>The carrier's normal at the new position.</returns>
    private Vector3d PutOnto(ref BallState s, Collider carrier, int collider)
    {
        Vector3d n = carrier.At(s.Position, s.Time).Normal;

        // Use Newton's method along the carrier, by −gap n_t/|n_t|², then project back onto the carrier.
        for (int i = 0; i < MostPuts; i++)
        {
            ShapePoint at = _world.Colliders[collider].At(s.Position, s.Time);
            Vector3d along = SurfaceSystem.Tangential(at.Normal, in n);
            double gap = at.Distance - _around.Radius;
            double share = along.LengthSquared;
            if (!(Math.Abs(gap) > ContactTolerances.ClosedGap) || !(share > 2.0 * ContactTolerances.SameNormal))
            {
                break;
            }

            s.Position -= gap / share * along;
            n = _world.Hold(ref s, carrier);
        }

        return n;
    }

    private SurfaceSystem System(in BallState s, in Motion from, bool rolls)
    {
        Collider carrier = _world.CarrierOf(in s);
        ShapePoint at = carrier.At(s.Position, s.Time);
        double about = Vector3d.Dot(from.Spin, at.Normal) - Vector3d.Dot(carrier.Spin, at.Normal);
        var system = SurfaceSystem.On(_around, carrier, in s, _jump.OnSurface(s.Branch, in from));
        system.Rolls = rolls;
        system.StartSpin = from.Spin;
        system.IsFace = carrier.HasFaces && !carrier.Rotates && at.IsFlat;
        system.FaceNormal = at.Normal;
        system.SpinSign = about > ContactTolerances.Rolling ? 1.0 : about < -ContactTolerances.Rolling ? -1.0 : 0.0;
        return system;
    }
}
