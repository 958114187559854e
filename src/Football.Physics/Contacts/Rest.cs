using System.Runtime.CompilerServices;

namespace FootballPhysics.Contacts;

/// <summary>Determines whether a ball rests: whether it is slow enough, and whether its contacts or a net hold it (contact.md, Rest).</summary>
internal sealed unsafe class Rest
{
    /// <summary>Forces balance if the remaining acceleration is below this, m/s²: a thousandth of the weight, and 10 µm in a net.</summary>
    private const double InBalance = 0.01;

    private readonly Surroundings _around;
    private readonly World _world;

    public Rest(Surroundings around)
    {
        _around = around;
        _world = around.World;
    }

    /// <summary>True if a ball on a carrier has no more than the rest energy.</summary>
    public bool IsSlow(in Motion at, Collider carrier, double time) =>
        _world.Energy(in at, carrier, time) <= _world.RestEnergy * (1.0 + ContactTolerances.AtRest);

    /// <summary>True if a ball in a net has no more than the rest energy, and all forces balance.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="evaluations">Counts the evaluations.</param>
    public bool IsStillInNet(in BallState s, ref int evaluations)
    {
        if (!(_world.Energy(s.Velocity, s.Spin) <= _world.RestEnergy))
        {
            return false;
        }

        // A slow ball may only be turning around, so also require that all forces balance, including those of nets.
        evaluations++;
        return HangsStill(in s);
    }

    /// <summary>True if a ball with zero relative velocity stays at its position, on its carrier or in a net.</summary>
    /// <remarks>Custom forces are not evaluated here; the next step checks them.</remarks>
    public bool Holds(in BallState s)
    {
        int evaluations = 0;

        // The game may have moved the ball to another net since the ball came to rest.
        return _around.Air.HasOwnForces || (_world.HangsInNet(in s) ? HangsStill(in s) : IsHeld(in s, 0, ref evaluations));
    }

    /// <summary>True if a ball at rest stays at rest, on its carrier or in a net.</summary>
    /// <remarks>A carrier whose velocity jumped takes the ball along if rolling friction holds it.</remarks>
    /// <param name="s">The ball.</param>
    /// <param name="perStep">1/length of the step, 1/s; 0 to ignore jumps.</param>
    /// <param name="evaluations">Counts the evaluations.</param>
    public bool IsHeld(in BallState s, double perStep, ref int evaluations)
    {
        if (_world.HangsInNet(in s))
        {
            evaluations++;
            return !_around.Air.Varies || HangsStill(in s);
        }

        Collider carrier = _world.CarrierOf(in s);
        ShapePoint point = carrier.At(s.Position, s.Time);
        if (!(point.Distance - _around.Radius <= ContactTolerances.Touching))
        {
            return false;
        }

        // V̇ at the ball's centre, and Ω̇: the carrier's velocity jumps divided by the step.
        var still = new Motion(s.Position, carrier.MaterialVelocity(s.Position, s.Time), carrier.Spin);
        Vector3d gained = perStep * (still.Velocity - s.Velocity);
        Vector3d turned = perStep * (still.Spin - s.Spin);
        return IsHeldBy(carrier, in s, in still, in gained, in turned, ref evaluations) || IsHeldByAll(in s, in still, in gained, ref evaluations);
    }

    /// <summary>True if rolling friction of the carrier alone holds the ball: |a_b,t (+ a_air,t) − A_s,t − α r Ω̇ × n|/(1 + α) ≤ c₀
    /// N/m.</summary>
    /// <param name="carrier">The carrier.</param>
    /// <param name="s">The ball.</param>
    /// <param name="still">The ball as it moves along with the carrier.</param>
    /// <param name="gained">V̇, m/s².</param>
    /// <param name="turned">Ω̇, rad/s².</param>
    /// <param name="evaluations">Counts the evaluations.</param>
    public bool IsHeldBy(Collider carrier, in BallState s, in Motion still, in Vector3d gained, in Vector3d turned, ref int evaluations)
    {
        var system = SurfaceSystem.On(_around, carrier, in s, _around.BranchAt(in still));
        system.Rolls = true;
        system.ForcesOn(s.Time, in still, out SurfaceForces on);
        evaluations++;
        Vector3d n = on.Normal;
        system.CarrierGain = SurfaceSystem.Tangential(in gained, in n) + (_world.Ball.InertiaFactor * _around.Radius * Vector3d.Cross(in turned, in n));
        on.Load += Vector3d.Dot(in gained, in n);
        return on.FreeLoad > ContactTolerances.LeastLoad && system.Rests(in on);
    }

    /// <summary>True if all contacts together hold the ball, and none of them moves relative to the carrier.</summary>
    [SkipLocalsInit]
    private bool IsHeldByAll(in BallState s, in Motion carried, in Vector3d gained, ref int evaluations)
    {
        Contact* room = stackalloc Contact[ContactSet.Room];
        BallState moved = s;
        moved.Velocity = carried.Velocity;
        Span<Contact> set = ContactSet.Touching(_world, in moved, new Span<Contact>(room, ContactSet.Room), _world.Room);
        return set.Length >= 2 && set.Length <= ContactSystem.Most && IsHeldBy(set, in moved, in gained, gained == Vector3d.Zero, ref evaluations);
    }

    /// <summary>True if contacts hold a ball at its carrier's velocity without spin. No contact may move relative to the carrier.</summary>
    /// <param name="set">The contacts.</param>
    /// <param name="s">The ball, with its carrier.</param>
    /// <param name="gained">The carrier's velocity jump divided by the step, m/s².</param>
    /// <param name="mayGrip">Whether friction may hold a ball that rolling resistance alone cannot hold.</param>
    /// <param name="evaluations">Counts the evaluations.</param>
    public bool IsHeldBy(scoped Span<Contact> set, in BallState s, in Vector3d gained, bool mayGrip, ref int evaluations)
    {
        var still = new Motion(s.Position, _world.CarrierOf(in s).MaterialVelocity(s.Position, s.Time), Vector3d.Zero);
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        for (int i = 0; i < set.Length; i++)
        {
            Collider collider = _world.ByIndex[set[i].Collider];
            if (collider.Velocity != still.Velocity || collider.Spin != Vector3d.Zero)
            {
                return false;
            }

            contacts[i].Prepare(in set[i], collider);
            contacts[i].Look(_world, s.Time, in still);
        }

        var system = new ContactSystem
        {
            Around = _around,
            World = _world,
            Contacts = contacts,
            Count = set.Length,
            Bearer = -1,
            Nets = s.Nets,
            NetSides = s.NetSides,
            Branch = _around.BranchAt(in still),
        };
        evaluations++;
        return Resists(in system, system.PushAtRest(s.Time, in still) - gained)
            || (mayGrip && Grips(ref system, s.Time, in still, (int)s.Carrier - _world.FirstCollider, ref evaluations));
    }

    /// <summary>True if rolling resistance holds a ball against a push (contact.md, Rest): the part that no load can take is at most (1 + α) c₀ N, with N
    /// the greatest load.</summary>
    private static bool Resists(in ContactSystem system, in Vector3d push)
    {
        // Project the push onto the directions that the contacts leave free. Zero to three contacts have a load; three leave no free direction.
        Vector3d* normals = stackalloc Vector3d[ContactSystem.Most];
        for (int i = 0; i < system.Count; i++)
        {
            normals[i] = system.Contacts[i].Normal;
        }

        PushProjection free = PushProjection.Of(normals, system.Count, in push);
        if (free.TakesAll || free.First < 0)
        {
            return free.TakesAll || push.Length <= ContactTolerances.LeastLoad;
        }

        int bearer = free.FirstLoad >= free.SecondLoad ? free.First : free.Second;
        double most = (1.0 + system.World.Ball.InertiaFactor) * system.Contacts[bearer].Resistance.MostRolling(Math.Max(free.FirstLoad, free.SecondLoad), 0);
        return free.Left.Length <= most + ContactTolerances.LeastLoad;
    }

    /// <summary>True if friction holds a ball: with equal velocities of ball and surfaces, the modes at that instant leave the ball at its
    /// position.</summary>
    private static bool Grips(ref ContactSystem system, double time, in Motion still, int carrier, ref int evaluations) =>
        ContactModes.Find(ref system, time, in still, ContactTolerances.LeastLoad, carrier, ref evaluations)
            && system.Start.Acceleration.Length + (system.World.Ball.Radius * system.Start.SpinAcceleration.Length) <= ContactTolerances.LeastLoad;

    /// <summary>True if all forces on a ball in a net balance. The ends of nets take the force that presses the ball onto them.</summary>
    private bool HangsStill(in BallState s)
    {
        var at = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        var system = new FlightSystem { Around = _around, Nets = s.Nets, NetSides = s.NetSides, Orientation = s.Orientation };
        Vector3d left = system.On(_around.BranchAt(in at), s.Time, in at).Acceleration;
        return left.LengthSquared <= InBalance * InBalance || IsHeldByEnds(in s, in left);
    }

    /// <summary>True if the ends of nets that a ball touches hold it against an acceleration.</summary>
    private bool IsHeldByEnds(in BallState s, in Vector3d push)
    {
        Vector3d* normals = stackalloc Vector3d[ContactSystem.Most];
        int count = 0;
        for (int i = 0; i < _world.Nets.Length && count < ContactSystem.Most; i++)
        {
            NetSheet net = _world.Nets[i];
            double side = NetSheet.SideOf(s.NetSides, i);
            if ((s.Nets >> i & 1) != 0 && net.Depth(s.Position, side) >= net.Give - ContactTolerances.Touching)
            {
                normals[count++] = side * net.Normal;
            }
        }

        PushProjection held = PushProjection.Of(normals, count, in push);
        return count > 0 && (held.TakesAll || held.Left.LengthSquared <= InBalance * InBalance);
    }
}
