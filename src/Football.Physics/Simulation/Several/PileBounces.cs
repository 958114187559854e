using FootballPhysics.Contacts;
using FootballPhysics.Events;

namespace FootballPhysics.Simulation;

/// <summary>Impacts within a pile: between its balls, and with other objects.</summary>
internal sealed class PileBounces
{
    /// <summary>Minimum exit speed of a bounce in a pile, m/s, even if the ground allows slower ones.</summary>
    private const double LeastBounce = 0.05;

    /// <summary>Maximum number of bounces per ball and step.</summary>
    private const int MostOfBall = 8;

    private readonly Simulator[] _simulators;
    private readonly PileSystem _system;
    private readonly ContactMaterial _material;
    private int _bounces;

    /// <param name="simulators">The scenes of all balls of the group.</param>
    /// <param name="system">The pile's balls and contacts.</param>
    /// <param name="material">The material of impacts between balls.</param>
    public PileBounces(Simulator[] simulators, PileSystem system, in ContactMaterial material)
    {
        _simulators = simulators;
        _system = system;
        _material = material;
    }

    /// <summary>True if the balls have used their bounces in this step.</summary>
    private bool IsSpent => _bounces >= MostOfBall * _system.Count;

    /// <summary>Starts a step.</summary>
    public void Clear() => _bounces = 0;

    /// <summary>Adds the bounces of a merged pile.</summary>
    public void Absorb(PileBounces other) => _bounces += other._bounces;

    /// <summary>Marks the contacts that close fast enough to bounce within a part. They have no load until they touch.</summary>
    /// <param name="states">The balls.</param>
    /// <param name="h">Length of the part, s.</param>
    public void Mark(BallState[] states, double h)
    {
        for (int i = 0; i < _system.ContactCount && !IsSpent; i++)
        {
            double time = BounceTime(in _system.Contacts[i], states);
            _system.Contacts[i].Bounces = time > 0 && time < h;
        }
    }

    /// <summary>Returns the time at which the first marked contact touches on the ways of the balls, s; at most the length of the part.</summary>
    public double FirstTouch(double h)
    {
        for (int i = 0; i < _system.ContactCount; i++)
        {
            ref readonly Contact contact = ref _system.Contacts[i];
            if (contact.Bounces)
            {
                Vector3d other = contact.Second < 0 ? contact.Velocity : _system.Members[contact.Second].Way;
                double closing = -Vector3d.Dot(_system.Members[contact.First].Way - other, in contact.Normal);
                h = contact.Gap < h * closing ? contact.Gap / closing : h;
            }
        }

        return h;
    }

    /// <summary>Resolves all contacts that close fast enough to bounce within a time, in order of time.</summary>
    /// <remarks>Resolving the bounces one after the other adds no energy.</remarks>
    /// <param name="states">The balls.</param>
    /// <param name="h">The time, s; 0 for the contacts that touch.</param>
    /// <param name="logs">Receive the events of each ball.</param>
    /// <returns>True if a ball bounced.</returns>
    public bool Bounce(BallState[] states, double h, StepLog[] logs)
    {
        // Limit the impacts to the number of contacts plus eight at one instant, and to eight per ball and step.
        bool bounced = false;
        for (int done = 0; done < _system.ContactCount + 8; done++)
        {
            int next = -1;
            double first = h > 0 ? h : double.Epsilon;
            for (int i = 0; i < _system.ContactCount && !IsSpent; i++)
            {
                double time = BounceTime(in _system.Contacts[i], states);
                next = time < first ? i : next;
                first = Math.Min(first, time);
            }

            if (next < 0)
            {
                break;
            }

            Bounce(in _system.Contacts[next], states, logs);
            _bounces++;
            bounced = true;
        }

        return bounced;
    }

    /// <summary>Returns the time at which a contact closes and bounces, s; infinite if it does not.</summary>
    private double BounceTime(in Contact contact, BallState[] states)
    {
        ref readonly PileMember a = ref _system.Members[contact.First];
        Vector3d other = contact.Second < 0 ? contact.Velocity : states[_system.Members[contact.Second].Ball].Velocity;
        double closing = -Vector3d.Dot(states[a.Ball].Velocity - other, in contact.Normal);
        World world = _simulators[a.Ball].World;
        double least = Math.Max(LeastBounce, world.MinimumBounceSpeed);
        if (!(closing > least))
        {
            return double.PositiveInfinity;
        }

        // The exit speed, e u_n.
        ContactMaterial material = contact.Second < 0 ? world.ByIndex[contact.Collider].MaterialAt(states[a.Ball].Position) : _material;
        double e = material.LargestRestitutionAt(closing);
        if (!(Math.Max(e * closing, material.MinimumExitSpeed) >= least))
        {
            return double.PositiveInfinity;
        }

        // The gap closes under constant forces: gap = c t + b t²/2, with the closing speed c and its rate b.
        Vector3d pull = contact.Second < 0 ? a.Free.Acceleration : a.Free.Acceleration - _system.Members[contact.Second].Free.Acceleration;
        double square = (closing * closing) - (2.0 * contact.Gap * Vector3d.Dot(in pull, in contact.Normal));
        return contact.Gap <= ContactTolerances.Touching ? 0 : square > 0 ? 2.0 * contact.Gap / (closing + Math.Sqrt(square)) : double.PositiveInfinity;
    }

    private void Bounce(in Contact contact, BallState[] states, StepLog[] logs)
    {
        int ball = _system.Members[contact.First].Ball;
        ref BallState s = ref states[ball];
        Simulator simulator = _simulators[ball];
        if (contact.Second >= 0)
        {
            int other = _system.Members[contact.Second].Ball;
            BallContact.Impact(_simulators, in _material, ball, other, in contact.Normal, states, logs, out Motion mine, out Motion theirs);
            Set(ref s, in mine.Velocity, in mine.Spin);
            Set(ref states[other], in theirs.Velocity, in theirs.Spin);
            return;
        }

        // Also treat an object with a mass as immovable: it does not recoil from a pile.
        Vector3d v = s.Velocity;
        Vector3d w = s.Spin;
        Collider hit = simulator.World.ByIndex[contact.Collider];
        ref readonly ContactMaterial material = ref hit.MaterialAt(s.Position);
        bool grips = ImpactLaw.Apply(simulator.Scene.Ball, in material, in contact.Normal, in contact.Velocity, in v, in w, out Vector3d velocity, out Vector3d spin);
        logs[ball].Report(new BallEvent(
            BallEventKind.Impact, simulator.World.ThingOf(contact.Collider), in contact.Normal, s.Time, s.Position, in v, in w, in velocity, in spin,
            new ImpactContact(in contact.Velocity, grips))
        {
            AddedEnergy = material.IsBumper
                ? ImpactLaw.Added(simulator.Scene.Ball, 0, Vector3d.Dot(v - contact.Velocity, in contact.Normal), Vector3d.Dot(velocity - contact.Velocity, in contact.Normal))
                : 0,
        });
        Set(ref s, in velocity, in spin);
    }

    private static void Set(ref BallState s, in Vector3d velocity, in Vector3d spin)
    {
        s.Velocity = velocity;
        s.SpinAxis = spin;
    }
}
