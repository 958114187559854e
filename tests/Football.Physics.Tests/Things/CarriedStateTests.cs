using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Things;

/// <summary>States of carried balls: the distance from the carrier that a state may have, and the ends of searches along a path.</summary>
public sealed class CarriedStateTests
{
    /// <summary>Far from the origin, positions are less exact, so the tolerance grows by a thousandth of itself per metre, on each axis.</summary>
    [Theory]
    [InlineData(0, 0, 0)]
    [InlineData(1e5, 0, 0)]
    [InlineData(-1e5, 0, 30)]
    [InlineData(0, 1e5, 0)]
    [InlineData(3, 0, 1e5)]
    [InlineData(3, 0, -1e5)]
    public void A_state_may_be_off_its_carrier_by_the_tolerance_at_its_distance(double x, double y, double z)
    {
        var box = new BoxShape(new Vector3d(x, y - 0.5, z), new Vector3d(2, 0.5, 2));
        var simulator = new Simulator(new Scene { Ground = Ground.None, Obstacles = [new Obstacle { Name = "box", Shape = box }] });
        var ball = new Ball(simulator);
        ball.Place(new Vector3d(x, y + simulator.Scene.Ball.Radius, z));
        for (int i = 0; i < 50; i++)
        {
            ball.Step(0.02);
        }

        Assert.Equal(MotionState.Rest, ball.Motion);
        BallState state = ball.State;
        double tolerance = 1e-6 * (1 + (1e-3 * Math.Max(Math.Abs(x), Math.Max(y + simulator.Scene.Ball.Radius, Math.Abs(z)))));
        foreach (double side in new[] { -1.0, 1.0 })
        {
            BallState near = state with { Position = state.Position + new Vector3d(0, 0.97 * side * tolerance, 0) };
            simulator.Validate(in near);
            BallState far = state with { Position = state.Position + new Vector3d(0, 1.03 * side * tolerance, 0) };
            Assert.StartsWith("state.position is ", Assert.Throws<ArgumentOutOfRangeException>(() => simulator.Validate(in far)).Message, StringComparison.Ordinal);
        }
    }

    /// <summary>A state that stores for how long its way is clear may come from a scene of a smaller ball, or of other obstacles: another scene searches again.</summary>
    [Theory]
    [InlineData(0.05, 0.2, 0.4, 0)]
    [InlineData(0.2, 0.2, 0.4, -0.15)]
    public void A_way_that_is_clear_in_one_scene_is_searched_in_another(double radius, double larger, double off, double nearer)
    {
        Scene SceneOf(double ball, double z) => new()
        {
            Air = new Air { Density = 0 },
            Ground = Ground.None,
            Gravity = 0,
            Ball = new BallProperties { Radius = ball },
            Obstacles = [new Obstacle { Name = "post", Shape = new SphereShape(new Vector3d(1.5, 0, z), 0.3) }],
        };
        var first = new Simulator(SceneOf(radius, off));
        var second = new Simulator(SceneOf(larger, off + nearer));
        BallState s = first.Launch(Vector3d.Zero, new Vector3d(20, 0, 0), Vector3d.Zero);
        var log = new StepLog();
        first.Step(ref s, 0.01, log);
        for (int i = 0; i < 10; i++)
        {
            second.Step(ref s, 0.01, log);
        }

        Assert.Equal("post", second.NameOf(Assert.Single(log.Events.Span.ToArray()).ColliderIndex));
    }

    /// <summary>A search that has reached the end of the path ends, also with a step of zero; a lengthened step does not skip the end.</summary>
    [Fact]
    public void A_search_along_a_path_ends_at_its_end()
    {
        foreach (double until in new[] { 0.5, 0.3, 0.01 })
        {
            var span = new SearchSpan(0.5, until);
            Assert.InRange(span.Shortest, 1e-15, 1e-3);
            Assert.Equal([until], TimesOf(in span, until, 0));

            double almost = until - (0.3 * span.Shortest);
            Assert.Equal([almost, until], TimesOf(in span, almost, 0.1 * span.Shortest));
            Assert.Equal([almost], TimesOf(in span, almost, 0.5 * span.Shortest));
            Assert.Equal([0, 0.25 * until, 0.5 * until, 0.75 * until, until], TimesOf(in span, 0, 0.25 * until));
        }
    }

    /// <summary>A search that could take a million short steps ends after some hundred: its steps grow. The first 512 do not.</summary>
    [Fact]
    public void A_search_in_short_steps_ends_soon()
    {
        List<double> times = TimesOf(new SearchSpan(1, 1), 0, 1e-6);
        Assert.InRange(times.Count, 513, 600);
        Assert.Equal(512e-6, times[512], 1e-12);
        Assert.All(times.Zip(times.Skip(1)), pair => Assert.True(pair.Second > pair.First));
    }

    /// <summary>The times at which a search evaluates a gap that stays open, if each step is equally long.</summary>
    private static List<double> TimesOf(in SearchSpan span, double from, double step)
    {
        var gap = new OpenGap(step);
        long evaluations = 0;
        Assert.Equal(double.PositiveInfinity, TimeOfImpact.First(ref gap, in span, ref evaluations, from));
        Assert.Equal(gap.Times.Count, evaluations);
        return gap.Times;
    }

    private readonly struct OpenGap(double length) : IGap
    {
        public List<double> Times { get; } = [];

        public bool IsClosed(double t, out double step)
        {
            Times.Add(t);
            step = length;
            return false;
        }
    }
}
