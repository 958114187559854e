namespace FootballPhysics.Simulation;

/// <summary>The contact of two balls: their gap.</summary>
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
}
