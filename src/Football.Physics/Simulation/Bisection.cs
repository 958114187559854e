namespace FootballPhysics;

/// <summary>The thesis' search for the time of impact with the level ground (2.4.4).</summary>
internal static class Bisection
{
    /// <summary>Shortens a step that ends below contact: halve, forwards or back, until the halving is no longer than the tolerance.</summary>
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

            // Below the last bit of τ there is nothing left to halve.
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
