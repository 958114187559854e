using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>Resolves contacts with the world: an impact, and the motion state of the ball after it.</summary>
internal sealed class WorldContact
{
    /// <summary>Maximum number of impacts at one instant: two contacts plus eight. After that, all contacts are resolved together without
    /// restitution.</summary>
    private const int MostAtOnce = 10;

    /// <summary>If a step resolves all contacts together more often than this, the ball has no room.</summary>
    private const int MostUntold = 3;

    private readonly Surroundings _around;
    private readonly World _world;
    private readonly ContactLoad _load;
    private readonly bool _gainsByHops;

    /// <param name="around">The forces on the ball.</param>
    /// <param name="gainsByHops">Whether the integrator returns from a hop faster than it left.</param>
    public WorldContact(Surroundings around, bool gainsByHops)
    {
        _around = around;
        _world = around.World;
        _load = new ContactLoad(around);
        _gainsByHops = gainsByHops;
    }

    /// <summary>Computes the load of the ball on a surface that it touches.</summary>
    public ContactLoad Load => _load;

    /// <summary>Resolves an impact with a collider that the ball touches, and sets the new motion state.</summary>
    public void Impact(ref BallState s, int collider, ref StepRun run)
    {
        // After too many impacts at one instant, or in a crowded step shortly after contact with a mover, resolve all contacts together.
        if (run.Impacts++ >= MostAtOnce || (run.IsCrowded && s.Time < s.SqueezeUntil))
        {
            ImpactAtOnce(ref s, collider, ref run);
            return;
        }

        Collider hit = _world.Colliders[collider];
        bool carried = s.Motion != MotionState.Airborne && !_world.HangsInNet(in s);
        if (!carried && hit.IsLevelGround)
        {
            // Height and vertical velocity are known exactly here. The difference is due to rounding, or to the tolerance of a contact or a
            // bisection.
            s.Position = hit.Snap(s.Position);
            s.Velocity = new Vector3d(s.Velocity.X, Math.Min(s.Velocity.Y, 0), s.Velocity.Z);
        }

        // Apply the impulse by Coulomb's law, relative to the surface velocity at the contact point.
        ShapePoint at = hit.At(s.Position, s.Time);
        Vector3d n = at.Normal;
        Vector3d v = s.Velocity;
        Vector3d w = s.Spin;
        int thing = collider + _world.FirstCollider;
        Vector3d contact = s.Position - (_world.Ball.Radius * n);
        Vector3d surface = hit.SpinVelocity(in contact, s.Time);
        Vector3d shape = hit.ShapeVelocity(in contact, s.Time);
        GivingWay way = hit.GivesWay ? GivingWay.Of(_world.Ball, hit.Mass) : default;
        ref readonly ContactMaterial material = ref hit.MaterialAt(s.Position);
        CoulombImpact.Apply(_world.Ball, in material, in way, in n, in surface, in v, in w, out Vector3d velocity, out Vector3d spin);

        // After quick successive hits by movers, limit the speed to the fastest mover's speed: rapid hits must not add energy.
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

        // The separation speed w = (v' − V')·n determines the motion state. An object with a mass recoils to V' = V − (m/M)(v' − v).
        bool may = run.Hit();
        double off = Vector3d.Dot(velocity - shape + (way.Ratio * (velocity - v)), in n);
        if (_gainsByHops && off > 0 && !hit.IsLevelGround)
        {
            // Subtract the speed that the integrator will add in the hop. On level ground, the pieces of a hop are short enough to prevent this gain.
            double gain = Math.Min(off, _load.GainOfHop(in s, off, velocity - (off * n), in spin, hit, in at, run.Length));
            off -= gain;
            velocity -= gain / (1.0 + way.Ratio) * n;
        }

        bool bounces = may && !_load.StaysAfter(in s, off, velocity - (off * n), in spin, hit, in at);
        if (!bounces && hit.GivesWay)
        {
            // A ball that stays on an object with a mass has an impact with e = 0, which conserves momentum.
            ContactMaterial dead = material.WithoutRestitution();
            CoulombImpact.Apply(_world.Ball, in dead, in way, in n, in surface, in v, in w, out velocity, out spin);
            off = 0;
        }

        double added = bounces ? CoulombImpact.Added(_world.Ball, in material, in way, Vector3d.Dot(v - surface, in n), Vector3d.Dot(velocity - surface + (way.Ratio * (velocity - v)), in n)) : 0;

        // The event reports the velocity due to the impulse. A ball that stays then loses its remaining separation speed.
        Vector3d reported = velocity;
        velocity = bounces && off > 0 ? velocity : velocity - (off * n);

        // Apply the opposite impulse, m (v − v'), to an object with a mass.
        if (hit.GivesWay && run.Log.Pushes)
        {
            run.Log.Motions?.Read();
            hit.Push(_world.Ball.Mass * (v - velocity), s.Time);
            run.Log.Pushed = true;
            run.Log.Halted |= run.Log.HaltsAtPush;
        }

        // In a crowded step, count slow impacts without reporting them: a ball that trembles in a corner would raise many events.
        if (run.IsCrowded && Vector3d.Dot(surface - v, in n) < _world.MinimumBounceSpeed)
        {
            run.Log.UnreportedImpacts++;
        }
        else
        {
            run.Report(new BallEvent(BallEventKind.Impact, thing, in n, s.Time, s.Position, in v, in w, in reported, in spin) { AddedEnergy = added });
        }

        run.Log.Halted |= run.Log.StopAt == StopAt.Impact;

        // The velocity has jumped, so choose the branch of the drag law again.
        s.Branch = DragBranch.Unknown;

        // Movers hit the ball too often in a short time, so it has no room.
        if (hit.Moves && run.IsCrowdedAt(s.Time))
        {
            s.Velocity = velocity;
            s.SetGroundSpin(in spin);
            BeginSqueeze(ref s, collider, ref run);
            return;
        }

        // A ball supported by another surface keeps its carrier unless the impulse lifts it.
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

    /// <summary>Resolves all contacts at once without restitution.</summary>
    /// <remarks>The ball then closes on no stationary object. Moving objects may squeeze it.</remarks>
    [SkipLocalsInit]
    private void ImpactAtOnce(ref BallState s, int collider, ref StepRun run)
    {
        run.Log.UnreportedImpacts++;

        // Solve all contacts as one set, over zero time and without restitution.
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        Span<Contact> set = ContactSet.Near(_world, in s, ContactTolerances.Touching, room, _world.Room);
        Vector3d v = s.Velocity;
        Vector3d w = s.Spin;
        double most = v.Length;
        bool solved = ContactSolver.Solve(set, _world.Ball, 0, ref v, ref w, closing: ContactTolerances.Approaching) && run.Untold++ < MostUntold;

        // If no impulses stop all contacts from closing, or if this happens repeatedly, the ball is squeezed. Only moving objects can squeeze it.
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

        // The contact with the greatest load becomes the carrier if the forces press the ball onto it. Otherwise, the ball flies.
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

    /// <summary>Starts a squeeze: moving objects leave the ball no room.</summary>
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

    /// <summary>Ends a squeeze: the ball has room again.</summary>
    public void EndSqueeze(ref BallState s, ref StepRun run)
    {
        run.Report(new BallEvent(BallEventKind.Pinned, -1, Vector3d.Zero, s.Time, s.Position, s.Velocity, s.Spin, s.Velocity, s.Spin));
        Fly(ref s, s.Velocity, s.Spin);
    }

    /// <summary>True if moving objects would make the ball too fast.</summary>
    /// <remarks>The limit is the greater of its speed on arrival and 1 + e times the speed of the fastest mover that pushes it.</remarks>
    /// <param name="s">The ball.</param>
    /// <param name="set">The contacts and their impulses.</param>
    /// <param name="velocity">The resulting velocity, m/s.</param>
    public bool IsTooFast(ref BallState s, Span<Contact> set, in Vector3d velocity)
    {
        // (1 + e) |V| of the fastest mover that pushes the ball, or −1 if there is no such mover.
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

    /// <summary>Records a contact with a moving object that may accelerate the ball to a given speed, m/s.</summary>
    /// <returns>True if another contact with a mover was recorded recently.</returns>
    private static bool Touches(ref BallState s, double fastest)
    {
        bool again = s.Time < s.SqueezeUntil;
        s.SqueezeSpeed = Math.Max(again ? s.SqueezeSpeed : s.Velocity.Length, fastest);
        s.SqueezeUntil = StateCheck.SqueezedUntil(s.Time);
        return again;
    }

    /// <summary>Makes a surface the carrier without an impact: the ball touches it, presses on it, and does not close on it.</summary>
    public void TakeUp(ref BallState s, int collider, ref StepRun run) => Stay(ref s, collider + _world.FirstCollider, s.Velocity, s.Spin, ref run);

    /// <summary>Ends a slip: the ball rolls if friction can hold it.</summary>
    public void EndSlip(ref BallState s, ref StepRun run)
    {
        if (_load.Grips(in s, _world.CarrierOf(in s), ref run))
        {
            StartRolling(ref s, ref run);
        }
    }

    /// <summary>Starts rolling: sets the spin of pure rolling.</summary>
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

    /// <summary>Handles a velocity jump of the carrier since the last step: the ball keeps its velocity, and slips (world.md, On a
    /// carrier).</summary>
    public void TakeJump(ref BallState s, ref StepRun run)
    {
        if (s.Motion != MotionState.Rolling || !_world.CarrierOf(in s).Moves)
        {
            return;
        }

        Collider carrier = _world.CarrierOf(in s);
        Vector3d n = carrier.At(s.Position, s.Time).Normal;
        Vector3d slip = Slip.Of(s.Velocity - _world.SurfaceVelocity(carrier, s.Position, in n, s.Time), s.Spin, in n, _world.Ball.Radius);
        if (slip.Length >= ContactTolerances.Rolling)
        {
            s.Motion = MotionState.Sliding;
            run.Jumped = true;
            run.CarrierGain = -run.PerStep * slip;
        }
    }

    /// <summary>Hands the ball over to a flush surface.</summary>
    /// <remarks>If its velocity differs, a rolling ball slips: v and ω stay (world.md, Flush).</remarks>
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
            if (change.Length >= ContactTolerances.Rolling)
            {
                StartSliding(ref s, ref run);
            }
        }
    }

    /// <summary>Starts a slide of a rolling ball.</summary>
    public void StartSliding(ref BallState s, ref StepRun run)
    {
        Vector3d n = _world.CarrierOf(in s).At(s.Position, s.Time).Normal;
        s.Motion = MotionState.Sliding;
        run.Report(new BallEvent(BallEventKind.Slide, (int)s.Carrier, in n, s.Time, s.Position, s.Velocity, s.Spin, s.Velocity, s.Spin));
    }

    /// <summary>Releases the ball from its carrier, and divides the rest of the step from scratch.</summary>
    public void Leave(ref BallState s, in Vector3d velocity, in Vector3d spin, ref StepRun run)
    {
        run.Report(new BallEvent(BallEventKind.ContactEnd, -1, Vector3d.Zero, s.Time, s.Position, s.Velocity, s.Spin, in velocity, in spin));
        run.Part = 0;
        Fly(ref s, in velocity, in spin);
    }

    /// <summary>Brings the ball to rest on its carrier; it then moves along with the carrier.</summary>
    public void Rest(ref BallState s, ref StepRun run)
    {
        Collider carrier = _world.CarrierOf(in s);
        Rest(ref s, carrier.MaterialVelocity(s.Position, s.Time), carrier.Spin, ref run);
    }

    /// <summary>Brings the ball to rest in a net.</summary>
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

    /// <summary>Raises a ball that is below the surface of the ground vertically.</summary>
    public void Raise(ref BallState s) => s.Position = GroundPlace.Raised(_world, s.Position);

    /// <summary>Sets the state of a placed ball: supported if it touches a surface slowly enough and is pressed on it; otherwise in the
    /// air.</summary>
    public void Settle(ref BallState s)
    {
        // If several surfaces could support the ball, use the first one in scene order.
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
                // Keep x and z bit-identical to the input.
                s.Position = GroundPlace.Onto(_world, in placed);
            }

            s.Velocity = velocity;
            s.Carrier = first + _world.FirstCollider;
            bool rolls = Slip.Of(velocity - _world.SurfaceVelocity(collider, s.Position, in n, s.Time), in spin, in n, _world.Ball.Radius).Length < ContactTolerances.Rolling;
            s.SetGroundSpin(in spin);
            s.Motion = rolls ? MotionState.Rolling : MotionState.Sliding;
        }
    }

    /// <summary>True if a collider supports a placed ball.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="index">The collider.</param>
    /// <param name="velocity">The ball's velocity along the surface, m/s.</param>
    private bool TakesUp(in BallState s, int index, out Vector3d velocity)
    {
        Collider collider = _world.Colliders[index];
        ShapePoint at = collider.At(s.Position, s.Time);
        double off = Vector3d.Dot(s.Velocity - collider.ShapeVelocity(s.Position, s.Time), at.Normal);
        velocity = s.Velocity - (off * at.Normal);

        // A level pitch supports a ball that closes more slowly than the minimum bounce speed. On any other surface, a closing ball has an impact.
        double slowest = collider.IsLevelGround ? -_world.MinimumBounceSpeed : -double.Epsilon;
        return at.Distance - _world.Ball.Radius <= ContactTolerances.Touching && off < _world.MinimumBounceSpeed && off > slowest
            && _load.Load(in s, in velocity, s.Spin, collider, in at) > ContactTolerances.LeastLoad;
    }

    /// <summary>Sets the state of a supported ball after a hit by another object: it keeps its carrier unless the impulse lifts
    /// it.</summary>
    /// <param name="s">The ball before the hit.</param>
    /// <param name="velocity">Its velocity after the hit, m/s.</param>
    /// <param name="spin">Its spin after the hit, rad/s.</param>
    /// <param name="hitVelocity">Velocity of the other object, m/s.</param>
    /// <param name="hitNormal">Normal of that contact.</param>
    /// <param name="pressing">The other collider if the ball stays on it; −1 if it bounces off or the object is a ball.</param>
    /// <param name="run">The step.</param>
    private void KeepCarrier(
        ref BallState s, in Vector3d velocity, in Vector3d spin, in Vector3d hitVelocity, in Vector3d hitNormal, int pressing, ref StepRun run)
    {
        Collider carrier = _world.CarrierOf(in s);
        Vector3d n = carrier.At(s.Position, s.Time).Normal;
        double off = Vector3d.Dot(velocity - carrier.ShapeVelocity(s.Position, s.Time), in n);

        // w_s < 0: the ball moves into its carrier, so it also hits the carrier at the same instant.
        if (off < -ContactTolerances.Approaching)
        {
            s.Velocity = velocity;
            s.SetGroundSpin(in spin);
            s.Motion = MotionState.Sliding;
            Impact(ref s, (int)s.Carrier - _world.FirstCollider, ref run);
            return;
        }

        // The other surface lifts the ball off its carrier, and the ball stays on it: it climbs that surface, such as a kerb.
        if (off > ContactTolerances.Approaching && pressing >= 0)
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
        if (pressing >= 0 && share > ContactTolerances.AlongNormal)
        {
            // Remove the velocity component into the other object by changing only the tangential velocity on the carrier.
            kept -= Vector3d.Dot(kept - hitVelocity, in hitNormal) / share * along;
        }

        Stay(ref s, (int)s.Carrier, in kept, in spin, ref run);
    }

    /// <summary>Sets the state of a ball that another ball has hit: it keeps its carrier unless the impulse lifts it.</summary>
    /// <remarks>A squeezed ball stays squeezed and only changes its speed.</remarks>
    public void Struck(ref BallState s, in Vector3d velocity, in Vector3d spin, in Vector3d n, ref StepRun run)
    {
        // The clear time and the branch of the drag law belong to the old velocity.
        s.ClearUntil = 0;
        s.Branch = DragBranch.Unknown;
        s.SqueezeSpeed = Math.Max(s.SqueezeSpeed, velocity.Length);

        // An impact with another ball ends the series of hits by movers, so the next hit is not the second of two.
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

        // Let the rest of the step move the ball out of the mover at its maximum speed. An immediate move could end inside a stationary object.
        s.Velocity = velocity;
        Collider carrier = _world.CarrierOf(in s);
        if (!carrier.Moves)
        {
            _world.Hold(ref s, carrier);
        }
    }

    /// <summary>Puts the ball onto a surface on which it stays, sliding or rolling.</summary>
    private void Stay(ref BallState s, int thing, in Vector3d velocity, in Vector3d spin, ref StepRun run)
    {
        // Report no new slide if the ball already slid there at this instant, nor in a crowded step.
        bool slidOn = (run.Impacts > 1 || run.IsCrowded) && s.Motion == MotionState.Sliding && s.Carrier == thing;
        s.Velocity = velocity;
        s.SetGroundSpin(in spin);
        s.Carrier = thing;
        s.Motion = MotionState.Sliding;
        Collider carrier = _world.CarrierOf(in s);
        Vector3d n = _world.Hold(ref s, carrier);
        if (carrier.Moves)
        {
            // A body that overlaps the ball could push it into a stationary object.
            KeepOut(ref s);
        }

        Vector3d surface = _world.SurfaceVelocity(carrier, s.Position, in n, s.Time);
        if (Slip.Of(s.Velocity - surface, in spin, in n, _world.Ball.Radius).Length < ContactTolerances.Rolling && _load.Grips(in s, carrier, ref run))
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

    /// <summary>Sets the ball in flight.</summary>
    public static void Fly(ref BallState s, in Vector3d velocity, in Vector3d spin)
    {
        s.Velocity = velocity;
        s.SetFlightSpin(in spin);
        s.Motion = MotionState.Airborne;
        s.Carrier = 0;
        s.Branch = DragBranch.Unknown;
    }
}
