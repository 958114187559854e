namespace FootballPhysics.Labs;

/// <summary>Random requests of every kind: speeds, spins, winds, laws, distances, heights, elevation bounds.</summary>
internal static class AimAnything
{
    /// <summary>The number of scenes that the requests are spread over.</summary>
    public const int Scenes = 100;

    private static readonly ForceSet[] Laws = [ForceSet.Published, ForceSet.Regularized, ForceSet.Constant, ForceSet.Published with { Magnus = ForceLaw.Constant }, ForceSet.None];

    /// <summary>Returns one of the scenes.</summary>
    public static Scene Scene(int seed, int index)
    {
        var random = new Random((seed * 1000) + index);
        double angle = random.Between(0, 2 * Math.PI);
        double wind = index % 2 == 0 ? 0 : random.Between(0, 12);
        return FootballPhysics.Scene.Published with { Forces = Laws[index % Laws.Length], Air = new Air { Wind = wind * new Vector3d(Math.Cos(angle), 0, Math.Sin(angle)) } };
    }

    /// <summary>Returns requests for a scene.</summary>
    public static AimRequest[] Requests(int seed, int index, int count)
    {
        var random = new Random((seed * 1000) + 500_000 + index);
        var requests = new AimRequest[count];
        for (int i = 0; i < count; i++)
        {
            double distance = random.Between(1, 70);
            double angle = random.Between(0, 2 * Math.PI);
            bool spins = random.Next(4) > 0;
            (double low, double high) = random.Next(5) switch
            {
                0 => (0, 90),
                1 => (-90, 90),
                2 => (random.Between(0, 30), random.Between(30, 80)),
                _ => (0.0, 45.0),
            };
            requests[i] = new AimRequest
            {
                From = new Vector3d(0, random.Next(3) > 0 ? 0.11 : random.Between(0.11, 2.5), 0),
                Target = new Vector3d(distance * Math.Cos(angle), random.Next(3) > 0 ? random.Between(0.11, 2.5) : random.Between(0.11, 12), distance * Math.Sin(angle)),
                Speed = random.Between(5, 40),
                TopSpin = spins ? random.Between(-60, 60) : 0,
                SideSpin = spins ? random.Between(-60, 60) : 0,
                MinimumElevationDegrees = low,
                MaximumElevationDegrees = high,
                Tolerance = 1e-3,
            };
        }

        return requests;
    }
}
