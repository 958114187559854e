using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Steps a ball on several surfaces in short parts with velocity-level impulses.</summary>
/// <remarks>It is the fallback of <see cref="ContactSetPhase{TIntegrator}"/>. Each part evaluates the forces at both ends, computes the impulses
/// with <see cref="ImpulseSolver"/>, and moves the ball at the mean velocity. This is exact if the forces are constant and no contact
/// changes its mode. At a change of mode, the error depends on the length of the part.</remarks>
internal sealed partial class ContactSetParts
{
    /// <summary>Length of a part, s. A slip that ends within a part displaces the ball by less than 1e-6 m.</summary>
    private const double Part = 0.5e-3;

    /// <summary>Maximum number of parts per step over all calls. Long steps get longer parts.</summary>
    public const int MostParts = 16;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly Rest _rest;
    private readonly WorldGuard _guard;
    private readonly WorldContact _contact;
    private readonly PartForces _forces;
    private readonly ShownPath _shown;
    private readonly ContactRoom _more = new();
    private readonly ContactRoom _moreBefore = new();

    public ContactSetParts(Surroundings around, WorldGuard guard, WorldContact contact)
    {
        _around = around;
        _world = around.World;
        _rest = new Rest(around);
        _guard = guard;
        _contact = contact;
        _forces = new PartForces(around);
        _shown = new ShownPath(_world);
    }

    /// <summary>Takes the rest of a step, or the part up to an event, if several contacts are active.</summary>
    /// <remarks>If only one contact other than the carrier is active, it becomes the carrier.</remarks>
    /// <returns>False if only the carrier, or no contact, has a load.</returns>
    [SkipLocalsInit]
    public bool Take(ref BallState s, ref StepRun run)
    {
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        Span<Contact> last = stackalloc Contact[ContactSet.Room];
        int before = 0;

        double part = LengthOfPart(in run, Part);
        bool taken = false;
        while (run.TakesParts(_world))
        {
            // Find the touched surfaces; the solver then determines which of them have a load.
            Span<Contact> set = ContactSet.Touching(_world, in s, room, _more, run.Rattles);
            if (set.Length < 2)
            {
                return taken;
            }

            // Warm start: a contact that existed in the previous part starts with the impulses from that part.
            ContactSet.Continue(set, last.Slice(0, before));
            var next = new SetPart
            {
                From = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance),
                Length = run.Left / Math.Max(1.0, Math.Round(run.Left / part)),
            };
            next.Turns = TurningNormals.Shorten(_world, in s, set, ref run, ref next.Length);
            Predict(in s, set, ref next);
            run.Log.Evaluations++;
            LeaveOut(ref set, run.Log);

            // At most one contact has a load, and no loaded surface moves: leave the ball to the single-surface phase, unless it would rattle.
            if (Bearers(set, next.Length, out int bearer) < 2 && !run.Rattles && (bearer < 0 || !ContactSet.HasMover(set)))
            {
                return taken | (bearer >= 0 && HandOver(ref s, set[bearer].Collider, ref run));
            }

            // The ball has no room if no impulses satisfy all contacts, or if it would have to leave too fast. Only moving objects squeeze the ball.
            if (SolvedSet.Drives(set, movers: true) && (!next.Solved || WorldContact.IsTooFast(in s, set, next.From.Velocity + (next.Length * next.Start.Acceleration), in next.Velocity)))
            {
                _contact.BeginSqueeze(ref s, set[bearer].Collider, ref run);
                return true;
            }

            taken = true;
            if (Rests(ref s, set, bearer, in next.Start, ref run))
            {
                return true;
            }

            if (next.IsStill(_around.Radius))
            {
                // No force moves the ball: take the rest of the step at once.
                next.Length = run.Left;
            }
            else
            {
                Correct(in s, set, ref run, ref next);
                run.Log.Evaluations++;
            }

            Move(ref s, ref run, set, ref next);
            Name(ref s, set, ref run);
            last = _moreBefore.Of(set.Length, last);
            set.CopyTo(last);
            before = set.Length;
            if (EndsPhase(ref s, ref run, in next))
            {
                return true;
            }
        }

        return true;
    }

    /// <summary>Predicts the motion at the end of a part from the forces at its start.</summary>
    /// <remarks>The impulses only determine the state in which <see cref="Correct"/> evaluates the forces at the end.</remarks>
    private void Predict(in BallState s, scoped Span<Contact> set, ref SetPart part)
    {
        double h = part.Length;
        part.Start = _forces.Free(in s, s.Time, in part.From, isCarried: true, h);
        part.Velocity = part.From.Velocity + (h * part.Start.Acceleration);
        part.Spin = part.From.Spin + (h * part.Start.SpinAcceleration);
        part.Solved = ImpulseSolver.Solve(set, _world.Ball, h, ref part.Velocity, ref part.Spin, ContactTolerances.Foreseen);
    }

    /// <summary>Corrects the predicted motion with the mean of the forces at both ends.</summary>
    private void Correct(in BallState s, scoped Span<Contact> set, ref StepRun run, ref SetPart part)
    {
        double h = part.Length;
        ref readonly Motion from = ref part.From;
        var end = new Motion(from.Position + ((0.5 * h) * (from.Velocity + part.Velocity)), in part.Velocity, in part.Spin, s.AirDistance);
        MotionRates there = _forces.Free(in s, s.Time + h, in end, isCarried: true, h);
        if (_around.Air.HasOwnForces && !((there.Acceleration - part.Start.Acceleration).Length <= part.Start.Acceleration.Length))
        {
            // Reduce custom forces that are too stiff for a part, and take them as constant.
            MotionRates limited = _forces.FreeLimited(in s, s.Time, in from, isCarried: true, h, out double change);
            run.Log.Evaluations += 2;
            if (change > 1)
            {
                part.Start = limited;
                there = limited;
                run.CountStiff();
            }
        }

        part.Velocity = from.Velocity + ((0.5 * h) * (part.Start.Acceleration + there.Acceleration));
        part.Spin = from.Spin + ((0.5 * h) * (part.Start.SpinAcceleration + there.SpinAcceleration));
        var unheld = new Motion(from.Position, in part.Velocity, in part.Spin);
        part.Solved = ImpulseSolver.Solve(set, _world.Ball, h, ref part.Velocity, ref part.Spin);
        SolvedSet.Correct(set, _world, h, part.Solved, in unheld, ref part.Velocity, ref part.Spin);
    }

    /// <summary>Moves the ball to the end of a part or to the first contact, then projects it onto its contacts.</summary>
    private void Move(ref BallState s, ref StepRun run, scoped Span<Contact> set, ref SetPart part)
    {
        ref readonly Motion from = ref part.From;
        double h = part.Length;
        Vector3d mean = 0.5 * (from.Velocity + part.Velocity);
        var path = PathCubic.Line(s.Position, in mean, h);
        double at = new ContactSearch(_world, in path, s.Time).First(in s, -1, out part.Met, set);
        part.Meets = at <= h;

        // Do not count a part that an impact or a turning normal cut short: the remaining parts must cover the rest.
        run.Spent.Parts += part.Meets || part.Turns ? 0 : 1;
        run.Spent.Turns += part.Turns ? 1 : 0;

        // Within a part, v and ω are linear in time: interpolate a shortened part.
        double length = part.Meets ? at : h;
        double share = length / h;
        BallState before = s;
        Vector3d v = from.Velocity + (share * (part.Velocity - from.Velocity));
        Vector3d w = from.Spin + (share * (part.Spin - from.Spin));
        Advance(ref s, length, 0.5 * (from.Velocity + v), in v, in w, in part.Start, ref run);
        if (part.IsPassage)
        {
            _guard.Meet(ref s, in part.Met, ref run);
        }

        // A straight path leaves a curved surface, so project the ball back onto its contacts. The projection may also enter nets and goals.
        Vector3d moved = s.Position;
        Hold(ref s, set);
        SolvedSet.PayForLift(ref s, set, _world.Ball, _around.Weight, in moved);
        _guard.Follow(ref s, in moved, ref run);
        _shown.Show(in before, in s, before.Velocity, s.Velocity, set, ref run);
    }

    /// <summary>Handles the contact that ends a part, on the path or at its end. The new state decides which phase continues.</summary>
    /// <returns>False if there is none.</returns>
    private bool EndsPhase(ref BallState s, ref StepRun run, in SetPart part)
    {
        if (!part.Meets || run.Log.Halted)
        {
            return _guard.HitsAtOnce(ref s, ref run);
        }

        if (!part.IsPassage)
        {
            _guard.Meet(ref s, in part.Met, ref run);
        }

        return true;
    }

    /// <summary>Returns the length of equal parts for the rest of a step, s.</summary>
    /// <remarks>If only a few parts are left, each is longer.</remarks>
    private static double LengthOfPart(in StepRun run, double requested) =>
        run.Left / Math.Max(1.0, Math.Min(MostParts - run.Spent.Parts, Math.Ceiling(run.Left / requested)));

    /// <summary>Returns the acceleration without its component along ω × u (the Magnus force).</summary>
    /// <remarks>The Magnus force turns with the velocity and does no work, however fast the velocity turns.</remarks>
    private Vector3d Working(in MotionRates free, in Motion at)
    {
        // a − (a·m) m/|m|² with the direction m = ω × u of the Magnus force: spin ω, velocity u through the air. If the full air force acts, the
        // projection excludes the weight.
        Vector3d weight = _world.SharesAir ? _around.Weight : Vector3d.Zero;
        Vector3d other = free.Acceleration - weight;
        Vector3d magnus = Vector3d.Cross(in at.Spin, at.Velocity - _around.Wind);
        double square = magnus.LengthSquared;
        return square > 0 && square < double.MaxValue ? weight + other - (Vector3d.Dot(in other, in magnus) / square * magnus) : free.Acceleration;
    }

    /// <summary>Counts the contacts with a load, and finds the one with the greatest load.</summary>
    private static int Bearers(Span<Contact> set, double h, out int bearer)
    {
        int count = 0;
        bearer = ContactSet.Heaviest(set);
        foreach (ref readonly Contact contact in set)
        {
            count += contact.Load > ContactTolerances.LeastLoad * h * contact.NormalMass ? 1 : 0;
        }

        return count;
    }

    /// <summary>Makes the only contact with a load the carrier, if it is not already.</summary>
    private bool HandOver(ref BallState s, int collider, ref StepRun run)
    {
        if (collider + _world.FirstCollider == s.Carrier)
        {
            return false;
        }

        _contact.TakeUp(ref s, collider, ref run);
        return true;
    }

    /// <summary>Stops a ball with no more than the rest energy if its contacts hold it and are stationary, or move along with its carrier.</summary>
    [SkipLocalsInit]
    private bool Rests(ref BallState s, scoped Span<Contact> set, int bearer, in MotionRates free, ref StepRun run)
    {
        BallState still = s;
        still.Carrier = bearer < 0 ? s.Carrier : set[bearer].Collider + _world.FirstCollider;
        if (!_rest.IsSlow(new Motion(s.Position, s.Velocity, s.Spin), _world.CarrierOf(in still), s.Time))
        {
            return false;
        }

        int evaluations = 0;
        bool rests = set.Length > ContactSystem.Most ? !SolvedSet.Drives(set, movers: true) && ImpulseSolver.Holds(set, _world, in free, Part, ContactTolerances.Standstill)
            : _rest.IsHeldBy(set, in still, Vector3d.Zero, mayGrip: true, ref evaluations);
        run.Log.Evaluations += evaluations;
        if (rests)
        {
            s.Carrier = still.Carrier;
            _contact.Rest(ref s, ref run);
        }

        return rests;
    }

    /// <summary>Moves the ball and advances the clock.</summary>
    private static void Advance(ref BallState s, double h, in Vector3d mean, in Vector3d v, in Vector3d w, in MotionRates free, ref StepRun run)
    {
        s.BaseOrientation = s.BaseOrientation.Turned((0.5 * h) * (s.Spin + w));
        s.Position += h * mean;
        s.Velocity = v;
        s.SpinAxis = w;
        s.AirDistance += h * free.AirSpeed;
        run.Advance(ref s, h);
        s.Time = run.Left > 0 ? s.Time : run.End;
    }

    /// <summary>Updates the carrier and the motion state.</summary>
    private void Name(ref BallState s, scoped Span<Contact> set, ref StepRun run)
    {
        int named = ContactSet.Named(set, (int)s.Carrier - _world.FirstCollider);
        if (named >= 0)
        {
            // Hysteresis: a slip starts at a higher threshold than it ends, so that a small slip does not toggle from part to part.
            ref readonly Contact contact = ref set[named];
            Vector3d surface = _world.SurfaceVelocity(_world.ByIndex[contact.Collider], s.Position, in contact.Normal, s.Time);
            double slip = Slip.Of(s.Velocity - surface, s.Spin, in contact.Normal, _around.Radius).Length;
            bool rolls = slip < ContactTolerances.Rolling || (s.Motion == MotionState.Rolling && slip <= ContactTolerances.ReportedSlip);
            _contact.Name(ref s, contact.Collider, rolls, ref run);
        }
    }

    /// <summary>Projects a ball onto its contacts. Moving contacts must not push it into stationary objects.</summary>
    public void Hold(ref BallState s, scoped Span<Contact> set)
    {
        Vector3d before = s.Position;
        ContactSet.Hold(_world, ref s, set);
        if (ContactSet.HasMover(set) && (s.Position - before).Length > ContactTolerances.ClosedGap)
        {
            _contact.KeepOut(ref s);
        }
    }

    /// <summary>Drops moving contacts without load from a set that is too large, and counts them.</summary>
    private static void LeaveOut(ref Span<Contact> set, StepLog log)
    {
        int before = set.Length;
        set = ContactSet.LeaveOut(set);
        log.LeftOut += before - set.Length;
    }
}

/// <summary>A part of a step on several surfaces.</summary>
internal struct SetPart
{
    /// <summary>The motion at the start.</summary>
    public Motion From;

    /// <summary>The forces at the start, without contact forces.</summary>
    public MotionRates Start;

    /// <summary>The proposed length, s.</summary>
    public double Length;

    /// <summary>The velocity at the end of that length, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>The spin at the end of that length, rad/s.</summary>
    public Vector3d Spin;

    /// <summary>True if the impulses satisfy all contacts.</summary>
    public bool Solved;

    /// <summary>True if the part is short because a normal turns.</summary>
    public bool Turns;

    /// <summary>True if a contact or a passage ends the part.</summary>
    public bool Meets;

    /// <summary>What ends the part, if anything does.</summary>
    public Separation Met;

    /// <summary>True if the ball enters or leaves a net or a goal at the end of the part.</summary>
    public readonly bool IsPassage => Meets && Met.What is not (SeparationKind.Contact or SeparationKind.Seam);

    /// <summary>True if the ball stands still at both ends.</summary>
    public readonly bool IsStill(double radius) =>
        Velocity.Length + (radius * Spin.Length) <= ContactTolerances.Standstill && From.Velocity.Length + (radius * From.Spin.Length) <= ContactTolerances.Standstill;
}
