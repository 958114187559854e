namespace FootballPhysics.Tests.Batch;

/// <summary>A result of a batch depends on its own launch alone.</summary>
public sealed class BatchDeterminismTests
{
    private const int Count = 1500;

    public static TheoryData<string, Integrator> ScenesAndMethods() => BallBatchTests.ScenesAndMethods();

    [Theory]
    [MemberData(nameof(ScenesAndMethods))]
    public void Every_width_of_register_gives_the_same_bits(string name, Integrator method)
    {
        // Slow shots: many cross the drag law's jump.
        BatchLaunches launches = BatchScenes.Launches(11, Count, 8, 30);
        var settings = new BatchSettings { Integrator = method, FindApex = true };
        BatchFlights one = BatchScenes.Fly(new BallBatch(BatchScenes.All[name], settings, 1), launches);
        foreach (int lanes in (int[])[4, 8, 16])
        {
            BatchFlights many = BatchScenes.Fly(new BallBatch(BatchScenes.All[name], settings, lanes), launches);
            for (int i = 0; i < Count; i++)
            {
                Assert.Equal(BatchScenes.Bits(one, i), BatchScenes.Bits(many, i));
            }
        }
    }

    [Theory]
    [InlineData(2)]
    [InlineData(5)]
    public void Threads_give_the_same_bits(int threads)
    {
        BatchLaunches launches = BatchScenes.Launches(12, Count);
        BatchFlights one = BatchScenes.Fly(new BallBatch(Scene.Published), launches);
        BatchFlights many = BatchScenes.Fly(new BallBatch(Scene.Published, new BatchSettings { Threads = threads }), launches);
        for (int i = 0; i < Count; i++)
        {
            Assert.Equal(BatchScenes.Bits(one, i), BatchScenes.Bits(many, i));
        }
    }

    [Fact]
    public void Order_and_company_do_not_matter()
    {
        BatchLaunches launches = BatchScenes.Launches(13, Count, 8, 30);
        BatchFlights straight = BatchScenes.Fly(new BallBatch(Scene.Published), launches);
        var shuffled = new BatchLaunches(Count / 2);
        int Place(int i) => i * 7 % Count;
        for (int i = 0; i < Count / 2; i++)
        {
            shuffled.Set(i, launches.Position[Place(i)], launches.Velocity[Place(i)], launches.Spin[Place(i)]);
        }

        BatchFlights other = BatchScenes.Fly(new BallBatch(Scene.Published), shuffled);
        for (int i = 0; i < Count / 2; i++)
        {
            Assert.Equal(BatchScenes.Bits(straight, Place(i)), BatchScenes.Bits(other, i));
        }
    }

    [Fact]
    public void A_run_allocates_nothing()
    {
        BatchLaunches launches = BatchScenes.Launches(14, Count, 8, 30);
        var flights = new BatchFlights(Count);
        foreach (BatchPrecision precision in (BatchPrecision[])[BatchPrecision.Single, BatchPrecision.Double])
        {
            var batch = new BallBatch(Scene.Published, new BatchSettings { Precision = precision, FindApex = true, TimeStep = 0.05 });
            Assert.Equal(0, Allocation.Of(() => batch.Fly(launches, flights, Count)));
        }
    }
}
