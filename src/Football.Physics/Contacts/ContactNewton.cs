namespace FootballPhysics.Contacts;

/// <summary>A semi-smooth Newton step on the impulses of a contact set.</summary>
/// <remarks>
/// With the modes (load, grip, slip) fixed, the impulses are the solution of one linear system. If they are undetermined, it applies the
/// change with
/// the least sum of squares. An example is a ball that grips both sides of a gutter.
/// </remarks>
internal static class ContactNewton
{
    /// <summary>Larger sets are left to Gauss–Seidel: the cost of a step grows with the third power of the number of contacts.</summary>
    private const int Most = 12;

    /// <summary>Improves impulses, velocity and spin.</summary>
    /// <param name="set">The contacts.</param>
    /// <param name="ball">The ball.</param>
    /// <param name="duration">The time, s.</param>
    /// <param name="resistance">Rolling and drilling resistance at one contact.</param>
    /// <param name="v">Velocity, m/s.</param>
    /// <param name="w">Spin, rad/s.</param>
    public static void Step(Span<Contact> set, BallProperties ball, double duration, ref TurningResistance resistance, ref Vector3d v, ref Vector3d w)
    {
        double r = ball.Radius;
        Span<int> pressing = stackalloc int[Most];
        int contacts = Pressing(set, duration, in v, resistance.Bearer, pressing, out int bearer);
        if (contacts > Most)
        {
            return;
        }

        int size = (3 * contacts) + (bearer < 0 ? 0 : 3);
        Span<Row> rows = stackalloc Row[size];
        Span<double> system = stackalloc double[size * (size + 1)];

        // Set up one row per unknown: its residual, and its derivatives with respect to v and ω.
        for (int i = 0; i < contacts; i++)
        {
            SetRows(rows.Slice(3 * i, 3), in set[pressing[i]], ball, duration, in v, in w, 3 * i);
        }

        if (bearer >= 0)
        {
            // The unknown r ω_t, which rolling resistance changes directly.
            ref readonly Contact contact = ref set[resistance.Bearer];
            Vector3d t1 = Tangent(in contact.Normal);
            Vector3d t2 = Vector3d.Cross(in contact.Normal, in t1);
            double share = contact.Load > 0 ? r * TurningResistance.MostRolling(in contact, ball, in v) / contact.Load : 0;
            Couple(
                rows.Slice(3 * contacts, 2), Vector3d.Zero, Vector3d.Zero, r * t1, r * t2, t1 / r, t2 / r,
                new Slipping(r * Vector3d.Dot(in w, in t1), r * Vector3d.Dot(in w, in t2)),
                new Slipping(r * Vector3d.Dot(in resistance.Rolling, in t1), r * Vector3d.Dot(in resistance.Rolling, in t2)),
                1.0, share, contact.Load, 3 * bearer);
            rows[size - 1] = Drilling(in contact, ball, duration, resistance.Drilling, in w, 3 * bearer);
        }

        // Residual + derivative × change = 0 is a linear system for the changes in all impulses.
        Fill(system, rows, size);
        if (!Eliminate(system, size))
        {
            return;
        }

        // Apply the changes in the impulses to v and ω.
        for (int i = 0; i < size; i++)
        {
            double change = system[(i * (size + 1)) + size];
            bool isLoad = i < 3 * contacts && i % 3 == 0;

            // Keep every load non-negative.
            change = isLoad ? Math.Max(change, -set[pressing[i / 3]].Load) : change;
            v += change * rows[i].PushV;
            w += change * rows[i].PushW;
            if (isLoad)
            {
                set[pressing[i / 3]].Load += change;
            }
            else if (i < 3 * contacts)
            {
                set[pressing[i / 3]].Friction += change * rows[i].PushV;
            }
            else if (i < size - 1)
            {
                resistance.Rolling += change * rows[i].PushW;
            }
            else
            {
                resistance.Drilling += change;
            }
        }
    }

    /// <summary>Sets the rows of a contact: its load, and its friction in two directions.</summary>
    private static void SetRows(Span<Row> rows, in Contact contact, BallProperties ball, double duration, in Vector3d v, in Vector3d w, int loadRow)
    {
        // Per unit mass: a tangential impulse changes the spin by 1/(α r) times the impulse, and the slip by (1 + α)/α times the impulse.
        double r = ball.Radius;
        double perTurn = 1.0 / (ball.InertiaFactor * r);
        double grip = ball.InertiaFactor / (1.0 + ball.InertiaFactor);
        Vector3d n = contact.Normal;
        Vector3d t1 = Tangent(in n);
        Vector3d t2 = Vector3d.Cross(in n, in t1);

        // A loaded contact must stop closing. The load of any other contact must be zero.
        double closing = ContactSolver.Closing(in contact, duration, in v);
        bool bears = contact.Load - closing > 0;
        rows[0] = new Row { AlongV = n, PushV = n, Residual = bears ? closing : contact.Load, OfMotion = bears ? 1 : 0, OfItself = bears ? 0 : 1, LoadRow = -1 };

        // The slip s = u_t + r n × ω; an impulse F changes the spin by −n × F/(α r).
        Vector3d relative = v - contact.Velocity;
        Couple(
            rows.Slice(1, 2), t1, t2, -r * t2, r * t1, -perTurn * t2, perTurn * t1,
            new Slipping(Vector3d.Dot(in relative, in t1) - (r * Vector3d.Dot(in w, in t2)), Vector3d.Dot(in relative, in t2) + (r * Vector3d.Dot(in w, in t1))),
            new Slipping(Vector3d.Dot(in contact.Friction, in t1), Vector3d.Dot(in contact.Friction, in t2)),
            grip, bears ? contact.Material.Resistance.Sliding : 0, contact.Load, loadRow);
    }

    /// <summary>Finds the contacts that have impulses or are about to get them. No other contact has an impulse after the step.</summary>
    /// <returns>Their number; more than <see cref="Most"/> if there are too many.</returns>
    private static int Pressing(Span<Contact> set, double duration, in Vector3d v, int bearer, Span<int> pressing, out int bearerAt)
    {
        int count = 0;
        bearerAt = -1;
        for (int i = 0; i < set.Length; i++)
        {
            ref readonly Contact contact = ref set[i];
            if (i != bearer && contact.Load == 0 && contact.Friction == Vector3d.Zero && !(contact.Load - ContactSolver.Closing(in contact, duration, in v) > 0))
            {
                continue;
            }

            if (count == pressing.Length)
            {
                return count + 1;
            }

            bearerAt = i == bearer ? count : bearerAt;
            pressing[count++] = i;
        }

        return count;
    }

    /// <summary>Sets the row of drilling friction: it stops the spin about the normal, or damps it and removes as much as the load
    /// allows.</summary>
    private static Row Drilling(in Contact contact, BallProperties ball, double duration, double drilling, in Vector3d w, int loadRow)
    {
        // Damping and drilling friction: ω_n = (ω_n − D)/(1 + k) ∓ c N.
        double about = Vector3d.Dot(in w, in contact.Normal);
        double damping = TurningResistance.Damping(in contact, ball, duration);
        double perLoad = TurningResistance.DrillingPerLoad(in contact, ball);
        double damped = (about - drilling) / (1.0 + damping);

        // Drilling friction stops the spin about the normal if the load allows it. Otherwise, damp the spin and reduce it by the friction limit.
        bool ends = Math.Abs(damped) <= perLoad * contact.Load;
        double resisted = damped > 0 ? perLoad : -perLoad;
        return new Row
        {
            AlongW = contact.Normal,
            PushW = contact.Normal,
            Residual = ends ? about : about - damped + (resisted * contact.Load),
            OfMotion = ends ? 1.0 : damping / (1.0 + damping),
            OfItself = ends ? 0 : 1.0 / (1.0 + damping),
            LoadRow = ends ? -1 : loadRow,
            PerLoad = resisted,
        };
    }

    /// <summary>Sets a pair of rows with a common bound: they stop a slip, or equal μ N against it.</summary>
    private static void Couple(
        Span<Row> rows, in Vector3d pushV1, in Vector3d pushV2, in Vector3d alongW1, in Vector3d alongW2,
        in Vector3d pushW1, in Vector3d pushW2, in Slipping slip, in Slipping push, double grip, double friction, double load, int loadRow)
    {
        // T = F − g s. If |T| ≤ μ N, the contact grips, so the slip must vanish; otherwise F = μ N T/|T|.
        double first = push.First - (grip * slip.First);
        double second = push.Second - (grip * slip.Second);
        double size = Math.Sqrt((first * first) + (second * second));
        double most = FrictionLaw.Limit(friction, load);
        bool grips = size <= most && most > 0;
        double x = size > 0 ? first / size : 0;
        double y = size > 0 ? second / size : 0;
        double turns = grips || !(size > 0) ? 0 : most / size;
        rows[0] = new Row
        {
            AlongV = pushV1,
            AlongW = alongW1,
            PushV = pushV1,
            PushW = pushW1,
            Residual = grips ? slip.First : push.First - (most * x),
            OfMotion = grips ? 1 : 0,
            OfItself = grips ? 0 : 1,
            LoadRow = grips ? -1 : loadRow,
            PerLoad = -friction * x,
            Turns = turns,
            Across = -y,
            Other = 1,
            Grip = grip,
        };
        rows[1] = new Row
        {
            AlongV = pushV2,
            AlongW = alongW2,
            PushV = pushV2,
            PushW = pushW2,
            Residual = grips ? slip.Second : push.Second - (most * y),
            OfMotion = grips ? 1 : 0,
            OfItself = grips ? 0 : 1,
            LoadRow = grips ? -1 : loadRow,
            PerLoad = -friction * y,
            Turns = turns,
            Across = x,
            Other = -1,
            Grip = grip,
        };
    }

    /// <summary>Builds the system: per unknown, the derivatives of its residual, and the negative residual.</summary>
    private static void Fill(Span<double> system, Span<Row> rows, int size)
    {
        // Compute how every row responds to a unit of every impulse.
        Span<double> motions = stackalloc double[size * size];
        for (int i = 0; i < size; i++)
        {
            ref readonly Row row = ref rows[i];
            for (int j = 0; j < size; j++)
            {
                ref readonly Row by = ref rows[j];
                motions[(i * size) + j] = Vector3d.Dot(in row.AlongV, in by.PushV) + Vector3d.Dot(in row.AlongW, in by.PushW);
            }
        }

        // The terms of a row: the motion, the unknown itself, the load that limits it, and the turn of its direction.
        for (int i = 0; i < size; i++)
        {
            ref readonly Row row = ref rows[i];
            Span<double> into = system.Slice(i * (size + 1), size + 1);
            Span<double> own = motions.Slice(i * size, size);
            for (int j = 0; j < own.Length; j++)
            {
                into[j] = row.OfMotion * own[j];
            }

            into[i] += row.OfItself + ContactTolerances.Regularisation;
            if (row.LoadRow >= 0)
            {
                into[row.LoadRow] += row.PerLoad;
            }

            if (row.Turns > 0)
            {
                // −μ dN T/|T| − (μ N/|T|)(1 − T Tᵀ/|T|²)(dF − g ds): only the change of T perpendicular to T matters.
                int second = i + row.Other;
                Span<double> other = motions.Slice(second * size, size);
                double across = row.Turns * row.Across;
                double acrossOther = rows[second].Across;
                for (int j = 0; j < own.Length; j++)
                {
                    into[j] += across * row.Grip * ((row.Across * own[j]) + (acrossOther * other[j]));
                }

                into[i] -= across * row.Across;
                into[second] -= across * acrossOther;
            }

            into[size] = -row.Residual;
        }
    }

    /// <summary>Gaussian elimination with partial pivoting; the solution replaces the right-hand side.</summary>
    /// <returns>False if there is no solution.</returns>
    private static bool Eliminate(Span<double> system, int size)
    {
        int width = size + 1;
        for (int column = 0; column < size; column++)
        {
            // Use the largest pivot in the column, because a small pivot would amplify rounding errors.
            int pivot = column;
            for (int i = column + 1; i < size; i++)
            {
                pivot = Math.Abs(system[(i * width) + column]) > Math.Abs(system[(pivot * width) + column]) ? i : pivot;
            }

            Span<double> own = system.Slice(column * width, width);
            Span<double> best = system.Slice(pivot * width, width);
            double largest = best[column];
            if (!(Math.Abs(largest) > ContactTolerances.LeastPivot))
            {
                return false;
            }

            for (int j = column; j < width; j++)
            {
                double value = best[j] / largest;
                best[j] = own[j];
                own[j] = value;
            }

            // Eliminate this column from the rows below.
            Span<double> pivoted = own.Slice(column);
            for (int i = column + 1; i < size; i++)
            {
                Span<double> row = system.Slice((i * width) + column, width - column);
                double factor = row[0];
                for (int j = 0; factor != 0 && j < pivoted.Length; j++)
                {
                    row[j] -= factor * pivoted[j];
                }
            }
        }

        // Back substitution.
        for (int i = size - 2; i >= 0; i--)
        {
            Span<double> row = system.Slice(i * width, width);
            for (int j = i + 1; j < size; j++)
            {
                row[size] -= row[j] * system[(j * width) + size];
            }
        }

        return true;
    }

    /// <summary>Returns a direction perpendicular to a normal.</summary>
    private static Vector3d Tangent(in Vector3d n)
    {
        Vector3d across = Math.Abs(n.X) < 0.6 ? new Vector3d(1, 0, 0) : Vector3d.Up;
        return (across - (Vector3d.Dot(in across, in n) * n)).Normalized();
    }

    /// <summary>A pair of components along a surface.</summary>
    private readonly struct Slipping
    {
        public readonly double First;
        public readonly double Second;

        public Slipping(double first, double second)
        {
            First = first;
            Second = second;
        }
    }

    /// <summary>An unknown: its effect on the ball, and its row of the system.</summary>
    private struct Row
    {
        /// <summary>Derivatives of its condition with respect to v and ω.</summary>
        public Vector3d AlongV;
        public Vector3d AlongW;

        /// <summary>Change of v and of ω by a unit impulse.</summary>
        public Vector3d PushV;
        public Vector3d PushW;

        /// <summary>Residual to be brought to zero.</summary>
        public double Residual;

        /// <summary>Weights of the motion and of the unknown itself in the condition.</summary>
        public double OfMotion;
        public double OfItself;

        /// <summary>The row of the load that bounds it, the bound per load, and the row of the other component.</summary>
        public int LoadRow;
        public double PerLoad;
        public int Other;

        /// <summary>μ N/|T|, the component across T, and the weight of the slip in T.</summary>
        public double Turns;
        public double Across;
        public double Grip;
    }
}
