using Football.Physics.Headless.Input;
using Football.Physics.Headless.Simulate;
using Football.Physics.Yardsticks;

namespace Football.Physics.Headless.Sweep;

/// <summary>A sweep: the scene, the ranges that launches are drawn from, and how to fly them.</summary>
internal sealed record SweepScenario
{
    public required Scene Scene { get; init; }

    public required BatchSettings Settings { get; init; }

    public required double Duration { get; init; }

    public Vector3d From { get; init; }

    /// <summary>The ranges of speed, elevation, azimuth, topspin and sidespin.</summary>
    public required (double Low, double High)[] Ranges { get; init; }

    /// <summary>Reads and checks a sweep.</summary>
    /// <exception cref="RefusedException">A field is unknown, missing or of the wrong type.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of the library's range.</exception>
    public static SweepScenario Read(InputFields fields)
    {
        InputObject root = fields.Root;
        Scene scene = SceneInput.Scene(root);
        InputObject launch = root.Object("launch");
        InputObject solver = root.Object("solver");
        var sweep = new SweepScenario
        {
            Scene = scene,
            Settings = new BatchSettings
            {
                Integrator = solver.Choice("integrator", BatchSettings.Default.Integrator),
                TimeStep = solver.Number("timeStep", BatchSettings.Default.TimeStep),
                Precision = solver.Choice("precision", BatchSettings.Default.Precision),
                FindApex = true,
            },
            Duration = root.Object("stop").Number("time", Scenario.DefaultDuration),
            From = launch.Vector("position", Vector3d.Zero),
            Ranges =
            [
                launch.Range("speed", (15, 35), KickNumbers.Speeds),
                launch.Range("elevation", (5, 35), KickNumbers.Elevations),
                launch.Range("azimuth", (0, 0), KickNumbers.Azimuths),
                launch.Range("topSpin", (-40, 40), KickNumbers.Spins),
                launch.Range("sideSpin", (-40, 40), KickNumbers.Spins),
            ],
        };
        fields.Check();

        // No launch flies yet, but everything that is the same for all of them is checked.
        new Simulator(scene).Launch(sweep.From, Vector3d.Zero, Vector3d.Zero);
        new BallBatch(scene, sweep.Settings).Fly(new BatchLaunches(1), new BatchFlights(1), 0, sweep.Duration);
        return sweep;
    }

    /// <summary>One launch: it depends on the seed and its index only.</summary>
    public KickNumbers Draw(long seed, long index)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, index));

        // A number is drawn for every range, so that narrowing one does not change the others.
        return new KickNumbers(Between(random, 0), Between(random, 1), Between(random, 2), Between(random, 3), Between(random, 4));
    }

    private double Between(SeededRandom random, int range) => Math.Min(random.Uniform(Ranges[range].Low, Ranges[range].High), Ranges[range].High);
}
