namespace FootballPhysics.Yardsticks;

/// <summary>Requests for kicks with given contacts before the target. A solution exists: a random kick had these contacts, and reached the target before any other one.</summary>
/// <param name="simulator">The scene.</param>
/// <param name="after">The contacts before the target.</param>
public sealed class BankShotSet(Simulator simulator, params string[] after)
{
    private readonly Trajectory _path = new(1024);

    /// <summary>The speeds of the kicks, m/s.</summary>
    public (double Least, double Most) Speed { get; init; } = (15, 26);

    /// <summary>The elevations of the kicks, degrees.</summary>
    public (double Least, double Most) Elevation { get; init; } = (4, 30);

    /// <summary>The azimuths of the kicks, degrees to the left of −z.</summary>
    public (double Least, double Most) Azimuth { get; init; } = (-15, 15);

    /// <summary>Draws the next request, to 1 mm.</summary>
    public AimRequest Draw(SeededRandom random)
    {
        const double PerDegree = Math.PI / 180;
        Vector3d from = Shot.Spot;
        while (true)
        {
            double azimuth = random.Uniform(Azimuth.Least, Azimuth.Most) * PerDegree;
            double elevation = random.Uniform(Elevation.Least, Elevation.Most) * PerDegree;
            Vector3d velocity = random.Uniform(Speed.Least, Speed.Most)
                * new Vector3d(-Math.Sin(azimuth) * Math.Cos(elevation), Math.Sin(elevation), -Math.Cos(azimuth) * Math.Cos(elevation));
            (double top, double side) = (random.Uniform(-20, 20), random.Uniform(-20, 20));
            BallState kick = simulator.Launch(from, velocity, KickVectors.Spin(velocity, top, side));
            simulator.LookAhead(in kick, new LookAheadRequest { Duration = 5, TimeStep = 0.01, StopAt = StopAt.Time }, _path);
            BallEvent[] impacts = [.. _path.Events.Span.ToArray().Where(e => e.Kind == BallEventKind.Impact)];
            if (impacts.Length > after.Length && impacts.Take(after.Length).Select(e => simulator.NameOf(e.ColliderIndex)).SequenceEqual(after))
            {
                double begin = impacts[after.Length - 1].Time;
                Vector3d target = _path.PositionAt(begin + (random.Uniform(0.2, 0.9) * (impacts[after.Length].Time - begin)));
                return new AimRequest { From = from, Target = target, Speed = velocity.Length, TopSpin = top, SideSpin = side, Tolerance = 0.001 };
            }
        }
    }
}
