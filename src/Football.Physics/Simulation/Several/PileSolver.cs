namespace FootballPhysics;

/// <summary>The impulses of all contacts of a pile over a short time, Coulomb's law at all of them at once: no contact closes by more than
/// its gap, none pulls, and friction is at most μ times the load.</summary>
/// <remarks>
/// Projected Gauss–Seidel, one contact after the other in an order that the places of the balls decide, up and down in turn, with conjugate
/// gradients between the rounds.
/// </remarks>
internal sealed class PileSolver
{
    /// <summary>So often it is asked whether all balls stand still.</summary>
    private const int RoundsBetween = 8;

    /// <summary>The balls.</summary>
    public PileMember[] Members = new PileMember[8];

    /// <summary>How many there are.</summary>
    public int Count;

    /// <summary>Their contacts.</summary>
    public PileContact[] Contacts = new PileContact[32];

    /// <summary>How many there are.</summary>
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

    /// <summary>Finds the impulses, from those that the contacts have already.</summary>
    /// <param name="h">The time, s.</param>
    /// <param name="mostRounds">How many rounds there are at most.</param>
    /// <param name="settled">Where no impulse changes a ball's speed by more than this, m/s, they are found.</param>
    /// <param name="slow">... or where no ball is faster than this, m/s; negative where that is not asked for.</param>
    public void Solve(double h, int mostRounds, double settled, double slow = -1)
    {
        for (int i = 0; i < Count; i++)
        {
            Members[i].Rolling = Vector3d.Zero;
            Members[i].Drilling = 0;
            Members[i].Bearer = -1;
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
            // Alternate the order: the load of a ball on top then reaches the ground in one iteration.
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
                change = Math.Max(change, Members[i].Radius * Resist(ref Members[i], h));
            }

            if (slow >= 0 && round % RoundsBetween == RoundsBetween - 1 && Fastest() <= slow)
            {
                return;
            }

            // The change of an iteration approximates a negative gradient: extrapolate along the conjugate direction, except after the last
            // one.
            if (round < mostRounds - 1 && change > settled)
            {
                Extrapolate(square <= before ? square / before : 0);
            }

            before = square;
        }
    }

    /// <summary>The greatest speed of any ball, with its spin, m/s.</summary>
    public double Fastest()
    {
        double fastest = 0;
        for (int i = 0; i < Count; i++)
        {
            fastest = Math.Max(fastest, Members[i].V.Length + (Members[i].Radius * Members[i].W.Length));
        }

        return fastest;
    }

    /// <summary>Nonsmooth nonlinear conjugate gradients (Silcowitz, Niebe, Erleben): β p more of the impulses, with p ← β p + change.</summary>
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

    /// <summary>The contact with what is no ball that bears a ball most; −1 where none does.</summary>
    public int BearerOf(int member)
    {
        ref readonly PileMember ball = ref Members[member];
        int bearer = -1;
        double most = 0;
        for (int i = ball.FirstContact; i < ball.FirstContact + ball.OwnContacts; i++)
        {
            // If two loads are equal to within rounding, the first contact counts.
            if (Contacts[i].Load > most * (1.0 + 1e-9))
            {
                most = Contacts[i].Load;
                bearer = i;
            }
        }

        return bearer;
    }

    /// <summary>One contact by itself.</summary>
    /// <returns>By how much it changed the speed of a ball, m/s.</returns>
    private double Press(ref PileContact contact, double h)
    {
        ref readonly PileMember a = ref Members[contact.First];
        Vector3d n = contact.Normal;

        // u = v₁ − r₁ ω₁ × n − V; for a ball, V = v₂ + r₂ ω₂ × n.
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
        double load = Math.Max(0, contact.Load - ((rate + (contact.Gap / h)) * contact.NormalMass));
        if (load == 0 && contact.Load == 0 && contact.Rub == Vector3d.Zero)
        {
            // The contact is near but has no load.
            return 0;
        }

        double pushed = load - contact.Load;
        contact.Load = load;

        // J_t: the impulse that stops the slip s, limited by friction.
        Vector3d slip = relative - (rate * n) - Vector3d.Cross(in turning, in n);
        Vector3d rub = contact.Rub - (contact.SlipMass * slip);
        double most = contact.Friction * load;
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
            double mostTwist = contact.DrillingLength * most;
            twist = Math.Max(-mostTwist, Math.Min(twist, mostTwist));
            double twisted = twist - contact.Twist;
            contact.Twist = twist;
            Twist(ref contact, twisted);
        }

        return perMass * Math.Max(Math.Abs(pushed), rubbed.Length);
    }

    /// <summary>Gives an impulse to the ball of a contact, and the opposite one to the other.</summary>
    private void Give(in PileContact contact, in Vector3d impulse, in Vector3d rub)
    {
        // v₁ += J/m₁, ω₁ −= (r₁/I₁) n × J; v₂ −= J/m₂, ω₂ −= (r₂/I₂) n × J.
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

    /// <summary>Turns the balls of a contact against each other about the normal, N m s.</summary>
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

    /// <summary>Rolling resistance and drilling, on the contact that bears a ball most and is no ball.</summary>
    /// <returns>By how much it changed the spin, rad/s.</returns>
    private double Resist(ref PileMember ball, double h)
    {
        int bearer = -1;
        double load = 0;
        for (int i = ball.FirstContact; i < ball.FirstContact + ball.OwnContacts; i++)
        {
            bearer = Contacts[i].Load > load * (1.0 + 1e-9) ? i : bearer;
            load = Math.Max(load, Contacts[i].Load);
        }

        // Another contact now has the greatest load: undo the resistance at the old one.
        if (bearer != ball.Bearer)
        {
            ball.W -= ball.Rolling + (ball.Bearer < 0 ? Vector3d.Zero : ball.Drilling * Contacts[ball.Bearer].Normal);
            ball.Rolling = Vector3d.Zero;
            ball.Drilling = 0;
            ball.Bearer = bearer;
        }

        if (bearer < 0)
        {
            return 0;
        }

        ref readonly PileContact contact = ref Contacts[bearer];
        Vector3d n = contact.Normal;
        double perLoad = contact.Load * ball.PerInertia;

        // About the normal: damping gives ω_n/(1 + c_ω h/I), then drilling friction brings it towards zero by at most b μ_s J_n/I.
        double about = Vector3d.Dot(in ball.W, in n);
        double damped = (about - ball.Drilling) / (1.0 + (h * contact.SpinDamping * ball.PerInertia));
        double most = contact.DrillingLength * contact.Friction * perLoad;
        double kept = damped > 0 ? Math.Max(0, damped - most) : Math.Min(0, damped + most);
        double drilled = kept - about;
        ball.Drilling += drilled;

        // Across the normal, if the contact sticks: rolling resistance (1 + α)(c₀ + c₁ |v|) r J_n/I, which never reverses the rolling.
        double share = contact.RollingFriction + (contact.RollingFrictionBySpeed * (ball.V - contact.Velocity).Length);
        double resistance = contact.Sticks ? (1.0 + ball.InertiaFactor) * share * ball.Radius * perLoad : 0;
        Vector3d rolling = ball.W - (about * n) - ball.Rolling;
        double size = rolling.Length;
        Vector3d resisted = size > resistance ? -(resistance / size) * rolling : -rolling;
        Vector3d more = resisted - ball.Rolling;
        ball.Rolling = resisted;
        ball.W += (drilled * n) + more;
        return Math.Max(Math.Abs(drilled), more.Length);
    }
}

/// <summary>A ball of a pile.</summary>
internal struct PileMember
{
    /// <summary>Its number in the group.</summary>
    public int Ball;

    /// <summary>1/m, 1/kg.</summary>
    public double PerMass;

    /// <summary>1/I, 1/(kg m²).</summary>
    public double PerInertia;

    /// <summary>α.</summary>
    public double InertiaFactor;

    /// <summary>r, m.</summary>
    public double Radius;

    /// <summary>What acts on it beside its contacts.</summary>
    public MotionRates Free;

    /// <summary>Until when that is known well enough, s.</summary>
    public double FreeUntil;

    /// <summary>Velocity and spin that the solver finds, m/s and rad/s.</summary>
    public Vector3d V;
    public Vector3d W;

    /// <summary>... and at the start of the part.</summary>
    public Vector3d StartV;
    public Vector3d StartW;

    /// <summary>Mean velocity in the part, m/s.</summary>
    public Vector3d Way;

    /// <summary>The ball at the start of the part.</summary>
    public BallState From;

    /// <summary>True if the observer has not seen its last part, at the end of which the ball may still be put apart from others.</summary>
    public bool IsUnshown;

    /// <summary>Its contacts with all but balls: the first of them, and how many there are.</summary>
    public int FirstContact;
    public int OwnContacts;

    /// <summary>The contact that resists its turning; −1 for none.</summary>
    /// <remarks>What that took of the rolling, and of the spin about its normal, rad/s.</remarks>
    public int Bearer;
    public Vector3d Rolling;
    public double Drilling;
}

/// <summary>A contact of a pile: of two of its balls, or of one with anything else.</summary>
internal struct PileContact
{
    /// <summary>The ball, as a member of the pile.</summary>
    public int First;

    /// <summary>The other ball; −1 where it is none.</summary>
    public int Second;

    /// <summary>Index of the collider; −1 for a ball.</summary>
    public int Collider;

    /// <summary>True when that moves.</summary>
    public bool Moves;

    /// <summary>True when no ball can rest on it: it moves in this step, or a ball is in it.</summary>
    public bool MovesNow;

    /// <summary>True when friction holds it.</summary>
    public bool Sticks;

    /// <summary>n, towards the first ball.</summary>
    public Vector3d Normal;

    /// <summary>V of what is no ball, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>Distance, m; 0 where they overlap.</summary>
    public double Gap;

    /// <summary>1/(1/m₁ + 1/m₂), and with r²/I of both beside it, kg.</summary>
    public double NormalMass;
    public double SlipMass;

    /// <summary>1/(1/I₁ + 1/I₂) of two balls, kg m².</summary>
    public double TwistMass;

    /// <summary>μ_s.</summary>
    public double Friction;

    /// <summary>c₀, c₁ and c_ω of what is no ball.</summary>
    public double RollingFriction;
    public double RollingFrictionBySpeed;
    public double SpinDamping;

    /// <summary>b, m.</summary>
    public double DrillingLength;

    /// <summary>J_n, N s.</summary>
    public double Load;

    /// <summary>J_t, N s.</summary>
    public Vector3d Rub;

    /// <summary>Of two balls the impulse about n, N m s.</summary>
    public double Twist;

    /// <summary>By how much a round changed both, N s; and the direction that it goes on along.</summary>
    public double LoadChange;
    public Vector3d RubChange;
    public double LoadStep;
    public Vector3d RubStep;
}
