using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Determines the modes of all contacts of a cluster at one instant, as <see cref="ContactModes"/> does for one ball.</summary>
/// <remarks>
/// The modes: which contacts have a load, which stick, and which balls spin relative to each other. It also checks that the modes still hold at
/// the end of a step.
/// </remarks>
internal static class ClusterModes
{
    /// <summary>Maximum number of mode changes per contact, and maximum number of iterations to find the bearers.</summary>
    private const int ChangesOfContact = 3;
    private const int MostBearers = 4;

    /// <summary>Determines the modes, starting with all contacts active.</summary>
    /// <param name="system">The balls and contacts, already updated.</param>
    /// <returns>False if none were found, or if one of the balls is at a standstill.</returns>
    public static bool Find(ClusterSystem system)
    {
        for (int i = 0; i < system.Count; i++)
        {
            ref ClusterBall ball = ref system.Balls[i];
            ball.Bearer = -1;
            ball.HoldsSpin = false;
            ball.SpinSign = 0;
        }

        for (int i = 0; i < system.ContactCount; i++)
        {
            ref ClusterContact contact = ref system.Contacts[i];
            ref SetContact on = ref contact.On;
            double slip = on.Slip.Length;
            on.Press(ContactTolerances.GroupSticking);
            on.Direction = slip > 0 && !on.Sticks ? on.Slip / slip : Vector3d.Zero;
            if (contact.Second >= 0)
            {
                double about = About(system, in contact);
                contact.TwistSign = about > ContactTolerances.GroupTurning ? 1.0 : about < -ContactTolerances.GroupTurning ? -1.0 : 0;
                contact.HoldsTwist = contact.TwistSign == 0 && contact.Lever > 0;
            }
        }

        int most = 8 + (ChangesOfContact * system.ContactCount);
        for (int change = 0; change < most; change++)
        {
            if (!Force(system))
            {
                return false;
            }

            if (!Change(system) && !Start(system))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>True if the modes hold at the end of a step: no load or grip has ended, no slip, spin or roll has passed zero, no
    /// overlap.</summary>
    public static bool Hold(ClusterSystem system)
    {
        for (int i = 0; i < system.ContactCount; i++)
        {
            ref readonly ClusterContact contact = ref system.Contacts[i];
            ref readonly SetContact on = ref contact.On;
            double least = LeastLoad(system, in contact);
            bool holds = !on.Bears ? contact.Gap > ContactTolerances.EnteredUnloaded || (contact.Gap >= -ContactTolerances.EnteredUnloaded && on.Opening >= -ContactTolerances.LeastLoad)
                : on.Load > least
                && (on.Sticks ? on.Grip >= 0 : !(on.Sliding > 0) || Vector3d.Dot(in on.Slip, in on.Direction) > 0)
                && (contact.HoldsTwist ? contact.TwistGrip >= 0 : !(contact.TwistSign * About(system, in contact) < 0));
            if (!holds)
            {
                return false;
            }
        }

        for (int i = 0; i < system.Count; i++)
        {
            ref readonly ClusterBall ball = ref system.Balls[i];
            if (BearerOf(system, i) != ball.Bearer)
            {
                return false;
            }

            if (ball.Bearer < 0)
            {
                continue;
            }

            ref readonly SetContact on = ref system.Contacts[ball.Bearer].On;
            double about = Vector3d.Dot(ball.At.Spin, in on.Normal) - on.CarrierSpin;
            bool holds = (ball.HoldsSpin ? IsHeld(in ball, in on) : !(on.Drilling > 0) || ball.SpinSign * about > 0)
                && (!on.Sticks || Vector3d.Dot(in on.RollingVelocity, in ball.Along) > 0);
            if (!holds)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Returns the relative spin of the two balls of a contact about the normal, rad/s.</summary>
    private static double About(ClusterSystem system, in ClusterContact contact) =>
        contact.Second < 0 ? 0 : Vector3d.Dot(system.Balls[contact.First].At.Spin - system.Balls[contact.Second].At.Spin, in contact.On.Normal);

    /// <summary>Returns the load below which a contact counts as unloaded, N.</summary>
    private static double LeastLoad(ClusterSystem system, in ClusterContact contact) => ContactTolerances.LeastLoad / system.Balls[contact.First].PerMass;

    private static bool IsHeld(in ClusterBall ball, in SetContact on) => Math.Abs(ball.HeldSpin) <= on.Drilling * ball.PerMass * on.Load * (1.0 + ContactTolerances.BeyondCone);

    /// <summary>Solves the forces with the current modes; the bearers follow from the loads.</summary>
    private static bool Force(ClusterSystem system)
    {
        for (int round = 0; round < MostBearers; round++)
        {
            if (!system.Solve())
            {
                return false;
            }

            bool same = true;
            for (int i = 0; i < system.Count; i++)
            {
                ref ClusterBall ball = ref system.Balls[i];
                int bearer = BearerOf(system, i);
                if (bearer != ball.Bearer)
                {
                    same = false;
                    ball.Bearer = bearer;
                    ball.HoldsSpin = false;
                    ball.SpinSign = 0;
                    if (bearer >= 0 && !Roll(ref ball, in system.Contacts[bearer].On))
                    {
                        return false;
                    }
                }
            }

            if (same)
            {
                break;
            }
        }

        return true;
    }

    /// <summary>Determines the direction of a ball's roll on its bearer, and its spin there.</summary>
    /// <returns>False if it is at a standstill.</returns>
    private static bool Roll(ref ClusterBall ball, in SetContact on)
    {
        double about = Vector3d.Dot(ball.At.Spin, in on.Normal) - on.CarrierSpin;
        ball.SpinSign = about > ContactTolerances.GroupTurning ? 1.0 : about < -ContactTolerances.GroupTurning ? -1.0 : 0.0;
        ball.HoldsSpin = ball.SpinSign == 0 && on.Drilling > 0;
        Vector3d rolling = SurfaceSystem.Tangential(in on.RollingVelocity, in on.Normal);
        double speed = rolling.Length;
        ball.Along = speed > 0 ? rolling / speed : Vector3d.Zero;
        return !on.Sticks || speed > ContactTolerances.Undirected;
    }

    /// <summary>Returns the sticking contact with the greatest load on a stationary object; if none sticks, the one with the greatest
    /// load.</summary>
    private static int BearerOf(ClusterSystem system, int ball)
    {
        int bearer = -1;
        for (int i = 0; i < system.ContactCount; i++)
        {
            ref readonly ClusterContact contact = ref system.Contacts[i];
            ref readonly SetContact on = ref contact.On;
            if (contact.First != ball || contact.Second >= 0 || !on.Bears || !(on.Load > 0))
            {
                continue;
            }

            bearer = bearer < 0 || on.Outweighs(in system.Contacts[bearer].On) ? i : bearer;
        }

        return bearer;
    }

    /// <summary>Changes one inconsistent mode: opens the most negative load, closes a penetrating contact, or starts a slip.</summary>
    /// <returns>False if all modes are consistent.</returns>
    private static bool Change(ClusterSystem system)
    {
        int worst = -1;
        double least = 0;
        for (int i = 0; i < system.ContactCount; i++)
        {
            ref readonly ClusterContact contact = ref system.Contacts[i];
            double over = contact.On.Load - LeastLoad(system, in contact);
            if (contact.On.Bears && over <= least)
            {
                least = over;
                worst = i;
            }
        }

        if (worst >= 0)
        {
            system.Contacts[worst].On.Bears = false;
            ForgetBearers(system);
            return true;
        }

        least = -ContactTolerances.LeastLoad;
        for (int i = 0; i < system.ContactCount; i++)
        {
            ref readonly SetContact on = ref system.Contacts[i].On;
            if (!on.Bears && on.Opening < least)
            {
                least = on.Opening;
                worst = i;
            }
        }

        if (worst >= 0)
        {
            system.Contacts[worst].On.Press(ContactTolerances.GroupSticking);
            ForgetBearers(system);
            return true;
        }

        return Slips(system) || Turns(system);
    }

    /// <summary>Starts a slip at the contact that exceeds its friction cone most, against the friction that it needed.</summary>
    private static bool Slips(ClusterSystem system)
    {
        int worst = -1;
        double most = 0;
        for (int i = 0; i < system.ContactCount; i++)
        {
            ref readonly SetContact on = ref system.Contacts[i].On;
            if (on.Bears && on.Sticks)
            {
                worst = on.Excess > most ? i : worst;
                most = Math.Max(most, on.Excess);
            }
        }

        if (worst < 0)
        {
            return false;
        }

        system.Contacts[worst].On.StartSlip();
        ForgetBearers(system);
        return true;
    }

    /// <summary>Starts a relative spin that drilling friction cannot hold, against the holding torque.</summary>
    private static bool Turns(ClusterSystem system)
    {
        for (int i = 0; i < system.ContactCount; i++)
        {
            ref ClusterContact contact = ref system.Contacts[i];
            if (contact.On.Bears && contact.HoldsTwist && Math.Abs(contact.Twist) > contact.Lever * contact.On.Load * (1.0 + ContactTolerances.BeyondCone))
            {
                contact.HoldsTwist = false;
                contact.TwistSign = contact.Twist > 0 ? -1.0 : 1.0;
                return true;
            }
        }

        for (int i = 0; i < system.Count; i++)
        {
            ref ClusterBall ball = ref system.Balls[i];
            if (ball.HoldsSpin && ball.Bearer >= 0 && !IsHeld(in ball, in system.Contacts[ball.Bearer].On))
            {
                ball.HoldsSpin = false;
                ball.SpinSign = ball.HeldSpin > 0 ? -1.0 : 1.0;
                return true;
            }
        }

        return false;
    }

    private static void ForgetBearers(ClusterSystem system)
    {
        for (int i = 0; i < system.Count; i++)
        {
            system.Balls[i].Bearer = -1;
            system.Balls[i].HoldsSpin = false;
            system.Balls[i].SpinSign = 0;
        }
    }

    /// <summary>Iterates the direction of a starting slip until friction and the rate of the slip agree.</summary>
    /// <returns>True if the forces have changed so much that the modes must be checked again.</returns>
    private static bool Start(ClusterSystem system)
    {
        bool changed = false;
        for (int round = 0; round < ContactModes.MostStarts; round++)
        {
            bool again = false;
            for (int i = 0; i < system.ContactCount; i++)
            {
                ref ClusterContact contact = ref system.Contacts[i];
                if (contact.On.StartsToSlip)
                {
                    Vector3d rate = SlipRate(system, in contact);
                    again |= contact.On.TurnSlip(in rate);
                }
            }

            if (!again || !system.Solve())
            {
                break;
            }

            changed = true;
        }

        return changed;
    }

    /// <summary>ṡ = (v̇₁ − v̇₂ − A + ṅ × (r₁ ω₁ + r₂ ω₂) + n × (r₁ ω̇₁ + r₂ ω̇₂))_t, m/s².</summary>
    public static Vector3d SlipRate(ClusterSystem system, in ClusterContact contact)
    {
        ref readonly ClusterBall ball = ref system.Balls[contact.First];
        Vector3d rate = ball.Rates.Acceleration - contact.On.SurfaceRate;
        Vector3d turning = ball.Radius * ball.At.Spin;
        Vector3d turned = ball.Radius * ball.Rates.SpinAcceleration;
        if (contact.Second >= 0)
        {
            ref readonly ClusterBall other = ref system.Balls[contact.Second];
            rate -= other.Rates.Acceleration;
            turning += other.Radius * other.At.Spin;
            turned += other.Radius * other.Rates.SpinAcceleration;
        }

        return SurfaceSystem.Tangential(rate + Vector3d.Cross(contact.On.Turning, in turning) + Vector3d.Cross(contact.On.Normal, in turned), in contact.On.Normal);
    }
}
