namespace Football.Physics.Tests.Queries;

/// <summary>The best pass of a fan.</summary>
public sealed class PassFanTests
{
    private static readonly PassFanRequest s_request = new() { From = new Vector3d(0, 0.11, 0), Direction = new Vector3d(0, 0, -1) };
    private static readonly Runner[] s_mates =
        [new Runner { Position = new Vector3d(5, 0, -30), Velocity = new Vector3d(1, 0, -4) }, new Runner { Position = new Vector3d(-12, 0, -25), Velocity = new Vector3d(0, 0, -3) }];

    private static readonly Runner[] s_opponents =
        [.. Enumerable.Range(0, 8).Select(i => new Runner { Position = new Vector3d(-21 + (6 * i), 0, -20 - (i % 3 * 5)) })];

    [Fact]
    public void The_answer_is_the_earliest_of_all_kicks_that_hold_on_their_exact_paths()
    {
        PassChoice choice = new PassFan(Scene.Measured).Find(s_request, s_mates, s_opponents);
        Assert.True(choice.IsFound);
        Assert.Equal(1000, choice.Kicks);
        Assert.True(choice.Lead >= s_request.Margin);
        double earliest = double.PositiveInfinity;
        var simulator = new Simulator(Scene.Measured);
        var path = new Trajectory();
        var query = new Physics.Interception();
        for (int i = 0; i < choice.Kicks; i++)
        {
            s_request.Kick(i, out Vector3d velocity, out Vector3d spin);
            BallState ball = simulator.Launch(s_request.From, velocity, spin);
            simulator.LookAhead(in ball, new LookAheadRequest { Duration = 8, StopAt = StopAt.Impact }, path);
            int mate = query.FindFirst(path, s_mates, out PathPoint at);
            int opponent = query.FindFirst(path, s_opponents, out PathPoint lost);
            bool holds = mate >= 0 && (opponent < 0 || lost.Time - at.Time >= s_request.Margin);
            earliest = holds ? Math.Min(earliest, at.Time) : earliest;
        }

        // Lanes look every 40 ms.
        Assert.InRange(choice.Meeting.Time, earliest - 1e-9, earliest + 0.0401);
    }

    [Fact]
    public void Without_team_mates_it_comes_down_near_the_target_out_of_reach_of_all_opponents()
    {
        var target = new Vector3d(4, 0, -38);
        PassChoice choice = new PassFan(Scene.Measured).Find(s_request with { Target = target }, [], s_opponents);
        Assert.True(choice.IsFound);
        Assert.Equal(-1, choice.Receiver);
        Assert.True(double.IsPositiveInfinity(choice.Lead));
        Assert.InRange((choice.Meeting.Position - target).Horizontal.Length, 0, 4);
    }

    [Fact]
    public void Where_opponents_stand_around_the_ball_there_is_none()
    {
        Runner[] around = [new Runner { Position = new Vector3d(0, 0, -0.3), HighestHeight = 9 }];
        PassChoice choice = new PassFan(Scene.Measured).Find(s_request, s_mates, around);
        Assert.False(choice.IsFound);
        Assert.InRange(choice.Open, 0, choice.Kicks / 10);
    }

    [Fact]
    public void A_search_allocates_nothing_once_there_is_room()
    {
        var fan = new PassFan(Scene.Measured);
        long allocated = long.MaxValue;
        for (int i = 0; i < 4; i++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            fan.Find(s_request, s_mates, s_opponents);
            allocated = Math.Min(allocated, GC.GetAllocatedBytesForCurrentThread() - before);
        }

        Assert.Equal(0, allocated);
    }

    [Fact]
    public void A_scene_with_things_is_refused() => Assert.Contains(
        "scene is", Assert.Throws<ArgumentOutOfRangeException>(() => new PassFan(Scene.Measured with { Goals = [new Goal { Center = default, Facing = new Vector3d(1, 0, 0) }] })).Message, StringComparison.Ordinal);
}
