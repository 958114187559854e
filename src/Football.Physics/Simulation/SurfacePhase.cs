namespace FootballPhysics;

/// <summary>
/// Sliding and rolling on any surface of the world, piece by piece: up to the drag law's jump, the first thing that is met, the end of the slip or of
/// the grip, the place where the load ends, or rest.
/// </summary>
internal sealed class SurfacePhase<TIntegrator>
    where TIntegrator : struct, IIntegrator
{
    /// <summary>On a curved surface, whose push changes with the place, it is no longer than this, s.</summary>
    private const double CurvedSlideEnd = 1.25e-5;

    /// <summary>
    /// The last of a slide is done in closed form where the push on the slip changes so little that the end is known to this, s, in a step of 20 ms; longer
    /// steps ask as much less as the method itself does, its order as the power.
    /// </summary>
    private const double SlideEnd = 1e-10;

    /// <summary>Shortest end of a slide for a method of an order below four, s.</summary>
    private const double CoarseSlideEnd = 1e-7;

    /// <summary>But that is never more than this share of the step.</summary>
    private const double LargestSlideEnd = 1e-3;

    /// <summary>A push on the slip, of which the square is less than this share of friction's, leaves it an end; one that all but outweighs friction leaves none that is sure.</summary>
    private const double LargestPush = 0.9999;

    /// <summary>A slip smaller than this, m/s, is none to the thesis' heuristic (2.28).</summary>
    private const double HeuristicSlip = 1e-3;

    /// <summary>
    /// How often a roll in a net may lose its grip in a step. One that is slack and tight in turn makes a ball on the ground grip and slip in turn, the sooner the less
    /// it slips; after so many it grips for the rest of the step: friction does no work on what rolls.
    /// </summary>
    private const int MostSlips = 2;

    /// <summary>After so many pieces, a step follows a slip that friction turns less closely: what pushes the ball has changed so often that no more is gained.</summary>
    private const int ManyPieces = 32;

    /// <summary>Onto what it meets a ball is put so often at most, and until it is no farther off than this, m.</summary>
    private const int MostPuts = 16;
    private const double Closed = 1e-12;

    /// <summary>The normal turns by no more than this in a piece, rad.</summary>
    private const double LargestTurn = 0.05;

    /// <summary>
    /// A ball creeps if rolling friction changes its velocity by more than so many times itself in what is left of the step. Its direction then follows the push
    /// within that share of the time, in which it moves by less than 1e-8 m in usual steps.
    /// </summary>
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

    /// <summary>The next piece of a slide or a roll.</summary>
    public void Take(ref BallState s, ref StepRun run)
    {
        // What the ball hits where it is goes first, then a set of contacts, which has a phase of its own.
        if (!_world.IsPlaneAlone)
        {
            if (_guard.HitsAtOnce(ref s, ref run))
            {
                return;
            }

            // Of flush surfaces another may carry the ball from here on: only the material and the velocity of the surface change.
            _contact.HandOver(ref s, Flush.CarrierOf(_world, in s), ref run);
            if (_set.Take(ref s, ref run))
            {
                return;
            }
        }

        // What acts here, and what becomes of the ball at once: it leaves, rests, grips, or slips.
        bool rolls = s.Motion == MotionState.Rolling;
        var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        SurfaceSystem system = System(in s, in from, rolls);
        system.CarrierGain = run.CarrierGain;
        SurfaceForces on = system.ForcesOn(s.Time, in from);
        run.Log.Evaluations++;
        if (on.FreeLoad <= SurfaceForces.Least)
        {
            _contact.Leave(ref s, s.Velocity, s.Spin, ref run);
            return;
        }

        double sliding = system.SlidingFriction(in on);
        Vector3d traction = system.Traction(in on);
        bool grips = system.Grips(in on) || KeepsGrip(in s, in run);
        Vector3d moving = rolls ? on.Rolling : system.SlipOf(in from, in on);
        double size = moving.Length;

        // A roll that needs more than the friction there is begins to slip.
        if (rolls && !grips)
        {
            run.Slips++;
            _contact.StartSliding(ref s, ref run);
            return;
        }

        // A slide without slip that friction can hold rolls.
        if (!rolls && size < Slip.Rolling && grips)
        {
            _contact.StartRolling(ref s, ref run);
            return;
        }

        // A roll rests, or is pinned where rolling friction holds it against the push; from a standstill it goes where the push leads.
        if (rolls)
        {
            Vector3d drive = system.Drive(in on) - on.MaterialRate;
            bool held = drive.Length <= system.RollingFriction(in on, 0);
            if (system.Rests(in on) && _world.Energy(in from, system.Carrier, s.Time) <= _world.RestEnergy * (1.0 + 1e-12))
            {
                _contact.Rest(ref s, ref run);
                return;
            }

            system.Pinned = size < Slip.Rolling && held;
            if (system.Pinned)
            {
                // What was left of its speed is none: it does not creep.
                s.Velocity = system.Carrier.MaterialVelocity(s.Position, s.Time);
                from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
                on = system.ForcesOn(s.Time, in from);
                run.Log.Evaluations++;
            }

            // Friction turns a ball that creeps into the push much sooner than the step ends.
            bool creeps = !held && run.Next * system.RollingFriction(in on, 0) > Creeping * size;
            if (creeps && size >= Slip.Rolling)
            {
                Creep(ref s, in on, in drive);
                from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
                on = system.ForcesOn(s.Time, in from);
                run.Log.Evaluations++;
                size = 0;
            }

            moving = size < Slip.Rolling ? drive : moving;
        }
        else
        {
            moving = size < Slip.Rolling ? traction : moving;
        }

        // The direction of the slip or the roll: friction keeps to it where a stage passes zero.
        double length = moving.Length;
        system.Direction = length > 0 ? moving / length : Vector3d.Zero;

        system.LocksDirection = size < Slip.Rolling;

        // How long the piece may be: first by stability, nets, borders and the turning normal, then by how fast the direction turns.
        double h = LongestPiece(in s, in from, in on, ref run);
        MotionRates rates = system.RatesUnder(in on, s.Time, in from);
        if (size >= Slip.Rolling)
        {
            double most = rolls ? system.RollingFriction(in on, size) : sliding;
            Vector3d rate = rolls ? rates.Acceleration + (on.Centripetal * on.Normal) - on.MaterialRate : SlipRate(in on, in rates, in from.Spin);

            // Near its end the direction of a slip turns ever faster: there it is done in closed form.
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

        // Take it: in a net by RK4 in parts, for that settles faster than a step is long.
        if (s.Nets != 0)
        {
            TakePiece<Substeps>(ref s, ref run, ref system, in from, in rates, h);
        }
        else if (run.Spirals)
        {
            // RK4 makes no velocity longer that turns by up to 2.8 rad.
            TakePiece<ClassicalRungeKutta>(ref s, ref run, ref system, in from, in rates, h);
        }
        else
        {
            TakePiece<TIntegrator>(ref s, ref run, ref system, in from, in rates, h);
        }

        // The thesis' end of a slide is looked for at the end of a piece.
        if (!_endsSlipExactly && sliding > 0 && s.Motion == MotionState.Sliding && !rolls && !run.Log.Halted)
        {
            EndSlipByHeuristic(ref s, ref run, size);
        }
    }

    /// <summary>True for a ball in a net that has lost its grip too often in the step.</summary>
    private static bool KeepsGrip(in BallState s, in StepRun run) => s.Nets != 0 && run.Slips >= MostSlips;

    /// <summary>How closely the end of a slide is known in a step of some length, s.</summary>
    private double SlideEndIn(double step)
    {
        double squared = TurnLimit.Coarseness(step) * TurnLimit.Coarseness(step);
        return Math.Min(LargestSlideEnd * step, _integrator.Order >= 4 ? SlideEnd * squared * squared : CoarseSlideEnd * squared);
    }

    /// <summary>Keeps of the velocity of a ball that creeps only the part along the push.</summary>
    private void Creep(ref BallState s, in SurfaceForces on, in Vector3d push)
    {
        Collider carrier = _world.CarrierOf(in s);
        Vector3d along = push / push.Length;
        s.Velocity += (Math.Max(0, Vector3d.Dot(on.Rolling, in along)) * along) - on.Rolling;
        Vector3d surface = _world.SurfaceVelocity(carrier, s.Position, in on.Normal, s.Time);
        s.SpinAxis = Slip.RollingSpin(s.Velocity - surface, Vector3d.Dot(s.SpinAxis, on.Normal), in on.Normal, _around.Radius);
    }

    /// <summary>The thesis' end of a slide (2.27, 2.28): the slip grew, or is small.</summary>
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

    /// <summary>Takes a piece, ends it at the first thing that happens in it, and moves the ball.</summary>
    private void TakePiece<TMethod>(ref BallState s, ref StepRun run, ref SurfaceSystem system, in Motion from, in MotionRates start, double h)
        where TMethod : struct, IIntegrator
    {
        int order = default(TMethod).Order;
        var sweep = new MotionSweep<SurfaceSystem, TMethod>(in system, s.Time, in from, in start, _around.Wind, _around.Radius);
        sweep.Step(h);

        // What may end it, one after the other: off a curved surface, the jump, load, grip, rest and spin, a border, a net's kink, what is met.
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
            // After a launch or an impact the branch was read from the flow: the crossing is one of that branch.
            s.Branch = system.Branch;
            _jump.EndAtCrossingOnGround(ref sweep, ref s.Branch, ref run);
        }

        double crossing = sweep.Length;
        bool overEdge = SurfaceMargin<TMethod>.EndPiece(ref sweep, in s, system.Rolls, KeepsGrip(in s, in run));
        SurfaceBorder.EndBeyond(ref sweep, in s, system.Carrier);
        _nets.EndWhereSlack(ref sweep, in s);
        _nets.EndWhereBent(ref sweep, in s, (int)s.Carrier - _world.FirstCollider);
        bool meets = _guard.EndAtFirst(ref sweep, in s, order, out Separation met);

        // Ended before the jump it is still on the branch that it was taken on.
        s.Branch = sweep.Length < crossing ? system.Branch : s.Branch;
        run.Log.Evaluations += sweep.Evaluations;

        // Move, and put the ball back onto its carrier, and onto what it meets.
        BallState before = s;
        before.Branch = system.Branch;
        sweep.MoveTo(ref s);
        run.Advance(ref s, sweep.Length);
        Hold(ref s, in system, meets && met.What == SeparationKind.Contact ? met.Index : -1);
        if (overEdge && run.Log.IsWatched)
        {
            // What acts beyond the edge is no end of this path.
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

    /// <summary>
    /// The end of a slide in closed form, whatever way the slip turns: near it the push and the load are all but constant, and their means of both ends are taken.
    /// </summary>
    /// <returns>False where it is not near, or friction cannot hold the ball then.</returns>
    private bool EndSlip(
        ref BallState s, ref StepRun run, ref SurfaceSystem system, in Motion from, in SurfaceForces on, in Vector3d slip, double longest)
    {
        // With the push and the friction at the start.
        double perLoad = (1.0 + (1.0 / _alpha)) * system.Material.SlidingFriction;
        Vector3d push = system.SlipPush(in on, in from.Spin);
        double friction = perLoad * on.Load;

        // In a net and on a curved surface the push changes with the place: only the very end is short enough there.
        double most = s.Nets == 0 && on.Turning == Vector3d.Zero ? longest : Math.Min(longest, CurvedSlideEnd);

        // |s| < k t: it may end in this piece; |c|² < k²: friction outweighs the push, so that it does end.
        if (!(slip.Length < friction * most) || !(push.LengthSquared < LargestPush * friction * friction))
        {
            return false;
        }

        double about = Vector3d.Dot(from.Spin, on.Normal);
        double turning = system.AboutRate(in on, in from);
        Vector3d start = on.Body + on.Air - (on.Centripetal * on.Normal);
        var decay = new SlipDecay(in slip, in push, friction);
        Motion end = SlipEnd(in system, s.Time, in from, in decay, system.SlidingFriction(in on), in start, in start, about + (decay.Time * turning), in on.Normal);

        // And with the means: the end is known to what they leave out.
        SurfaceForces there = system.ForcesOn(s.Time + decay.Time, in end);
        run.Log.Evaluations++;
        Vector3d endPush = system.SlipPush(in there, in end.Spin);
        double endFriction = perLoad * there.Load;
        double change = (endPush - push).Length * (endPush.Length + push.Length);
        double loadChange = endFriction - friction;

        // Where the means still leave out too much, a piece is taken first.
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

        // Not where the spin about the normal ends, or another surface begins, before the slip does.
        if (system.SpinSign * (about - Vector3d.Dot(system.Carrier.Spin, in on.Normal)) < 0 || system.Carrier.PatchAt(s.Position) != system.Carrier.PatchAt(in end.Position)
            || (system.IsFace && system.Carrier.FaceMargin(in end.Position, s.Time + t) < 0))
        {
            return false;
        }

        // Nor if the drag law jumps before: a piece ends there first.
        if (_jump.Acts && DragJump.At(in end, in _around.Wind, _around.Radius).Branch != system.Branch)
        {
            return false;
        }

        // Nor where anything is met on the way.
        var path = PathCubic.Line(s.Position, (end.Position - s.Position) / t, t);
        if (new ContactSearch(_world, in path, s.Time).First(in s, (int)s.Carrier - _world.FirstCollider, out _) <= t)
        {
            return false;
        }

        // ∫ω, and Magnus' term for its turning axis, t²/12 ω(t) × ω(0).
        Vector3d torque = SurfaceSystem.Tangential(on.Torque, on.Normal) + (turning * on.Normal);
        Vector3d lastTorque = SurfaceSystem.Tangential(there.Torque, on.Normal) + (lastTurning * on.Normal);
        Vector3d turn = (t * from.Spin) + ((t * t / 6.0) * ((2.0 * torque) + lastTorque))
            + ((sliding / (_alpha * _around.Radius)) * Vector3d.Cross(on.Normal, decay.Twice))
            + ((t * t / 12.0) * Vector3d.Cross(end.Spin, from.Spin));

        // Move the ball to the end of the slip.
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

        // The slip is over: it rolls, if friction holds it there.
        if (!run.Log.Halted && (system.Grips(in there) || KeepsGrip(in s, in run)))
        {
            _contact.StartRolling(ref s, ref run);
        }

        return true;
    }

    /// <summary>
    /// The motion where a slip ends: v = v₀ + ∫a − μ_s N/m ∫ŝ, p = p₀ + v₀ t + ∫∫a − μ_s N/m ∫∫ŝ with a linear in time, and the spin of a roll.
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

    /// <summary>ṡ = v̇_t − A_t + r (ṅ × ω)_t + r n × ω̇.</summary>
    private Vector3d SlipRate(in SurfaceForces on, in MotionRates rates, in Vector3d spin) =>
        SurfaceSystem.Tangential(in rates.Acceleration, on.Normal)
        + (_around.Radius * (Vector3d.Cross(on.Normal, in rates.SpinAcceleration) + SurfaceSystem.SlipTurn(in on, in spin))) - on.SurfaceRate;

    /// <summary>The longest piece that stability, nets and the turning of the normal allow, s.</summary>
    private double LongestPiece(in BallState s, in Motion from, in SurfaceForces on, ref StepRun run)
    {
        double asked = run.Next;
        Collider carrier = _world.CarrierOf(in s);
        ref readonly ContactMaterial material = ref carrier.MaterialAt(s.Position);
        double gain = s.Motion == MotionState.Sliding ? asked * material.SlidingFriction * on.Load : 0;
        double h = _limit.PartOf(
            ref _around.Air, asked, (from.Velocity - _around.Wind).Length, from.Spin.Length, s.Branch, ref run.Spirals, material.SpinDamping / _inertia, gain);

        // |ṅ| h bounds how far the normal turns; a net and the narrowest surface bound the piece as well.
        double turning = on.Turning.Length;
        h = turning * h > LargestTurn ? LargestTurn / turning : h;
        h = Math.Min(h, _nets.LongestPiece(in s, h));
        h = SurfaceBorder.LongestPiece(carrier, on.Velocity.Length, h);
        run.Keep(h, asked);
        return h;
    }

    /// <summary>Puts the ball onto all that it touches: what the integrator left of it is within its own error.</summary>
    private void Hold(ref BallState s, in SurfaceSystem system, int met)
    {
        // Just beyond the edge of a flat face the ball is still on its plane.
        bool beyond = system.IsFace && system.Carrier.FaceMargin(s.Position, s.Time) <= 0;
        Vector3d n = beyond ? system.FaceNormal : _world.Hold(ref s, system.Carrier);
        if (met < 0 && !_world.IsPlaneAlone)
        {
            // Back on the surface it may be in what it was just leaving, or in what it touched and was not pressed on.
            met = NearThings.Deepest(_world, in s, out _);
        }

        if (met >= 0)
        {
            n = PutOnto(ref s, system.Carrier, met);
        }

        Vector3d spin = s.SpinAxis;
        double about = Vector3d.Dot(in spin, in n);
        double carried = Vector3d.Dot(system.Carrier.Spin, in n);

        // Friction, damping and the air's decay end the spin about the normal, relative to the carrier, and reverse nothing.
        bool brakesAlone = system.Material.DrillingLength > 0 || (!_around.Air.Varies && _isFlat && system.Carrier == _world.Ground);
        double kept = system.AboutCarrier(in system.StartSpin, in n) * (about - carried) < 0 && brakesAlone ? carried : about;
        Vector3d surface = _world.SurfaceVelocity(system.Carrier, s.Position, in n, s.Time);
        s.SpinAxis = system.Rolls ? Slip.RollingSpin(s.Velocity - surface, kept, in n, _around.Radius)
            : kept == about ? spin : spin - ((about - kept) * n);
    }

    /// <summary>
    /// Puts the ball onto something else that it touches too, along what carries it: back and forth, where those are curved. A flush surface, sin² of the angle to which is
    /// all but zero, carries it next instead.
    /// </summary>
    /// <returns>The carrier's normal there.</returns>
    private Vector3d PutOnto(ref BallState s, Collider carrier, int collider)
    {
        Vector3d n = carrier.At(s.Position, s.Time).Normal;

        // Newton along the carrier, by −gap n_t/|n_t|², and back onto the carrier.
        for (int i = 0; i < MostPuts; i++)
        {
            ShapePoint at = _world.Colliders[collider].At(s.Position, s.Time);
            Vector3d along = SurfaceSystem.Tangential(at.Normal, in n);
            double gap = at.Distance - _around.Radius;
            double share = along.LengthSquared;
            if (!(Math.Abs(gap) > Closed) || !(share > 2.0 * Flush.SameNormal))
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
        return new SurfaceSystem
        {
            Around = _around,
            World = _world,
            Carrier = carrier,
            Material = carrier.MaterialAt(s.Position),
            Branch = _jump.OnSurface(s.Branch, in from),
            Nets = s.Nets,
            NetSides = s.NetSides,
            Rolls = rolls,
            StartSpin = from.Spin,
            IsFace = carrier.HasFaces && !carrier.Rotates && at.IsFlat,
            FaceNormal = at.Normal,
            SpinSign = about > Slip.Rolling ? 1.0 : about < -Slip.Rolling ? -1.0 : 0.0,
        };
    }
}
