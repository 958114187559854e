using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Solves the impulses of all contacts of a pile over a short time, with Coulomb's law at all of them.</summary>
/// <remarks>
/// No contact closes by more than its gap, no load is negative, and friction is at most μ times the load.
/// The method is projected Gauss–Seidel, in alternating order of the balls' positions, with conjugate gradients between the iterations.
/// </remarks>
internal sealed class PileSolver
{
    /// <summary>Number of iterations between two checks whether all balls are at a standstill.</summary>
    private const int RoundsBetween = 8;

    /// <summary>The balls.</summary>
    public PileMember[] Members = new PileMember[8];

    /// <summary>Number of balls.</summary>
    public int Count;

    /// <summary>Their contacts.</summary>
    public PileContact[] Contacts = new PileContact[32];

    /// <summary>Number of contacts.</summary>
    public int ContactCount;

    /// <summary>Adds a contact.</summary>
    public void Add(in PileContact contact)
    {
        if (ContactCount == Contacts.Length)
        {
            Array.Resize(ref Contacts, 2 * ContactCount);
        }

        Contacts[ContactCount++] = contact;
    }

    /// <summary>Sets the velocity at which each ball moves: the mean of the old and new ones, or the new one if the ball hits something.</summary>
    public void SetWays()
    {
        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref Members[i];
            member.Way = 0.5 * (member.StartV + member.V);
        }

        for (int i = 0; i < ContactCount; i++)
        {
            ref readonly PileContact contact = ref Contacts[i];
            if (contact.Load > 0 && Closes(in contact))
            {
                ref PileMember first = ref Members[contact.First];
                first.Way = first.V;
                if (contact.Second >= 0)
                {
                    ref PileMember second = ref Members[contact.Second];
                    second.Way = second.V;
                }
            }
        }
    }

    /// <summary>True if a contact closes at the start of the part. At the mean velocity, the ball would enter the other object.</summary>
    private bool Closes(in PileContact contact)
    {
        Vector3d other = contact.Second >= 0 ? Members[contact.Second].StartV : contact.Velocity;
        return Vector3d.Dot(Members[contact.First].StartV - other, in contact.Normal) < -ContactTolerances.Pressing;
    }

    /// <summary>Solves the impulses, starting from those that the contacts and the balls already hold.</summary>
    /// <param name="h">The time, s.</param>
    /// <param name="mostRounds">Maximum number of iterations.</param>
    /// <param name="settled">Change of a ball's speed below which the solver has converged, m/s.</param>
    /// <param name="slow">Speed of all balls below which it also stops, m/s; negative to skip this check.</param>
    /// <param name="share">Share of the resistance of the last part that each ball starts with.</param>
    public void Solve(double h, int mostRounds, double settled, double slow = -1, double share = 0)
    {
        for (int i = 0; i < Count; i++)
        {
            // Warm start also of the resistance: without it, the impulses of the last part would be no solution.
            ref PileMember ball = ref Members[i];
            int bearer = BearerOf(i);
            ball.Turning = bearer < 0 ? TurningResistance.None
                : new TurningResistance { Bearer = bearer, Normal = Contacts[bearer].Normal, Rolling = share * ball.Turning.Rolling, Drilling = share * ball.Turning.Drilling };
            ball.W += ball.Turning.Removed;
        }

        for (int i = 0; i < ContactCount; i++)
        {
            ref PileContact contact = ref Contacts[i];
            Give(in contact, (contact.Load * contact.Normal) + contact.Rub, in contact.Rub);
            Twist(ref contact, contact.Twist);
        }

        double change = double.PositiveInfinity;
        double before = 0;
        for (int round = 0; round < mostRounds && change > settled; round++)
        {
            // Alternate the order, so that the load of a ball on top reaches the ground in one iteration.
            change = 0;
            double square = 0;
            for (int i = 0; i < ContactCount; i++)
            {
                ref PileContact contact = ref Contacts[(round & 1) == 0 ? ContactCount - 1 - i : i];
                double load = contact.Load;
                Vector3d rub = contact.Rub;
                change = Math.Max(change, Press(ref contact, h));
                contact.LoadChange = contact.Load - load;
                contact.RubChange = contact.Rub - rub;
                square += (contact.LoadChange * contact.LoadChange / contact.NormalMass) + (contact.RubChange.LengthSquared / contact.SlipMass);
            }

            for (int i = 0; i < Count; i++)
            {
                change = Math.Max(change, Members[i].Radius * Resist(i, h));
            }

            if (slow >= 0 && round % RoundsBetween == RoundsBetween - 1 && Fastest() <= slow)
            {
                return;
            }

            // The change in an iteration approximates a negative gradient: extrapolate along the conjugate direction, except after the last
            // iteration.
            if (round < mostRounds - 1 && change > settled)
            {
                Extrapolate(square <= before ? square / before : 0);
            }

            before = square;
        }
    }

    /// <summary>Scales velocities and spins until stationary contacts do no work, as <see cref="SolvedSet"/> does for one ball.</summary>
    /// <remarks>If only balls press each other, it scales their impulses instead, because these keep the momentum.</remarks>
    /// <param name="h">Length of the part, s.</param>
    public void LimitWork(double h)
    {
        bool isFree = true;
        for (int i = 0; i < ContactCount; i++)
        {
            if (Contacts[i].Velocity != Vector3d.Zero)
            {
                return;
            }

            isFree &= Contacts[i].Second >= 0 || Contacts[i].Load == 0;
        }

        // v·M v, v·M v_free, J·v_free and J·M⁻¹J over all balls and spins, with v_free = v₀ + h a and J = M (v − v_free).
        double square = 0;
        double shared = 0;
        double closing = 0;
        double pushed = 0;
        for (int i = 0; i < Count; i++)
        {
            ref readonly PileMember ball = ref Members[i];
            Vector3d v = FreeVelocity(in ball, h);
            Vector3d w = FreeSpin(in ball, h);
            Vector3d impulse = ball.V - v;
            Vector3d torque = ball.W - w;
            square += (ball.V.LengthSquared / ball.PerMass) + (ball.W.LengthSquared / ball.PerInertia);
            shared += (Vector3d.Dot(in ball.V, in v) / ball.PerMass) + (Vector3d.Dot(in ball.W, in w) / ball.PerInertia);
            closing += (Vector3d.Dot(in impulse, in v) / ball.PerMass) + (Vector3d.Dot(in torque, in w) / ball.PerInertia);
            pushed += (impulse.LengthSquared / ball.PerMass) + (torque.LengthSquared / ball.PerInertia);
        }

        double share = SolvedSet.ShareWithoutWork(square, shared);
        if (share == 1)
        {
            return;
        }

        // Scaled by s, the impulses do the work s J·v_free + s² J·M⁻¹J.
        share = isFree ? Math.Max(0, Math.Min(1, -closing / pushed)) : share;
        for (int i = 0; i < Count; i++)
        {
            ref PileMember ball = ref Members[i];
            ball.V = isFree ? FreeVelocity(in ball, h) + (share * (ball.V - FreeVelocity(in ball, h))) : share * ball.V;
            ball.W = isFree ? FreeSpin(in ball, h) + (share * (ball.W - FreeSpin(in ball, h))) : share * ball.W;
        }
    }

    /// <summary>Returns the velocity of a ball without contacts, m/s.</summary>
    private static Vector3d FreeVelocity(in PileMember ball, double h) => ball.StartV + (h * ball.Free.Acceleration);

    /// <summary>Returns the spin of a ball without contacts, rad/s.</summary>
    private static Vector3d FreeSpin(in PileMember ball, double h) => ball.StartW + (h * ball.Free.SpinAcceleration);

    /// <summary>Returns the greatest speed of any ball, including its spin, m/s.</summary>
    public double Fastest()
    {
        double fastest = 0;
        for (int i = 0; i < Count; i++)
        {
            fastest = Math.Max(fastest, Members[i].V.Length + (Members[i].Radius * Members[i].W.Length));
        }

        return fastest;
    }

    /// <summary>Nonsmooth nonlinear conjugate gradients (Silcowitz, Niebe, Erleben): adds β p to the impulses, with p ← β p +
    /// change.</summary>
    private void Extrapolate(double beta)
    {
        for (int i = 0; i < ContactCount; i++)
        {
            ref PileContact contact = ref Contacts[i];
            double load = beta > 0 ? beta * contact.LoadStep : 0;
            Vector3d rub = beta > 0 ? beta * contact.RubStep : Vector3d.Zero;
            contact.LoadStep = load + contact.LoadChange;
            contact.RubStep = rub + contact.RubChange;
            if (beta > 0)
            {
                contact.Load += load;
                contact.Rub += rub;
                Give(in contact, (load * contact.Normal) + rub, in rub);
            }
        }
    }

    /// <summary>Returns the contact of a ball with the greatest load, other than with balls; −1 if there is none.</summary>
    public int BearerOf(int member)
    {
        ref readonly PileMember ball = ref Members[member];
        int bearer = -1;
        double most = 0;
        for (int i = ball.FirstContact; i < ball.FirstContact + ball.OwnContacts; i++)
        {
            // If two loads are equal to within rounding, take the first contact.
            if (Contacts[i].Load > most * (1.0 + ContactTolerances.SameLoad))
            {
                most = Contacts[i].Load;
                bearer = i;
            }
        }

        return bearer;
    }

    /// <summary>Solves a single contact.</summary>
    /// <returns>Change of the speed of a ball, m/s.</returns>
    private double Press(ref PileContact contact, double h)
    {
        ref readonly PileMember a = ref Members[contact.First];
        Vector3d n = contact.Normal;

        // The slip velocity u = v₁ − r₁ ω₁ × n − V; for two balls, V = v₂ + r₂ ω₂ × n.
        Vector3d turning = a.Radius * a.W;
        Vector3d relative = a.V;
        double perMass = a.PerMass;
        if (contact.Second >= 0)
        {
            ref readonly PileMember b = ref Members[contact.Second];
            relative -= b.V;
            turning += b.Radius * b.W;
            perMass = Math.Max(perMass, b.PerMass);
        }
        else
        {
            relative -= contact.Velocity;
        }

        // J_n: the surfaces must separate at least as fast as the gap requires.
        double rate = Vector3d.Dot(in relative, in n);
        double load = contact.Bounces ? 0 : Math.Max(0, contact.Load - ((rate + (contact.Gap / h)) * contact.NormalMass));
        if (load == 0 && contact.Load == 0 && contact.Rub == Vector3d.Zero)
        {
            // The surfaces are close, but the contact carries no load: there is no impulse to apply.
            return 0;
        }

        double pushed = load - contact.Load;
        contact.Load = load;

        // J_t: the impulse that stops the slip s, limited by friction.
        Vector3d slip = relative - (rate * n) - Vector3d.Cross(in turning, in n);
        Vector3d rub = contact.Rub - (contact.SlipMass * slip);
        double most = contact.Resistance.MostFriction(load);
        double square = rub.LengthSquared;
        contact.Sticks = square <= most * most;
        if (!contact.Sticks)
        {
            rub = most / Math.Sqrt(square) * rub;
        }

        Vector3d rubbed = rub - contact.Rub;
        contact.Rub = rub;
        Give(in contact, (pushed * n) + rubbed, in rubbed);
        if (contact.Second >= 0)
        {
            // About the normal: the impulse that stops the relative spin, at most b μ J_n.
            double about = Vector3d.Dot(a.W - Members[contact.Second].W, in n);
            double twist = contact.Twist - (contact.TwistMass * about);
            double mostTwist = contact.Resistance.MostDrilling(load);
            twist = Math.Max(-mostTwist, Math.Min(twist, mostTwist));
            double twisted = twist - contact.Twist;
            contact.Twist = twist;
            Twist(ref contact, twisted);
        }

        return perMass * Math.Max(Math.Abs(pushed), rubbed.Length);
    }

    /// <summary>Applies an impulse to the first ball of a contact, and the opposite one to the second.</summary>
    private void Give(in PileContact contact, in Vector3d impulse, in Vector3d rub)
    {
        // Apply the impulse to both: v₁ += J/m₁, ω₁ −= (r₁/I₁) n × J; v₂ −= J/m₂, ω₂ −= (r₂/I₂) n × J.
        Vector3d turned = Vector3d.Cross(in contact.Normal, in rub);
        ref PileMember a = ref Members[contact.First];
        a.V += a.PerMass * impulse;
        a.W -= a.Radius * a.PerInertia * turned;
        if (contact.Second >= 0)
        {
            ref PileMember b = ref Members[contact.Second];
            b.V -= b.PerMass * impulse;
            b.W -= b.Radius * b.PerInertia * turned;
        }
    }

    /// <summary>Applies an impulse to the relative spin of two balls about the normal, N m s.</summary>
    private void Twist(ref PileContact contact, double impulse)
    {
        if (contact.Second >= 0)
        {
            ref PileMember a = ref Members[contact.First];
            ref PileMember b = ref Members[contact.Second];
            a.W += a.PerInertia * impulse * contact.Normal;
            b.W -= b.PerInertia * impulse * contact.Normal;
        }
    }

    /// <summary>Applies rolling resistance and drilling friction at the contact with the greatest load, other than with balls.</summary>
    /// <returns>Change of the spin, rad/s.</returns>
    private double Resist(int member, double h)
    {
        int bearer = BearerOf(member);
        ref PileMember ball = ref Members[member];
        ball.Turning.MoveTo(bearer, bearer < 0 ? Vector3d.Zero : Contacts[bearer].Normal, ref ball.W);
        if (bearer < 0)
        {
            return 0;
        }

        // A contact that slips has no rolling resistance.
        ref readonly PileContact contact = ref Contacts[bearer];
        double perLoad = contact.Load * ball.PerInertia;
        double mostRolling = contact.Resistance.MostRolling(perLoad, (ball.V - contact.Velocity).Length);
        return ball.Turning.Act(
            h * contact.Resistance.Damping * ball.PerInertia, contact.Resistance.MostDrilling(perLoad),
            contact.Sticks ? (1.0 + ball.InertiaFactor) * ball.Radius * mostRolling : 0, ref ball.W);
    }
}

/// <summary>A ball of a pile.</summary>
internal struct PileMember
{
    /// <summary>Its index in the group.</summary>
    public int Ball;

    /// <summary>1/m, 1/kg.</summary>
    public double PerMass;

    /// <summary>1/I, 1/(kg m²).</summary>
    public double PerInertia;

    /// <summary>α.</summary>
    public double InertiaFactor;

    /// <summary>r, m.</summary>
    public double Radius;

    /// <summary>The rates without contacts.</summary>
    public MotionRates Free;

    /// <summary>True if the custom forces hardly change in a part; false before the first part.</summary>
    public bool HasSoftForces;

    /// <summary>True if custom forces were too stiff for a part of this step.</summary>
    public bool IsStiff;

    /// <summary>Time up to which these rates are valid, s.</summary>
    public double FreeUntil;

    /// <summary>Velocity and spin in the solver, m/s and rad/s.</summary>
    public Vector3d V;
    public Vector3d W;

    /// <summary>Velocity and spin at the start of the part, m/s and rad/s.</summary>
    public Vector3d StartV;
    public Vector3d StartW;

    /// <summary>Mean velocity in the part, m/s.</summary>
    public Vector3d Way;

    /// <summary>The ball at the start of the part.</summary>
    public BallState From;

    /// <summary>True if its last part was not reported yet, because the ball may still be separated from others at its end.</summary>
    public bool IsUnshown;

    /// <summary>Its contacts with objects other than balls: index of the first, and their number.</summary>
    public int FirstContact;
    public int OwnContacts;

    /// <summary>The resistance to its rotation, rad/s.</summary>
    public TurningResistance Turning;
}
