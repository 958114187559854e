using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>
/// A ball that several contacts carry, guide or press at once, in short parts of a step: forces at both ends, impulses by <see cref="ContactSolver"/>, the
/// place by the mean velocity. Exact where the forces are constant and every contact keeps gripping, or slipping one way; where one of them begins to
/// grip, as good as the part is short.
/// </summary>
internal sealed partial class ContactSetParts
{
    /// <summary>Length of a part, s: a slip that ends within one moves the ball by less than 1e-6 m from where it would be.</summary>
    private const double Part = 0.5e-3;

    /// <summary>Parts of a step at most, all calls together: in long ones they are longer.</summary>
    private const int MostParts = 16;

    /// <summary>A ball that rolls is told to slide from this slip on, m/s: less may be over in the next part.</summary>
    private const double Slips = 1e-3;

    /// <summary>How often a step tells so: a ball that what pushes it makes slip and grip in turn does it at every part.</summary>
    private const int MostNames = 2;

    /// <summary>A ball that is so slow, m/s and rad/s times its radius, stands still.</summary>
    private const double Still = 1e-12;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly DragJumpGuard _jump;
    private readonly WorldGuard _guard;
    private readonly WorldContact _contact;
    private readonly Displacement _displacement;
    private readonly NetGuard _nets;
    private readonly ShownPath _shown;
    private readonly ContactRoom _more = new();
    private readonly ContactRoom _moreBefore = new();

    public ContactSetParts(Surroundings around, DragJumpGuard jump, WorldGuard guard, Displacement displacement, WorldContact contact)
    {
        _around = around;
        _world = around.World;
        _jump = jump;
        _guard = guard;
        _displacement = displacement;
        _contact = contact;
        _nets = new NetGuard(_world);
        _shown = new ShownPath(_world);
    }

    /// <summary>Takes what is left of a step, or up to what ends it, where several contacts bear the ball; hands it to the one that does where that is another.</summary>
    /// <returns>False where the ball's carrier alone bears it, or nothing does.</returns>
    [SkipLocalsInit]
    public bool Take(ref BallState s, ref StepRun run)
    {
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        Span<Contact> last = stackalloc Contact[ContactSet.Room];
        int before = 0;

        double part = LengthOfPart(in run, Part);
        bool taken = false;
        int named = 0;
        while (run.Left > 0 && !run.Log.Halted)
        {
            // What touches the ball, and what of that would bear it.
            Span<Contact> set = ContactSet.Touching(_world, in s, room, _more);
            if (set.Length < 2)
            {
                return taken;
            }

            // Warm start: a contact that was there in the part before begins with its impulses.
            ContactSet.Continue(set, last.Slice(0, before));
            double h = run.Left / Math.Max(1.0, Math.Round(run.Left / part));
            bool turns = TurningNormals.Shorten(_world, in s, set, ref run, ref h);

            // Predict: v + h a with the forces at the start. These impulses only say where the forces at the end are asked for.
            var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
            MotionRates start = Free(in s, s.Time, in from, h);
            Vector3d v = from.Velocity + (h * start.Acceleration);
            Vector3d w = from.Spin + (h * start.SpinAcceleration);
            bool solved = ContactSolver.Solve(set, _world.Ball, h, ref v, ref w, ContactSolver.Foreseen);
            run.Log.Evaluations++;
            LeaveOut(ref set, run.Log);

            // One contact alone bears it and nothing there moves, or none does: the phase of a single surface takes the ball on.
            if (Bearers(set, h, out int bearer) < 2 && (bearer < 0 || !ContactSet.HasMover(set)))
            {
                return taken | (bearer >= 0 && HandOver(ref s, set[bearer].Collider, ref run));
            }

            // There is no room if no impulses satisfy all contacts, or if they would give the ball more than its allowed speed. Only objects that move squeeze.
            if (Moves(set) && (!solved || _contact.IsTooFast(ref s, set, in v)))
            {
                _contact.BeginSqueeze(ref s, set[bearer].Collider, ref run);
                return true;
            }

            taken = true;
            if (Rests(ref s, set, bearer, in start, ref run))
            {
                return true;
            }

            bool stays = v.Length + (_around.Radius * w.Length) <= Still && from.Velocity.Length + (_around.Radius * from.Spin.Length) <= Still;
            if (stays)
            {
                // Nothing changes until something comes.
                h = run.Left;
            }
            else
            {
                // Once more, with the mean of the forces.
                var end = new Motion(from.Position + ((0.5 * h) * (from.Velocity + v)), in v, in w, s.AirDistance);
                MotionRates there = Free(in s, s.Time + h, in end, h);
                v = from.Velocity + ((0.5 * h) * (start.Acceleration + there.Acceleration));
                w = from.Spin + ((0.5 * h) * (start.SpinAcceleration + there.SpinAcceleration));
                double most = v.Length;
                if (!ContactSolver.Solve(set, _world.Ball, h, ref v, ref w))
                {
                    Settle(set, h, most, ref v);
                }

                run.Log.Evaluations++;
            }

            // Along the way, to its end or to what is met on it.
            Vector3d mean = 0.5 * (from.Velocity + v);
            var path = PathCubic.Line(s.Position, in mean, h);
            double at = new ContactSearch(_world, in path, s.Time).First(in s, -1, set, out Separation met);
            bool meets = at <= h;
            double length = meets ? at : h;

            // An impact that cuts a part short is counted as an impact, and a turn as a turn: the parts that remain must cover the rest of the step.
            run.Parts += meets || turns ? 0 : 1;
            run.Turns += turns ? 1 : 0;
            double share = length / h;

            // v and ω are linear in a part, so also where it is cut short.
            BallState at0 = s;
            v = from.Velocity + (share * (v - from.Velocity));
            w = from.Spin + (share * (w - from.Spin));
            Move(ref s, length, 0.5 * (from.Velocity + v), in v, in w, in start, ref run);

            bool passes = meets && met.What is not (SeparationKind.Contact or SeparationKind.Seam);
            if (passes)
            {
                _guard.Meet(ref s, in met, ref run);
            }

            // Back onto the contacts that bear it: on a curved one the straight way leads off. Nets and goals are met on that way too.
            Vector3d moved = s.Position;
            Hold(ref s, set);
            _displacement.Follow(ref s, in moved, ref run);
            _shown.Show(in at0, in s, at0.Velocity, s.Velocity, set, ref run);
            Name(ref s, set, ref named, ref run);
            last = _moreBefore.Of(set.Length, last);
            set.CopyTo(last);
            before = set.Length;

            // What is met on the way, or closes where the ball is, ends this phase: what becomes of the ball decides which one goes on.
            if (meets && !run.Log.Halted)
            {
                if (!passes)
                {
                    _guard.Meet(ref s, in met, ref run);
                }

                return true;
            }

            if (_guard.HitsAtOnce(ref s, ref run))
            {
                return true;
            }
        }

        return true;
    }

    /// <summary>The rest of a step in parts of equal length, s. If the step has few parts left, they are longer.</summary>
    private static double LengthOfPart(in StepRun run, double asked) =>
        run.Left / Math.Max(1.0, Math.Min(MostParts - run.Parts, Math.Ceiling(run.Left / asked)));

    /// <summary>What acts on the ball without its contacts, for a part of a step.</summary>
    private MotionRates Free(in BallState s, double time, in Motion at, double h)
    {
        // The drag law is locked to the branch at the start of the part: its jump is not located here.
        DragBranch branch = _around.Air.Jumps ? DragJump.At(in at, in _around.Wind, _around.Radius).Branch : DragBranch.Unknown;
        MotionRates rates = new FlightSystem { Around = _around }.On(branch, time, in at);
        Vector3d acceleration = rates.Acceleration;
        Vector3d spinAcceleration = rates.SpinAcceleration;
        if (!_world.SharesAir)
        {
            // Of the air no more counts than on one surface: nothing, or what it does along the carrier.
            Collider carrier = _world.CarrierOf(in s);
            var surface = new SurfaceSystem { Around = _around, World = _world, Carrier = carrier, Material = carrier.MaterialAt(in at.Position), Branch = branch };
            SurfaceForces on = surface.ForcesOn(time, in at);
            acceleration = on.Body + on.Air - ((on.FreeLoad + on.Centripetal) * on.Normal);
            spinAcceleration = on.Torque;
        }

        return PartForces.Bounded(_world, _nets, in s, in at, new MotionRates(in acceleration, in spinAcceleration, rates.AirSpeed), h);
    }

    /// <summary>The acceleration without what is along ω × u, the Magnus force: it turns with the velocity and does no work, where that turns at once as where it turns slowly.</summary>
    private Vector3d Working(in MotionRates free, in Motion at)
    {
        // a − (a·m) m/|m|², m = ω × u; where all of the air counts the weight is left out of this.
        Vector3d weight = _world.SharesAir ? _around.Weight : Vector3d.Zero;
        Vector3d other = free.Acceleration - weight;
        Vector3d magnus = Vector3d.Cross(in at.Spin, at.Velocity - _around.Wind);
        double square = magnus.LengthSquared;
        return square > 0 && square < double.MaxValue ? weight + other - (Vector3d.Dot(in other, in magnus) / square * magnus) : free.Acceleration;
    }

    /// <summary>How many contacts bear the ball, and which of them most, or alone.</summary>
    private static int Bearers(Span<Contact> set, double h, out int bearer)
    {
        int count = 0;
        bearer = ContactSet.Heaviest(set);
        foreach (ref readonly Contact contact in set)
        {
            count += contact.Load > SurfaceForces.Least * h ? 1 : 0;
        }

        return count;
    }

    /// <summary>Another contact than the one that carried the ball bears it alone: that carries it now.</summary>
    private bool HandOver(ref BallState s, int collider, ref StepRun run)
    {
        if (collider + _world.FirstCollider == s.Carrier)
        {
            return false;
        }

        _contact.TakeUp(ref s, collider, ref run);
        return true;
    }

    /// <summary>A ball with no more energy than one at rest rests, if all that touches it stands still, or moves along with its carrier, and holds it.</summary>
    [SkipLocalsInit]
    private bool Rests(ref BallState s, scoped Span<Contact> set, int bearer, in MotionRates free, ref StepRun run)
    {
        BallState still = s;
        still.Carrier = bearer < 0 ? s.Carrier : set[bearer].Collider + _world.FirstCollider;
        if (!(_world.Energy(new Motion(s.Position, s.Velocity, s.Spin), _world.CarrierOf(in still), s.Time) <= _world.RestEnergy * (1.0 + 1e-12)))
        {
            return false;
        }

        int evaluations = 0;
        var held = new Motion(s.Position, _world.CarrierOf(in still).MaterialVelocity(s.Position, s.Time), Vector3d.Zero);
        bool rests = set.Length > ContactSystem.Most ? !Moves(set) && ContactSolver.Holds(set, _world, in free, Part, Still)
            : ContactModes.HoldAtRest(_around, set, in still, in held, _jump.OnSurface(DragBranch.Unknown, in held), Vector3d.Zero, ref evaluations);
        run.Log.Evaluations += evaluations;
        if (rests)
        {
            s.Carrier = still.Carrier;
            _contact.Rest(ref s, ref run);
        }

        return rests;
    }

    /// <summary>Moves the ball, and the clock.</summary>
    private static void Move(ref BallState s, double h, in Vector3d mean, in Vector3d v, in Vector3d w, in MotionRates free, ref StepRun run)
    {
        s.BaseOrientation = s.BaseOrientation.Turned((0.5 * h) * (s.Spin + w));
        s.Position += h * mean;
        s.Velocity = v;
        s.SpinAxis = w;
        s.AirDistance += h * free.AirSpeed;
        run.Advance(ref s, h);
        s.Time = run.Left > 0 ? s.Time : run.End;
    }

    /// <summary>The contact that bears most names the carrier; the one before does as long as it bears about as much. Whether that slips says whether the ball slides or rolls.</summary>
    private void Name(ref BallState s, scoped Span<Contact> set, ref int told, ref StepRun run)
    {
        int named = ContactSet.Named(set, (int)s.Carrier - _world.FirstCollider);
        if (named < 0)
        {
            return;
        }

        ref readonly Contact contact = ref set[named];
        s.Carrier = contact.Collider + _world.FirstCollider;
        Collider collider = _world.Colliders[contact.Collider];
        double slip = Slip.Of(s.Velocity - _world.SurfaceVelocity(collider, s.Position, in contact.Normal, s.Time), s.Spin, in contact.Normal, _around.Radius).Length;
        if (told >= MostNames)
        {
            return;
        }

        // A slip ends below one threshold and begins above a higher one: between them it may be over in the next part.
        if (slip < Slip.Rolling && s.Motion != MotionState.Rolling)
        {
            told++;
            _contact.StartRolling(ref s, ref run);
        }
        else if (slip > Slips && s.Motion == MotionState.Rolling)
        {
            told++;
            _contact.StartSliding(ref s, ref run);
        }
    }

    /// <summary>Puts a ball onto the contacts that bear it; what moves among them puts it into nothing else that stands still.</summary>
    public void Hold(ref BallState s, scoped Span<Contact> set)
    {
        ContactSet.Hold(_world, ref s, set);
        if (ContactSet.HasMover(set))
        {
            _contact.KeepOut(ref s);
        }
    }

    /// <summary>Leaves moving contacts without a load out of a set that has too many, and counts them.</summary>
    private static void LeaveOut(ref Span<Contact> set, StepLog log)
    {
        int before = set.Length;
        set = ContactSet.LeaveOut(set);
        log.LeftOut += before - set.Length;
    }

    /// <summary>True if any of the surfaces moves now.</summary>
    private static bool Moves(Span<Contact> set)
    {
        foreach (ref readonly Contact contact in set)
        {
            if (contact.Moves && contact.Velocity != Vector3d.Zero)
            {
                return true;
            }
        }

        return false;
    }
}
