using FootballPhysics.Contacts;
using FootballPhysics.Events;

namespace FootballPhysics.Simulation;

/// <summary>Computes and reports the outcome of an impact with an object.</summary>
internal sealed class ImpactResult
{
    private readonly World _world;
    private readonly ContactLoad _load;
    private readonly bool _gainsByHops;

    /// <param name="world">The world.</param>
    /// <param name="load">Computes the load on a surface.</param>
    /// <param name="gainsByHops">Whether the integrator returns from a hop faster than it left.</param>
    public ImpactResult(World world, ContactLoad load, bool gainsByHops)
    {
        _world = world;
        _load = load;
        _gainsByHops = gainsByHops;
    }

    /// <summary>Computes the impulse of an impact, relative to the surface velocity at the contact point, and whether the ball bounces.</summary>
    public ImpactOutcome Of(ref BallState s, Collider hit, ref StepRun run)
    {
        ShapePoint at = hit.At(s.Position, s.Time);
        Vector3d n = at.Normal;
        Vector3d v = s.Velocity;
        Vector3d w = s.Spin;
        Vector3d contact = s.Position - (_world.Ball.Radius * n);
        Vector3d surface = hit.SpinVelocity(in contact, s.Time);
        Vector3d shape = hit.ShapeVelocity(in contact, s.Time);
        double recoil = hit.GivesWay ? _world.Ball.Mass / hit.Mass : 0;
        ref readonly ContactMaterial material = ref hit.MaterialAt(s.Position);
        bool grips = ImpactLaw.Apply(_world.Ball, in material, in n, in surface, in v, in w, out Vector3d velocity, out Vector3d spin, recoil);

        run.Spent.Fastest = hit.Moves ? Math.Max(run.Spent.Fastest, material.FastestBy(surface.Length)) : run.Spent.Fastest;

        // The separation speed is w = (v' − V')·n: ball v', object V', normal n. An object of mass M recoils to V' = V − (m/M)(v' − v).
        bool may = run.Hit();
        double off = Vector3d.Dot(velocity - shape + (recoil * (velocity - v)), in n);
        if (_gainsByHops && off > 0 && !hit.IsLevelGround)
        {
            // Subtract the speed that the integrator will add in the hop. On level ground, the pieces of a hop are short enough to prevent this gain.
            double gain = Math.Min(off, _load.GainOfHop(in s, off, velocity - (off * n), in spin, hit, in at, run.Length));
            off -= gain;
            velocity -= gain / (1.0 + recoil) * n;
        }

        bool bounces = may && !_load.StaysAfter(in s, off, velocity - (off * n), in spin, hit, in at);
        if (!bounces && hit.GivesWay)
        {
            // A ball that stays on an object with a mass has an impact with e = 0, which conserves momentum.
            ContactMaterial dead = material.WithoutRestitution();
            grips = ImpactLaw.Apply(_world.Ball, in dead, in n, in surface, in v, in w, out velocity, out spin, recoil);
            off = 0;
        }

        double added = bounces && material.IsBumper ? ImpactLaw.Added(_world.Ball, recoil, Vector3d.Dot(v - surface, in n), Vector3d.Dot(velocity - surface + (recoil * (velocity - v)), in n)) : 0;
        return new ImpactOutcome
        {
            Normal = n,
            Closing = Vector3d.Dot(surface - v, in n),
            Struck = velocity,
            Velocity = bounces && off > 0 ? velocity : velocity - (off * n),
            Spin = spin,
            Added = added,
            Contact = new ImpactContact(in surface, grips, recoil / _world.Ball.Mass),
            Bounces = bounces,
        };
    }

    /// <summary>Pushes the object, and reports the impact.</summary>
    public void Report(ref BallState s, Collider hit, int thing, in ImpactOutcome end, ref StepRun run)
    {
        // Apply the opposite impulse, m (v − v'), to an object with a mass.
        if (hit.GivesWay && run.Log.Pushes)
        {
            run.Log.Motions?.Read();
            hit.Push(_world.Ball.Mass * (s.Velocity - end.Velocity), s.Time);
            run.Log.Pushed = true;
            run.Log.Halted |= run.Log.HaltsAtPush;
        }

        // In a crowded step, count slow impacts without reporting them: a ball that trembles in a corner would raise many events.
        if (end.Closing < _world.MinimumBounceSpeed && run.IsCrowded)
        {
            run.Log.UnreportedImpacts++;
        }
        else
        {
            run.Report(BallEventKind.Impact, _world.Reported(thing), in end.Normal, in s, in end.Struck, in end.Spin, end.Added, in end.Contact);
        }

        run.Log.Halted |= run.Log.StopAt == StopAt.Impact;
    }
}

/// <summary>The outcome of an impact.</summary>
internal struct ImpactOutcome
{
    /// <summary>n.</summary>
    public Vector3d Normal;

    /// <summary>The speed at which the ball closed, m/s.</summary>
    public double Closing;

    /// <summary>The velocity that the impulse gives the ball, m/s; the event reports it.</summary>
    public Vector3d Struck;

    /// <summary>The velocity after, m/s. A ball that stays has lost its remaining separation speed.</summary>
    public Vector3d Velocity;

    /// <summary>The spin after, rad/s.</summary>
    public Vector3d Spin;

    /// <summary>The energy that a bumper added, J.</summary>
    public double Added;

    /// <summary>The object, for the event.</summary>
    public ImpactContact Contact;

    /// <summary>True if the ball leaves the object.</summary>
    public bool Bounces;
}
