using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Accuracy;

/// <summary>What is picked for a wanted accuracy keeps to it: random shots from the kick to the impact, against steps of 0.5 ms.</summary>
public sealed class AccuracyWantedTests
{
    private const int Count = 1200;

    private static readonly Dictionary<string, Scene> s_scenes = new()
    {
        ["published"] = Scene.Published,
        ["wind"] = Scene.Published with { Air = new Air { Wind = new Vector3d(6, 0.5, -5) } },
        ["regularised"] = Scene.Published with { Forces = ForceSet.Regularized },
        ["constant"] = Scene.Published with { Forces = ForceSet.Constant },
        ["small ball"] = new() { Ball = BallProperties.YouthFootball },
    };

    public static TheoryData<string> Scenes() => [.. s_scenes.Keys];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Every_shot_lands_within_the_accuracy_wanted(string name)
    {
        Scene scene = s_scenes[name];
        var launches = new BatchLaunches(Count);
        var random = new Shots(61);
        for (int i = 0; i < Count; i++)
        {
            launches.Set(i, default, random.Velocity(8, 40, 1, 60), random.Uniform(0, 80) * random.Direction());
        }

        BatchFlights reference = Fly(scene, launches, new BatchSettings { TimeStep = 5e-4, Precision = BatchPrecision.Double });
        foreach ((FootballPhysics.Accuracy wanted, double metres) in Wanted())
        {
            SolverSettings settings = SolverSettings.For(wanted, out double step);
            var one = new BatchSettings { Integrator = settings.Integrator, TimeStep = step, Precision = BatchPrecision.Double };
            Hold($"{name}, {wanted}", Fly(scene, launches, one), reference, metres);
            Hold($"{name}, {wanted}, batch", Fly(scene, launches, BatchSettings.For(wanted)), reference, metres);
        }
    }

    [Fact]
    public void A_coarser_accuracy_takes_larger_steps()
    {
        double longest = double.PositiveInfinity;
        foreach ((FootballPhysics.Accuracy wanted, _) in Wanted())
        {
            SolverSettings settings = SolverSettings.For(wanted, out double step);
            settings.Validate();
            BatchSettings.For(wanted).Validate();
            Assert.True(step < longest);
            longest = step;
        }
    }

    [Fact]
    public void Refuses_what_is_none_of_them()
    {
        string message = Assert.Throws<ArgumentOutOfRangeException>(() => SolverSettings.For((FootballPhysics.Accuracy)3, out _)).Message;
        Assert.Contains("accuracy is 3", message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => BatchSettings.For((FootballPhysics.Accuracy)(-1)));
    }

    private static (FootballPhysics.Accuracy Wanted, double Metres)[] Wanted() =>
        [(FootballPhysics.Accuracy.Millimeter, 1e-3), (FootballPhysics.Accuracy.TenthOfMillimeter, 1e-4), (FootballPhysics.Accuracy.Micrometer, 1e-6)];

    private static BatchFlights Fly(Scene scene, BatchLaunches launches, BatchSettings settings)
    {
        var flights = new BatchFlights(launches.Capacity);
        new BallBatch(scene, settings).Fly(launches, flights, launches.Capacity);
        return flights;
    }

    private static void Hold(string what, BatchFlights flights, BatchFlights reference, double metres)
    {
        for (int i = 0; i < Count; i++)
        {
            double apart = Vector3d.Distance(flights.Position[i], reference.Position[i]);
            Assert.True(apart <= metres, $"{what}: shot {i} lands {apart:e2} m from the reference");
        }
    }
}
