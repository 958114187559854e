namespace FootballPhysics;

/// <summary>The forces of a part of a step that impulses end: bounded, so that a part overshoots nothing however long it is.</summary>
internal static class PartForces
{
    /// <summary>The greatest change of the velocity in a part, m/s: far more than any flight gives.</summary>
    private const double MostSpeed = 100.0;

    /// <summary>The greatest change of the spin in a part, rad/s, beside the spin that the ball has.</summary>
    private const double MostSpin = 1000.0;

    /// <summary>Bounds the forces of the air and of the weight, and adds the nets.</summary>
    /// <param name="world">The world.</param>
    /// <param name="guard">The guard of its nets.</param>
    /// <param name="s">The ball, with the nets that it is in.</param>
    /// <param name="at">Its position, velocity and spin.</param>
    /// <param name="rates">The rates without contacts and nets.</param>
    /// <param name="h">The length of the part, s.</param>
    public static MotionRates Bounded(World world, NetGuard guard, in BallState s, in Motion at, in MotionRates rates, double h)
    {
        Vector3d acceleration = NoMore(in rates.Acceleration, MostSpeed / h);
        Vector3d spinAcceleration = NoMore(in rates.SpinAcceleration, (at.Spin.Length + MostSpin) / h);
        if (s.Nets != 0)
        {
            // A net settles at the rate λ. An implicit step takes the share 1/(1 + h λ) of its push.
            MotionRates nets = world.PushOfNets(s.Nets, s.NetSides, in at);
            double share = 1.0 / (1.0 + (h * guard.FastestRate(in s, in at.Position)));
            acceleration += share * nets.Acceleration;
            spinAcceleration += share * nets.SpinAcceleration;
        }

        return new MotionRates(in acceleration, in spinAcceleration, rates.AirSpeed);
    }

    private static Vector3d NoMore(in Vector3d vector, double most)
    {
        double size = vector.Length;
        return size > most ? most / size * vector : vector;
    }
}
