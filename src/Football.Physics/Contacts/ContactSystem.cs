using FootballPhysics.Integration;
using FootballPhysics.State;

namespace FootballPhysics.Contacts;

/// <summary>A ball on several surfaces at once, with the contacts and their modes locked (contact.md, Several contacts).</summary>
/// <remarks>
/// With n, ṅ, V_c and A of each contact: v̇ = a + Σ (N n + F), ω̇ = T/I − Σ n × F/(α r).
/// An active contact keeps touching: n·v̇ = −(qᵀHq − A_s·n). A sticking one keeps zero slip: (v̇ − A + r ṅ × ω + r n × ω̇)_t = 0.
/// A slipping one has F = −μ_s N ŝ. One linear system gives all loads and friction forces.
/// </remarks>
internal unsafe struct ContactSystem : IContactMotion
{
    /// <summary>Maximum number of contacts of a set.</summary>
    public const int Most = 6;

    private const int Limits = (int)Limit.HoldSpin + 1;

    /// <summary>The events that end a piece; those from <see cref="Rest"/> on belong to the bearer.</summary>
    private enum Limit
    {
        Load,
        Grip,
        Slip,
        Opening,
        Bearer,
        Rest,
        Spin,
        Roll,
        Hold,
        HoldSpin,
    }

    public Surroundings Around;
    public World World;
    public SetContact* Contacts;
    public int Count;

    /// <summary>The contact at which rolling resistance and drilling friction act; −1 for none.</summary>
    public int Bearer;

    /// <summary>True if another contact has as much load as the bearer, whichever of the two is the bearer.</summary>
    public bool IsTied;
    public DragBranch Branch;
    public ulong Nets;
    public ulong NetSides;

    /// <inheritdoc cref="FlightSystem.NetsSlack"/>
    public ulong? NetsSlack;

    /// <summary>The direction that the contacts leave free, in which the ball rolls from a standstill; zero if there is none.</summary>
    public Vector3d Along;

    /// <summary>True if rolling resistance holds a ball at a standstill, so that it only spins.</summary>
    public bool Pinned;

    /// <summary>The holding force per mass, m/s².</summary>
    public double Held;

    /// <summary>The rates with which the modes were determined.</summary>
    public MotionRates Start;

    /// <summary>Sign of the spin about the bearer's normal, relative to the bearer. Drilling friction keeps this sign.</summary>
    public double SpinSign;

    /// <summary>True if drilling friction holds the spin about the bearer's normal equal to the bearer's spin.</summary>
    public bool HoldsSpin;

    /// <summary>The holding torque per moment of inertia, rad/s².</summary>
    public double HeldSpin;

    public ForceTrace* Trace { get; set; }

    /// <summary>Forgets the custom forces so far: the next ones are those at the start of a piece.</summary>
    public readonly void BeginTrace()
    {
        if (Trace != null)
        {
            Trace->Begin(Around.Radius);
        }
    }

    public void Rates(double time, in Motion at, out MotionRates rates)
    {
        for (int i = 0; i < Count; i++)
        {
            Contacts[i].Look(World, time, in at);
        }

        rates = ContactForces.Solve(ref this, in at.Spin, Free(time, in at));
    }

    public readonly int Margins => Limits * Count;

    public void Look(double time, in Motion at) => Rates(time, in at, out _);

    public readonly double Margin(int index, double time, in Motion at)
    {
        var limit = (Limit)(index % Limits);
        index /= Limits;
        ref readonly SetContact contact = ref Contacts[index];
        if (limit >= Limit.Rest && index != Bearer)
        {
            return 0;
        }

        switch (limit)
        {
            case Limit.Load when contact.Bears:
                return contact.Load - ContactTolerances.LeastLoad;
            case Limit.Grip when contact.Bears && contact.Sticks:
                return contact.Grip;
            case Limit.Slip when contact.Bears && !contact.Sticks && contact.Resistance.Rubs && contact.Slip != Vector3d.Zero:
                return Vector3d.Dot(in contact.Slip, in contact.Direction);
            case Limit.Opening when !contact.Bears:
                return contact.Opening + ContactTolerances.LeastLoad;
            case Limit.Bearer when contact.Bears && Bearer >= 0 && !IsTied && index != Bearer && contact.Sticks == Contacts[Bearer].Sticks:
                return (Contacts[Bearer].Load * (1.0 + ContactTolerances.SameLoad)) - contact.Load;
            case Limit.Rest:
                return World.AboveRest(in at, World.ByIndex[contact.Collider], time);
            case Limit.Spin when contact.Resistance.Drills && SpinSign != 0:
                return SpinSign * (Vector3d.Dot(in at.Spin, in contact.Normal) - contact.CarrierSpin);
            case Limit.Roll when contact.Sticks && !Pinned:
                return Vector3d.Dot(in contact.RollingVelocity, in Along);
            case Limit.Hold when Pinned:
                return contact.MostRolling - Math.Abs(Held);
            case Limit.HoldSpin when HoldsSpin:
                return MostDrilling(in contact) - Math.Abs(HeldSpin);
            default:
                return 0;
        }
    }

    public readonly double LongestPart(in Motion at, in MotionRates rates) => World.NetForces.Longest(Nets, NetSides, in at.Position, in at.Velocity);

    public readonly void Move(ref BallState s, in Motion from, in MotionStep step)
    {
        s.BaseOrientation = s.BaseOrientation.Turned(in step.Rotation);
        s.Position = step.End.Position;
        s.Velocity = step.End.Velocity;
        s.SpinAxis = step.End.Spin;
        s.AirDistance = step.End.AirDistance;
    }

    /// <summary>b μ_s N/I, rad/s².</summary>
    public readonly double MostDrilling(in SetContact contact) => contact.Resistance.MostDrilling(contact.Load) * World.Ball.Mass / World.Ball.MomentOfInertia;

    /// <summary>Computes the forces on the ball without contacts.</summary>
    public readonly MotionRates Free(double time, in Motion at)
    {
        bool sticks = Bearer >= 0 && Contacts[Bearer].Sticks;
        MotionRates free = new FreeForces(Around, Branch, sticks ? MotionState.Rolling : MotionState.Sliding, time, in at, Trace)
            .Supported(Bearer < 0 ? Vector3d.Zero : Contacts[Bearer].Normal, sticks);
        if (Nets == 0)
        {
            return free;
        }

        MotionRates nets = World.NetForces.Push(Nets, NetSides, NetsSlack, in at);
        int carrier = HeaviestOnNets();
        Vector3d push = carrier < 0 ? nets.Acceleration : SurfaceSystem.Tangential(nets.Acceleration, in Contacts[carrier].Normal);
        return new MotionRates(free.Acceleration + push, free.SpinAcceleration + nets.SpinAcceleration, free.AirSpeed);
    }

    /// <summary>Returns the contact whose load the nets do not change; −1 if the net's force counts in full.</summary>
    /// <remarks>The end of a net is no such contact: the net pulls the ball off it. Next to an end, it is the surface with the greatest load.</remarks>
    private readonly int HeaviestOnNets()
    {
        if (Bearer < 0 || !World.ByIndex[Contacts[Bearer].Collider].IsNetEnd)
        {
            return Bearer;
        }

        int heaviest = -1;
        for (int i = 0; i < Count; i++)
        {
            bool carries = Contacts[i].Bears && !World.ByIndex[Contacts[i].Collider].IsNetEnd;
            heaviest = carries && (heaviest < 0 || Contacts[i].Load > Contacts[heaviest].Load) ? i : heaviest;
        }

        return heaviest;
    }

    /// <summary>Returns the forces on a ball at rest, per mass. In the published profile they exclude the air.</summary>
    public readonly Vector3d PushAtRest(double time, in Motion still)
    {
        if (World.SharesAir)
        {
            return Free(time, in still).Acceleration;
        }

        Vector3d nets = Nets == 0 ? Vector3d.Zero : World.NetForces.Push(Nets, NetSides, NetsSlack, in still).Acceleration;
        return new FreeForces(Around, Branch, MotionState.Rolling, time, in still).AtRest + nets;
    }
}
