using FootballPhysics.Contacts;
using FootballPhysics.State;

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

    /// <summary>Reduces custom forces that are too stiff for a part: a damping then ends the motion at most, and a spring swings instead of growing.</summary>
    /// <param name="around">The forces.</param>
    /// <param name="ball">The ball.</param>
    /// <param name="branch">The branch of the drag law.</param>
    /// <param name="h">Length of the part, s.</param>
    /// <param name="air">The air and the custom forces; the custom forces are reduced.</param>
    /// <returns>The change of the custom forces by their own effect, as a share of them. Above 1, they were reduced.</returns>
    public static double LimitOwn(Surroundings around, in ForceContext ball, DragBranch branch, double h, ref AirFactors air)
    {
        // Evaluate them again after the velocity, the displacement and the spin that they give.
        Vector3d gained = h * NoMore(in air.Acceleration, MostSpeed / h);
        Vector3d v = ball.Velocity + gained;
        Vector3d w = ball.Spin + (h * NoMore(in air.SpinAcceleration, (ball.Spin.Length + MostSpin) / h));
        Vector3d place = ball.Position + (h * gained);
        Vector3d u = v - around.Wind;
        around.Air.Evaluate(new ForceContext(ball.Time, in place, in v, in u, in w, ball.Motion, ball.AirDistance), branch, out AirFactors after);
        double change = Share(in air.Acceleration, in after.Acceleration);
        double turn = Share(in air.SpinAcceleration, in after.SpinAcceleration);
        air.Acceleration *= change > 1 ? 1.0 / change : 1.0;
        air.SpinAcceleration *= turn > 1 ? 1.0 / turn : 1.0;
        return Math.Max(change, turn);
    }

    private static double Share(in Vector3d before, in Vector3d after)
    {
        double change = (after - before).Length;
        return change == 0 ? 0 : change / before.Length;
    }

    private static Vector3d NoMore(in Vector3d vector, double most)
    {
        double size = vector.Length;
        return size > most ? most / size * vector : vector;
    }
}
