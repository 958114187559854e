using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Batch;

/// <summary>Scenes and launches for batches, the same in every run.</summary>
internal static class BatchScenes
{
    public static readonly IReadOnlyDictionary<string, Scene> All = new Dictionary<string, Scene>
    {
        ["published"] = Scene.Published,
        ["wind"] = Scene.Published with { Air = new Air { Wind = new Vector3d(4, 1, -3) } },
        ["regularised"] = Scene.Published with { Forces = ForceSet.Regularized, Air = new Air { Wind = new Vector3d(-2, 0, 5) } },
        ["constant"] = Scene.Published with { Forces = ForceSet.Constant with { SpinDecayCoefficient = 1e-4 } },
        ["vacuum"] = Scene.Vacuum,
        ["no lift"] = Scene.Published with { Forces = ForceSet.Published with { Magnus = ForceLaw.None } },
        ["measured"] = Scene.Measured,
        ["measured, wind, Jabulani, thin air"] = Scene.Measured with
        {
            Ball = BallProperties.Jabulani,
            Air = Weather.AtAltitude(2240).ToAir() with { Wind = new Vector3d(-3, 0.5, 5) },
            Forces = ForceSet.Measured with { SpinDecay = ForceLaw.None },
            Ground = new Ground { Material = SurfaceMaterial.WetTurf, Height = 1 },
        },
        ["no decay, small ball, raised ground"] = Scene.Published with
        {
            Ball = BallProperties.YouthFootball,
            Forces = ForceSet.Published with { SpinDecay = ForceLaw.None },
            Ground = Ground.PublishedTurf with { Material = SurfaceMaterial.PublishedWetTurf, Height = 3 },
        },
    };

    public static TheoryData<string> Names() => [.. All.Keys];

    /// <summary>Shots from the ground, and some from above it.</summary>
    public static BatchLaunches Launches(int seed, int count, double slow = 15, double fast = 35, double mostSpin = 60)
    {
        var random = new Shots(seed);
        var launches = new BatchLaunches(count);
        for (int i = 0; i < count; i++)
        {
            var from = new Vector3d(random.Uniform(-50, 50), i % 4 == 0 ? random.Uniform(3.2, 10) : 0, random.Uniform(-50, 50));
            Vector3d velocity = random.Velocity(slow, fast, i % 4 == 0 ? -30 : 5, 40);
            launches.Set(i, from, velocity, random.Uniform(i % 7 == 0 ? 0 : 2, mostSpin) * random.Direction());
        }

        return launches;
    }

    public static BatchFlights Fly(BallBatch batch, BatchLaunches launches, double duration = 30)
    {
        var flights = new BatchFlights(launches.Capacity);
        batch.Fly(launches, flights, launches.Capacity, duration);
        return flights;
    }

    /// <summary>Every bit of the results.</summary>
    public static long[] Bits(BatchFlights flights, int index) =>
    [
        (long)flights.End[index],
        BitConverter.DoubleToInt64Bits(flights.Time[index]),
        BitConverter.DoubleToInt64Bits(flights.Apex[index]),
        .. Bits(flights.Position[index]),
        .. Bits(flights.Velocity[index]),
        .. Bits(flights.Spin[index]),
        .. Bits(flights.VelocityAfter[index]),
        .. Bits(flights.SpinAfter[index]),
    ];

    public static long[] Bits(Vector3d v) =>
        [BitConverter.DoubleToInt64Bits(v.X), BitConverter.DoubleToInt64Bits(v.Y), BitConverter.DoubleToInt64Bits(v.Z)];
}
