using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Batch;

/// <summary>Many aims at once answer what the single aimer answers.</summary>
public sealed class BatchAimerTests
{
    private const int Count = 600;

    public static TheoryData<string> Scenes() => BatchScenes.Names();

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Every_hit_passes_within_a_millimetre(string name)
    {
        Scene scene = BatchScenes.All[name];
        BatchAims aims = Aims(21, 20, 30, scene.Ground.Height);
        var kicks = new BatchKicks(Count);
        var aimer = new BatchAimer(scene);
        aimer.Find(aims, kicks, Count);
        var meter = new AimContext(new Simulator(scene)).Miss;
        var single = new Aimer(scene);
        int hits = 0;
        for (int i = 0; i < Count; i++)
        {
            if (kicks.Status[i] != AimStatus.Hit)
            {
                Assert.Equal(single.Find(aims.Request(i)).Status, kicks.Status[i]);
                continue;
            }

            hits++;
            double miss = meter.Measure(aims.Request(i), kicks.Velocity[i], kicks.Spin[i]).Distance;
            Assert.True(miss <= 1e-3, $"aim {i} misses by {miss:e2} m");
            Assert.Equal(aims.Speed[i], kicks.Velocity[i].Length, 1e-9);
        }

        Assert.InRange(hits, Count / 2, Count);
        Assert.True(aimer.ScalarFallbackCount < Count / 20, $"{aimer.ScalarFallbackCount} handed on");
    }

    /// <summary>At these spins and speeds the drag law's branch with spin is so narrow that a large step may miss it.</summary>
    [Fact]
    public void No_hit_is_a_false_one()
    {
        const int many = 8000;
        var random = new Shots(24);
        var aims = new BatchAims(many) { MinimumElevationDegrees = -10, MaximumElevationDegrees = 80, Tolerance = 1e-3 };
        for (int i = 0; i < many; i++)
        {
            double distance = random.Uniform(8, 40);
            double azimuth = random.Uniform(0, 2 * Math.PI);
            var target = new Vector3d(distance * Math.Cos(azimuth), random.Uniform(0.11, 8), distance * Math.Sin(azimuth));
            aims.Set(i, default, target, random.Uniform(14, 32), 0, random.Uniform(5, 7));
        }

        var kicks = new BatchKicks(many);
        new BatchAimer(Scene.Published).Find(aims, kicks, many);
        var meter = new AimContext(new Simulator(Scene.Published)).Miss;
        int hits = 0;
        for (int i = 0; i < many; i++)
        {
            if (kicks.Status[i] == AimStatus.Hit)
            {
                double miss = meter.Measure(aims.Request(i), kicks.Velocity[i], kicks.Spin[i]).Distance;
                Assert.True(miss <= 1e-3, $"aim {i} misses by {miss:e2} m");
                hits++;
            }
        }

        Assert.InRange(hits, many / 2, many);
    }

    /// <summary>What flies in the lanes would roll: a kick from the ground leaves it only from some upward speed on.</summary>
    [Fact]
    public void A_low_drive_with_backspin_is_no_false_hit()
    {
        const int many = 4000;
        var random = new Shots(25);
        var aims = new BatchAims(many) { MaximumElevationDegrees = 60, Tolerance = 1e-3 };
        for (int i = 0; i < many; i++)
        {
            double distance = random.Uniform(5, 30);
            double azimuth = random.Uniform(0, 2 * Math.PI);
            var target = new Vector3d(distance * Math.Cos(azimuth), random.Uniform(0.11, 0.6), distance * Math.Sin(azimuth));
            aims.Set(i, new Vector3d(0, 0.11, 0), target, random.Uniform(20, 35), random.Uniform(-60, -20), random.Uniform(-30, 30));
        }

        var kicks = new BatchKicks(many);
        new BatchAimer(Scene.Published).Find(aims, kicks, many);
        MissMeter meter = new AimContext(new Simulator(Scene.Published)).Miss;
        int hits = 0;
        for (int i = 0; i < many; i++)
        {
            if (kicks.Status[i] == AimStatus.Hit)
            {
                double miss = meter.Measure(aims.Request(i), kicks.Velocity[i], kicks.Spin[i]).Distance;
                Assert.True(miss <= 1e-3, $"aim {i} misses by {miss:e2} m");
                hits++;
            }
        }

        Assert.InRange(hits, many / 4, many);
    }

    [Fact]
    public void Says_what_the_single_aimer_says()
    {
        // Half of them near or beyond the reach.
        BatchAims aims = Aims(22, 10, 22, 0);
        var kicks = new BatchKicks(Count);
        new BatchAimer(Scene.Published).Find(aims, kicks, Count);
        var single = new Aimer(Scene.Published);
        int refused = 0;
        for (int i = 0; i < Count; i++)
        {
            AimResult result = single.Find(aims.Request(i));
            Assert.Equal(result.Status, kicks.Status[i]);
            refused += result.Status == AimStatus.OutOfReach ? 1 : 0;
            if (result.Status == AimStatus.Hit)
            {
                // Both within a millimetre of the same target with the same speed: the same kick to a tenth of a degree.
                Assert.True(Vector3d.Distance(result.Velocity, kicks.Velocity[i]) < 2e-3 * aims.Speed[i]);
            }
        }

        Assert.InRange(refused, Count / 20, Count);
    }

    [Fact]
    public void Width_threads_and_company_do_not_matter()
    {
        BatchAims aims = Aims(23, 15, 30, 0);
        var one = new BatchKicks(Count);
        new BatchAimer(Scene.Published, 1, 1).Find(aims, one, Count);
        foreach ((int threads, int lanes, int count) in ((int, int, int)[])[(1, 4, Count), (1, 8, Count), (3, 16, Count), (1, 16, 77)])
        {
            var other = new BatchKicks(Count);
            new BatchAimer(Scene.Published, threads, lanes).Find(aims, other, count);
            for (int i = 0; i < count; i++)
            {
                Assert.Equal(one.Status[i], other.Status[i]);
                Assert.Equal(BatchScenes.Bits(one.Velocity[i]), BatchScenes.Bits(other.Velocity[i]));
                Assert.Equal(one.Time[i], other.Time[i]);
            }
        }
    }

    [Fact]
    public void Refuses_what_is_out_of_range()
    {
        var aims = new BatchAims(2);
        aims.Set(0, default, new Vector3d(10, 1, 0), 25);
        aims.Set(1, default, new Vector3d(10, 1, 0), -25);
        var aimer = new BatchAimer(Scene.Published);
        string message = Assert.Throws<ArgumentOutOfRangeException>(() => aimer.Find(aims, new BatchKicks(2), 2)).Message;
        Assert.Contains("aim.speed[1] is -25", message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => aimer.Find(aims, new BatchKicks(2), 3));
        Assert.Throws<ArgumentOutOfRangeException>(() => aimer.Find(new BatchAims(1) { MinimumElevationDegrees = 50 }, new BatchKicks(1), 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new BatchAimer(Scene.Published, 0));
    }

    private static BatchAims Aims(int seed, double slow, double fast, double ground)
    {
        var random = new Shots(seed);
        var aims = new BatchAims(Count) { Tolerance = 1e-3 };
        for (int i = 0; i < Count; i++)
        {
            double distance = random.Uniform(15, 25);
            double azimuth = random.Uniform(0, 2 * Math.PI);
            var target = new Vector3d(distance * Math.Cos(azimuth), ground + random.Uniform(0.3, 2.3), distance * Math.Sin(azimuth));
            aims.Set(i, new Vector3d(0, ground, 0), target, random.Uniform(slow, fast), random.Uniform(-20, 20), random.Uniform(-30, 30));
        }

        return aims;
    }

    /// <summary>What is lighter than the air falls as it was kicked, turns, and rises: the ground may be in between.</summary>
    [Fact]
    public void A_balloon_that_would_go_through_the_ground_is_no_hit_of_the_lanes()
    {
        Scene scene = new() { Ball = new BallProperties { Mass = 0.005 }, Forces = new ForceSet { Drag = ForceLaw.None, Magnus = ForceLaw.None, SpinDecay = ForceLaw.None } };
        var aims = new BatchAims(1) { MinimumElevationDegrees = -45 };
        aims.Set(0, new Vector3d(0, 0.5, 0), new Vector3d(0, 0.5, -20), 10);
        var kicks = new BatchKicks(1);
        new BatchAimer(scene).Find(aims, kicks, 1);
        AimResult alone = new Aimer(scene).Find(aims.Request(0));
        Assert.Equal(alone.Status, kicks.Status[0]);
        if (alone.Status == AimStatus.Hit)
        {
            Assert.Equal(alone.Velocity.Y, kicks.Velocity[0].Y, 0.05);
        }
    }
}
