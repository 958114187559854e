using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace FootballPhysics.Contacts;

/// <summary>Solves the impulses of all contacts of one or more balls over a short time, with Coulomb's law at all of them: J_n ≥ 0, no contact closes by
/// more than its gap, |J_t| ≤ μ J_n.</summary>
/// <remarks>
/// The method is projected Gauss–Seidel, in alternating order of the contacts, with conjugate gradients between the iterations.
/// On a sphere a normal impulse does not change the spin, and a tangential one acts on the same mass in every direction. Each contact therefore has a
/// closed-form solution per iteration.
/// </remarks>
internal static class ImpulseSolver
{
    /// <summary>Maximum number of iterations. If they do not suffice, the set is unsolvable, as with two objects that close on a ball.</summary>
    private const int MostRounds = 48;

    /// <summary>Maximum number of iterations for a set that may be unsolvable; the result is then approximate.</summary>
    public const int RoundsInVain = 16;

    /// <summary>Number of iterations between two checks whether all balls are at a standstill.</summary>
    private const int RoundsBetween = 8;

    /// <summary>Solves the velocity and the spin of one ball after a time, given their values without contacts.</summary>
    /// <param name="set">The contacts. They hold the impulses of the previous part, or zero, and receive the new ones.</param>
    /// <param name="ball">The ball.</param>
    /// <param name="duration">The time, s, in which a contact with a gap may close.</param>
    /// <param name="v">Velocity, m/s.</param>
    /// <param name="w">Spin, rad/s.</param>
    /// <param name="settled">Relative change of speeds below which the solver has converged.</param>
    /// <param name="closing">Maximum closing speed of a contact, m/s.</param>
    /// <param name="rounds">Maximum number of iterations.</param>
    /// <returns>True if a solution was found.</returns>
    public static bool Solve(
        Span<Contact> set, BallProperties ball, double duration, ref Vector3d v, ref Vector3d w,
        double settled = ContactTolerances.Settled, double closing = ContactTolerances.LargestClosing, int rounds = MostRounds)
    {
        var pressed = new PressedBall(ball) { V = v, W = w, OwnContacts = set.Length };
        double scale = v.Length + (ball.Radius * w.Length);
        foreach (ref readonly Contact contact in set)
        {
            scale = Math.Max(scale, contact.Velocity.Length);
        }

        Span<PressedBall> balls = MemoryMarshal.CreateSpan(ref pressed, 1);
        double change = Solve(balls, set, duration, rounds, settled * scale);
        v = pressed.V;
        w = pressed.W;
        bool found = change <= ContactTolerances.Foreseen * scale;
        foreach (ref readonly Contact contact in set)
        {
            found &= Vector3d.Dot(v - contact.Velocity, in contact.Normal) + contact.MostClosing >= -closing;
        }

        return found;
    }

    /// <summary>True if a set too large for the force-level solver holds a ball: from a standstill, the forces do not move it.</summary>
    /// <param name="set">The contacts.</param>
    /// <param name="world">The world.</param>
    /// <param name="free">The rates without contacts.</param>
    /// <param name="duration">The time, s.</param>
    /// <param name="still">A ball below this speed is at a standstill, m/s, and rad/s times its radius.</param>
    [SkipLocalsInit]
    public static bool Holds(scoped Span<Contact> set, World world, in MotionRates free, double duration, double still)
    {
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        Span<Contact> held = world.Spare.Of(set.Length, room).Slice(0, set.Length);
        set.CopyTo(held);
        ContactSet.Forget(held);
        Vector3d v = duration * free.Acceleration;
        Vector3d w = duration * free.SpinAcceleration;
        double most = ContactTolerances.StillHeld * (v.Length + (world.Ball.Radius * w.Length));
        Solve(held, world.Ball, duration, ref v, ref w);
        return v.Length + (world.Ball.Radius * w.Length) <= most + still;
    }

    /// <summary>Solves the impulses, starting from those that the contacts and the balls already hold.</summary>
    /// <param name="balls">The balls, with the velocities and spins without contacts.</param>
    /// <param name="contacts">Their contacts.</param>
    /// <param name="h">The time, s, in which a contact with a gap may close.</param>
    /// <param name="mostRounds">Maximum number of iterations.</param>
    /// <param name="settled">Change of a ball's speed below which the solver has converged, m/s.</param>
    /// <param name="slow">Speed of all balls below which it also stops, m/s; negative to skip this check.</param>
    /// <param name="share">Share of the resistance of the last part that each ball starts with.</param>
    /// <returns>The change of a ball's speed in the last iteration, m/s.</returns>
    public static double Solve(Span<PressedBall> balls, Span<Contact> contacts, double h, int mostRounds, double settled, double slow = -1, double share = 0)
    {
        Begin(balls, contacts, h, share);
        double change = double.PositiveInfinity;
        double before = 0;
        for (int round = 0; round < mostRounds && change > settled; round++)
        {
            // Alternate the order, so that the load of a ball on top reaches the ground in one iteration.
            change = 0;
            double square = 0;
            for (int i = 0; i < contacts.Length; i++)
            {
                ref Contact contact = ref contacts[(round & 1) == 0 ? contacts.Length - 1 - i : i];
                change = Math.Max(change, Press(ref contact, balls, ref square));
            }

            foreach (ref PressedBall ball in balls)
            {
                change = Math.Max(change, ball.Radius * Resist(ref ball, contacts, h));
            }

            if (slow >= 0 && round % RoundsBetween == RoundsBetween - 1 && Fastest(balls) <= slow)
            {
                break;
            }

            // The change in an iteration approximates a negative gradient: extrapolate along the conjugate direction, except after the last
            // iteration.
            if (round < mostRounds - 1 && change > settled)
            {
                Extrapolate(balls, contacts, square <= before ? square / before : 0);
            }

            before = square;
        }

        return change;
    }

    /// <summary>Returns the greatest speed of any ball, including its spin, m/s.</summary>
    public static double Fastest(Span<PressedBall> balls)
    {
        double fastest = 0;
        foreach (ref readonly PressedBall ball in balls)
        {
            fastest = Math.Max(fastest, ball.V.Length + (ball.Radius * ball.W.Length));
        }

        return fastest;
    }

    /// <summary>Returns the contact of a ball with the greatest load, other than with balls; −1 if there is none.</summary>
    public static int BearerOf(in PressedBall ball, Span<Contact> contacts)
    {
        int bearer = ContactSet.Heaviest(contacts.Slice(ball.FirstContact, ball.OwnContacts));
        return bearer < 0 ? bearer : ball.FirstContact + bearer;
    }

    /// <summary>Scales velocities and spins until stationary contacts do no work.</summary>
    /// <remarks>
    /// By Coulomb's law, each impulse J satisfies J·v ≤ 0 at the end; together, J = M (v − v_free). So v·M v ≤ v·M v_free. In a narrow wedge the impulses
    /// are huge, and their rounding errors break this. If only balls press each other, it scales their impulses instead, because these keep the momentum.
    /// </remarks>
    /// <param name="balls">The balls.</param>
    /// <param name="contacts">Their contacts, which do not change.</param>
    public static void LimitWork(Span<PressedBall> balls, Span<Contact> contacts)
    {
        bool isFree = true;
        foreach (ref readonly Contact contact in contacts)
        {
            if (contact.Velocity != Vector3d.Zero)
            {
                return;
            }

            isFree &= contact.Second >= 0 || contact.Load == 0;
        }

        // v·M v, v·M v_free, J·v_free and J·M⁻¹J over all balls and spins, with J = M (v − v_free).
        double square = 0;
        double shared = 0;
        double closing = 0;
        double pushed = 0;
        foreach (ref readonly PressedBall ball in balls)
        {
            Vector3d impulse = ball.V - ball.FreeV;
            Vector3d torque = ball.W - ball.FreeW;
            square += (ball.V.LengthSquared / ball.PerMass) + (ball.W.LengthSquared / ball.PerInertia);
            shared += (Vector3d.Dot(in ball.V, in ball.FreeV) / ball.PerMass) + (Vector3d.Dot(in ball.W, in ball.FreeW) / ball.PerInertia);
            closing += (Vector3d.Dot(in impulse, in ball.FreeV) / ball.PerMass) + (Vector3d.Dot(in torque, in ball.FreeW) / ball.PerInertia);
            pushed += (impulse.LengthSquared / ball.PerMass) + (torque.LengthSquared / ball.PerInertia);
        }

        if (!(square > shared + (ContactTolerances.PieceEnergy * square)))
        {
            return;
        }

        // Scaled by s, the impulses do the work s J·v_free + s² J·M⁻¹J.
        double share = Math.Max(0, isFree ? Math.Min(1, -closing / pushed) : shared / square);
        foreach (ref PressedBall ball in balls)
        {
            ball.V = isFree ? ball.FreeV + (share * (ball.V - ball.FreeV)) : share * ball.V;
            ball.W = isFree ? ball.FreeW + (share * (ball.W - ball.FreeW)) : share * ball.W;
        }
    }

    /// <summary>Stores the motion without contacts, and applies the impulses that the contacts and the balls already hold.</summary>
    private static void Begin(Span<PressedBall> balls, Span<Contact> contacts, double h, double share)
    {
        foreach (ref PressedBall ball in balls)
        {
            ball.FreeV = ball.V;
            ball.FreeW = ball.W;

            // Warm start also of the resistance: without it, the impulses of the last part would be no solution.
            int bearer = BearerOf(in ball, contacts);
            ball.Turning = bearer < 0 ? TurningResistance.None
                : new TurningResistance { Bearer = bearer, Normal = contacts[bearer].Normal, Rolling = share * ball.Turning.Rolling, Drilling = share * ball.Turning.Drilling };
            ball.W += ball.Turning.Removed;
        }

        foreach (ref Contact contact in contacts)
        {
            // A gap may close within the time h. Over zero time, only touching surfaces count.
            contact.MostClosing = h > 0 ? Math.Max(0, contact.Gap) / h : contact.Touches ? 0 : double.MaxValue;
            Give(in contact, (contact.Load * contact.Normal) + contact.Rub, in contact.Rub, balls);
            Twist(in contact, contact.Twist, balls);
        }
    }

    /// <summary>Nonsmooth nonlinear conjugate gradients (Silcowitz, Niebe, Erleben): adds β p to the impulses, with p ← β p +
    /// change.</summary>
    private static void Extrapolate(Span<PressedBall> balls, Span<Contact> contacts, double beta)
    {
        foreach (ref Contact contact in contacts)
        {
            double load = beta > 0 ? beta * contact.LoadStep : 0;
            Vector3d friction = beta > 0 ? beta * contact.RubStep : Vector3d.Zero;
            contact.LoadStep = load + contact.LoadChange;
            contact.RubStep = friction + contact.RubChange;
            if (load != 0 || friction != Vector3d.Zero)
            {
                contact.Load += load;
                contact.Rub += friction;
                Give(in contact, (load * contact.Normal) + friction, in friction, balls);
            }
        }
    }

    /// <summary>Solves a single contact.</summary>
    /// <param name="contact">The contact.</param>
    /// <param name="balls">The balls.</param>
    /// <param name="square">Receives the square of the change of its impulses, divided by their masses.</param>
    /// <returns>Change of the speed of a ball, m/s.</returns>
    private static double Press(ref Contact contact, Span<PressedBall> balls, ref double square)
    {
        ref readonly PressedBall a = ref balls[contact.First];
        Vector3d n = contact.Normal;

        // The slip velocity u = v₁ − r₁ ω₁ × n − V; for two balls, V = v₂ + r₂ ω₂ × n.
        Vector3d turning = a.Radius * a.W;
        Vector3d relative = a.V;
        double perMass = a.PerMass;
        if (contact.Second >= 0)
        {
            ref readonly PressedBall b = ref balls[contact.Second];
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
        double load = contact.Bounces ? 0 : Math.Max(0, contact.Load - ((rate + contact.MostClosing) * contact.NormalMass));
        if (load == 0 && contact.Load == 0 && contact.Rub == Vector3d.Zero)
        {
            // The surfaces are close, but the contact carries no load: there is no impulse to apply.
            contact.LoadChange = 0;
            contact.RubChange = Vector3d.Zero;
            return 0;
        }

        double pushed = load - contact.Load;
        contact.Load = load;
        contact.LoadChange = pushed;

        // J_t: the impulse that stops the slip s, limited by friction.
        Vector3d slip = relative - (rate * n) - Vector3d.Cross(in turning, in n);
        Vector3d friction = contact.Rub - (contact.SlipMass * slip);
        double most = contact.Material.Resistance.MostFriction(load);
        double size = friction.LengthSquared;
        contact.Sticks = size <= most * most;
        if (!contact.Sticks)
        {
            friction = most > 0 ? most / Math.Sqrt(size) * friction : Vector3d.Zero;
        }

        Vector3d rubbed = friction - contact.Rub;
        contact.Rub = friction;
        contact.RubChange = rubbed;
        square += (pushed * pushed / contact.NormalMass) + (rubbed.LengthSquared / contact.SlipMass);
        Give(in contact, (pushed * n) + rubbed, in rubbed, balls);
        if (contact.Second >= 0)
        {
            // About the normal: the impulse that stops the relative spin, at most b μ J_n.
            double about = Vector3d.Dot(a.W - balls[contact.Second].W, in n);
            double twist = contact.Twist - (contact.TwistMass * about);
            double mostTwist = contact.Material.Resistance.MostDrilling(load);
            twist = Math.Max(-mostTwist, Math.Min(twist, mostTwist));
            double twisted = twist - contact.Twist;
            contact.Twist = twist;
            Twist(in contact, twisted, balls);
        }

        return perMass * Math.Max(Math.Abs(pushed), rubbed.Length);
    }

    /// <summary>Applies an impulse to the first ball of a contact, and the opposite one to the second.</summary>
    private static void Give(in Contact contact, in Vector3d impulse, in Vector3d friction, Span<PressedBall> balls)
    {
        // Apply the impulse to both: v₁ += J/m₁, ω₁ −= (r₁/I₁) n × J; v₂ −= J/m₂, ω₂ −= (r₂/I₂) n × J.
        Vector3d turned = Vector3d.Cross(in contact.Normal, in friction);
        ref PressedBall a = ref balls[contact.First];
        a.V += a.PerMass * impulse;
        a.W -= a.Radius * a.PerInertia * turned;
        if (contact.Second >= 0)
        {
            ref PressedBall b = ref balls[contact.Second];
            b.V -= b.PerMass * impulse;
            b.W -= b.Radius * b.PerInertia * turned;
        }
    }

    /// <summary>Applies an impulse to the relative spin of two balls about the normal, N m s.</summary>
    private static void Twist(in Contact contact, double impulse, Span<PressedBall> balls)
    {
        if (contact.Second >= 0)
        {
            ref PressedBall a = ref balls[contact.First];
            ref PressedBall b = ref balls[contact.Second];
            a.W += a.PerInertia * impulse * contact.Normal;
            b.W -= b.PerInertia * impulse * contact.Normal;
        }
    }

    /// <summary>Applies rolling resistance, drilling friction and damping at the contact with the greatest load, other than with balls.</summary>
    /// <returns>Change of the spin, rad/s.</returns>
    private static double Resist(ref PressedBall ball, Span<Contact> contacts, double h)
    {
        int bearer = BearerOf(in ball, contacts);
        ball.Turning.MoveTo(bearer, bearer < 0 ? Vector3d.Zero : contacts[bearer].Normal, ref ball.W);
        if (bearer < 0)
        {
            return 0;
        }

        // A contact that slips has no rolling resistance.
        ref readonly Contact contact = ref contacts[bearer];
        Resistance resistance = contact.Material.Resistance;
        double perLoad = contact.Load * ball.PerInertia;
        double mostRolling = resistance.MostRolling(perLoad, (ball.V - contact.Velocity).Length);
        return ball.Turning.Act(
            h * resistance.Damping * ball.PerInertia, resistance.MostDrilling(perLoad),
            contact.Sticks ? (1.0 + ball.InertiaFactor) * ball.Radius * mostRolling : 0, ref ball.W);
    }
}
