namespace Football.Physics;

/// <summary>Ends a step where the ball touches the ground.</summary>
internal static class TimeOfImpact
{
    /// <summary>Below this height, m, contact needs no correction.</summary>
    private const double Touching = 1e-14;

    /// <summary>Shortens a step to the instant of contact: from the integrator's own root on, most often one re-step and one linear correction of it.</summary>
    /// <returns>False where the ball does not touch the ground after all.</returns>
    public static bool Exact<TSweep, TIntegrator>(ref TSweep sweep, TIntegrator integrator, in HeightArc arc, double contact)
        where TSweep : struct, ISweep
        where TIntegrator : struct, IIntegrator
    {
        EventLocator.Locate(ref sweep, new Touchdown<TSweep>(contact), integrator.ContactTime(in arc));

        // A step that ends below contact has touched it, even where its own velocity is zero there (a semi-implicit hop).
        return arc.End < 0 || sweep.Velocity.Y < 0;
    }

    /// <summary>Shortens a step that ends below contact by the thesis' recursive search (2.4.4): halve until the halving is no longer than the tolerance.</summary>
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

    /// <summary>The height above contact, on its way down.</summary>
    private readonly struct Touchdown<TSweep> : IEventFunction<TSweep>
        where TSweep : struct, ISweep
    {
        private readonly double _contact;

        public Touchdown(double contact) => _contact = contact;

        public bool Evaluate(ref TSweep sweep, double tau, out double value, out double correction)
        {
            value = sweep.Position.Y - _contact;
            double velocity = sweep.Velocity.Y;
            correction = velocity < 0 ? -value / velocity : double.NaN;
            if (Math.Abs(value) <= Touching)
            {
                return true;
            }

            bool isClose = EventLocator.IsLinear(ref sweep, correction);
            if (isClose)
            {
                // Not to before the step's start.
                sweep.Nudge(Math.Max(correction, -tau));
            }

            return isClose;
        }
    }
}
