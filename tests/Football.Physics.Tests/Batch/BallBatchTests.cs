using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Batch;

/// <summary>Many balls at once do what the single ball does.</summary>
public sealed class BallBatchTests
{
    private const int Count = 600;

    public static TheoryData<string> Scenes() => BatchScenes.Names();

    public static TheoryData<string, Integrator> ScenesAndMethods()
    {
        var all = new TheoryData<string, Integrator>();
        foreach (string scene in BatchScenes.All.Keys)
        {
            all.Add(scene, Integrator.Rk2);
            all.Add(scene, Integrator.Rk4);
        }

        return all;
    }

    [Theory]
    [MemberData(nameof(ScenesAndMethods))]
    public void Lands_where_the_single_ball_lands(string name, Integrator method)
    {
        Scene scene = BatchScenes.All[name];
        var batch = new BallBatch(scene, new BatchSettings { Integrator = method, TimeStep = 0.01, FindApex = true });
        BatchLaunches launches = BatchScenes.Launches(1, Count);
        BatchFlights flights = BatchScenes.Fly(batch, launches);
        var simulator = new Simulator(scene, new SolverSettings { Integrator = method });
        var distances = new List<double>();
        for (int i = 0; i < Count; i++)
        {
            BallState state = simulator.Launch(launches.Position[i], launches.Velocity[i], launches.Spin[i]);
            var log = new StepLog();
            simulator.Run(ref state, batch.TimeStep, 30, StopAt.Impact, log);
            BallEvent impact = log.Events[0];
            Assert.Equal(BatchEnd.Impact, flights.End[i]);
            distances.Add(Vector3d.Distance(impact.Position, flights.Position[i]));
            Assert.Equal(impact.Time, flights.Time[i], 5e-3);
            Assert.True(Vector3d.Distance(impact.VelocityBefore, flights.Velocity[i]) < 2e-2);
            Assert.True(Vector3d.Distance(impact.SpinBefore, flights.Spin[i]) < 2e-3);
            Assert.Equal(simulator.ContactHeight, flights.Position[i].Y);
            ImpactIsApplied(scene, flights, i);
        }

        distances.Sort();
        FlewInLanes(distances);
        Assert.True(distances[Count * 99 / 100] < 2e-5, $"99 % within {distances[Count * 99 / 100]:e2} m");
        Assert.True(distances[^1] < 1e-4, $"all within {distances[^1]:e2} m");
    }

    /// <summary>Among so many some graze the drag law's jump, slide along it, or pass its corner within a step.</summary>
    [Theory]
    [InlineData(10, 22, 25, 0.01, 1e-5, 1e-4)]
    [InlineData(10, 22, 25, 0.02, 1e-5, 1e-4)]
    [InlineData(10, 22, 25, 0.04, 1e-5, 5e-4)]
    [InlineData(15, 40, 130, 0.01, 2e-5, 1e-4)]
    [InlineData(15, 40, 130, 0.02, 2e-5, 2e-4)]
    [InlineData(15, 40, 130, 0.04, 2e-5, 5e-4)]
    [InlineData(11, 16, 8, 0.02, 1e-5, 1e-4)]
    public void No_shot_is_far_from_the_single_ball(double slow, double fast, double mostSpin, double step, double nearlyAll, double all)
    {
        const int many = 10_000;
        BatchLaunches launches = BatchScenes.Launches(6, many, slow, fast, mostSpin);
        BatchFlights single = BatchScenes.Fly(new BallBatch(Scene.Published, new BatchSettings { TimeStep = step }), launches);
        BatchFlights twice = BatchScenes.Fly(new BallBatch(Scene.Published, new BatchSettings { TimeStep = step, Precision = BatchPrecision.Double }), launches);
        double[] apart = [.. Enumerable.Range(0, many).Select(i => Vector3d.Distance(single.Position[i], twice.Position[i])).Order()];
        FlewInLanes(apart);
        Assert.True(apart[many * 99 / 100] < nearlyAll, $"99 % within {apart[many * 99 / 100]:e2} m");
        Assert.True(apart[^1] < all, $"all within {apart[^1]:e2} m");
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Finds_the_highest_point(string name)
    {
        Scene scene = BatchScenes.All[name];
        BatchLaunches launches = BatchScenes.Launches(2, Count);
        BatchFlights single = BatchScenes.Fly(new BallBatch(scene, new BatchSettings { FindApex = true }), launches);
        BatchFlights twice = BatchScenes.Fly(new BallBatch(scene, new BatchSettings { FindApex = true, Precision = BatchPrecision.Double }), launches);
        double[] apart = [.. Enumerable.Range(0, Count).Select(i => Math.Abs(single.Apex[i] - twice.Apex[i])).Order()];
        FlewInLanes(apart);
        Assert.True(apart[Count * 99 / 100] < 1e-5);
        Assert.True(apart[^1] < 1e-4);
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Flies_until_a_time(string name)
    {
        Scene scene = BatchScenes.All[name];
        BatchLaunches launches = BatchScenes.Launches(3, Count);
        var batch = new BallBatch(scene, new BatchSettings { TimeStep = 0.01 });
        BatchFlights flights = BatchScenes.Fly(batch, launches, 0.4567);
        var simulator = new Simulator(scene);
        for (int i = 0; i < Count; i++)
        {
            BallState state = simulator.Launch(launches.Position[i], launches.Velocity[i], launches.Spin[i]);
            if (simulator.Run(ref state, batch.TimeStep, 0.4567, StopAt.Impact, new StepLog()))
            {
                Assert.Equal(BatchEnd.Impact, flights.End[i]);
                continue;
            }

            Assert.Equal(BatchEnd.Time, flights.End[i]);
            Assert.Equal(0.4567, flights.Time[i], 1e-15);
            Assert.True(Vector3d.Distance(state.Position, flights.Position[i]) < 1e-4);
            Assert.Equal(flights.Velocity[i], flights.VelocityAfter[i]);
        }
    }

    [Fact]
    public void In_double_it_is_the_single_ball_to_the_bit()
    {
        var batch = new BallBatch(Scene.Published, new BatchSettings { Precision = BatchPrecision.Double });
        BatchLaunches launches = BatchScenes.Launches(4, 50);
        BatchFlights flights = BatchScenes.Fly(batch, launches);
        var simulator = new Simulator(Scene.Published);
        for (int i = 0; i < 50; i++)
        {
            BallState state = simulator.Launch(launches.Position[i], launches.Velocity[i], launches.Spin[i]);
            var log = new StepLog();
            simulator.Run(ref state, batch.TimeStep, 30, StopAt.Impact, log);
            Assert.Equal(log.Events[0].Position, flights.Position[i]);
            Assert.Equal(log.Events[0].Time, flights.Time[i]);
            Assert.Equal(log.Events[0].Spin, flights.SpinAfter[i]);
        }
    }

    [Fact]
    public void What_is_outside_the_lanes_domain_flies_alone()
    {
        var launches = new BatchLaunches(4);
        launches.Set(0, new Vector3d(0, 500, 0), new Vector3d(10, 0, 0), default);
        launches.Set(1, default, new Vector3d(150, 30, 0), new Vector3d(0, 10, 0));
        launches.Set(2, default, new Vector3d(20, 10, 0), new Vector3d(0, 9999, 0));
        launches.Set(3, default, new Vector3d(20, -1, 0), new Vector3d(0, 10, 0));
        BatchFlights flights = BatchScenes.Fly(new BallBatch(Scene.Published), launches);
        BatchFlights twice = BatchScenes.Fly(new BallBatch(Scene.Published, new BatchSettings { Precision = BatchPrecision.Double }), launches);
        foreach (int i in (int[])[0, 1, 3])
        {
            Assert.Equal(BatchScenes.Bits(twice, i), BatchScenes.Bits(flights, i));
        }

        Assert.Equal(0, flights.Time[3]);
        Assert.Equal(BatchEnd.Impact, flights.End[3]);
    }

    [Fact]
    public void A_ball_that_lies_on_the_ground_does_not_fly()
    {
        var launches = new BatchLaunches(1);
        launches.Set(0, default, new Vector3d(5, 0.1, 0), default);
        BatchFlights flights = BatchScenes.Fly(new BallBatch(Scene.Published), launches);
        Assert.Equal(BatchEnd.Ground, flights.End[0]);
        Assert.Equal(0, flights.Time[0]);
        Assert.Equal(0.11, flights.Position[0].Y);
    }

    [Fact]
    public void A_scene_with_a_force_of_its_own_flies_alone_and_feels_it()
    {
        BatchLaunches launches = BatchScenes.Launches(5, 20);
        BatchFlights without = BatchScenes.Fly(new BallBatch(Scene.Published), launches);
        var gust = IForce.From(ball => new Vector3d(0.4 + (0.1 * ball.Position.Y), 0, -0.02 * ball.AirVelocity.Z));
        BatchFlights flights = AreFlownAlone(Scene.Published with { Forces = ForceSet.Published with { CustomForces = [gust] } }, launches);
        for (int i = 0; i < 20; i++)
        {
            // Half a metre in a second, and there is no shot so short.
            Assert.True(flights.Position[i].X - without.Position[i].X > 0.02, $"{flights.Position[i]}, without the force {without.Position[i]}");
        }
    }

    [Fact]
    public void A_scene_of_constant_and_fitted_laws_flies_alone() =>
        AreFlownAlone(Scene.Published with { Forces = ForceSet.Published with { Drag = ForceLaw.Constant } }, BatchScenes.Launches(5, 20));

    [Fact]
    public void Refuses_what_is_out_of_range()
    {
        var batch = new BallBatch(Scene.Published, new BatchSettings { Threads = 2 });
        var launches = new BatchLaunches(700);
        var flights = new BatchFlights(700);
        for (int i = 0; i < 700; i++)
        {
            launches.Set(i, default, new Vector3d(1, 1, 1), default);
        }

        launches.Velocity.Y[450] = double.NaN;
        string message = Assert.Throws<ArgumentOutOfRangeException>(() => batch.Fly(launches, flights, 700)).Message;
        Assert.Contains("launch.velocity[450] is (1, NaN, 1)", message, StringComparison.Ordinal);
        batch.Fly(launches, flights, 400);
        Assert.Throws<ArgumentOutOfRangeException>(() => batch.Fly(launches, flights, 701));
        Assert.Throws<ArgumentOutOfRangeException>(() => batch.Fly(launches, flights, 1, 0));
        Assert.Throws<ArgumentNullException>(() => batch.Fly(null!, flights, 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new BallBatch(Scene.Published, new BatchSettings { Integrator = Integrator.Euler }));
        Assert.Throws<ArgumentOutOfRangeException>(() => new BallBatch(Scene.Published, new BatchSettings { TimeStep = 0 }));
        Assert.Throws<ArgumentOutOfRangeException>(() => new BallBatch(Scene.Published, new BatchSettings { Threads = 0 }));
    }

    /// <summary>To the bit what is flown in double, which lanes of floats never are.</summary>
    private static BatchFlights AreFlownAlone(Scene scene, BatchLaunches launches)
    {
        BatchFlights flights = BatchScenes.Fly(new BallBatch(scene), launches);
        BatchFlights twice = BatchScenes.Fly(new BallBatch(scene, new BatchSettings { Precision = BatchPrecision.Double }), launches);
        for (int i = 0; i < launches.Capacity; i++)
        {
            Assert.Equal(BatchScenes.Bits(twice, i), BatchScenes.Bits(flights, i));
        }

        return flights;
    }

    /// <summary>Flown alone they would be what they are compared with, to the bit: most of these, sorted, are not.</summary>
    private static void FlewInLanes(IReadOnlyList<double> apart) => Assert.True(apart[apart.Count / 2] > 0, "flown alone");

    private static void ImpactIsApplied(Scene scene, BatchFlights flights, int i)
    {
        ImpactLaw.Apply(
            scene.Ball, new ContactMaterial(scene.Ground), Vector3d.Up, Vector3d.Zero, flights.Velocity[i], flights.Spin[i], out Vector3d velocity, out Vector3d spin);

        Assert.Equal(velocity, flights.VelocityAfter[i]);
        Assert.Equal(spin, flights.SpinAfter[i]);
    }
}
