using System.Runtime.CompilerServices;

namespace FootballPhysics.Contacts;

/// <summary>Solves the loads and friction forces of a contact set with locked modes.</summary>
/// <remarks>
/// The forces solve one linear system, with one unknown per load and two per sticking contact. If the solution is not unique, it takes the solution
/// with the least sum of squares.
/// </remarks>
internal static unsafe class ContactForces
{
    /// <summary>Adds the forces of the contacts to the rates, and stores the load and the friction of each contact.</summary>
    /// <param name="system">The contacts, with their normals and slips at this state.</param>
    /// <param name="spin">Spin of the ball, rad/s.</param>
    /// <param name="free">The rates without the contacts.</param>
    public static MotionRates Solve(ref ContactSystem system, in Vector3d spin, in MotionRates free)
    {
        Vector3d acceleration = free.Acceleration;
        Vector3d spinAcceleration = free.SpinAcceleration;
        if (system.Bearer >= 0)
        {
            // The damped spin about the normal: ω̇_n = −(c_ω/I) (ω − Ω)·n, with the damping c_ω and the carrier's spin Ω.
            ref readonly SetContact bearer = ref system.Contacts[system.Bearer];
            spinAcceleration -= bearer.Resistance.Damping / system.World.Ball.MomentOfInertia * (Vector3d.Dot(in spin, in bearer.Normal) - bearer.CarrierSpin) * bearer.Normal;
        }

        SolveAll(ref system, in spin, ref acceleration, ref spinAcceleration);
        for (int i = 0; i < system.Count; i++)
        {
            ref SetContact contact = ref system.Contacts[i];
            contact.Opening = Vector3d.Dot(in contact.Normal, in acceleration) + contact.Centripetal;
        }

        return new MotionRates(in acceleration, in spinAcceleration, free.AirSpeed);
    }

    /// <summary>Returns the friction of a contact in the last solution, per mass, m/s²; that of the bearer includes rolling resistance.</summary>
    public static Vector3d FrictionOf(in ContactSystem system, int index)
    {
        ref readonly SetContact contact = ref system.Contacts[index];
        ForceRow row = default;
        SetLoad(in system, index, 0, ref row);

        // The force of a unit of load, apart from the load itself, is sliding friction or rolling resistance.
        Vector3d friction = contact.Friction + (contact.Load * (row.PushV - contact.Normal));
        return index == system.Bearer && system.Pinned ? friction + (system.Held * system.Along) : friction;
    }

    /// <summary>Sets G, the response of each condition to a unit of each force, and b, the remainder of each condition without these
    /// forces.</summary>
    private static void SetSystem(ForceRow* rows, double* g, double* b, int size, in Vector3d acceleration, in Vector3d spinAcceleration)
    {
        for (int i = 0; i < size; i++)
        {
            ref readonly ForceRow row = ref rows[i];
            b[i] = row.Target - Vector3d.Dot(in row.AlongV, in acceleration) - Vector3d.Dot(in row.AlongW, in spinAcceleration);
            for (int j = 0; j < size; j++)
            {
                g[(i * size) + j] = Vector3d.Dot(in row.AlongV, in rows[j].PushV) + Vector3d.Dot(in row.AlongW, in rows[j].PushW);
            }
        }
    }

    /// <summary>Solves all forces at once.</summary>
    [SkipLocalsInit]
    private static void SolveAll(ref ContactSystem system, in Vector3d spin, ref Vector3d acceleration, ref Vector3d spinAcceleration)
    {
        ForceRow* rows = stackalloc ForceRow[ContactRows.Most];
        double* g = stackalloc double[ContactRows.Most * ContactRows.Most];
        double* x = stackalloc double[ContactRows.Most];
        int first = -1;
        int second = -1;
        int sticking = 0;
        int firstRow = 0;
        int secondRow = 0;
        int size = 0;
        for (int i = 0; i < system.Count; i++)
        {
            if (system.Contacts[i].Width == 3)
            {
                sticking++;
                secondRow = size;
                firstRow = first < 0 ? size : firstRow;
                second = i;
                first = first < 0 ? i : first;
            }

            size += system.Contacts[i].Bears ? SetRows(in system, i, in spin, rows + size) : 0;
        }

        // First eliminate the resistance that holds a ball at a standstill, and its spin: the sum of squares of the forces must not include them.
        Vector3d normal = system.Bearer >= 0 ? system.Contacts[system.Bearer].Normal : Vector3d.Zero;
        Vector3d turning = Vector3d.Cross(in normal, in system.Along) / system.World.Ball.Radius;
        double held = 0;
        if (system.Pinned)
        {
            held = Vector3d.Dot(system.Contacts[system.Bearer].MaterialRate - acceleration, in system.Along);
            acceleration += held * system.Along;
            spinAcceleration += held * turning;
            for (int i = 0; i < size; i++)
            {
                rows[i].Held = -Vector3d.Dot(in rows[i].PushV, in system.Along);
                rows[i].PushV += rows[i].Held * system.Along;
                rows[i].PushW += rows[i].Held * turning;
            }
        }

        if (system.HoldsSpin)
        {
            HoldSpin(ref system, in spin, ref spinAcceleration, rows, size);
        }

        SetSystem(rows, g, x, size, in acceleration, in spinAcceleration);
        if (size > 0 && (sticking != 2 || !SolvePair(g, x, size, in system.Contacts[first], firstRow, in system.Contacts[second], secondRow)))
        {
            ContactRows.Solve(g, x, size);
        }

        for (int i = 0; i < size; i++)
        {
            acceleration += x[i] * rows[i].PushV;
            spinAcceleration += x[i] * rows[i].PushW;
            held += x[i] * rows[i].Held;
            system.HeldSpin += x[i] * rows[i].HeldSpin;
        }

        system.Held = held;
        Store(ref system, x);
    }

    /// <summary>Solves all forces if exactly two contacts stick.</summary>
    /// <returns>False if more than the force along the line between the contact points is undetermined; b is then unchanged.</returns>
    [SkipLocalsInit]
    private static bool SolvePair(double* g, double* b, int size, in SetContact first, int firstRow, in SetContact second, int secondRow)
    {
        double* z = stackalloc double[ContactRows.Most];
        new Span<double>(z, size).Clear();
        SetLine(in first, in second, z + firstRow);
        SetLine(in second, in first, z + secondRow);
        if (!ContactRows.SolveBraced(g, b, z, size))
        {
            return false;
        }

        double share = FrictionBrace.Share(b + firstRow, z + firstRow, first.Resistance.Sliding, b + secondRow, z + secondRow, second.Resistance.Sliding);
        for (int k = 0; k < size && share != 0; k++)
        {
            b[k] += share * z[k];
        }

        return true;
    }

    /// <summary>Adds the condition that drilling friction holds the spin about the bearer's normal: d(ω·n)/dt = ω̇·n + ω·ṅ stays
    /// zero.</summary>
    private static void HoldSpin(ref ContactSystem system, in Vector3d spin, ref Vector3d spinAcceleration, ForceRow* rows, int size)
    {
        ref readonly SetContact bearer = ref system.Contacts[system.Bearer];
        system.HeldSpin = -Vector3d.Dot(in spin, in bearer.Turning) - Vector3d.Dot(in spinAcceleration, in bearer.Normal);
        spinAcceleration += system.HeldSpin * bearer.Normal;
        for (int i = 0; i < size; i++)
        {
            ref ForceRow row = ref rows[i];
            row.HeldSpin = -Vector3d.Dot(in row.PushW, in bearer.Normal);
            row.PushW += row.HeldSpin * bearer.Normal;
        }
    }

    /// <summary>Stores the solution.</summary>
    private static void Store(ref ContactSystem system, double* x)
    {
        int next = 0;
        for (int i = 0; i < system.Count; i++)
        {
            ref SetContact contact = ref system.Contacts[i];
            contact.Load = contact.Bears ? x[next++] : 0;
            contact.Friction = default;
            if (contact.Width == 3)
            {
                contact.Friction = (x[next] * contact.First) + (x[next + 1] * contact.Second);
                next += 2;
            }
        }
    }

    /// <summary>Sets the unknowns of an active contact: its load, and its friction if it sticks.</summary>
    /// <remarks>
    /// A sticking contact has t·(v̇ + r n × ω̇) = t·(A − r ṅ × ω) for its two directions t, and a force t changes the spin by −n × t/(α r). The first
    /// direction, the second and n are at right angles, so n × t is ± the other direction.
    /// </remarks>
    /// <returns>The number of unknowns.</returns>
    private static int SetRows(in ContactSystem system, int index, in Vector3d spin, ForceRow* rows)
    {
        ref readonly SetContact contact = ref system.Contacts[index];
        double r = system.World.Ball.Radius;
        double perTurn = 1.0 / (system.World.Ball.InertiaFactor * r);
        SetLoad(in system, index, perTurn, ref rows[0]);
        if (!contact.Sticks)
        {
            return 1;
        }

        Vector3d target = contact.IsFixed ? Vector3d.Zero : contact.SurfaceRate - (r * Vector3d.Cross(in contact.Turning, in spin));
        SetStick(in contact.First, in target, -r * contact.Second, -perTurn * contact.Second, ref rows[1]);
        SetStick(in contact.Second, in target, r * contact.First, perTurn * contact.First, ref rows[2]);
        return 3;
    }

    /// <summary>Sets the row of a load: n·v̇ = −(qᵀHq − A_s·n). If the contact slips, its friction is included.</summary>
    private static void SetLoad(in ContactSystem system, int index, double perTurn, ref ForceRow row)
    {
        ref readonly SetContact contact = ref system.Contacts[index];
        row.AlongV = contact.Normal;
        row.AlongW = default;
        row.Target = -contact.Centripetal;
        row.PushV = contact.Normal;
        row.PushW = default;
        row.Held = 0;
        row.HeldSpin = 0;
        if (!contact.Sticks)
        {
            Vector3d direction = contact.SlipDirection;
            row.PushV -= contact.Resistance.Sliding * direction;
            row.PushW = contact.Resistance.Sliding * perTurn * Vector3d.Cross(in contact.Normal, in direction);
        }

        if (index == system.Bearer)
        {
            AddResistance(in system, in contact, ref row);
        }
    }

    /// <summary>Sets the row of a friction component along a direction.</summary>
    private static void SetStick(in Vector3d along, in Vector3d target, in Vector3d alongSpin, in Vector3d pushSpin, ref ForceRow row)
    {
        row.AlongV = along;
        row.AlongW = alongSpin;
        row.Target = Vector3d.Dot(in target, in along);
        row.PushV = along;
        row.PushW = pushSpin;
        row.Held = 0;
        row.HeldSpin = 0;
    }

    /// <summary>Adds rolling resistance (c₀ + c₁|v|) N/m against the motion, and drilling friction b μ_s N/I against the spin about the
    /// normal.</summary>
    private static void AddResistance(in ContactSystem system, in SetContact contact, ref ForceRow load)
    {
        BallProperties ball = system.World.Ball;
        load.PushW -= system.SpinSign * contact.Resistance.Drilling * ball.Mass / ball.MomentOfInertia * contact.Normal;
        if (!contact.Sticks || system.Pinned || system.Along == Vector3d.Zero)
        {
            return;
        }

        double speed = contact.RollingVelocity.Length;
        Vector3d direction = speed > 0 && !(Vector3d.Dot(in contact.RollingVelocity, in system.Along) < 0) ? contact.RollingVelocity / speed : system.Along;
        double share = contact.Resistance.MostRolling(1, speed);
        load.PushV -= share * direction;
        load.PushW -= share / ball.Radius * Vector3d.Cross(in contact.Normal, in direction);
    }

    /// <summary>The unit force that two sticking contacts exert against each other along the line between the contact points: n₁ − n₂, at the first contact.</summary>
    private static void SetLine(in SetContact contact, in SetContact other, double* into)
    {
        Vector3d line = contact.Normal - other.Normal;
        line = 1.0 / (Math.Sqrt(2.0) * line.Length) * line;
        into[0] = Vector3d.Dot(in line, in contact.Normal);
        into[1] = Vector3d.Dot(in line, in contact.First);
        into[2] = Vector3d.Dot(in line, in contact.Second);
    }
}
