using System.Runtime.CompilerServices;

namespace FootballPhysics.Contacts;

/// <summary>Solves the loads and friction forces of a contact set with locked modes.</summary>
/// <remarks>
/// The forces solve one linear system, with one unknown per load and two per sticking contact. If the solution is not unique, it takes the solution
/// with the least sum of squares.
/// </remarks>
internal static unsafe class ContactForces
{
    /// <summary>Adds the forces of the contacts to the accelerations, and stores the load and the friction of each contact.</summary>
    /// <param name="system">The contacts, with their normals and slips at this state.</param>
    /// <param name="spin">Spin of the ball, rad/s.</param>
    /// <param name="acceleration">Acceleration without the contacts, m/s²; replaced by the acceleration with them.</param>
    /// <param name="spinAcceleration">The same for the spin, rad/s².</param>
    public static void Solve(ref ContactSystem system, in Vector3d spin, ref Vector3d acceleration, ref Vector3d spinAcceleration)
    {
        if (system.Bearer >= 0)
        {
            // The damped spin about the normal: ω̇_n = −(c_ω/I) (ω − Ω)·n.
            ref readonly SetContact bearer = ref system.Contacts[system.Bearer];
            spinAcceleration -= bearer.Damping * (Vector3d.Dot(in spin, in bearer.Normal) - bearer.CarrierSpin) * bearer.Normal;
        }

        SolveAll(ref system, in spin, ref acceleration, ref spinAcceleration);
        for (int i = 0; i < system.Count; i++)
        {
            ref SetContact contact = ref system.Contacts[i];
            contact.Opening = Vector3d.Dot(in contact.Normal, in acceleration) + contact.Centripetal;
        }
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
        double* copy = stackalloc double[ContactRows.Most * ContactRows.Most];
        new Span<double>(z, size).Clear();
        new Span<double>(g, size * size).CopyTo(new Span<double>(copy, size * size));
        SetLine(in first, in second, z + firstRow);
        SetLine(in second, in first, z + secondRow);
        if (!ContactRows.SolveBraced(copy, b, z, size))
        {
            return false;
        }

        double share = FrictionBrace.Share(b + firstRow, z + firstRow, first.Sliding, b + secondRow, z + secondRow, second.Sliding);
        for (int k = 0; k < size; k++)
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
    /// <returns>The number of unknowns.</returns>
    private static int SetRows(in ContactSystem system, int index, in Vector3d spin, ForceRow* rows)
    {
        ref readonly SetContact contact = ref system.Contacts[index];
        SetLoad(in system, index, out rows[0]);
        if (!contact.Sticks)
        {
            return 1;
        }

        double r = system.World.Ball.Radius;
        double perTurn = 1.0 / (system.World.Ball.InertiaFactor * r);
        Vector3d target = Target(in contact, r, in spin);
        rows[1] = Stick(in contact.Normal, in contact.First, r, perTurn, in target);
        rows[2] = Stick(in contact.Normal, in contact.Second, r, perTurn, in target);
        return 3;
    }

    /// <summary>Sets the row of a load: n·v̇ = −(qᵀHq − A_s·n). If the contact slips, its friction is included.</summary>
    private static void SetLoad(in ContactSystem system, int index, out ForceRow row)
    {
        ref readonly SetContact contact = ref system.Contacts[index];
        row = new ForceRow { AlongV = contact.Normal, Target = -contact.Centripetal, PushV = contact.Normal };
        if (!contact.Sticks)
        {
            Vector3d direction = contact.SlipDirection;
            double perTurn = 1.0 / (system.World.Ball.InertiaFactor * system.World.Ball.Radius);
            row.PushV -= contact.Sliding * direction;
            row.PushW += contact.Sliding * perTurn * Vector3d.Cross(in contact.Normal, in direction);
        }

        if (index == system.Bearer)
        {
            AddResistance(in system, in contact, ref row);
        }
    }

    /// <summary>Adds rolling resistance (c₀ + c₁|v|) N/m against the motion, and drilling friction b μ_s N/I against the spin about the
    /// normal.</summary>
    private static void AddResistance(in ContactSystem system, in SetContact contact, ref ForceRow load)
    {
        load.PushW -= system.SpinSign * contact.Drilling * contact.Normal;
        if (!contact.Sticks || system.Pinned || system.Along == Vector3d.Zero)
        {
            return;
        }

        double speed = contact.RollingVelocity.Length;
        Vector3d direction = speed > 0 && !(Vector3d.Dot(in contact.RollingVelocity, in system.Along) < 0) ? contact.RollingVelocity / speed : system.Along;
        double share = contact.Rolling + (contact.RollingBySpeed * speed);
        load.PushV -= share * direction;
        load.PushW -= share / system.World.Ball.Radius * Vector3d.Cross(in contact.Normal, in direction);
    }

    /// <summary>Returns the row of a friction component t: t·(v̇ + r n × ω̇) = t·(A − r ṅ × ω).</summary>
    /// <remarks>A force t changes the spin by −n × t/(α r).</remarks>
    private static ForceRow Stick(in Vector3d normal, in Vector3d along, double r, double perTurn, in Vector3d target) => new()
    {
        AlongV = along,
        AlongW = r * Vector3d.Cross(in along, in normal),
        Target = Vector3d.Dot(in target, in along),
        PushV = along,
        PushW = -perTurn * Vector3d.Cross(in normal, in along),
    };

    /// <summary>Returns the slip rate that keeps a contact without slip, A − r ṅ × ω.</summary>
    private static Vector3d Target(in SetContact contact, double r, in Vector3d spin) => contact.SurfaceRate - (r * Vector3d.Cross(in contact.Turning, in spin));

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
