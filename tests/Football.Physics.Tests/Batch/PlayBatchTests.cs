using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Batch;

/// <summary>Balls that are played to a plane, to rest or into a goal, on any number of threads.</summary>
public sealed class PlayBatchTests
{
    private const int Count = 300;

    private static readonly Plane3d s_line = new(new Vector3d(0, 0, -20), new Vector3d(0, 0, 1));

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void Every_ball_ends_where_it_does_alone(int threads)
    {
        var simulator = new Simulator();
        BatchLaunches launches = Launches();
        var plays = new BatchResults(Count, samples: 20);
        foreach (LookAheadRequest request in (LookAheadRequest[])[new() { Duration = 60 }, new() { UntilPlane = s_line }])
        {
            new BatchSimulator(simulator, threads).Run(launches, plays, Count, request);
            var path = new Trajectory(4096);
            int crossed = 0;
            for (int i = 0; i < Count; i++)
            {
                BallState ball = simulator.Launch(launches.Position[i], launches.Velocity[i], launches.Spin[i]);
                simulator.LookAhead(in ball, request, path);
                bool crosses = path.TryGetCrossing(in s_line, out PathPoint at) && request.UntilPlane is not null;
                crossed += crosses ? 1 : 0;
                Assert.Equal(crosses, plays.Crossed[i]);
                Assert.Equal(crosses ? at.Position : path.Final.Position, plays.Position[i]);
                Assert.Equal(!crosses && path.TryGetRest(out _), plays.Rests[i]);
                Assert.Equal(path.PositionAt(3 * 0.05), plays.Places[(i * 20) + 3]);
                Assert.InRange(plays.SampleCount[i], 5, 20);
            }

            Assert.Equal(request.UntilPlane is not null, crossed > Count / 2);
        }
    }

    [Fact]
    public void A_goal_is_told_of()
    {
        var scene = new Scene { Goals = [new Goal { Center = new Vector3d(0, 0, -12), Facing = new Vector3d(0, 0, 1) }] };
        var launches = new BatchLaunches(2);
        launches.Set(0, new Vector3d(0, 0.11, 0), new Vector3d(0, 3, -20), Vector3d.Zero);
        launches.Set(1, new Vector3d(0, 0.11, 0), new Vector3d(12, 3, -20), Vector3d.Zero);
        var plays = new BatchResults(2);
        new BatchSimulator(new Simulator(scene)).Run(launches, plays, 2, new LookAheadRequest { Duration = 3 });
        Assert.Equal([true, false], plays.Scored);
    }

    [Fact]
    public void A_run_is_cancelled_between_groups_and_tells_how_far_it_is()
    {
        BatchLaunches launches = Launches();
        using var source = new CancellationTokenSource();
        var told = new List<int>();
        var progress = new Told(done =>
        {
            told.Add(done);
            source.Cancel();
        });
        Assert.Throws<OperationCanceledException>(() => new BallBatch().Fly(launches, new BatchFlights(Count), Count, 30, progress, source.Token));
        Assert.Single(told);
        Assert.InRange(told[0], 1, Count - 1);
        var all = new List<int>();
        new BallBatch().Fly(launches, new BatchFlights(Count), Count, 30, new Told(all.Add));
        Assert.Equal(Count, all[^1]);
        Assert.Equal(all.Order(), all);
    }

    private static BatchLaunches Launches()
    {
        var random = new Shots(61);
        var launches = new BatchLaunches(Count);
        for (int i = 0; i < Count; i++)
        {
            launches.Set(i, new Vector3d(0, 0.11, 0), new Vector3d(random.Uniform(-4, 4), random.Uniform(2, 8), random.Uniform(-25, -10)), random.Uniform(0, 30) * random.Direction());
        }

        return launches;
    }

    private sealed class Told(Action<int> tell) : IProgress<int>
    {
        public void Report(int value) => tell(value);
    }

    /// <summary>Balls that push what they meet share no thread: the answer is that of one.</summary>
    [Fact]
    public void Among_things_that_give_way_the_threads_do_not_count()
    {
        Scene scene = new() { Obstacles = [new Obstacle { Shape = new SphereShape(new Vector3d(0, 0.5, -9), 0.8), Mass = 3 }] };
        BatchLaunches launches = Launches();
        var one = new BatchResults(Count);
        var four = new BatchResults(Count);
        new BatchSimulator(new Simulator(scene)).Run(launches, one, Count, new LookAheadRequest { Duration = 4 });
        new BatchSimulator(new Simulator(scene), 4).Run(launches, four, Count, new LookAheadRequest { Duration = 4 });
        for (int i = 0; i < Count; i++)
        {
            Assert.Equal(one.Position[i], four.Position[i]);
            Assert.Equal(one.Bounces[i], four.Bounces[i]);
        }
    }

    [Fact]
    public void All_bounces_are_counted()
    {
        Scene scene = Scene.Published with { Forces = new ForceSet { Buoyancy = false, Drag = ForceLaw.None, Magnus = ForceLaw.None, SpinDecay = ForceLaw.None }, Ground = Ground.PublishedTurf with { Material = SurfaceMaterial.PublishedTurf with { NormalRestitution = 1 } } };
        var launches = new BatchLaunches(1);
        launches.Set(0, new Vector3d(0, 0.2, 0), Vector3d.Zero, Vector3d.Zero);
        var plays = new BatchResults(1);
        new BatchSimulator(new Simulator(scene)).Run(launches, plays, 1, new LookAheadRequest { Duration = 600, StopAt = StopAt.Time });

        // A hop of 9 cm takes 2 √(2 h/g).
        Assert.Equal(600 / (2 * Math.Sqrt(2 * 0.09 / scene.Gravity)), plays.Bounces[0], 2.0);
    }
}
