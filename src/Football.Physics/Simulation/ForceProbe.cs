using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>Ends a step at its first evaluation of the forces, and splits their sum. The step's own phases choose the equations.</summary>
/// <param name="around">The scene.</param>
/// <param name="scene">The same scene as the caller gave it.</param>
internal sealed unsafe class ForceProbe(Surroundings around, Scene scene)
{
    private readonly World _world = around.World;

    /// <summary>The forces; null until they are found.</summary>
    public BallForces? Found { get; private set; }

    /// <summary>True if the step solves the contacts by impulses.</summary>
    public bool UsesImpulses { get; set; }

    /// <summary>Splits the forces in flight.</summary>
    public void Fly(in BallState s)
    {
        var from = new Motion(s.Position, s.Velocity, s.Spin, s.AirDistance);
        var system = new FlightSystem
        {
            Around = around,
            Branch = s.Branch,
            Nets = s.Nets,
            NetSides = s.NetSides,
            Orientation = around.Air.HasSide ? s.Orientation : default,
        };
        system.Rates(s.Time, in from, out MotionRates start);
        ForceShares shares;
        if (s.Branch is DragBranch.AlongCriticalSpeed or DragBranch.AlongCriticalSpin)
        {
            double share = Math.Max(0, Math.Min(1, system.SpinningShare(s.Time, in from, out _, out _)));
            ForceShares spinning = ForceShares.Of(around, DragBranch.Spinning, MotionState.Airborne, s.Time, in from, in system.Orientation);
            ForceShares noSpin = ForceShares.Of(around, DragBranch.NoSpin, MotionState.Airborne, s.Time, in from, in system.Orientation);
            shares = ForceShares.Mean(share, in spinning, in noSpin);
        }
        else
        {
            shares = ForceShares.Of(around, s.Branch, MotionState.Airborne, s.Time, in from, in system.Orientation);
        }

        shares.Nets = s.Nets == 0 ? Vector3d.Zero : _world.NetForces.Push(s.Nets, s.NetSides, null, in from).Acceleration;
        Found = new BallForces(scene, in shares, in start.Acceleration, []);
    }

    /// <summary>Splits the forces of a slide or a roll.</summary>
    /// <param name="system">The equations, with the forces of the last evaluation.</param>
    /// <param name="at">The ball at that evaluation.</param>
    /// <param name="acceleration">The acceleration, m/s².</param>
    /// <param name="time">The time, s.</param>
    /// <param name="carrier">The index of the carrier in states.</param>
    /// <param name="rests">True for a ball at rest.</param>
    public void Slide(in SurfaceSystem system, in Motion at, in Vector3d acceleration, double time, long carrier, bool rests = false)
    {
        ref readonly SurfaceForces on = ref system.Forces;
        Vector3d n = on.Normal;
        var shares = ForceShares.Of(around, system.Branch, system.Rolls ? MotionState.Rolling : MotionState.Sliding, time, in at);
        shares.Support(_world, in n, rests);
        Vector3d nets = system.Nets == 0 ? Vector3d.Zero : _world.NetForces.Push(system.Nets, system.NetSides, system.NetsSlack, in at).Acceleration;
        shares.Nets = SurfaceSystem.Tangential(in nets, in n);
        Vector3d friction = system.FrictionOn(in at, in on);

        // The surface guides the ball: the part of the load that friction does not count comes from a net that presses the ball, or from the surface.
        double left = -on.Centripetal - Vector3d.Dot(around.Weight + shares.Sum, in n) - on.Load;
        shares.Nets += system.Nets == 0 ? Vector3d.Zero : left * n;
        Vector3d load = (on.Load + (system.Nets == 0 ? left : 0)) * n;
        Found = new BallForces(scene, in shares, in acceleration, [Contact((int)_world.Reported(carrier), in at, in n, in load, in friction)]);
    }

    /// <summary>Splits the forces on several surfaces.</summary>
    /// <param name="system">The equations, with their solution.</param>
    /// <param name="at">The ball.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="rests">True for a ball at rest.</param>
    public void Press(in ContactSystem system, in Motion at, double time, bool rests = false)
    {
        bool hasBearer = system.Bearer >= 0;
        bool sticks = hasBearer && system.Contacts[system.Bearer].Sticks;
        Vector3d normal = hasBearer ? system.Contacts[system.Bearer].Normal : Vector3d.Zero;
        MotionState motion = sticks ? MotionState.Rolling : MotionState.Sliding;
        var shares = ForceShares.Of(around, system.Branch, motion, time, in at);
        shares.Support(_world, in normal, rests);
        shares.Nets = system.Nets == 0 ? Vector3d.Zero
            : system.Free(time, in at).Acceleration - new FreeForces(around, system.Branch, motion, time, in at).Supported(in normal, sticks).Acceleration;
        var contacts = new ContactForce[system.Count];
        int count = 0;
        for (int i = 0; i < system.Count; i++)
        {
            ref readonly SetContact contact = ref system.Contacts[i];
            if (contact.Bears)
            {
                Vector3d load = contact.Load * contact.Normal;
                contacts[count++] = Contact((int)_world.Reported(_world.ThingOf(contact.Collider)), in at, contact.Normal, in load, ContactForces.FrictionOf(in system, i));
            }
        }

        Found = new BallForces(scene, in shares, system.Start.Acceleration, contacts.AsSpan(0, count).ToArray());
    }

    /// <summary>Splits the forces on a ball at rest: a net or its contacts balance the other forces.</summary>
    /// <returns>False if the forces of its contacts are not determined.</returns>
    [SkipLocalsInit]
    public bool Rest(in BallState s)
    {
        if (s.RestsInPile)
        {
            return false;
        }

        if (_world.HangsInNet(in s))
        {
            var hanging = new Motion(s.Position, Vector3d.Zero, Vector3d.Zero, s.AirDistance);
            var hung = ForceShares.Of(around, around.BranchAt(in hanging), MotionState.Airborne, s.Time, in hanging, s.Orientation);
            hung.Nets = -(around.Weight + hung.Sum);
            Found = new BallForces(scene, in hung, Vector3d.Zero, []);
            return true;
        }

        Collider carrier = _world.CarrierOf(in s);
        BallState moved = s;
        moved.Velocity = carrier.MaterialVelocity(s.Position, s.Time);
        var still = new Motion(s.Position, moved.Velocity, carrier.Spin);
        Contact* room = stackalloc Contact[ContactSet.Room];
        Span<Contact> set = ContactSet.Touching(_world, in moved, new Span<Contact>(room, ContactSet.Room), _world.Room);
        if (set.Length >= 2)
        {
            return set.Length <= ContactSystem.Most && RestOn(set, in s, in still);
        }

        var system = SurfaceSystem.On(around, carrier, in s, around.BranchAt(in still));
        system.Rolls = true;
        system.Pinned = true;
        system.Look(s.Time, in still);
        Vector3d acceleration = system.Forces.MaterialRate - (system.Forces.Centripetal * system.Forces.Normal);
        Slide(in system, in still, in acceleration, s.Time, s.Carrier, rests: true);
        return true;
    }

    private bool RestOn(scoped Span<Contact> set, in BallState s, in Motion still)
    {
        SetContact* contacts = stackalloc SetContact[ContactSystem.Most];
        for (int i = 0; i < set.Length; i++)
        {
            contacts[i].Prepare(in set[i], _world.ByIndex[set[i].Collider]);
        }

        var system = new ContactSystem
        {
            Around = around,
            World = _world,
            Contacts = contacts,
            Count = set.Length,
            Nets = s.Nets,
            NetSides = s.NetSides,
            Branch = around.BranchAt(in still),
        };
        int evaluations = 0;
        bool found = ContactModes.Find(ref system, s.Time, in still, ContactTolerances.LeastLoad, (int)s.Carrier - _world.FirstCollider, ref evaluations);

        // The modes may only let the ball go: then something else holds it, such as rolling resistance, which shares its force in no known way.
        if (!found || system.Bearer < 0 || !(system.Start.Acceleration.Length <= ContactTolerances.LeastLoad))
        {
            return false;
        }

        Press(in system, in still, s.Time, rests: true);
        return true;
    }

    private ContactForce Contact(int thing, in Motion at, in Vector3d normal, in Vector3d load, in Vector3d friction)
    {
        double mass = scene.Ball.Mass;
        return new ContactForce(thing, at.Position - (around.Radius * normal), normal, mass * load, mass * friction);
    }
}
