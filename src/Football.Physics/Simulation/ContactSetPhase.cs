using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;

namespace FootballPhysics.Simulation;

/// <summary>Steps a ball on several surfaces at once with the chosen integrator.</summary>
/// <remarks>
/// Contacts and modes are locked for a piece (<see cref="ContactSystem"/>). A piece ends at the first event: a load, friction cone, slip or
/// gap reaches its limit, the ball comes to rest, or it hits another object. If no modes are consistent, or the set changes too often in a
/// step, <see cref="ContactSetParts"/> takes the rest.
/// </remarks>
internal sealed unsafe class ContactSetPhase<TIntegrator>
    where TIntegrator : struct, IIntegrator
{
    /// <summary>Maximum number of set changes per step while several contacts are active.</summary>
    /// <remarks>After that the rest of the step is taken in parts.</remarks>
    private const int MostChanges = 8;

    /// <summary>Maximum number of pieces per step with several active contacts.</summary>
    /// <remarks>
    /// After that the rest of the step is taken in parts: a turning slip would need ever more pieces. Above: the last of them last nanoseconds. Below: the
    /// parts change the motion; with 160 pieces, a ball that a player walks into a net ends 6e-6 m away.
    /// </remarks>
    private const int MostPieces = 80;

    /// <summary>After this many pieces, a turning slip ends at the larger tolerance.</summary>
    private const int ManyPieces = 24;

    /// <summary>Maximum number of checks per step of whether friction holds a ball that rolling resistance cannot hold.</summary>
    private const int MostGrips = 4;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly WorldGuard _guard;
    private readonly WorldContact _contact;
    private readonly DragJumpGuard _jump;
    private readonly PieceLength _length;
    private readonly NetGuard _nets;
    private readonly Rest _rest;
    private readonly ContactSetParts _parts;
    private readonly OwnForceGuard? _own;

    public ContactSetPhase(Surroundings around, in StabilityLimit limit, DragJumpGuard jump, WorldGuard guard, WorldContact contact, ContactSetParts parts, OwnForceGuard? own)
    {
        _around = around;
        _world = around.World;
        _length = new PieceLength(around, in limit);
        _jump = jump;
        _guard = guard;
        _contact = contact;
        _nets = new NetGuard(_world);
        _rest = new Rest(around);
        _parts = parts;
        _own = own;
    }

    /// <summary>Takes the next piece if several contacts are active. If another single contact is active, it becomes the carrier.</summary>
    /// <returns>False if only the carrier, or no contact, has a load.</returns>
    [SkipLocalsInit]
    public bool Take(ref BallState s, ref StepRun run)
    {
        Contact* room = stackalloc Contact[ContactSet.Room];
        Span<Contact> set = ContactSet.Touching(_world, in s, new Span<Contact>(room, ContactSet.Room), _world.Room, run.Rattles);
        if (set.Length < 2)
        {
            return false;
        }

        if (run.Rattles || set.Length > ContactSystem.Most || run.Spent.SetChanges > MostChanges || run.Spent.SetPieces >= MostPieces)
        {
            return TakeParts(ref s, ref run);
        }

        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        var piece = new SetPiece { System = new ContactSystem { Around = _around, World = _world, Contacts = contacts, Count = set.Length } };
        ForceTrace trace;
        piece.System.Trace = _own is null ? null : &trace;
        switch (Propose(ref s, ref run, set, ref piece))
        {
            case SetMotion.One:
                return false;
            case SetMotion.Unsolved:
                return TakeParts(ref s, ref run);
            case SetMotion.Changed:
                return true;
        }

        if (run.Probe is not null)
        {
            run.Probe.Press(in piece.System, in piece.From, s.Time);
            return true;
        }

        bool taken;
        _own?.Shorten(ref piece.Length, s.Nets != 0 ? piece.System.LongestPart(in piece.From, default) : double.PositiveInfinity, ref run);
        if (s.Nets != 0 && _own is null)
        {
            Take<Substeps>(ref s, ref run, set, ref piece, out taken);
        }
        else if (run.Followed > 0
            || !(run.Spirals ? Take<ClassicalRungeKutta>(ref s, ref run, set, ref piece, out taken) : Take<TIntegrator>(ref s, ref run, set, ref piece, out taken)))
        {
            Take<EighthOrder>(ref s, ref run, set, ref piece, out taken);
        }

        return taken;
    }

    /// <summary>Takes the rest of the step in parts.</summary>
    private bool TakeParts(ref BallState s, ref StepRun run)
    {
        if (run.Probe is not null)
        {
            run.Probe.UsesImpulses = true;
            return true;
        }

        return _parts.Take(ref s, ref run);
    }

    /// <summary>Takes a piece up to its first event, moves the ball, and handles the event. If the set has no solution, takes the parts instead.</summary>
    /// <returns>False if the method does not follow the custom forces. The ball has not moved then.</returns>
    [SkipLocalsInit]
    private bool Take<TMethod>(ref BallState s, ref StepRun run, Span<Contact> set, ref SetPiece piece, out bool taken)
        where TMethod : struct, IMotionMethod
    {
        taken = true;
        if (!Integrate(in s, ref run, in piece, out MotionSweep<ContactSystem, TMethod> sweep))
        {
            return false;
        }

        piece.System.Trace = null;
        if (!SetGuard.IsFinite(sweep.EndMotion))
        {
            run.Log.Evaluations += sweep.Evaluations;
            taken = _parts.Take(ref s, ref run);
            return true;
        }

        Shorten(ref sweep, ref s, ref run, set, ref piece);
        if (SetGuard.Overshoots(_around, in s, in piece.System, in piece.From, sweep.EndMotion, sweep.Length, default(TMethod).Order))
        {
            s.Branch = piece.System.Branch;
            taken = _parts.Take(ref s, ref run);
            return true;
        }

        Move(ref s, ref run, ref sweep, set, in piece);
        Respond(ref s, ref run, set, in piece);
        return true;
    }

    /// <summary>Finds the modes of the contacts, and the length of the piece.</summary>
    private SetMotion Propose(ref BallState s, ref StepRun run, Span<Contact> set, ref SetPiece piece)
    {
        // Determine the contact modes at the start.
        ref ContactSystem system = ref piece.System;
        SetContact* contacts = system.Contacts;
        for (int i = 0; i < set.Length; i++)
        {
            contacts[i].Prepare(in set[i], _world.ByIndex[set[i].Collider]);
        }

        piece.From = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        system.Nets = s.Nets;
        system.NetSides = s.NetSides;
        system.Branch = _jump.OnSurface(s.Branch, in piece.From);
        system.BeginTrace();
        int evaluations = 0;
        double sticking = run.Spent.SetPieces < ManyPieces ? ContactTolerances.Sticking : ContactTolerances.StickingAfterMany;
        bool found = ContactModes.Find(ref system, s.Time, in piece.From, sticking, (int)s.Carrier - _world.FirstCollider, ref evaluations);
        run.Log.Evaluations += evaluations;
        if (!found)
        {
            return SetMotion.Unsolved;
        }

        // At most one contact has a load: leave the ball to the single-surface phase.
        int bearing = 0;
        int last = -1;
        for (int i = 0; i < system.Count; i++)
        {
            bearing += contacts[i].Bears ? 1 : 0;
            last = contacts[i].Bears ? i : last;
        }

        if (bearing < 2)
        {
            if (last < 0 || contacts[last].Collider + _world.FirstCollider == s.Carrier)
            {
                return SetMotion.One;
            }

            _contact.TakeUp(ref s, contacts[last].Collider, ref run);
            return SetMotion.Changed;
        }

        if (Rests(ref s, set, in system, in piece.From, ref run))
        {
            _contact.Rest(ref s, ref run);
            return SetMotion.Changed;
        }

        StuckMotion.Project(_world, in system, ref s);
        var stuck = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        if (!((stuck.Velocity - piece.From.Velocity).Length + (_around.Radius * (stuck.Spin - piece.From.Spin).Length) <= ContactTolerances.Standstill))
        {
            system.BeginTrace();
            system.Rates(s.Time, in stuck, out system.Start);
            run.Log.Evaluations++;
        }

        piece.From = stuck;
        system.NetsSlack = _nets.SlackAt(in s, in system.Start.Acceleration);
        piece.Length = LongestPiece(in s, in stuck, in system, ref run);
        return SetMotion.Several;
    }

    /// <summary>Integrates a piece.</summary>
    /// <returns>False if the method does not follow the custom forces.</returns>
    private bool Integrate<TMethod>(in BallState s, ref StepRun run, in SetPiece piece, out MotionSweep<ContactSystem, TMethod> sweep)
        where TMethod : struct, IMotionMethod
    {
        ref readonly ContactSystem system = ref piece.System;
        sweep = new MotionSweep<ContactSystem, TMethod>(in system, s.Time, in piece.From, in system.Start, system.Around.Wind, system.Around.Radius);
        if (_own is not null)
        {
            return _own.Take(ref sweep, piece.Length, system.Trace, ref run);
        }

        sweep.Step(piece.Length);
        return true;
    }

    /// <summary>Ends a piece at the first event: a face's edge, the jump in the drag law, a change in a contact (load, friction limit, slip, rest), a
    /// border between two materials, a net that goes slack, or a new contact.</summary>
    private void Shorten<TMethod>(
        ref MotionSweep<ContactSystem, TMethod> sweep, ref BallState s, ref StepRun run, Span<Contact> set, ref SetPiece piece)
        where TMethod : struct, IMotionMethod
    {
        ref ContactSystem system = ref piece.System;
        double whole = sweep.Length;
        for (int i = 0; i < system.Count; i++)
        {
            Collider collider = _world.ByIndex[system.Contacts[i].Collider];
            if (system.Contacts[i].IsFixed && collider.HasFaces)
            {
                FaceBorder.EndBeyond(ref sweep, in s, collider);
            }
        }

        if (_jump.Acts)
        {
            s.Branch = system.Branch;
            _jump.EndAtCrossingOnGround(ref sweep, ref s.Branch, ref run);
        }

        double crossing = sweep.Length;
        bool changes = EventMargin<ContactSystem, TMethod>.EndPiece(ref sweep, s.Time, out _);
        SurfaceBorder.EndBeyond(ref sweep, in s, _world.CarrierOf(in s));
        _nets.EndWhereSlack(ref sweep, in s, system.NetsSlack);
        piece.Meets = _guard.EndAtFirst(ref sweep, in s, default(TMethod).Order, set, out piece.Met);
        s.Branch = sweep.Length < crossing ? system.Branch : s.Branch;
        run.Log.Evaluations += sweep.Evaluations;
        run.Spent.SetPieces++;
        run.Spent.SetChanges += (changes || piece.Meets) && sweep.Length < whole ? 1 : 0;
    }

    /// <summary>Moves the ball to the end of a piece, then projects it onto its contacts, because it drifts off curved surfaces.</summary>
    private void Move<TMethod>(ref BallState s, ref StepRun run, ref MotionSweep<ContactSystem, TMethod> sweep, Span<Contact> set, in SetPiece piece)
        where TMethod : struct, IMotionMethod
    {
        BallState before = s;
        before.Branch = piece.System.Branch;
        sweep.MoveTo(ref s);
        run.Advance(ref s, sweep.Length);
        for (int i = 0; i < set.Length; i++)
        {
            set[i].Load = piece.System.Contacts[i].Load;
        }

        s.ClearIn = BallState.TouchesSeveral;
        _parts.Hold(ref s, set);
        run.Show(in before, in s, ref sweep, default(TMethod).Order);
    }

    /// <summary>Updates the carrier, and handles the contact at the end of a piece.</summary>
    private void Respond(ref BallState s, ref StepRun run, Span<Contact> set, in SetPiece piece)
    {
        int named = ContactSet.Named(set, (int)s.Carrier - _world.FirstCollider);
        if (named >= 0)
        {
            _contact.Name(ref s, set[named].Collider, piece.System.Contacts[named].Sticks, ref run);
        }

        if (piece.Meets && !run.Log.Halted)
        {
            _guard.Meet(ref s, in piece.Met, ref run);
        }
    }

    /// <summary>True if a ball below the rest energy is held by contacts that are stationary or move together.</summary>
    private bool Rests(ref BallState s, Span<Contact> set, in ContactSystem system, in Motion from, ref StepRun run)
    {
        ref readonly SetContact bearer = ref system.Contacts[Math.Max(0, system.Bearer)];
        if (!_rest.IsSlow(in from, _world.ByIndex[bearer.Collider], s.Time))
        {
            return false;
        }

        bool sticks = true;
        for (int i = 0; i < system.Count; i++)
        {
            sticks &= !system.Contacts[i].Bears || system.Contacts[i].Sticks;
        }

        BallState still = s;
        still.Carrier = bearer.Collider + _world.FirstCollider;
        int evaluations = 0;
        bool holds = _rest.IsHeldBy(set, in still, Vector3d.Zero, sticks && run.Grips < MostGrips, ref evaluations);
        run.Grips += evaluations > 1 ? 1 : 0;
        run.Log.Evaluations += evaluations;
        s.Carrier = holds ? still.Carrier : s.Carrier;
        return holds;
    }

    /// <summary>Returns the longest piece that stability, nets, turning slips and turning normals allow, s.</summary>
    private double LongestPiece(in BallState s, in Motion from, in ContactSystem system, ref StepRun run)
    {
        double damping = 0;
        double slowing = 0;
        double turning = 0;
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            damping = Math.Max(damping, contact.Resistance.Damping);
            slowing += contact.Bears && !contact.Sticks ? contact.Resistance.MostFriction(contact.Load) : 0;
            turning = Math.Max(turning, contact.Turning.Length);
        }

        double h = _length.Longest(in s, in from, damping, slowing, turning, ref run);
        return ShortenForSlips(in system, in from, h, run.Length);
    }

    /// <summary>Shortens a piece so that the integrator can follow every turning slip.</summary>
    private double ShortenForSlips(in ContactSystem system, in Motion from, double h, double step)
    {
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            double size = contact.Slip.Length;
            if (contact.Bears && !contact.Sticks && contact.Resistance.Rubs && size > 0)
            {
                Vector3d rate = contact.SlipRate(in system.Start, from.Spin, _around.Radius);
                h = TurnLimit.Shorten(h, step, contact.Direction, size, in rate, contact.Turning.Length);
            }
        }

        return h;
    }
}

/// <summary>A piece on several surfaces.</summary>
internal struct SetPiece
{
    /// <summary>The equations, with contacts and modes locked for the piece.</summary>
    public ContactSystem System;

    /// <summary>The motion at the start.</summary>
    public Motion From;

    /// <summary>The proposed length, s.</summary>
    public double Length;

    /// <summary>True if the piece ends at a contact.</summary>
    public bool Meets;

    /// <summary>The contact at its end, if it meets one.</summary>
    public Separation Met;
}

/// <summary>What a ball does that touches several surfaces.</summary>
internal enum SetMotion
{
    /// <summary>At most its carrier has a load.</summary>
    One,

    /// <summary>Several contacts have a load.</summary>
    Several,

    /// <summary>It changed its carrier, or rests.</summary>
    Changed,

    /// <summary>No modes are consistent.</summary>
    Unsolved,
}
