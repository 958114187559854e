namespace FootballPhysics.Tests.Several;

/// <summary>How balls are numbered decides nothing, to the last bit, but of impacts at exactly one time.</summary>
public sealed class NumberingTests
{
    /// <summary>Impacts so soon after a step's start, s, may have been found at that very time, where two touch already.</summary>
    private const double Soon = 1e-6;

    private static readonly BallProperties[] s_sizes =
        [BallProperties.Tunnel, new() { Mass = 0.2, Radius = 0.09 }, new() { Mass = 0.6, Radius = 0.12, InertiaFactor = 0.4 }];

    /// <summary>Heaps of several sizes in a box, in a corner, among leaning walls and on open ground, into which now and then one of their balls is thrown again.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void A_heap_goes_the_same_way_in_any_order(int kind)
    {
        int compared = 0;
        int steps = 0;
        for (int draw = 0; draw < 6; draw++)
        {
            var random = new Random((4 * draw) + kind);
            double Draw(double low, double high) => low + (random.NextDouble() * (high - low));
            Vector3d Across(double most, double height) => new(Draw(-most, most), height, Draw(-most, most));
            double half = Draw(0.2, 0.4);
            double step = new[] { 1 / 60.0, 1 / 120.0, 1 / 30.0, 0.1 }[random.Next(4)];
            Scene scene = Among(kind, half);
            BallProperties[] kinds = [.. Enumerable.Range(0, random.Next(6, 15)).Select(_ => s_sizes[random.Next(3)])];
            int[] order = [.. Enumerable.Range(0, kinds.Length)];
            random.Shuffle(order);
            var group = new BallGroup(scene, kinds);
            var turned = new BallGroup(scene, [.. order.Select(i => kinds[i])]);
            double aside = kind == 3 ? 0.25 : 0.1;
            BallState[] balls = [.. kinds.Select((_, i) => group.SimulatorOf(i).Launch(Across(aside, 0.2 + (0.3 * i)), Across(0.5, 0), Across(9, 3)))];
            var log = new StepLog();
            for (int k = 0; k < 3 / step; k++)
            {
                if (k % 40 == 39)
                {
                    int thrown = random.Next(kinds.Length);
                    double time = balls[thrown].Time;
                    Vector3d place = Across(aside, balls.Max(ball => ball.Position.Y) + Draw(0.3, 0.6));
                    balls[thrown] = group.SimulatorOf(thrown).Launch(place, Across(0.5, Draw(-6, 0)), default);
                    balls[thrown].Time = time;
                }

                double start = balls[0].Time;
                BallState[] other = [.. order.Select(i => balls[i])];
                log.Clear();
                group.Step(balls, step, log);
                turned.Step(other, step, new StepLog());
                steps++;
                if (MayBeAtOnce(log, start))
                {
                    continue;
                }

                compared++;
                for (int i = 0; i < order.Length; i++)
                {
                    Assert.True(
                        Snapshot.Same(in balls[order[i]], in other[i]), $"draw {draw} step {k} ball {order[i]}: {Snapshot.Difference(in balls[order[i]], in other[i])}");
                }
            }
        }

        Assert.InRange(compared, 0.9 * steps, steps);
    }

    private static Scene Among(int kind, double half)
    {
        Obstacle Leaning(double x, double z, double up) => Heap.Wall(x, z) with { Shape = new PlaneShape(new Vector3d(x, 0, z), new Vector3d(-x, up, -z)) };
        return kind switch
        {
            0 => Heap.Box(half),
            1 => Heap.Corner(),
            2 => Scene.Default with { Ground = Heap.Turf, Obstacles = [Leaning(half, 0, 0.1), Leaning(-half, 0, 0.05), Leaning(0, half, 0.15), Leaning(0, -half, 0)] },
            _ => Scene.Default with { Ground = Heap.Turf },
        };
    }

    /// <summary>True when two pairs may have met at exactly one time: of those the ball of the lower number has its impact first.</summary>
    private static bool MayBeAtOnce(StepLog log, double start)
    {
        BallEvent[] met = [.. log.Events.Span.ToArray().Where(item => item.OtherBall > item.Ball)];
        return met.Any(item => item.Time - start < Soon) || met.Select(item => (item.Time, item.Ball, item.OtherBall)).Distinct().GroupBy(item => item.Time).Any(at => at.Count() > 1);
    }
}
