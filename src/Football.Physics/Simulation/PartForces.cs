using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <summary>Bounds the forces in a part of a step with velocity-level impulses, so that a part of any length does not overshoot.</summary>
internal static class PartForces
{
    /// <summary>Maximum change of the velocity per part, m/s; no flight comes close to it.</summary>
    private const double MostSpeed = 100.0;

    /// <summary>Maximum change of the spin per part, in addition to the current spin, rad/s.</summary>
    private const double MostSpin = 1000.0;

    /// <summary>Bounds the forces of the air and the weight, and adds the nets.</summary>
    /// <param name="world">The world.</param>
    /// <param name="guard">The guard of its nets.</param>
    /// <param name="s">The ball, with its nets.</param>
    /// <param name="at">Its position, velocity and spin.</param>
    /// <param name="rates">The rates without contacts and nets.</param>
    /// <param name="h">Length of the part, s.</param>
    public static MotionRates Bounded(World world, NetGuard guard, in BallState s, in Motion at, in MotionRates rates, double h)
    {
        Vector3d acceleration = NoMore(in rates.Acceleration, MostSpeed / h);
        Vector3d spinAcceleration = NoMore(in rates.SpinAcceleration, (at.Spin.Length + MostSpin) / h);
        if (s.Nets != 0)
        {
            // A net settles at the rate λ. Apply the share 1/(1 + h λ) of its push, as an implicit step would.
            MotionRates nets = world.NetForces.Push(s.Nets, s.NetSides, null, in at);
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
