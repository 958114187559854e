using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>Effect of touching a thing of the world: an impact, and whether it then flies, is guided, or is carried, sliding or rolling.</summary>
internal sealed class WorldContact
{
    /// <summary>More impacts than this at one instant, and the rest of it is without restitution, at all contacts together: two contacts, and eight.</summary>
    private const int MostAtOnce = 10;

    /// <summary>More than this in a step that were taken together, and the ball has no room.</summary>
    private const int MostUntold = 3;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly ContactLoad _load;
    private readonly bool _gainsByHops;

    /// <param name="around">What acts on the ball.</param>
    /// <param name="gainsByHops">Whether the method comes down from a hop faster than it went up.</param>
    public WorldContact(Surroundings around, bool gainsByHops)
    {
        _around = around;
        _world = around.World;
        _load = new ContactLoad(around);
        _gainsByHops = gainsByHops;
    }

    /// <summary>What presses the ball on what it touches.</summary>
    public ContactLoad Load => _load;

    /// <summary>An impact with a collider that the ball touches, and what becomes of the ball.</summary>
    public void Impact(ref BallState s, int collider, ref StepRun run)
    {
        // Neither at one instant, nor in a crowd where something that moves has touched the ball lately.
        if (run.Impacts++ >= MostAtOnce || (run.IsCrowded && s.Time < s.SqueezeUntil))
        {
            ImpactAtOnce(ref s, collider, ref run);
            return;
        }

        Collider hit = _world.Colliders[collider];
        bool carried = s.Motion != MotionState.Airborne && !_world.HangsInNet(in s);
        if (!carried && _world.IsLevel && hit == _world.Ground)
        {
            // Height and climb are known here: what was left of them is rounding, what counts as touching, or the tolerance of a bisection.
            s.Position = new Vector3d(s.Position.X, _world.LevelContact, s.Position.Z);
            s.Velocity = new Vector3d(s.Velocity.X, Math.Min(s.Velocity.Y, 0), s.Velocity.Z);
        }

        // The impulse by Coulomb's law in the frame of the contact, relative to the surface's velocity there.
        ShapePoint at = hit.At(s.Position, s.Time);
        Vector3d n = at.Normal;
        Vector3d v = s.Velocity;
        Vector3d w = s.Spin;
        int thing = collider + _world.FirstCollider;
        Vector3d contact = s.Position - (_world.Ball.Radius * n);
        Vector3d surface = hit.SurfaceVelocity(in contact, s.Time);
        Vector3d shape = hit.ShapeVelocity(in contact, s.Time);
        GivingWay way = hit.GivesWay ? GivingWay.Of(_world.Ball, hit.Mass) : default;
        ref readonly ContactMaterial material = ref hit.MaterialAt(s.Position);
        CoulombImpact.Apply(_world.Ball, in material, in way, in n, in surface, in v, in w, out Vector3d velocity, out Vector3d spin);

        // Hit by movers in quick succession it is no faster than the fastest of them makes it: being batted to and fro gives no energy.
        if (hit.Moves)
        {
            double restitution = hit.MaterialAt(s.Position).LargestRestitutionAt(Vector3d.Dot(surface - v, in n));
            bool again = Touches(ref s, ((1.0 + restitution) * surface.Length) + material.MinimumExitSpeed);
            double fastest = Math.Max(s.SqueezeSpeed, v.Length);
            if (again && velocity.Length > fastest)
            {
                CoulombImpact.ApplySoftened(_world.Ball, in hit.MaterialAt(s.Position), in way, in n, in surface, in v, in w, fastest, out velocity, out spin);
            }
        }

        // w = (v' − V')·n, the speed off the surface, decides what becomes of the ball. What gives way goes on with V' = V − (m/M)(v' − v).
        bool may = run.Hit();
        double off = Vector3d.Dot(velocity - shape + (way.Ratio * (velocity - v)), in n);
        if (_gainsByHops && off > 0 && !(_world.IsLevel && hit == _world.Ground))
        {
            // What the method would add in the hop is taken away first. On level ground the pieces of a hop are short enough.
            double gain = Math.Min(off, _load.GainOfHop(in s, off, velocity - (off * n), in spin, hit, in at, run.Length));
            off -= gain;
            velocity -= gain / (1.0 + way.Ratio) * n;
        }

        bool bounces = may && !_load.StaysAfter(in s, off, velocity - (off * n), in spin, hit, in at);
        if (!bounces && hit.GivesWay)
        {
            // A ball that stays on what gives way has had an impact without restitution: momentum is conserved.
            ContactMaterial dead = material.WithoutRestitution();
            CoulombImpact.Apply(_world.Ball, in dead, in way, in n, in surface, in v, in w, out velocity, out spin);
            off = 0;
        }

        double added = bounces ? CoulombImpact.Added(_world.Ball, in material, in way, Vector3d.Dot(v - surface, in n), Vector3d.Dot(velocity - surface + (way.Ratio * (velocity - v)), in n)) : 0;

        // The event reports the velocity by the impulse; a ball that stays loses what is left of it off the surface.
        Vector3d reported = velocity;
        velocity = bounces && off > 0 ? velocity : velocity - (off * n);

        // What has a mass gets the opposite impulse, m (v − v').
        if (hit.GivesWay && run.Log.Pushes)
        {
            run.Log.Motions?.Read();
            hit.Push(_world.Ball.Mass * (v - velocity), s.Time);
            run.Log.Pushed = true;
            run.Log.Halted |= run.Log.HaltsAtPush;
        }

        // A ball that trembles in a corner would tell of each time that it comes back.
        if (run.IsCrowded && Vector3d.Dot(surface - v, in n) < _world.MinimumBounceSpeed)
        {
            run.Log.UnreportedImpacts++;
        }
        else
        {
            run.Report(new BallEvent(BallEventKind.Impact, thing, in n, s.Time, s.Position, in v, in w, in reported, in spin) { AddedEnergy = added });
        }

        run.Log.Halted |= run.Log.StopAt == StopAt.Impact;

        // The velocity has jumped: the branch of the drag law is read from the flow again.
        s.Branch = DragBranch.Unknown;

        // So many hits by movers in so short a time: there is no room.
        if (hit.Moves && run.IsCrowdedAt(s.Time))
        {
            s.Velocity = velocity;
            s.SetGroundSpin(in spin);
            BeginSqueeze(ref s, collider, ref run);
            return;
        }

        // Carried by something else it keeps that, unless the impulse lifts it.
        if (carried && s.Carrier != thing)
        {
            KeepCarrier(ref s, in velocity, in spin, hit.ShapeVelocity(in contact, s.Time), in n, bounces ? -1 : collider, ref run);
            return;
        }

        if (bounces)
        {
            Fly(ref s, in velocity, in spin);
        }
        else
        {
            Stay(ref s, thing, in velocity, in spin, ref run);
        }
    }

    /// <summary>All that the ball touches at once, without restitution: what stands still is then not come closer to; what moves may squeeze it.</summary>
    [SkipLocalsInit]
    private void ImpactAtOnce(ref BallState s, int collider, ref StepRun run)
    {
        run.Log.UnreportedImpacts++;

        // All contacts as one set, over no time and without restitution.
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        Span<Contact> set = ContactSet.Near(_world, in s, ContactSearch.Touching, room, _world.Room);
        Vector3d v = s.Velocity;
        Vector3d w = s.Spin;
        double most = v.Length;
        bool solved = ContactSolver.Solve(set, _world.Ball, 0, ref v, ref w, closing: ContactSearch.Approaching) && run.Untold++ < MostUntold;

        // No impulses keep all of them from closing, or it takes them again and again: squeezed. Only moving objects squeeze.
        if (ContactSet.HasMover(set) && (!solved || IsTooFast(ref s, set, in v)))
        {
            BeginSqueeze(ref s, collider, ref run);
            return;
        }

        if (!solved)
        {
            ContactSetParts.Settle(set, 0, most, ref v);
        }

        s.Velocity = v;
        s.SetGroundSpin(in w);

        // What bears it most carries it, if the forces press it there; else it flies.
        int bearer = ContactSet.Heaviest(set);
        if (bearer >= 0 && _load.IsPressed(in s, set[bearer].Collider))
        {
            Stay(ref s, set[bearer].Collider + _world.FirstCollider, in v, in w, ref run);
        }
        else
        {
            Fly(ref s, in v, in w);
        }
    }

    /// <summary>Begins a squeeze: moving things leave the ball no room.</summary>
    public void BeginSqueeze(ref BallState s, int collider, ref StepRun run)
    {
        run.Squeezes++;
        Vector3d spin = s.Spin;
        Vector3d normal = _world.Colliders[collider].At(s.Position, s.Time).Normal;
        s.Carrier = collider + _world.FirstCollider;
        s.SetGroundSpin(in spin);
        s.Motion = MotionState.Pinned;
        s.Branch = DragBranch.Unknown;
        run.Report(new BallEvent(BallEventKind.Pinned, (int)s.Carrier, in normal, s.Time, s.Position, s.Velocity, in spin, s.Velocity, in spin));
    }

    /// <summary>The ball has room again.</summary>
    public void EndSqueeze(ref BallState s, ref StepRun run)
    {
        run.Report(new BallEvent(BallEventKind.Pinned, -1, Vector3d.Zero, s.Time, s.Position, s.Velocity, s.Spin, s.Velocity, s.Spin));
        Fly(ref s, s.Velocity, s.Spin);
    }

    /// <summary>True when things that move would make the ball faster by their contacts than the fastest of them, times 1 + e, or than it came.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="set">The contacts, with what they gave.</param>
    /// <param name="velocity">What became of its velocity, m/s.</param>
    public bool IsTooFast(ref BallState s, Span<Contact> set, in Vector3d velocity)
    {
        // (1 + e) |V| of the fastest mover that pushes; −1 where none does.
        double fastest = -1.0;
        foreach (ref readonly Contact contact in set)
        {
            double speed = contact.Velocity.Length;
            fastest = contact.Moves && contact.Load > 0 ? Math.Max(fastest, ((1.0 + contact.Material.LargestRestitutionAt(speed)) * speed) + contact.Material.MinimumExitSpeed) : fastest;
        }

        if (fastest < 0)
        {
            return false;
        }

        Touches(ref s, fastest);
        return velocity.Length > s.SqueezeSpeed;
    }

    /// <summary>Something that moves touches the ball, and may make it so fast, m/s.</summary>
    /// <returns>Whether something did so lately.</returns>
    private static bool Touches(ref BallState s, double fastest)
    {
        bool again = s.Time < s.SqueezeUntil;
        s.SqueezeSpeed = Math.Max(again ? s.SqueezeSpeed : s.Velocity.Length, fastest);
        s.SqueezeUntil = StateCheck.SqueezedUntil(s.Time);
        return again;
    }

    /// <summary>A thing takes a ball that touches it, does not come closer and is pressed on it: no impact.</summary>
    public void TakeUp(ref BallState s, int collider, ref StepRun run) => Stay(ref s, collider + _world.FirstCollider, s.Velocity, s.Spin, ref run);

    /// <summary>The slip is over: the ball rolls, where friction can hold it.</summary>
    public void EndSlip(ref BallState s, ref StepRun run)
    {
        if (_load.Grips(in s, _world.CarrierOf(in s), ref run))
        {
            StartRolling(ref s, ref run);
        }
    }

    /// <summary>The slip is over, or was never there: the spin becomes that of pure rolling.</summary>
    public void StartRolling(ref BallState s, ref StepRun run)
    {
        Collider carrier = _world.CarrierOf(in s);
        Vector3d n = carrier.At(s.Position, s.Time).Normal;
        Vector3d before = s.Spin;
        Vector3d surface = _world.SurfaceVelocity(carrier, s.Position, in n, s.Time);
        Vector3d spin = Slip.RollingSpin(s.Velocity - surface, Vector3d.Dot(in before, in n), in n, _world.Ball.Radius);
        s.SetGroundSpin(in spin);
        s.Motion = MotionState.Rolling;
        if (run.Jumped)
        {
            run.Jumped = false;
            return;
        }

        run.Report(new BallEvent(BallEventKind.Roll, (int)s.Carrier, in n, s.Time, s.Position, s.Velocity, in before, s.Velocity, in spin));
    }

    /// <summary>The velocity of the carrier may have jumped since the last step: the ball keeps its own, and slips (world.md, On a carrier).</summary>
    public void TakeJump(ref BallState s, ref StepRun run)
    {
        if (s.Motion != MotionState.Rolling || !_world.CarrierOf(in s).Moves)
        {
            return;
        }

        Collider carrier = _world.CarrierOf(in s);
        Vector3d n = carrier.At(s.Position, s.Time).Normal;
        Vector3d slip = Slip.Of(s.Velocity - _world.SurfaceVelocity(carrier, s.Position, in n, s.Time), s.Spin, in n, _world.Ball.Radius);
        if (slip.Length >= Slip.Rolling)
        {
            s.Motion = MotionState.Sliding;
            run.Jumped = true;
            run.CarrierGain = -run.PerStep * slip;
        }
    }

    /// <summary>A flush surface takes over the ball. One that moves otherwise than the last makes a rolling ball slip: v and ω stay (world.md, Flush).</summary>
    public void HandOver(ref BallState s, int collider, ref StepRun run)
    {
        if (collider == s.Carrier - _world.FirstCollider)
        {
            return;
        }

        Collider before = _world.CarrierOf(in s);
        Collider next = _world.Colliders[collider];
        s.Carrier = collider + _world.FirstCollider;
        if (s.Motion == MotionState.Rolling)
        {
            Vector3d n = next.At(s.Position, s.Time).Normal;
            Vector3d change = _world.SurfaceVelocity(next, s.Position, in n, s.Time) - _world.SurfaceVelocity(before, s.Position, in n, s.Time);
            if (change.Length >= Slip.Rolling)
            {
                StartSliding(ref s, ref run);
            }
        }
    }

    /// <summary>A rolling ball begins to slip.</summary>
    public void StartSliding(ref BallState s, ref StepRun run)
    {
        Vector3d n = _world.CarrierOf(in s).At(s.Position, s.Time).Normal;
        s.Motion = MotionState.Sliding;
        run.Report(new BallEvent(BallEventKind.Slide, (int)s.Carrier, in n, s.Time, s.Position, s.Velocity, s.Spin, s.Velocity, s.Spin));
    }

    /// <summary>The ball leaves what carries it: the step is divided anew.</summary>
    public void Leave(ref BallState s, in Vector3d velocity, in Vector3d spin, ref StepRun run)
    {
        run.Report(new BallEvent(BallEventKind.ContactEnd, -1, Vector3d.Zero, s.Time, s.Position, s.Velocity, s.Spin, in velocity, in spin));
        run.Part = 0;
        Fly(ref s, in velocity, in spin);
    }

    /// <summary>The ball comes to rest on what carries it, and moves along with that.</summary>
    public void Rest(ref BallState s, ref StepRun run)
    {
        Collider carrier = _world.CarrierOf(in s);
        Rest(ref s, carrier.MaterialVelocity(s.Position, s.Time), carrier.Spin, ref run);
    }

    /// <summary>The ball comes to rest in a net.</summary>
    public void RestInNet(ref BallState s, int net, ref StepRun run)
    {
        s.Carrier = _world.ThingOfNet(net);
        s.Branch = DragBranch.Unknown;
        Rest(ref s, Vector3d.Zero, Vector3d.Zero, ref run);
    }

    private static void Rest(ref BallState s, in Vector3d velocity, in Vector3d spin, ref StepRun run)
    {
        run.Report(new BallEvent(BallEventKind.Rest, -1, Vector3d.Zero, s.Time, s.Position, s.Velocity, s.Spin, s.Velocity, s.Spin));
        run.Log.Halted |= run.Log.StopAt == StopAt.Rest;
        s.Velocity = velocity;
        s.SetGroundSpin(in spin);
        s.ClearIn = s.ClearIn == BallState.TouchesSeveral ? 0 : s.ClearIn;
        s.Motion = MotionState.Rest;
    }

    /// <summary>Raises a ball whose state says that it is in the ground, straight up.</summary>
    public void Raise(ref BallState s) => s.Position = GroundPlace.Raised(_world, s.Position);

    /// <summary>A ball that is placed: carried, where it touches something slowly enough and is pressed on it; else in the air.</summary>
    public void Settle(ref BallState s)
    {
        // Of several things that would take it the first of the scene does.
        int first = int.MaxValue;
        var near = NearThings.At(_world, s.Position, s.Time);
        while (near.NextCollider(out int i))
        {
            first = i < first && TakesUp(in s, i, out _) ? i : first;
        }

        if (first < int.MaxValue)
        {
            TakesUp(in s, first, out Vector3d velocity);
            Collider collider = _world.Colliders[first];
            Vector3d spin = s.Spin;
            Vector3d placed = s.Position;
            Vector3d n = _world.Hold(ref s, collider);
            if (collider == _world.Ground)
            {
                // Where it was placed, to the last bit of x and z.
                s.Position = GroundPlace.Onto(_world, in placed);
            }

            s.Velocity = velocity;
            s.Carrier = first + _world.FirstCollider;
            bool rolls = Slip.Of(velocity - _world.SurfaceVelocity(collider, s.Position, in n, s.Time), in spin, in n, _world.Ball.Radius).Length < Slip.Rolling;
            s.SetGroundSpin(in spin);
            s.Motion = rolls ? MotionState.Rolling : MotionState.Sliding;
        }
    }

    /// <summary>True when a collider carries a ball that is placed.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="index">The collider.</param>
    /// <param name="velocity">The ball's velocity along the surface, m/s.</param>
    private bool TakesUp(in BallState s, int index, out Vector3d velocity)
    {
        Collider collider = _world.Colliders[index];
        ShapePoint at = collider.At(s.Position, s.Time);
        double off = Vector3d.Dot(s.Velocity - collider.ShapeVelocity(s.Position, s.Time), at.Normal);
        velocity = s.Velocity - (off * at.Normal);

        // On a level pitch that is so up to the speed of the slowest bounce; on anything else what comes closer hits.
        double slowest = _world.IsLevel && collider == _world.Ground ? -_world.MinimumBounceSpeed : -double.Epsilon;
        return at.Distance - _world.Ball.Radius <= ContactSearch.Touching && off < _world.MinimumBounceSpeed && off > slowest
            && _load.Load(in s, in velocity, s.Spin, collider, in at) > SurfaceForces.Least;
    }

    /// <summary>A carried ball was hit by something else: it keeps its carrier unless the impulse lifts it.</summary>
    /// <param name="s">The ball before.</param>
    /// <param name="velocity">Its velocity after, m/s.</param>
    /// <param name="spin">Its spin after, rad/s.</param>
    /// <param name="hitVelocity">Velocity of what hit it, m/s.</param>
    /// <param name="hitNormal">Normal there.</param>
    /// <param name="pressing">The collider that it hit and stays on; −1 where it bounces off that, or another ball hit it.</param>
    /// <param name="run">The step.</param>
    private void KeepCarrier(
        ref BallState s, in Vector3d velocity, in Vector3d spin, in Vector3d hitVelocity, in Vector3d hitNormal, int pressing, ref StepRun run)
    {
        Collider carrier = _world.CarrierOf(in s);
        Vector3d n = carrier.At(s.Position, s.Time).Normal;
        double off = Vector3d.Dot(velocity - carrier.ShapeVelocity(s.Position, s.Time), in n);

        // w_s < 0, its speed into the carrier: an impact there at the same instant.
        if (off < -ContactSearch.Approaching)
        {
            s.Velocity = velocity;
            s.SetGroundSpin(in spin);
            s.Motion = MotionState.Sliding;
            Impact(ref s, (int)s.Carrier - _world.FirstCollider, ref run);
            return;
        }

        // Lifted off the carrier and pressed on what it hit, with no speed off that: it climbs that, as a kerb.
        if (off > ContactSearch.Approaching && pressing >= 0)
        {
            Stay(ref s, pressing + _world.FirstCollider, in velocity, in spin, ref run);
            return;
        }

        if (off >= _world.MinimumBounceSpeed)
        {
            Leave(ref s, in velocity, in spin, ref run);
            return;
        }

        Vector3d kept = velocity - (off * n);
        Vector3d along = hitNormal - (Vector3d.Dot(in hitNormal, in n) * n);
        double share = along.LengthSquared;
        if (pressing >= 0 && share > 1e-12)
        {
            // Neither off the carrier nor into what it hit.
            kept -= Vector3d.Dot(kept - hitVelocity, in hitNormal) / share * along;
        }

        Stay(ref s, (int)s.Carrier, in kept, in spin, ref run);
    }

    /// <summary>Another ball has hit this one: it keeps its carrier unless the impulse lifts it. One that is squeezed goes on as it went, but for its speed.</summary>
    public void Struck(ref BallState s, in Vector3d velocity, in Vector3d spin, in Vector3d n, ref StepRun run)
    {
        // What was free ahead, and the branch of the drag law, belong to the old velocity.
        s.ClearUntil = 0;
        s.Branch = DragBranch.Unknown;
        s.SqueezeSpeed = Math.Max(s.SqueezeSpeed, velocity.Length);

        // Thrown back by another ball it hits the next thing anew, and that is not the second of two movers that bat it to and fro.
        s.SqueezeUntil = s.Motion == MotionState.Pinned ? s.SqueezeUntil : Math.Min(s.SqueezeUntil, s.Time);
        if (s.Motion == MotionState.Airborne || _world.HangsInNet(in s))
        {
            Fly(ref s, in velocity, in spin);
            return;
        }

        if (s.Motion != MotionState.Pinned)
        {
            KeepCarrier(ref s, in velocity, in spin, Vector3d.Zero, in n, -1, ref run);
            return;
        }

        // The rest of the step moves the ball out of the mover at its allowed speed. If it were put onto the mover at once, it could end inside a stationary object.
        s.Velocity = velocity;
        Collider carrier = _world.CarrierOf(in s);
        if (!carrier.Moves)
        {
            _world.Hold(ref s, carrier);
        }
    }

    /// <summary>The ball stays on a thing, and is put onto it: it slides, or rolls.</summary>
    private void Stay(ref BallState s, int thing, in Vector3d velocity, in Vector3d spin, ref StepRun run)
    {
        // What slid there at this instant already, before it was hit again, slides on; in a crowd what slid there at all.
        bool slidOn = (run.Impacts > 1 || run.IsCrowded) && s.Motion == MotionState.Sliding && s.Carrier == thing;
        s.Velocity = velocity;
        s.SetGroundSpin(in spin);
        s.Carrier = thing;
        s.Motion = MotionState.Sliding;
        Collider carrier = _world.CarrierOf(in s);
        Vector3d n = _world.Hold(ref s, carrier);
        if (carrier.Moves)
        {
            // A body that overlaps the ball would put it into a stationary object.
            KeepOut(ref s);
        }

        Vector3d surface = _world.SurfaceVelocity(carrier, s.Position, in n, s.Time);
        if (Slip.Of(s.Velocity - surface, in spin, in n, _world.Ball.Radius).Length < Slip.Rolling && _load.Grips(in s, carrier, ref run))
        {
            StartRolling(ref s, ref run);
        }
        else if (!slidOn)
        {
            StartSliding(ref s, ref run);
        }
    }

    /// <summary>Moves the ball out of stationary objects that it overlaps.</summary>
    [SkipLocalsInit]
    public void KeepOut(ref BallState s)
    {
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        ContactSet.KeepOut(_world, ref s, ContactSet.Near(_world, in s, 0, room, _world.Room));
    }

    /// <summary>The ball flies on.</summary>
    public static void Fly(ref BallState s, in Vector3d velocity, in Vector3d spin)
    {
        s.Velocity = velocity;
        s.SetFlightSpin(in spin);
        s.Motion = MotionState.Airborne;
        s.Carrier = 0;
        s.Branch = DragBranch.Unknown;
    }
}
