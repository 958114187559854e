using FootballPhysics.Contacts;
using FootballPhysics.Events;

namespace FootballPhysics.Simulation;

/// <summary>The contact of two balls: their gap and their impacts.</summary>
internal static class BallContact
{
    /// <summary>Two balls that close more slowly than this are in sustained contact, m/s: no bounce, and no impact event.</summary>
    public const double Gentle = 0.01;

    /// <summary>Returns the normal of two balls, from the second to the first. Two balls at one place part along x.</summary>
    /// <param name="apart">The first centre minus the second, m.</param>
    /// <param name="distance">Its length, m.</param>
    public static Vector3d Normal(in Vector3d apart, double distance) => distance > 0 ? apart / distance : new Vector3d(1, 0, 0);

    /// <summary>Returns the gap between the surfaces of two balls, m, and its rate, m/s.</summary>
    public static double Gap(in BallState first, double firstRadius, in BallState second, double secondRadius, out Vector3d normal, out double rate)
    {
        Vector3d apart = first.Position - second.Position;
        double distance = apart.Length;
        normal = Normal(in apart, distance);
        rate = Vector3d.Dot(first.Velocity - second.Velocity, in normal);
        return distance - (firstRadius + secondRadius);
    }

    /// <summary>Computes and reports an impact of two balls.</summary>
    /// <param name="simulators">The scenes of all balls.</param>
    /// <param name="material">The material of impacts between balls.</param>
    /// <param name="i">The first ball.</param>
    /// <param name="j">The second ball.</param>
    /// <param name="n">The normal, from the second ball to the first.</param>
    /// <param name="states">All balls.</param>
    /// <param name="logs">Receive the events of each ball.</param>
    /// <param name="first">The first ball after the impact.</param>
    /// <param name="second">The second ball after the impact.</param>
    public static void Impact(
        Simulator[] simulators, in ContactMaterial material, int i, int j, in Vector3d n, BallState[] states, StepLog[] logs, out Motion first, out Motion second)
    {
        BallProperties ball = simulators[i].Scene.Ball;
        BallProperties other = simulators[j].Scene.Ball;
        ref readonly BallState s = ref states[i];
        ref readonly BallState its = ref states[j];
        bool grips = ImpactLaw.Apply(ball, other, in material, in n, in s, in its, out first, out second);
        logs[i].Report(new BallEvent(j, in n, s.Time, in s, in first.Velocity, in first.Spin, ImpactContact.With(other, in its, in second, -n, grips)));
        logs[j].Report(new BallEvent(i, -n, s.Time, in its, in second.Velocity, in second.Spin, ImpactContact.With(ball, in s, in first, in n, grips)));
    }
}
