namespace Football.Physics;

/// <summary>What touching a thing of the world does to the ball: an impact, and whether it then flies, is guided, or is carried, sliding or rolling.</summary>
internal sealed class WorldContact
{
    /// <summary>More impacts than this at one instant, and the ball is wedged: it goes along with what pushes it.</summary>
    private const int MostAtOnce = 64;

    /// <summary>A ball is raised out of the ground in so many steps: more than one where that is curved.</summary>
    private const int MostRaises = 4;

    /// <summary>Less than this is no overlap to be raised from, m.</summary>
    private const double Overlap = 5e-10;

    private readonly Surroundings _around;
    private readonly World _world;

    public WorldContact(Surroundings around)
    {
        _around = around;
        _world = around.World;
    }

    /// <summary>An impact with a collider that the ball touches, and what becomes of the ball.</summary>
    public void Impact(ref BallState s, int collider, ref StepRun run)
    {
        Collider hit = _world.Colliders[collider];
        bool carried = s.Motion != MotionState.Airborne;
        if (!carried && _world.IsLevel && hit == _world.Ground)
        {
            // Height and climb are known here: what was left of them is rounding, what counts as touching, or the tolerance of a bisection.
            s.Position = new Vector3d(s.Position.X, _world.LevelContact, s.Position.Z);
            s.Velocity = new Vector3d(s.Velocity.X, Math.Min(s.Velocity.Y, 0), s.Velocity.Z);
        }

        ShapePoint at = hit.At(s.Position, s.Time);
        Vector3d n = at.Normal;
        Vector3d v = s.Velocity;
        Vector3d w = s.Spin;
        int thing = collider + _world.FirstCollider;
        bool wedged = run.Impacts++ >= MostAtOnce;
        Vector3d surface = hit.SurfaceVelocity(s.Position - (_world.Ball.Radius * n), s.Time);
        CoulombImpact.Apply(_world.Ball, in hit.MaterialAt(s.Position), in n, in surface, in v, in w, out Vector3d velocity, out Vector3d spin);
        if (wedged)
        {
            velocity = v - (Vector3d.Dot(v - hit.Velocity, in n) * n);
            spin = w;
        }
        else
        {
            run.Log.Events.Add(new BallEvent(BallEventKind.Impact, thing, in n, s.Time, s.Position, in v, in w, in velocity, in spin));
            run.Log.Halted |= run.Log.StopAt == StopAt.Impact;
        }

        s.Branch = DragBranch.Unknown;
        bool may = run.Hit();
        double off = Vector3d.Dot(velocity - hit.Velocity, in n);

        // What would be back within a microsecond stays down: so an impact takes time, however strong the ball is pressed.
        bool bounces = may && off >= _world.MinimumBounceSpeed
            && off >= 0.5 * StabilityLimit.ShortestHop * Load(in s, velocity - (off * n), in spin, hit, in at);
        velocity = bounces ? velocity : velocity - (off * n);
        if (carried && s.Carrier != thing)
        {
            KeepCarrier(ref s, in velocity, in spin, hit.Velocity, in n, bounces, ref run);
            return;
        }

        // Where a step has had its impacts, or is spent, the ball stays on what it hits even if the air would lift it.
        if (!bounces && (!may || Load(in s, in velocity, in spin, hit, in at) > SurfaceForces.Least))
        {
            Stay(ref s, thing, in velocity, in spin, ref run);
            return;
        }

        Fly(ref s, in velocity, in spin);
    }

    /// <summary>The ground takes a ball that touches it, does not come closer and is pressed on it: no impact.</summary>
    public void TakeUp(ref BallState s, int collider, ref StepRun run) => Stay(ref s, collider + _world.FirstCollider, s.Velocity, s.Spin, ref run);

    /// <summary>The slip is over: the ball rolls, where friction can hold it.</summary>
    public void EndSlip(ref BallState s, ref StepRun run)
    {
        if (Grips(in s, _world.CarrierOf(in s), ref run))
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
        Vector3d spin = Slip.RollingSpin(s.Velocity - carrier.Velocity, Vector3d.Dot(in before, in n), in n, _world.Ball.Radius);
        s.SetGroundSpin(in spin);
        s.Motion = MotionState.Rolling;
        run.Log.Events.Add(new BallEvent(BallEventKind.Roll, (int)s.Carrier, in n, s.Time, s.Position, s.Velocity, in before, s.Velocity, in spin));
    }

    /// <summary>A rolling ball begins to slip.</summary>
    public void StartSliding(ref BallState s, ref StepRun run)
    {
        Vector3d n = _world.CarrierOf(in s).At(s.Position, s.Time).Normal;
        s.Motion = MotionState.Sliding;
        run.Log.Events.Add(new BallEvent(BallEventKind.Slide, (int)s.Carrier, in n, s.Time, s.Position, s.Velocity, s.Spin, s.Velocity, s.Spin));
    }

    /// <summary>The ball leaves what carries it: the step is divided anew.</summary>
    public void Leave(ref BallState s, in Vector3d velocity, in Vector3d spin, ref StepRun run)
    {
        run.Log.Events.Add(new BallEvent(BallEventKind.Leave, -1, Vector3d.Zero, s.Time, s.Position, s.Velocity, s.Spin, in velocity, in spin));
        run.Part = 0;
        Fly(ref s, in velocity, in spin);
    }

    /// <summary>The ball comes to rest on what carries it.</summary>
    public void Rest(ref BallState s, ref StepRun run)
    {
        run.Log.Events.Add(new BallEvent(BallEventKind.Rest, -1, Vector3d.Zero, s.Time, s.Position, s.Velocity, s.Spin, s.Velocity, s.Spin));
        run.Log.Halted |= run.Log.StopAt == StopAt.Rest;
        s.Velocity = _world.CarrierOf(in s).Velocity;
        s.SetGroundSpin(Vector3d.Zero);
        s.Motion = MotionState.Stopped;
    }

    /// <summary>A ball inside the ground, where a state says so, is raised to it.</summary>
    public void Raise(ref BallState s)
    {
        if (_world.IsLevel)
        {
            // To the last bit: heights of a ball on level ground are compared with that.
            s.Position = new Vector3d(s.Position.X, Math.Max(s.Position.Y, _world.LevelContact), s.Position.Z);
            return;
        }

        for (int i = 0; i < MostRaises && _world.Ground is { } ground; i++)
        {
            ShapePoint at = ground.At(s.Position);
            double below = _world.Ball.Radius - at.Distance;
            if (!(below > Overlap))
            {
                break;
            }

            s.Position += below * at.Normal;
        }
    }

    /// <summary>Whether a collider would carry a ball that touches it, and would not let it go at once.</summary>
    public bool IsPressed(in BallState s, int collider)
    {
        Collider on = _world.Colliders[collider];
        ShapePoint at = on.At(s.Position, s.Time);
        return Load(in s, s.Velocity, s.Spin, on, in at) > SurfaceForces.Least;
    }

    /// <summary>A ball that is placed: carried, where it touches something slowly enough and is pressed on it; else in the air.</summary>
    public void Settle(ref BallState s)
    {
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
            Vector3d n = _world.Hold(ref s, collider);
            s.Velocity = velocity;
            s.Carrier = first + _world.FirstCollider;
            bool rolls = Slip.Of(velocity - collider.Velocity, in spin, in n, _world.Ball.Radius).Length < Slip.Rolling;
            s.SetGroundSpin(in spin);
            s.Motion = rolls ? MotionState.Rolling : MotionState.Sliding;
        }
    }

    /// <summary>Whether a collider carries a ball that is placed.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="index">The collider.</param>
    /// <param name="velocity">The ball's velocity along the surface, m/s.</param>
    private bool TakesUp(in BallState s, int index, out Vector3d velocity)
    {
        Collider collider = _world.Colliders[index];
        ShapePoint at = collider.At(s.Position, s.Time);
        double off = Vector3d.Dot(s.Velocity - collider.Velocity, at.Normal);
        velocity = s.Velocity - (off * at.Normal);

        // On a level pitch that is so up to the speed of the slowest bounce; on anything else what comes closer hits.
        double slowest = _world.IsLevel && collider == _world.Ground ? -_world.MinimumBounceSpeed : -double.Epsilon;
        return at.Distance - _world.Ball.Radius <= ContactSearch.Touching && off < _world.MinimumBounceSpeed && off > slowest
            && Load(in s, in velocity, s.Spin, collider, in at) > SurfaceForces.Least;
    }

    /// <summary>A carried ball was hit by something else: it keeps its carrier unless the impulse lifts it.</summary>
    private void KeepCarrier(
        ref BallState s, in Vector3d velocity, in Vector3d spin, in Vector3d hitVelocity, in Vector3d hitNormal, bool bounces, ref StepRun run)
    {
        Collider carrier = _world.CarrierOf(in s);
        Vector3d n = carrier.At(s.Position, s.Time).Normal;
        double off = Vector3d.Dot(velocity - carrier.Velocity, in n);
        if (off >= _world.MinimumBounceSpeed)
        {
            Leave(ref s, in velocity, in spin, ref run);
            return;
        }

        if (off < -ContactSearch.Approaching)
        {
            s.Velocity = velocity;
            s.SetGroundSpin(in spin);
            s.Motion = MotionState.Sliding;
            Impact(ref s, (int)s.Carrier - _world.FirstCollider, ref run);
            return;
        }

        Vector3d kept = velocity - (off * n);
        Vector3d along = hitNormal - (Vector3d.Dot(in hitNormal, in n) * n);
        double share = along.LengthSquared;
        if (!bounces && share > 1e-12)
        {
            // Neither off the carrier nor into what it hit.
            kept -= Vector3d.Dot(kept - hitVelocity, in hitNormal) / share * along;
        }

        Stay(ref s, (int)s.Carrier, in kept, in spin, ref run);
    }

    /// <summary>The ball stays on a thing, and is put onto it: it slides, or rolls.</summary>
    private void Stay(ref BallState s, int thing, in Vector3d velocity, in Vector3d spin, ref StepRun run)
    {
        s.Velocity = velocity;
        s.SetGroundSpin(in spin);
        s.Carrier = thing;
        s.Motion = MotionState.Sliding;
        Collider carrier = _world.CarrierOf(in s);
        Vector3d n = _world.Hold(ref s, carrier);
        if (Slip.Of(s.Velocity - carrier.Velocity, in spin, in n, _world.Ball.Radius).Length < Slip.Rolling && Grips(in s, carrier, ref run))
        {
            StartRolling(ref s, ref run);
        }
        else
        {
            StartSliding(ref s, ref run);
        }
    }

    /// <summary>Whether friction can hold a ball without slip.</summary>
    private bool Grips(in BallState s, Collider carrier, ref StepRun run)
    {
        SurfaceSystem system = System(in s, carrier);
        SurfaceForces on = system.ForcesOn(s.Time, new Motion(s.Position, s.Velocity, s.Spin));
        run.Log.Evaluations++;
        return system.Grips(in on);
    }

    /// <summary>N/m, m/s², were the ball to follow the surface.</summary>
    private double Load(in BallState s, in Vector3d velocity, in Vector3d spin, Collider collider, in ShapePoint at)
    {
        var motion = new Motion(s.Position, in velocity, in spin);
        if (_world.AirLoads)
        {
            return System(in s, collider).ForcesOn(s.Time, in motion).FreeLoad;
        }

        Vector3d along = velocity - collider.Velocity;
        return (-_around.Upward * at.Normal.Y) - Vector3d.Dot(in along, at.Curvature * along);
    }

    private SurfaceSystem System(in BallState s, Collider carrier) => new()
    {
        Around = _around,
        World = _world,
        Carrier = carrier,
        Material = carrier.MaterialAt(s.Position),
        Branch = _around.Air.Jumps
            ? DragJump.At((s.Velocity - _around.Wind).LengthSquared, _around.RadiusSquared * s.Spin.LengthSquared).Branch
            : DragBranch.Unknown,
        Nets = s.Nets,
        NetSides = s.NetSides,
    };

    private static void Fly(ref BallState s, in Vector3d velocity, in Vector3d spin)
    {
        s.Velocity = velocity;
        s.SetFlightSpin(in spin);
        s.Motion = MotionState.Airborne;
        s.Carrier = 0;
        s.Branch = DragBranch.Unknown;
    }
}
