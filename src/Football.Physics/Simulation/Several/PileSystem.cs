using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>The balls of a pile and their contacts, whose impulses <see cref="ImpulseSolver"/> solves together.</summary>
internal sealed class PileSystem
{
    /// <summary>The balls.</summary>
    public PileMember[] Members = new PileMember[8];

    /// <summary>The same balls in the solver.</summary>
    public PressedBall[] Balls = new PressedBall[8];

    /// <summary>Number of balls.</summary>
    public int Count;

    /// <summary>Their contacts.</summary>
    public Contact[] Contacts = new Contact[32];

    /// <summary>Number of contacts.</summary>
    public int ContactCount;

    /// <summary>Adds a ball.</summary>
    public void Add(in PileMember member, in PressedBall ball)
    {
        if (Count == Members.Length)
        {
            Array.Resize(ref Members, 2 * Count);
            Array.Resize(ref Balls, 2 * Count);
        }

        Members[Count] = member;
        Balls[Count++] = ball;
    }

    /// <summary>Adds a contact.</summary>
    public void Add(in Contact contact)
    {
        if (ContactCount == Contacts.Length)
        {
            Array.Resize(ref Contacts, 2 * ContactCount);
        }

        Contacts[ContactCount++] = contact;
    }

    /// <inheritdoc cref="ImpulseSolver.Solve(Span{PressedBall}, Span{Contact}, double, int, double, double, double)"/>
    public void Solve(double h, int mostRounds, double settled, double slow = -1, double share = 0) =>
        ImpulseSolver.Solve(Balls.AsSpan(0, Count), Contacts.AsSpan(0, ContactCount), h, mostRounds, settled, slow, share);

    /// <inheritdoc cref="ImpulseSolver.LimitWork"/>
    public void LimitWork() => ImpulseSolver.LimitWork(Balls.AsSpan(0, Count), Contacts.AsSpan(0, ContactCount));

    /// <inheritdoc cref="ImpulseSolver.Fastest"/>
    public double Fastest() => ImpulseSolver.Fastest(Balls.AsSpan(0, Count));

    /// <inheritdoc cref="ImpulseSolver.BearerOf"/>
    public int BearerOf(int member) => ImpulseSolver.BearerOf(in Balls[member], Contacts.AsSpan(0, ContactCount));

    /// <summary>Returns the contacts of a ball with objects other than balls.</summary>
    public Span<Contact> OwnContactsOf(int member) => Contacts.AsSpan(Balls[member].FirstContact, Balls[member].OwnContacts);

    /// <summary>Sets the velocity at which each ball moves: the mean of the old and new ones, or the new one if the ball hits something.</summary>
    public void SetWays()
    {
        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref Members[i];
            member.Way = 0.5 * (member.StartV + Balls[i].V);
        }

        for (int i = 0; i < ContactCount; i++)
        {
            ref readonly Contact contact = ref Contacts[i];
            if (contact.Load > 0 && Closes(in contact))
            {
                Members[contact.First].Way = Balls[contact.First].V;
                if (contact.Second >= 0)
                {
                    Members[contact.Second].Way = Balls[contact.Second].V;
                }
            }
        }
    }

    /// <summary>True if a contact closes at the start of the part. At the mean velocity, the ball would enter the other object.</summary>
    private bool Closes(in Contact contact)
    {
        Vector3d other = contact.Second >= 0 ? Members[contact.Second].StartV : contact.Velocity;
        return Vector3d.Dot(Members[contact.First].StartV - other, in contact.Normal) < -ContactTolerances.Pressing;
    }
}

/// <summary>A ball of a pile.</summary>
internal struct PileMember
{
    /// <summary>Its index in the group.</summary>
    public int Ball;

    /// <summary>The rates without contacts.</summary>
    public MotionRates Free;

    /// <summary>True if the custom forces hardly change in a part; false before the first part.</summary>
    public bool HasSoftForces;

    /// <summary>True if custom forces were too stiff for a part of this step.</summary>
    public bool IsStiff;

    /// <summary>Time up to which these rates are valid, s.</summary>
    public double FreeUntil;

    /// <summary>Velocity and spin at the start of the part, m/s and rad/s.</summary>
    public Vector3d StartV;
    public Vector3d StartW;

    /// <summary>Mean velocity in the part, m/s.</summary>
    public Vector3d Way;

    /// <summary>The ball at the start of the part.</summary>
    public BallState From;

    /// <summary>True if its last part was not reported yet, because the ball may still be separated from others at its end.</summary>
    public bool IsUnshown;
}
