using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>
/// A ball on several surfaces at once, in whole steps of the method: the contacts and their modes are locked for a piece (<see cref="ContactSystem"/>), and the piece
/// ends where a load, a friction cone, a slip or a gap ends, where the ball comes to rest, or where it meets something (contacts.md, A step). Where no modes hold,
/// or a step has changed them too often, <see cref="ContactSetParts"/> takes the rest.
/// </summary>
internal sealed unsafe class ContactSetPhase<TIntegrator>
    where TIntegrator : struct, IIntegrator
{
    /// <summary>Changes of the set in a step, while several contacts bear; after them the rest of it is taken in parts.</summary>
    private const int MostChanges = 8;

    /// <summary>Pieces in a step in which several contacts bear; after them the rest of it is taken in parts: a slip that turns would need ever more of them.</summary>
    private const int MostPieces = 160;

    /// <summary>A slip of less than this, m/s, has ended.</summary>
    private const double Sticking = 1e-7;

    /// <summary>A state that changes by less than this, m/s, keeps the rates that were found for it.</summary>
    private const double Unmoved = 1e-12;

    /// <summary>A step with many pieces follows a slip that turns no further than to this, m/s.</summary>
    private const double StickingOfMany = 1e-6;
    private const int ManyPieces = 24;

    /// <summary>A normal turns by no more than this in a piece, rad.</summary>
    private const double LargestTurn = 0.05;

    /// <summary>How often a step reports that the ball slides or rolls.</summary>
    private const int MostNames = 2;

    /// <summary>How often a step checks whether friction holds a ball that rolling resistance does not hold.</summary>
    private const int MostGrips = 4;

    /// <summary>Rounds in which slips and speeds off contacts are ended, one contact after the other; more are taken only while they change the velocity by more than this, m/s.</summary>
    private const int FewStickRounds = 4;
    private const int MostStickRounds = 128;
    private const double Corrected = 1e-9;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly WorldGuard _guard;
    private readonly WorldContact _contact;
    private readonly DragJumpGuard _jump;
    private readonly StabilityLimit _limit;
    private readonly NetGuard _nets;
    private readonly ContactSetParts _parts;

    public ContactSetPhase(Surroundings around, in StabilityLimit limit, DragJumpGuard jump, WorldGuard guard, WorldContact contact, ContactSetParts parts)
    {
        _around = around;
        _world = around.World;
        _limit = limit;
        _jump = jump;
        _guard = guard;
        _contact = contact;
        _nets = new NetGuard(_world);
        _parts = parts;
    }

    /// <summary>Takes the next piece where several contacts bear the ball; hands it to the one that does where that is another than its carrier.</summary>
    /// <returns>False where the ball's carrier alone bears it, or nothing does.</returns>
    [SkipLocalsInit]
    public bool Take(ref BallState s, ref StepRun run)
    {
        Contact* room = stackalloc Contact[ContactSet.Room];
        Span<Contact> set = ContactSet.Touching(_world, in s, new Span<Contact>(room, ContactSet.Room), _world.Room);
        if (set.Length < 2)
        {
            return false;
        }

        if (set.Length > ContactSystem.Most || run.SetChanges > MostChanges || run.SetPieces >= MostPieces)
        {
            return _parts.Take(ref s, ref run);
        }

        // The modes at the start.
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        for (int i = 0; i < set.Length; i++)
        {
            contacts[i].Prepare(in set[i], _world.Colliders[set[i].Collider], _world.Ball);
        }

        var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        var system = new ContactSystem
        {
            Around = _around,
            World = _world,
            Contacts = contacts,
            Count = set.Length,
            Nets = s.Nets,
            NetSides = s.NetSides,
            Branch = _jump.OnSurface(s.Branch, in from),
        };
        int evaluations = 0;
        double sticking = run.SetPieces < ManyPieces ? Sticking : StickingOfMany;
        bool found = ContactModes.Find(ref system, s.Time, in from, sticking, (int)s.Carrier - _world.FirstCollider, ref evaluations);
        run.Log.Evaluations += evaluations;
        if (!found)
        {
            return _parts.Take(ref s, ref run);
        }

        // One contact alone bears it, or none does: the phase of a single surface takes the ball on.
        int bearing = 0;
        int last = -1;
        for (int i = 0; i < system.Count; i++)
        {
            bearing += contacts[i].Bears ? 1 : 0;
            last = contacts[i].Bears ? i : last;
        }

        if (bearing < 2)
        {
            if (last >= 0 && contacts[last].Collider + _world.FirstCollider != s.Carrier)
            {
                _contact.TakeUp(ref s, contacts[last].Collider, ref run);
                return true;
            }

            return false;
        }

        if (Rests(ref s, in system, in from, ref run))
        {
            _contact.Rest(ref s, ref run);
            return true;
        }

        Stick(in system, ref s);
        var stuck = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        if (!((stuck.Velocity - from.Velocity).Length + (_around.Radius * (stuck.Spin - from.Spin).Length) <= Unmoved))
        {
            system.Rates(s.Time, in stuck, out MotionRates rates);
            run.Log.Evaluations++;
            system.Acceleration = rates.Acceleration;
            system.SpinAcceleration = rates.SpinAcceleration;
        }

        TakePiece(ref s, ref run, ref system, set, in stuck);
        return true;
    }

    /// <summary>True when a ball of no more energy than one at rest is held by contacts that stand still, or move along together.</summary>
    private bool Rests(ref BallState s, in ContactSystem system, in Motion from, ref StepRun run)
    {
        ref readonly SetContact bearer = ref system.Contacts[Math.Max(0, system.Bearer)];
        Collider carrier = _world.Colliders[bearer.Collider];
        if (!(_world.Energy(in from, carrier, s.Time) <= _world.RestEnergy * (1.0 + 1e-12)))
        {
            return false;
        }

        bool sticks = true;
        for (int i = 0; i < system.Count; i++)
        {
            sticks &= !system.Contacts[i].Bears || system.Contacts[i].Sticks;
            Collider collider = _world.Colliders[system.Contacts[i].Collider];
            if (collider.Velocity != carrier.Velocity || collider.Spin != Vector3d.Zero)
            {
                return false;
            }
        }

        var still = new Motion(s.Position, carrier.Velocity, Vector3d.Zero);
        int evaluations = 1;
        bool holds = ContactModes.Hold(in system, system.PushAtRest(s.Time, in still))
            || (sticks && run.Grips++ < MostGrips && ContactModes.Grip(in system, s.Time, in still, bearer.Collider, ref evaluations));
        run.Log.Evaluations += evaluations;
        s.Carrier = holds ? bearer.Collider + _world.FirstCollider : s.Carrier;
        return holds;
    }

    /// <summary>Ends what is left of a slip at contacts that stick, and of a speed off contacts that bear: below what the modes are told by.</summary>
    private void Stick(in ContactSystem system, ref BallState s)
    {
        double r = _world.Ball.Radius;
        double grip = _world.Ball.InertiaFactor / (1.0 + _world.Ball.InertiaFactor);
        Vector3d v = s.Velocity;
        Vector3d w = s.SpinAxis;
        double change = double.PositiveInfinity;
        for (int round = 0; round < MostStickRounds && change > (round < FewStickRounds ? 1e-15 : Corrected); round++)
        {
            change = 0;
            for (int i = 0; i < system.Count; i++)
            {
                ref readonly SetContact contact = ref system.Contacts[i];
                if (!contact.Bears)
                {
                    // What the others change must not lead into a stationary surface.
                    double closing = Vector3d.Dot(in v, contact.Normal);
                    bool enters = closing < -ContactSearch.Approaching && !_world.Colliders[contact.Collider].Moves;
                    v -= enters ? closing * contact.Normal : Vector3d.Zero;
                    change = enters ? Math.Max(change, -closing) : change;
                    continue;
                }

                // A push F along the surface turns the ball by −n × F/(α r), and takes (1 + α)/α of itself from the slip.
                Vector3d n = contact.Normal;
                Collider collider = _world.Colliders[contact.Collider];
                double off = Vector3d.Dot(v - collider.ShapeVelocity(s.Position - (r * n), s.Time), in n);
                v -= off * n;
                change = Math.Max(change, Math.Abs(off));
                if (contact.Sticks)
                {
                    Vector3d slip = Slip.Of(v - contact.Surface, in w, in n, r);
                    Vector3d push = -grip * slip;
                    v += push;
                    w -= 1.0 / (_world.Ball.InertiaFactor * r) * Vector3d.Cross(in n, in push);
                    change = Math.Max(change, slip.Length);
                }
            }

        }

        // Moving objects may leave no such velocity. Then the ball does not enter stationary ones.
        for (int i = 0; i < system.Count && change > Corrected; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            double off = Vector3d.Dot(in v, contact.Normal);
            off = contact.Bears ? off : Math.Min(0, off);
            v -= _world.Colliders[contact.Collider].Moves ? Vector3d.Zero : off * contact.Normal;
        }

        s.Velocity = v;
        s.SpinAxis = w;
        if (system.HoldsSpin)
        {
            ref readonly SetContact bearer = ref system.Contacts[system.Bearer];
            s.SpinAxis = w - ((Vector3d.Dot(in w, bearer.Normal) - bearer.CarrierSpin) * bearer.Normal);
        }

        if (system.Pinned)
        {
            // What was left of its speed is none: it does not creep.
            ref readonly SetContact bearer = ref system.Contacts[system.Bearer];
            Vector3d material = _world.Colliders[bearer.Collider].MaterialVelocity(s.Position, s.Time);
            double about = Vector3d.Dot(s.SpinAxis, bearer.Normal);
            s.Velocity = material;
            s.SpinAxis = Slip.RollingSpin(material - bearer.Surface, about, bearer.Normal, r);
        }
    }

    private void TakePiece(ref BallState s, ref StepRun run, ref ContactSystem system, Span<Contact> set, in Motion from)
    {
        double h = LongestPiece(in s, in from, in system, ref run);
        if (s.Nets != 0)
        {
            TakePiece<Substeps>(ref s, ref run, ref system, set, in from, h);
        }
        else if (run.Spirals)
        {
            TakePiece<ClassicalRungeKutta>(ref s, ref run, ref system, set, in from, h);
        }
        else
        {
            TakePiece<TIntegrator>(ref s, ref run, ref system, set, in from, h);
        }
    }

    /// <summary>Takes a piece, ends it at the first thing that happens in it, and moves the ball.</summary>
    [SkipLocalsInit]
    private void TakePiece<TMethod>(ref BallState s, ref StepRun run, ref ContactSystem system, Span<Contact> set, in Motion from, double h)
        where TMethod : struct, IIntegrator
    {
        int order = default(TMethod).Order;
        double* starts = stackalloc double[SetMargin<TMethod>.Most];
        var start = new MotionRates(in system.Acceleration, in system.SpinAcceleration, system.AirSpeed);
        var sweep = new MotionSweep<ContactSystem, TMethod>(in system, s.Time, in from, in start, _around.Wind, _around.Radius);
        SetMargin<TMethod>.Start(ref sweep, in s, in from, starts);
        sweep.Step(h);
        double whole = sweep.Length;

        // What may end it: an edge under the ball, the drag law's jump, loads, cones, slips and rest, a border, a net's kink, what is met.
        for (int i = 0; i < system.Count; i++)
        {
            Collider collider = _world.Colliders[system.Contacts[i].Collider];
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
        bool changes = SetMargin<TMethod>.EndPiece(ref sweep, in s, starts);
        SurfaceBorder.EndBeyond(ref sweep, in s, _world.CarrierOf(in s));
        _nets.EndWhereSlack(ref sweep, in s);
        bool meets = _guard.EndAtFirst(ref sweep, in s, order, set, out Separation met);
        s.Branch = sweep.Length < crossing ? system.Branch : s.Branch;
        run.Log.Evaluations += sweep.Evaluations;
        run.SetPieces++;
        run.SetChanges += (changes || meets) && sweep.Length < whole ? 1 : 0;

        // Move, and put the ball back onto what bears it: curved surfaces drift.
        BallState before = s;
        before.Branch = system.Branch;
        sweep.MoveTo(ref s);
        run.Advance(ref s, sweep.Length);
        for (int i = 0; i < set.Length; i++)
        {
            set[i].Load = system.Contacts[i].Load;
        }

        s.ClearIn = BallState.TouchesSeveral;
        _parts.Hold(ref s, set);
        run.Show(in before, in s, ref sweep, order);
        Name(ref s, set, in system, ref run);
        if (meets && !run.Log.Halted)
        {
            _guard.Meet(ref s, in met, ref run);
        }
    }

    /// <summary>The longest piece that stability, nets, slips that turn and normals that turn allow, s.</summary>
    private double LongestPiece(in BallState s, in Motion from, in ContactSystem system, ref StepRun run)
    {
        double asked = run.Next;
        double damping = 0;
        double gain = 0;
        double turning = 0;
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            damping = Math.Max(damping, contact.Damping);
            gain += contact.Bears && !contact.Sticks ? asked * contact.Sliding * contact.Load : 0;
            turning = Math.Max(turning, contact.Turning.Length);
        }

        double h = _limit.PartOf(
            ref _around.Air, asked, (from.Velocity - _around.Wind).Length, from.Spin.Length, s.Branch, ref run.Spirals, damping, gain);
        h = turning * h > LargestTurn ? LargestTurn / turning : h;
        h = Math.Min(h, _nets.LongestPiece(in s, h));
        run.Keep(h, asked);
        return ShortenForSlips(in system, in from, h, run.Length);
    }

    /// <summary>A piece takes no more of a slip that turns than the method can follow.</summary>
    private double ShortenForSlips(in ContactSystem system, in Motion from, double h, double step)
    {
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            double size = contact.Slip.Length;
            if (contact.Bears && !contact.Sticks && contact.Sliding > 0 && size > 0)
            {
                Vector3d rate = contact.SlipRate(in system.Acceleration, in system.SpinAcceleration, from.Spin, _around.Radius);
                h = TurnLimit.Shorten(h, step, contact.Direction, size, in rate, contact.IsFixed);
            }
        }

        return h;
    }

    /// <summary>The contact that bears most names the carrier; the one before does as long as it bears about as much. Whether that slips says whether the ball slides or rolls.</summary>
    private void Name(ref BallState s, Span<Contact> set, in ContactSystem system, ref StepRun run)
    {
        int named = ContactSet.Named(set, (int)s.Carrier - _world.FirstCollider);
        if (named < 0)
        {
            return;
        }

        ref readonly SetContact contact = ref system.Contacts[named];
        s.Carrier = contact.Collider + _world.FirstCollider;
        bool rolls = contact.Sticks;
        if (rolls == (s.Motion == MotionState.Rolling) || run.Named >= MostNames)
        {
            return;
        }

        run.Named++;
        if (rolls)
        {
            _contact.StartRolling(ref s, ref run);
        }
        else
        {
            _contact.StartSliding(ref s, ref run);
        }
    }
}
