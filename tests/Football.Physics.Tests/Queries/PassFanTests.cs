namespace FootballPhysics.Tests.Queries;

/// <summary>The best pass of a fan.</summary>
public sealed class PassFanTests
{
    private static readonly PassFanRequest s_request = new() { From = new Vector3d(0, 0.11, 0), Direction = new Vector3d(0, 0, -1) };
    private static readonly Player[] s_mates =
        [new Player { Position = new Vector3d(5, 0, -30), Velocity = new Vector3d(1, 0, -4) }, new Player { Position = new Vector3d(-12, 0, -25), Velocity = new Vector3d(0, 0, -3) }];

    private static readonly Player[] s_opponents =
        [.. Enumerable.Range(0, 8).Select(i => new Player { Position = new Vector3d(-21 + (6 * i), 0, -20 - (i % 3 * 5)) })];

    [Fact]
    public void Without_team_mates_it_comes_down_near_the_target_out_of_reach_of_all_opponents()
    {
        var target = new Vector3d(4, 0, -38);
        PassResult choice = new PassFan(Scene.Measured).Find(s_request with { Target = target }, [], s_opponents);
        Assert.True(choice.IsFound);
        Assert.Equal(-1, choice.Receiver);
        Assert.True(double.IsPositiveInfinity(choice.TimeMargin));
        Assert.InRange((choice.Meeting.Position - target).Horizontal.Length, 0, 4);
    }

    [Fact]
    public void Where_opponents_stand_around_the_ball_there_is_none()
    {
        Player[] around = [new Player { Position = new Vector3d(0, 0, -0.3), MaximumHeight = 9 }];
        PassResult choice = new PassFan(Scene.Measured).Find(s_request, s_mates, around);
        Assert.False(choice.IsFound);
        Assert.InRange(choice.Open, 0, choice.Kicks / 10);
    }

    [Fact]
    public void All_kicks_of_elevation_zero_go_along_the_ground_and_are_met_there()
    {
        PassFanRequest along = s_request with { MinimumElevationDegrees = 0, MaximumElevationDegrees = 0, Elevations = 1 };
        PassResult choice = new PassFan(Scene.Measured).Find(along, s_mates, []);
        Assert.True(choice.IsFound);
        Assert.Equal(100, choice.Kicks);
        Assert.Equal(0, choice.Velocity.Y);
        Assert.Equal(0.11, choice.Meeting.Position.Y, 1e-12);
        Assert.InRange(choice.Meeting.Velocity.Length, 1, choice.Velocity.Length - 2);
    }

    [Fact]
    public void Without_team_mates_a_pass_along_the_ground_comes_to_rest_near_the_target()
    {
        var target = new Vector3d(3, 0, -25);
        PassFanRequest along = s_request with
        {
            MinimumElevationDegrees = 0,
            MaximumElevationDegrees = 0,
            Elevations = 1,
            MinimumSpeed = 4,
            MaximumSpeed = 14,
            Speeds = 40,
            Target = target,
            Duration = 20,
        };
        PassResult choice = new PassFan(Scene.Measured).Find(along, [], []);
        Assert.True(choice.IsFound);
        Assert.Equal(0, choice.Meeting.Velocity.Length);
        Assert.InRange((choice.Meeting.Position - target).Horizontal.Length, 0, 2.5);
    }

    [Theory]
    [InlineData(8, 0)]
    [InlineData(0, 0)]
    [InlineData(0, 4)]
    public void Few_kicks_are_judged_on_their_exact_paths(double lowest, double wind)
    {
        var fan = new PassFan(Scene.Measured with { Air = Scene.Measured.Air with { Wind = new Vector3d(wind, 0, 0) } });
        Assert.True(fan.Find(s_request with { MinimumElevationDegrees = lowest }, s_mates, s_opponents).IsFound);
        Assert.InRange(fan.Judged, 1, 6);
    }

    [Theory]
    [InlineData(8, 0)]
    [InlineData(0, 0)]
    [InlineData(0, 4)]
    public void A_search_allocates_nothing_once_there_is_room(double lowest, double wind)
    {
        var fan = new PassFan(Scene.Measured with { Air = Scene.Measured.Air with { Wind = new Vector3d(wind, 0, 0) } });
        PassFanRequest request = s_request with { MinimumElevationDegrees = lowest };
        long allocated = long.MaxValue;
        for (int i = 0; i < 4; i++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            fan.Find(request, s_mates, s_opponents);
            allocated = Math.Min(allocated, GC.GetAllocatedBytesForCurrentThread() - before);
        }

        Assert.Equal(0, allocated);
    }

    [Theory]
    [InlineData(-1, 8, "fan.elevation.min")]
    [InlineData(0, 0, "fan.duration")]
    [InlineData(0, 61, "fan.duration")]
    public void Numbers_out_of_range_are_refused(double lowest, double duration, string field) => Assert.Contains(
        field,
        Assert.Throws<ArgumentOutOfRangeException>(
            () => new PassFan(Scene.Measured).Find(s_request with { MinimumElevationDegrees = lowest, Duration = duration }, s_mates, s_opponents)).Message,
        StringComparison.Ordinal);

    [Fact]
    public void A_scene_that_the_game_moves_is_refused()
    {
        var bodies = new KinematicBodies();
        bodies.Add("player", new SphereShape(Vector3d.Zero, 0.3));
        Assert.Contains("scene is", Assert.Throws<ArgumentOutOfRangeException>(() => new PassFan(Scene.Measured with { Bodies = bodies })).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void On_a_pitch_the_best_pass_is_that_of_the_open_field()
    {
        PassResult open = new PassFan(Scene.Measured).Find(s_request, s_mates, s_opponents);
        PassResult pitch = new PassFan(Pitch.Stadium.On(Scene.Measured)).Find(s_request, s_mates, s_opponents);
        Assert.True(open.IsFound);
        Assert.Equal((open.Velocity, open.Spin, open.Receiver, open.Meeting.Time), (pitch.Velocity, pitch.Spin, pitch.Receiver, pitch.Meeting.Time));
    }

    [Fact]
    public void What_stands_in_the_way_of_the_best_pass_has_another_taken()
    {
        PassResult open = new PassFan(Scene.Measured).Find(s_request, s_mates, s_opponents);
        Simulator free = new(Scene.Measured);
        BallState ball = free.Launch(s_request.From, open.Velocity, open.Spin);
        free.Run(ref ball, 0.01, 0.5 * open.Meeting.Time, StopAt.Time, new StepLog());
        Scene scene = Scene.Measured with { Obstacles = [new Obstacle { Name = "referee", Shape = new SphereShape(ball.Position, 0.3) }] };
        PassResult other = new PassFan(scene).Find(s_request, s_mates, s_opponents);
        Assert.True(other.IsFound && other.Meeting.Time >= open.Meeting.Time);
        Assert.NotEqual(open.Velocity, other.Velocity);
        var simulator = new Simulator(scene);
        BallState kicked = simulator.Launch(s_request.From, other.Velocity, other.Spin);
        var log = new StepLog();
        simulator.Run(ref kicked, 0.01, other.Meeting.Time, StopAt.Time, log);
        Assert.DoesNotContain(log.Events.Span.ToArray(), item => item.ColliderIndex > 0);
    }

    /// <summary>A mate who has the ball at his feet meets it before anything stands in the way; and what gives way stands where it stood for the next kick and the next call.</summary>
    [Fact]
    public void Among_things_that_give_way_every_call_has_the_same_answer()
    {
        Obstacle[] cones = [.. Enumerable.Range(-4, 9).Select(i => new Obstacle { Name = $"cone {i}", Shape = new SphereShape(new Vector3d(0.7 * i, 0.2, -6), 0.2), Mass = 0.3 })];
        var fan = new PassFan(Scene.Measured with { Obstacles = cones });
        PassFanRequest along = s_request with { MinimumElevationDegrees = 0 };
        PassResult first = fan.Find(along, s_mates, s_opponents);
        Assert.True(first.IsFound);
        Assert.Equal(first, fan.Find(along, s_mates, s_opponents));
        Assert.True(fan.Find(along, [new Player { Position = along.From }], []).IsFound);
    }
}
