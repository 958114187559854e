using FootballPhysics.Integration;

namespace FootballPhysics.Simulation;

/// <summary>Finds the time of impact with level ground by the thesis' bisection (2.4.4).</summary>
internal static class Bisection
{
    /// <summary>Shortens a step that ends below contact height: bisects the length until the bracket is within the
    /// tolerance.</summary>
    public static void End<TSweep>(ref TSweep sweep, double tolerance, double contact)
        where TSweep : struct, ISweep
    {
        double tau = sweep.Length;
        double half = tau;
        bool below = true;
        while (half > tolerance)
        {
            half *= 0.5;
            double next = below ? tau - half : tau + half;

            // Stop when a halving no longer changes τ in double precision.
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
