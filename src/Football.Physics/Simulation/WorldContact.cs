using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>Resolves contacts with the world: an impact, and the motion state of the ball after it.</summary>
internal sealed partial class WorldContact
{
    /// <summary>After this many hits by movers in a step, each further hit may squeeze the ball.</summary>
    private const int MostHits = 8;

    /// <summary>Maximum number of slide and roll events per step of a ball on several surfaces.</summary>
    /// <remarks>A ball that alternately slips and grips would report an event in every part.</remarks>
    private const int MostNames = 2;

    private readonly World _world;
    private readonly ContactLoad _load;
    private readonly Rest _rest;
    private readonly ImpactResult _result;

    /// <param name="around">The forces on the ball.</param>
    /// <param name="gainsByHops">Whether the integrator returns from a hop faster than it left.</param>
    public WorldContact(Surroundings around, bool gainsByHops)
    {
        _world = around.World;
        _load = new ContactLoad(around);
        _rest = new Rest(around);
        _result = new ImpactResult(_world, _load, gainsByHops);
    }

    /// <summary>Computes the load of the ball on a surface that it touches.</summary>
    public ContactLoad Load => _load;

    /// <summary>Resolves an impact with a collider that the ball touches, and sets the new motion state.</summary>
    public void Impact(ref BallState s, int collider, ref StepRun run)
    {
        // After too many impacts at one instant, resolve all contacts together.
        if (run.InQuickSuccession(s.Time) > StepRun.MostAtOnce)
        {
            ImpactAtOnce(ref s, collider, ref run);
            return;
        }

        Collider hit = _world.ByIndex[collider];
        bool carried = s.Motion != MotionState.Airborne && !_world.HangsInNet(in s);
        if (!carried && hit.IsLevelGround)
        {
            // Height and vertical velocity are known exactly here. The difference is due to rounding, or to the tolerance of a contact or a
            // bisection.
            s.Position = hit.Snap(s.Position);
            s.Velocity = new Vector3d(s.Velocity.X, Math.Min(s.Velocity.Y, 0), s.Velocity.Z);
        }

        // The separation speed determines the motion state.
        ImpactOutcome end = _result.Of(ref s, hit, ref run);
        _result.Report(ref s, hit, collider + _world.FirstCollider, in end, ref run);

        // The velocity has jumped, so choose the branch of the drag law again.
        s.Branch = DragBranch.Unknown;

        // Movers have hit the ball often in this step: find out whether they leave it room.
        if (hit.Moves && run.Spent.Hits++ >= MostHits && !FreePlace.Exists(_world, in s, in end.Velocity, in end.Normal, in run))
        {
            s.Velocity = end.Velocity;
            s.SetGroundSpin(in end.Spin);
            BeginSqueeze(ref s, collider, ref run);
            return;
        }

        if (!end.Bounces)
        {
            run.Stay(s.Time);
        }

        // A ball supported by another surface keeps its carrier unless the impulse lifts it.
        if (carried && s.Carrier != collider + _world.FirstCollider)
        {
            Vector3d shape = hit.ShapeVelocity(s.Position - (_world.Ball.Radius * end.Normal), s.Time);
            KeepCarrier(ref s, in end.Velocity, in end.Spin, in shape, in end.Normal, end.Bounces ? -1 : collider, ref run);
        }
        else if (end.Bounces)
        {
            Fly(ref s, in end.Velocity, in end.Spin);
        }
        else
        {
            Stay(ref s, collider + _world.FirstCollider, in end.Velocity, in end.Spin, ref run);
        }
    }

    /// <summary>Makes a surface the carrier without an impact: the ball touches it, presses on it, and does not close on it.</summary>
    public void TakeUp(ref BallState s, int collider, ref StepRun run) => Stay(ref s, collider + _world.FirstCollider, s.Velocity, s.Spin, ref run);

    /// <summary>Makes one of several contacts the carrier. The ball rolls if it has no slip there; otherwise it slides.</summary>
    public void Name(ref BallState s, int collider, bool rolls, ref StepRun run)
    {
        s.Carrier = collider + _world.FirstCollider;
        if (rolls == (s.Motion == MotionState.Rolling) || run.Spent.Named >= MostNames)
        {
            return;
        }

        run.Spent.Named++;
        if (rolls)
        {
            StartRolling(ref s, ref run);
        }
        else
        {
            StartSliding(ref s, ref run);
        }
    }

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
        Vector3d surface = _world.SurfaceVelocity(carrier, s.Position, in n, s.Time);
        Vector3d spin = Slip.RollingSpin(s.Velocity - surface, Vector3d.Dot(s.Spin, in n), in n, _world.Ball.Radius);
        if (!run.Jumped)
        {
            run.Report(BallEventKind.Roll, _world.Reported(s.Carrier), in n, in s, s.Velocity, in spin);
        }

        run.Jumped = false;
        s.SetGroundSpin(in spin);
        s.Motion = MotionState.Rolling;
    }

    /// <summary>Handles a velocity jump of the carrier since the last step: the ball keeps its velocity, and slips (contact.md,
    /// Surfaces that move).</summary>
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
    /// <remarks>If its velocity differs, a rolling ball slips: v and ω stay (contact.md, Several contacts).</remarks>
    public void HandOver(ref BallState s, int collider, ref StepRun run)
    {
        if (collider == s.Carrier - _world.FirstCollider)
        {
            return;
        }

        Collider before = _world.CarrierOf(in s);
        Collider next = _world.ByIndex[collider];
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
        run.Report(BallEventKind.Slide, _world.Reported(s.Carrier), in n, in s, s.Velocity, s.Spin);
    }

    /// <summary>Releases the ball from its carrier, and divides the rest of the step from scratch.</summary>
    public void Leave(ref BallState s, in Vector3d velocity, in Vector3d spin, ref StepRun run)
    {
        run.Report(BallEventKind.ContactEnd, -1, Vector3d.Zero, in s, in velocity, in spin);
        run.Part = 0;
        Fly(ref s, in velocity, in spin);
    }

    /// <summary>Releases a ball from the end of a net that it has left over an edge.</summary>
    public void LeaveNetEnd(ref BallState s, ref StepRun run)
    {
        long carrier = s.Carrier - _world.FirstCollider;
        if (s.Motion == MotionState.Airborne || !_world.IsNetEnd(carrier) || _world.ActsOn(carrier, in s))
        {
            return;
        }

        if (s.Motion == MotionState.Pinned)
        {
            s.Carrier = 0;
        }
        else
        {
            Leave(ref s, s.Velocity, s.Spin, ref run);
        }
    }

    /// <summary>Brings the ball to rest on its carrier; it then moves along with the carrier.</summary>
    public void Rest(ref BallState s, ref StepRun run)
    {
        Collider carrier = _world.CarrierOf(in s);
        Rest(ref s, carrier.MaterialVelocity(s.Position, s.Time), carrier.Spin, ref run);
    }

    /// <summary>Stops a ball in a net if its energy is below the rest energy and all forces balance.</summary>
    /// <returns>True if the ball rests.</returns>
    public bool RestsInNet(ref BallState s, ref StepRun run)
    {
        int evaluations = 0;
        bool rests = _rest.IsStillInNet(in s, ref evaluations);
        run.Log.Evaluations += evaluations;
        if (rests)
        {
            s.Carrier = _world.ThingOfNet(_world.NetForces.Deepest(in s));
            s.Branch = DragBranch.Unknown;
            Rest(ref s, Vector3d.Zero, Vector3d.Zero, ref run);
        }

        return rests;
    }

    private static void Rest(ref BallState s, in Vector3d velocity, in Vector3d spin, ref StepRun run)
    {
        run.Report(BallEventKind.Rest, -1, Vector3d.Zero, in s, s.Velocity, s.Spin);
        run.Log.Halted |= run.Log.StopAt == StopAt.Rest;
        s.Velocity = velocity;
        s.SetGroundSpin(in spin);
        s.ClearIn = s.ClearIn == BallState.TouchesSeveral ? 0 : s.ClearIn;
        s.Motion = MotionState.Rest;
    }

    /// <summary>Sets the state of a placed ball: supported if it touches a surface slowly enough and is pressed on it; otherwise in the
    /// air.</summary>
    public void Settle(ref BallState s)
    {
        // If several surfaces could support the ball, use the first one in scene order.
        int first = int.MaxValue;
        var near = NearThings.At(_world, in s);
        while (near.Next(out int i))
        {
            first = i < first && TakesUp(in s, i, out _) ? i : first;
        }

        if (first < int.MaxValue)
        {
            TakesUp(in s, first, out Vector3d velocity);
            Collider collider = _world.ByIndex[first];
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
        Collider collider = _world.ByIndex[index];
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

        // w_s < 0: the ball moves into its carrier, so it also hits the carrier at the same instant. Its motion stays, so that a slide has an event.
        if (off < -ContactTolerances.Approaching)
        {
            s.Velocity = velocity;
            s.SetGroundSpin(in spin);
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
        run.Spent.Arrival = Math.Max(run.Spent.Arrival, velocity.Length);
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
        if (!carrier.Moves && carrier.At(s.Position, s.Time).Distance - _world.Ball.Radius <= ContactTolerances.Touching)
        {
            _world.Hold(ref s, carrier);
        }
    }

    /// <summary>Puts the ball onto a surface on which it stays, sliding or rolling.</summary>
    private void Stay(ref BallState s, int thing, in Vector3d velocity, in Vector3d spin, ref StepRun run)
    {
        // Report no new slide if the ball already slid there at this instant, nor in a crowded step.
        bool slidOn = (run.Spent.Quick > 1 || run.IsCrowded) && s.Motion == MotionState.Sliding && s.Carrier == thing;
        run.Jumped &= slidOn;
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
