using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// A ball on several surfaces at once, with the contacts and their modes locked (contacts.md, Rates under a fixed set). With n, ṅ, V_c and A of each contact,
/// v̇ = a + Σ (N n + F), ω̇ = T/I − Σ n × F/(α r): a contact that bears keeps touching, n·v̇ = −(qᵀHq − A_s·n); one that sticks keeps its slip at zero,
/// (v̇ − A + r ṅ × ω + r n × ω̇)_t = 0; one that slips has F = −μ_s N ŝ. One linear system gives all loads and friction forces.
/// </summary>
internal unsafe struct ContactSystem : IMotionSystem
{
    /// <summary>Contacts that a set holds at most.</summary>
    public const int Most = 6;

    /// <summary>Forces that are brought back into a friction cone are so far inside, as a share of the square.</summary>
    private const double Inside = 1.0 - 1e-9;

    public Surroundings Around;
    public World World;
    public SetContact* Contacts;
    public int Count;

    /// <summary>The contact that rolling resistance and drilling friction belong to; −1 for none.</summary>
    public int Bearer;

    /// <summary>True if another contact has as much load as the bearer, whichever of the two is the bearer.</summary>
    public bool IsTied;
    public DragBranch Branch;
    public ulong Nets;
    public ulong NetSides;

    /// <summary>The direction that the contacts leave to the velocity, and that the ball rolls in from a standstill; zero where they leave none.</summary>
    public Vector3d Along;

    /// <summary>True when rolling resistance holds a ball that stands on its spot, and only spins.</summary>
    public bool Pinned;

    /// <summary>What holds it, m/s².</summary>
    public double Held;

    /// <summary>The accelerations for which the modes were found, m/s² and rad/s².</summary>
    public Vector3d Acceleration;
    public Vector3d SpinAcceleration;

    /// <summary>Which way it spins about the bearer's normal, relative to that: drilling friction keeps to it.</summary>
    public double SpinSign;

    /// <summary>True when drilling friction holds the spin about the bearer's normal at that of the bearer.</summary>
    public bool HoldsSpin;

    /// <summary>What holds it, rad/s².</summary>
    public double HeldSpin;

    public void Rates(double time, in Motion at, out MotionRates rates)
    {
        for (int i = 0; i < Count; i++)
        {
            Contacts[i].Look(World, time, in at);
        }

        Free(time, in at, out Vector3d acceleration, out Vector3d spinAcceleration, out double airSpeed);
        Solve(in at.Spin, ref acceleration, ref spinAcceleration);
        rates = new MotionRates(in acceleration, in spinAcceleration, airSpeed);
    }

    public readonly double LongestPart(in Motion at, double jerk) => World.LongestPartInNets(Nets, NetSides, in at, jerk);

    public readonly void Move(ref BallState s, in Motion from, in MotionStep step)
    {
        s.BaseOrientation = s.BaseOrientation.Turned(in step.Rotation);
        s.Position = step.End.Position;
        s.Velocity = step.End.Velocity;
        s.SpinAxis = step.End.Spin;
        s.AirDistance = step.End.AirDistance;
    }

    /// <summary>What acts on the ball but for its contacts.</summary>
    public readonly void Free(double time, in Motion at, out Vector3d acceleration, out Vector3d spinAcceleration, out double airSpeed)
    {
        Vector3d u = at.Velocity - Around.Wind;
        bool sticks = Bearer >= 0 && Contacts[Bearer].Sticks;
        var ball = new ForceInput(time, in at.Position, in at.Velocity, in u, in at.Spin, sticks ? MotionState.Rolling : MotionState.Sliding, at.AirDistance);
        Around.Air.Evaluate(in ball, Branch, out AirFactors air);
        u = air.AirVelocity;
        airSpeed = air.AirSpeed;

        // a_air = L (ω × u) − D u; how much of it counts is the ground's to say.
        Vector3d push = air.Acceleration;
        if (World.AirActs)
        {
            push += (air.Lift * Vector3d.Cross(in at.Spin, in u)) - (air.Drag * u);
        }

        spinAcceleration = (-air.Decay * at.Spin) + air.SpinAcceleration;
        if (!World.AirLoads && Bearer >= 0)
        {
            push = SurfaceSystem.Tangential(in push, in Contacts[Bearer].Normal);
        }

        if (!World.SharesAir && sticks)
        {
            // The air moves a ball that rolls without a share for its spin, which follows: ω̇_t = n × a_air/r.
            ref readonly SetContact bearer = ref Contacts[Bearer];
            Vector3d along = SurfaceSystem.Tangential(in push, in bearer.Normal);
            spinAcceleration = (Vector3d.Dot(in spinAcceleration, in bearer.Normal) * bearer.Normal) + (Vector3d.Cross(in bearer.Normal, in along) / Around.Radius);
        }

        acceleration = push + new Vector3d(0, Around.Upward, 0);
        if (Nets != 0)
        {
            MotionRates nets = World.PushOfNets(Nets, NetSides, in at);
            acceleration += Bearer < 0 ? nets.Acceleration : SurfaceSystem.Tangential(nets.Acceleration, in Contacts[Bearer].Normal);
            spinAcceleration += nets.SpinAcceleration;
        }
    }

    /// <summary>What acts on a ball at rest; in the published profile the air does not.</summary>
    public readonly Vector3d PushAtRest(double time, in Motion still)
    {
        if (World.SharesAir)
        {
            Free(time, in still, out Vector3d acceleration, out _, out _);
            return acceleration;
        }

        Vector3d u = still.Velocity - Around.Wind;
        Around.Air.Evaluate(new ForceInput(time, in still.Position, in still.Velocity, in u, in still.Spin, MotionState.Rolling), Branch, out AirFactors air);
        Vector3d nets = Nets == 0 ? Vector3d.Zero : World.PushOfNets(Nets, NetSides, in still).Acceleration;
        return air.Acceleration + new Vector3d(0, Around.Upward, 0) + nets;
    }

    /// <summary>Adds what the contacts do, and says what each gives.</summary>
    [SkipLocalsInit]
    public void Solve(in Vector3d spin, ref Vector3d acceleration, ref Vector3d spinAcceleration)
    {
        Row* rows = stackalloc Row[ContactRows.Most];
        double* g = stackalloc double[ContactRows.Most * ContactRows.Most];
        double* x = stackalloc double[ContactRows.Most];
        double r = World.Ball.Radius;
        double perTurn = 1.0 / (World.Ball.InertiaFactor * r);
        if (Bearer >= 0)
        {
            // ω̇_n = −(c_ω/I) (ω − Ω)·n
            ref readonly SetContact bearer = ref Contacts[Bearer];
            spinAcceleration -= bearer.Damping * (Vector3d.Dot(in spin, in bearer.Normal) - bearer.CarrierSpin) * bearer.Normal;
        }

        int size = 0;
        for (int i = 0; i < Count; i++)
        {
            ref SetContact contact = ref Contacts[i];
            if (!contact.Bears)
            {
                continue;
            }

            ref Row load = ref rows[size++];
            load.AlongV = contact.Normal;
            load.AlongW = default;
            load.Asked = -contact.Centripetal;
            load.PushV = contact.Normal;
            load.PushW = default;
            if (!contact.Sticks)
            {
                Vector3d direction = contact.SlipDirection;
                load.PushV -= contact.Sliding * direction;
                load.PushW += contact.Sliding * perTurn * Vector3d.Cross(in contact.Normal, in direction);
            }

            if (i == Bearer)
            {
                AddResistance(in contact, ref load);
            }

            if (contact.Sticks)
            {
                Vector3d asked = contact.SurfaceRate - (r * Vector3d.Cross(in contact.Turning, in spin));
                SetStick(ref rows[size++], in contact.Normal, in contact.First, r, perTurn, in asked);
                SetStick(ref rows[size++], in contact.Normal, in contact.Second, r, perTurn, in asked);
            }
        }

        // What holds a ball that stands, and its spin, is no load and no friction force: it is eliminated first, so that it has no say in which of several answers is the least.
        Vector3d normal = Bearer >= 0 ? Contacts[Bearer].Normal : Vector3d.Zero;
        Vector3d turning = Vector3d.Cross(in normal, in Along) / r;
        double held = 0;
        double heldSpin = 0;
        if (Pinned)
        {
            held = Vector3d.Dot(Contacts[Bearer].MaterialRate - acceleration, in Along);
            acceleration += held * Along;
            spinAcceleration += held * turning;
        }

        if (HoldsSpin)
        {
            // d(ω·n)/dt = ω̇·n + ω·ṅ stays zero.
            heldSpin = -Vector3d.Dot(in spin, Contacts[Bearer].Turning) - Vector3d.Dot(in spinAcceleration, in normal);
            spinAcceleration += heldSpin * normal;
        }

        for (int i = 0; i < size; i++)
        {
            ref Row row = ref rows[i];
            row.Held = Pinned ? -Vector3d.Dot(in row.PushV, in Along) : 0;
            row.HeldSpin = HoldsSpin ? -Vector3d.Dot(in row.PushW, in normal) : 0;
            row.PushV += row.Held * Along;
            row.PushW += (row.Held * turning) + (row.HeldSpin * normal);
        }

        for (int i = 0; i < size; i++)
        {
            ref readonly Row row = ref rows[i];
            x[i] = row.Asked - Vector3d.Dot(in row.AlongV, in acceleration) - Vector3d.Dot(in row.AlongW, in spinAcceleration);
            for (int j = 0; j < size; j++)
            {
                g[(i * size) + j] = Vector3d.Dot(in row.AlongV, in rows[j].PushV) + Vector3d.Dot(in row.AlongW, in rows[j].PushW);
            }
        }

        if (size > 0)
        {
            double* z = stackalloc double[ContactRows.Most];
            if (PairThatSticks(z, size, out int first, out int second))
            {
                // The direction from one contact point to the other: along it two sticking contacts say the same, and may press without moving anything.
                double* copy = stackalloc double[ContactRows.Most * ContactRows.Most];
                for (int i = 0; i < size * size; i++)
                {
                    copy[i] = g[i];
                }

                if (ContactRows.SolveBraced(copy, x, z, size))
                {
                    Brace(x, z, size, first, second);
                }
                else
                {
                    ContactRows.Solve(g, x, size);
                }
            }
            else
            {
                ContactRows.Solve(g, x, size);
            }
        }

        for (int i = 0; i < size; i++)
        {
            acceleration += x[i] * rows[i].PushV;
            spinAcceleration += x[i] * rows[i].PushW;
            held += x[i] * rows[i].Held;
            heldSpin += x[i] * rows[i].HeldSpin;
        }

        int next = 0;
        for (int i = 0; i < Count; i++)
        {
            ref SetContact contact = ref Contacts[i];
            contact.Load = contact.Bears ? x[next++] : 0;
            contact.Friction = default;
            contact.Opening = Vector3d.Dot(in contact.Normal, in acceleration) + contact.Centripetal;
            if (contact.Bears && contact.Sticks)
            {
                contact.Friction = (x[next] * contact.First) + (x[next + 1] * contact.Second);
                next += 2;
            }
        }

        Held = held;
        HeldSpin = heldSpin;
    }

    /// <summary>
    /// Forces that are not determined: a ball that sticks to two surfaces may press them apart, along the line between the contact points, without moving. Where the
    /// least forces leave a friction cone, it does so by as little as brings them back into both.
    /// </summary>
    private readonly void Brace(double* x, double* z, int size, int first, int second)
    {
        int row = RowOf(first);
        int other = RowOf(second);
        if (!IsBeyondCone(x + row, in Contacts[first]) && !IsBeyondCone(x + other, in Contacts[second]))
        {
            return;
        }

        double low = double.NegativeInfinity;
        double high = double.PositiveInfinity;
        Allow(x + row, z + row, in Contacts[first], ref low, ref high);
        Allow(x + other, z + other, in Contacts[second], ref low, ref high);
        double share = low > 0 ? low : high < 0 ? high : 0;
        for (int k = 0; k < size && low <= high && Math.Abs(share) < double.MaxValue; k++)
        {
            x[k] += share * z[k];
        }
    }

    /// <summary>True where exactly two contacts stick: n₁ − n₂ as load and friction of both is the force that moves nothing, of length 1.</summary>
    private readonly bool PairThatSticks(double* z, int size, out int first, out int second)
    {
        first = -1;
        second = -1;
        for (int i = 0; i < Count; i++)
        {
            if (Contacts[i].Width == 3)
            {
                if (second >= 0)
                {
                    return false;
                }

                second = first >= 0 ? i : -1;
                first = first >= 0 ? first : i;
            }
        }

        if (second < 0)
        {
            return false;
        }

        Vector3d line = Contacts[first].Normal - Contacts[second].Normal;
        line = 1.0 / (Math.Sqrt(2.0) * line.Length) * line;
        for (int k = 0; k < size; k++)
        {
            z[k] = 0;
        }

        Split(z + RowOf(first), in Contacts[first], in line);
        Split(z + RowOf(second), in Contacts[second], -line);
        return true;
    }

    /// <summary>The first unknown of a contact.</summary>
    private readonly int RowOf(int contact)
    {
        int row = 0;
        for (int i = 0; i < contact; i++)
        {
            row += Contacts[i].Width;
        }

        return row;
    }

    private static bool IsBeyondCone(double* x, in SetContact contact) =>
        (x[1] * x[1]) + (x[2] * x[2]) > contact.Sliding * contact.Sliding * x[0] * x[0] || x[0] < 0;

    private static void Split(double* into, in SetContact contact, in Vector3d force)
    {
        into[0] = Vector3d.Dot(in force, in contact.Normal);
        into[1] = Vector3d.Dot(in force, in contact.First);
        into[2] = Vector3d.Dot(in force, in contact.Second);
    }

    /// <summary>Narrows the shares λ of a change z for which the friction stays in its cone, |F + λ z_F| ≤ μ (N + λ z_N), on the side where the load grows.</summary>
    private static void Allow(double* x, double* z, in SetContact contact, ref double low, ref double high)
    {
        double mu = contact.Sliding * contact.Sliding * Inside;
        double a = (z[1] * z[1]) + (z[2] * z[2]) - (mu * z[0] * z[0]);
        double b = (x[1] * z[1]) + (x[2] * z[2]) - (mu * x[0] * z[0]);
        double c = (x[1] * x[1]) + (x[2] * x[2]) - (mu * x[0] * x[0]);
        double square = (b * b) - (a * c);
        double root = Math.Sqrt(Math.Max(0, square));
        if (a < 0)
        {
            // Beyond the larger root, where the load is positive.
            double least = (-b - (z[0] > 0 ? root : -root)) / a;
            low = z[0] > 0 ? Math.Max(low, least) : low;
            high = z[0] < 0 ? Math.Min(high, least) : high;
        }
        else if (a > 0 && square >= 0)
        {
            low = Math.Max(low, (-b - root) / a);
            high = Math.Min(high, (-b + root) / a);
        }
        else
        {
            high = double.NegativeInfinity;
        }
    }

    /// <summary>Rolling resistance takes (c₀ + c₁|v|) N/m from the motion, spin and all; drilling friction takes b μ_s N/I from the spin about the normal.</summary>
    private readonly void AddResistance(in SetContact contact, ref Row load)
    {
        load.PushW -= SpinSign * contact.Drilling * contact.Normal;
        if (!contact.Sticks || Pinned || Along == Vector3d.Zero)
        {
            return;
        }

        double speed = contact.RollingVelocity.Length;
        Vector3d direction = speed > 0 && !(Vector3d.Dot(in contact.RollingVelocity, in Along) < 0) ? contact.RollingVelocity / speed : Along;
        double share = contact.Rolling + (contact.RollingBySpeed * speed);
        load.PushV -= share * direction;
        load.PushW -= share / World.Ball.Radius * Vector3d.Cross(in contact.Normal, in direction);
    }

    private static void SetStick(ref Row row, in Vector3d normal, in Vector3d along, double r, double perTurn, in Vector3d asked)
    {
        // t·(v̇ + r n × ω̇) = t·(A − r ṅ × ω); a push t turns by −n × t/(α r).
        row.AlongV = along;
        row.AlongW = r * Vector3d.Cross(in along, in normal);
        row.Asked = Vector3d.Dot(in asked, in along);
        row.PushV = along;
        row.PushW = -perTurn * Vector3d.Cross(in normal, in along);
    }

    /// <summary>An unknown: what a unit of it does to the ball, and the condition that it is there for.</summary>
    private struct Row
    {
        public Vector3d AlongV;
        public Vector3d AlongW;
        public double Asked;
        public Vector3d PushV;
        public Vector3d PushW;

        /// <summary>What rolling resistance and drilling friction take of the push, where they hold the ball.</summary>
        public double Held;
        public double HeldSpin;
    }
}
