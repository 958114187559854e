namespace Football.Physics;

/// <summary>Ends a step where the ball touches the ground.</summary>
internal static class TimeOfImpact
{
    /// <summary>Below this correction, s, a linear one is exact to rounding.</summary>
    private const double Negligible = 1e-6;

    /// <summary>Below this height, m, contact needs no correction.</summary>
    private const double Touching = 1e-14;

    /// <summary>Shortens a step to the instant of contact: the integrator's own root, one re-step, one Newton correction on it.</summary>
    /// <returns>False where the ball does not touch the ground after all.</returns>
    public static bool Exact<TSweep, TIntegrator>(ref TSweep sweep, TIntegrator integrator, in HeightArc arc, double contact)
        where TSweep : struct, ISweep
        where TIntegrator : struct, IIntegrator
    {
        double tau = integrator.ContactTime(in arc);
        double low = 0;
        double high = arc.Length;
        for (int i = 0; i < 60; i++)
        {
            sweep.Step(tau);
            double above = sweep.Position.Y - contact;
            if (Math.Abs(above) <= Touching)
            {
                break;
            }

            double velocity = sweep.Velocity.Y;
            double correction = -above / velocity;
            if (velocity < 0 && Math.Abs(correction) <= Negligible)
            {
                sweep.Nudge(correction);
                break;
            }

            if (above > 0)
            {
                low = tau;
            }
            else
            {
                high = tau;
            }

            double next = tau + correction;
            tau = velocity < 0 && next > low && next < high ? next : 0.5 * (low + high);
            if (high - low <= 1e-15 * arc.Length)
            {
                break;
            }
        }

        // A step that ends below contact has touched it, even where its own velocity is zero there (a semi-implicit hop).
        return arc.End < 0 || sweep.Velocity.Y < 0;
    }

    /// <summary>Shortens a step by the thesis' recursive search (2.4.4): halve until the halving is no longer than the tolerance.</summary>
    public static void Bisection<TSweep>(ref TSweep sweep, double h, double tolerance, double contact)
        where TSweep : struct, ISweep
    {
        double tau = h;
        double half = h;
        bool below = true;
        while (half > tolerance)
        {
            half *= 0.5;
            double next = below ? tau - half : tau + half;
            if (next == tau)
            {
                break;
            }

            tau = next;
            sweep.Step(tau);
            below = sweep.Position.Y < contact;
        }

        sweep.Step(tau);
    }
}
