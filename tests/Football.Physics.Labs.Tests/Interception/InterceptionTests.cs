using FootballPhysics.Labs.Intercept;
using FootballPhysics.Prediction;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Tests.Interception;

/// <summary>Who gets to the ball: windows, who is first, who owns which part of the way.</summary>
public sealed class InterceptionTests
{
    private static readonly Trajectory s_shot = Path(new Vector3d(0, 0.11, 0), new Vector3d(0, 7, -22), 3);

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Windows_of_random_runners_are_those_of_a_dense_scan(bool measured)
    {
        var check = new InterceptCheck(measured ? Scene.Measured : Scene.Published);
        for (int i = 0; i < 40; i++)
        {
            check.Run(new SeededRandom(SeededRandom.Mix(17, i)));
        }

        Assert.InRange(check.Counts["windows"], 20, 1000);
        Assert.True(check.Holds, $"{string.Join(", ", check.Counts.Cells(InterceptCheck.Columns))}; {check.Worst} s");
    }

    [Fact]
    public void A_ball_that_passes_in_a_millisecond_is_met()
    {
        // It grazes the rim of his circle: the window is as short as the rim is near.
        Trajectory path = Path(new Vector3d(0, 1, 0), new Vector3d(0, 0, -30), 0.25);
        Vector3d place = path.PositionAt(0.1);
        Vector3d side = Vector3d.Cross(path.VelocityAt(0.1), Vector3d.Up);
        foreach (double overlap in new[] { 1e-5, 1e-7, 1e-9 })
        {
            var runner = new Player { Position = (place + ((0.5 - overlap) / side.Length * side)).Horizontal, Reaction = 10, Reach = 0.5 };
            var query = new FootballPhysics.Prediction.Interception();
            query.Find(path, [runner]);
            InterceptWindow window = Assert.Single(query.Windows.ToArray());
            double half = Math.Sqrt((0.25 - ((0.5 - overlap) * (0.5 - overlap))) / path.VelocityAt(0.1).Horizontal.LengthSquared);
            Assert.Equal(2 * half, window.To - window.From, 0.02 * half);
        }
    }

    /// <summary>Standing where the ball has been a while ago, he has not saved it; standing where it will be, he saves it from now on.</summary>
    [Fact]
    public void A_keeper_saves_nothing_before_now()
    {
        var goal = new Goal { Center = new Vector3d(0, 0, -11), Facing = new Vector3d(0, 0, 1) };
        Trajectory path = Path(new Vector3d(0, 0.11, 0), new Vector3d(0, 2, -20), 1);
        var query = new FootballPhysics.Prediction.Interception();
        var passed = new Player { Position = new Vector3d(0, 0, -3), Reaction = 10, Reach = 1 };
        Assert.True(query.FindSave(path, in passed, goal).Saves);
        Assert.False(query.FindSave(path, in passed, goal, 0.3).Saves);
        var there = new Player { Position = new Vector3d(0, 0, -5), Reach = 3 };
        KeeperResult answer = query.FindSave(path, in there, goal, 0.3);
        Assert.Equal((true, 0.3), (answer.Saves, answer.Save.Time));
    }

    [Fact]
    public void What_a_keeper_covers_is_told_from_the_foot_of_his_goal()
    {
        Trajectory path = Path(new Vector3d(0, 0.11, 0), new Vector3d(0, 2, -20), 1);
        var goal = new Goal { Center = new Vector3d(0, 3, -11), Facing = new Vector3d(0, 0, 1) };
        var keeper = new Player { Position = new Vector3d(0, 3, -10.5), MaximumHeight = 5 };
        Assert.Equal(2, new FootballPhysics.Prediction.Interception().FindSave(path, in keeper, goal).ReachHeight, 1e-12);
    }

    [Fact]
    public void Who_is_first_is_found_without_all_windows_too()
    {
        Player[] runners = [.. Enumerable.Range(0, 22).Select(i => new Player { Position = new Vector3d(-12 + (1.7 * (i % 11)), 0, i < 11 ? -25 : -38) })];
        var query = new FootballPhysics.Prediction.Interception();
        query.Find(s_shot, runners);
        (int first, double lead) = (query.First, query.TimeMargin);
        Assert.InRange(first, 0, 21);
        Assert.Equal(first, query.FindFirst(s_shot, runners, out PathPoint at));
        Assert.Equal(lead, query.TimeMargin, 12);
        Assert.Equal(query.WindowsOf(first)[0].From, at.Time);
        Assert.Equal(query.WindowsOf(first)[0].Position, at.Position);
    }

    [Fact]
    public void Shares_cover_what_windows_cover_and_are_owned_by_who_could_be_there_first()
    {
        Player[] runners = [.. Enumerable.Range(0, 22).Select(i => new Player { Position = new Vector3d(-12 + (1.7 * (i % 11)), 0, i < 11 ? -25 : -38), Reaction = 0.1 + (0.01 * i) })];
        var query = new FootballPhysics.Prediction.Interception();
        query.Find(s_shot, runners);
        PossessionInterval[] shares = query.FindShares().ToArray();
        InterceptWindow[] windows = query.Windows.ToArray();
        Assert.InRange(shares.Length, 2, 60);
        for (double t = s_shot.StartTime; t < s_shot.EndTime; t += 0.0037)
        {
            bool covered = windows.Any(window => window.From <= t && t < window.To);
            PossessionInterval[] owner = [.. shares.Where(share => share.From <= t && t < share.To)];
            Assert.Equal(covered ? 1 : 0, owner.Length);
            if (covered)
            {
                double Arrival(int i) => i < 0 ? double.PositiveInfinity : Math.Min(t, new RunnerMotion(in runners[i], 0).ArrivalAt((s_shot.PositionAt(t) - runners[i].Position).Horizontal.Length));
                int[] here = [.. windows.Where(window => window.From <= t && t < window.To).Select(window => window.Player)];
                Assert.Equal(here.Min(Arrival), Arrival(owner[0].Player), 1e-6);
            }
        }
    }

    [Fact]
    public void A_ball_at_rest_is_met_by_who_comes_later()
    {
        Trajectory path = Path(new Vector3d(0, 0.11, 0), new Vector3d(4, 0, 0), 10, StopAt.Rest);
        var runner = new Player { Position = path.Final.Position + new Vector3d(0, 0, 60) };
        var query = new FootballPhysics.Prediction.Interception();
        query.Find(path, [runner]);
        Assert.Equal(-1, query.First);
        query.Find(path, [runner], until: 20);
        Assert.Equal(0, query.First);
        Assert.Equal(0.2 + (59.4 / 8) + (0.5 * 8 / 6), query.Windows[0].From, 1e-9);
        Assert.Equal(20, query.Windows[0].To);
    }

    [Fact]
    public void Queries_allocate_nothing_once_there_is_room()
    {
        Player[] runners = [.. Enumerable.Range(0, 22).Select(i => new Player { Position = new Vector3d(-12 + (1.7 * (i % 11)), 0, i < 11 ? -25 : -38) })];
        var goal = new Goal { Center = new Vector3d(0, 0, -30), Facing = new Vector3d(0, 0, 1) };
        var query = new FootballPhysics.Prediction.Interception();
        Assert.Equal(0, Allocation.Of(() =>
        {
            query.Find(s_shot, runners);
            query.FindFirst(s_shot, runners, out _);
            query.FindShares();
            query.FindSave(s_shot, in runners[0], goal);
        }));
    }

    [Fact]
    public void A_keeper_saves_what_he_can_reach_and_must_dive_in_time()
    {
        var goal = new Goal { Center = new Vector3d(0, 0, -20), Facing = new Vector3d(0, 0, 1) };
        Trajectory path = Path(new Vector3d(0, 0.11, 0), new Vector3d(3.5, 4, -25), 2);
        var keeper = new Player { Position = new Vector3d(3, 0, -19.5), Reaction = 0.2, Acceleration = 5, Speed = 6, Reach = 1.2, MaximumHeight = 2.7 };
        var query = new FootballPhysics.Prediction.Interception();
        KeeperResult answer = query.FindSave(path, in keeper, goal);
        Assert.True(answer.Crosses && answer.IsOnTarget);
        Assert.Equal(-20, answer.Crossing.Position.Z, 1e-9);
        Assert.Equal(answer.Crossing.Position.X, answer.LateralOffset * goal.Right.X, 1e-9);
        Assert.True(answer.Saves);
        Assert.InRange(answer.Save.Time, 0.2, answer.Crossing.Time);
        Assert.InRange(answer.LateralOffset, answer.ReachLeft, answer.ReachRight);

        // A microsecond later is too late, a microsecond sooner is not.
        Assert.InRange(answer.LatestReaction, 0.2, answer.Crossing.Time);
        Assert.True(query.FindSave(path, keeper.Reacting(answer.LatestReaction - 1e-6), goal).Saves);
        KeeperResult late = query.FindSave(path, keeper.Reacting(answer.LatestReaction + 1e-6), goal);
        Assert.False(late.Saves);
        Assert.True(double.IsNaN(late.LatestReaction));
    }

    [Fact]
    public void A_number_of_a_runner_that_is_out_of_range_is_refused()
    {
        var query = new FootballPhysics.Prediction.Interception();
        Assert.Contains("runner.acceleration is 0; allowed: a finite number above 0.", Assert.ThrowsAny<ArgumentException>(() => query.Find(s_shot, [new Player { Acceleration = 0 }])).Message);
        Assert.Contains("runner.heights[1]", Assert.ThrowsAny<ArgumentException>(() => query.Find(s_shot, [new Player { MinimumHeight = 3 }])).Message);
    }

    private static Trajectory Path(Vector3d position, Vector3d velocity, double duration, StopAt stopAt = StopAt.Time)
    {
        var simulator = new Simulator(Scene.Measured);
        var path = new Trajectory();
        simulator.LookAhead(simulator.Launch(position, velocity, new Vector3d(0, 20, 0)), new LookAheadRequest { Duration = duration, StopAt = stopAt }, path);
        return path;
    }

    [Fact]
    public void Of_those_who_meet_it_at_one_instant_the_lowest_index_is_first()
    {
        // All stand under a high ball and wait until it falls to where they can reach it.
        var simulator = new Simulator(Scene.Measured);
        var path = new Trajectory();
        var query = new FootballPhysics.Prediction.Interception();
        var random = new SeededRandom(8L);
        for (int k = 0; k < 200; k++)
        {
            BallState kicked = simulator.Launch(new Vector3d(0, 0.11, 0), random.Velocity(14, 20, 50, 70), Vector3d.Zero);
            simulator.LookAhead(in kicked, new LookAheadRequest { Duration = 6 }, path);
            Assert.True(path.TryGetTouchdown(0, out BallEvent down));
            Player[] runners =
            [
                new Player { Position = new Vector3d(500, 0, 0) },
                .. Enumerable.Range(0, 6).Select(_ => new Player { Position = (down.Position + (random.Uniform(0, 2) * random.Heading())).Horizontal, MaximumHeight = 2.3 }),
            ];
            query.Find(path, runners);
            Assert.Equal(1, query.First);
            Assert.Equal(0, query.TimeMargin, 1e-8);
            Assert.Equal(1, query.FindFirst(path, runners, out PathPoint at));
            Assert.Equal(query.WindowsOf(1)[0].From, at.Time);
        }
    }

    /// <summary>Runners who meet it within a nanosecond or two of one another, in any order of index: both answers name the same one, to the last bit.</summary>
    [Fact]
    public void Both_ways_to_ask_name_the_same_one()
    {
        var query = new FootballPhysics.Prediction.Interception();
        var random = new SeededRandom(11L);
        int close = 0;
        for (int k = 0; k < 400; k++)
        {
            Trajectory path = Path(new Vector3d(0, 0.11, 0), random.Velocity(12, 24, 5, 50), 3);
            var first = new Player { Position = path.PositionAt(random.Uniform(0.8, 2.5)).Horizontal + (random.Uniform(0, 3) * random.Heading()), Reaction = random.Uniform(0.1, 0.3) };
            Player[] runners = [.. Enumerable.Range(0, 8).Select(_ => first.Reacting(first.Reaction + random.Uniform(0, 3e-9)))];
            query.Find(path, runners);
            (int of, double lead) = (query.First, query.TimeMargin);
            Assert.Equal(of, query.FindFirst(path, runners, out PathPoint at));
            Assert.Equal(lead, query.TimeMargin);
            if (of >= 0)
            {
                Assert.Equal(query.WindowsOf(of)[0].From, at.Time);
                close += lead < 1e-9 ? 1 : 0;
            }
        }

        Assert.InRange(close, 50, 400);
    }

    [Fact]
    public void After_the_latest_reaction_of_a_keeper_who_runs_no_other_saves()
    {
        var random = new SeededRandom(2L);
        var goal = new Goal { Center = new Vector3d(0, 0, -20), Facing = new Vector3d(0, 0, 1) };
        var query = new FootballPhysics.Prediction.Interception();
        int saves = 0;
        for (int k = 0; k < 300; k++)
        {
            Trajectory path = Path(new Vector3d(random.Uniform(-6, 6), 0.11, 0), new Vector3d(random.Uniform(-5, 5), random.Uniform(1, 6), -random.Uniform(10, 24)), 3);
            var keeper = new Player
            {
                Position = new Vector3d(random.Uniform(-5, 5), 0, -20 + random.Uniform(0, 5)),
                Velocity = random.Uniform(0, 6) * random.Heading(),
                Reach = 0.9,
                Reaction = random.Uniform(0, 0.3),
                MaximumHeight = 2.5,
            };
            KeeperResult answer = query.FindSave(path, in keeper, goal);
            if (!answer.Saves || !answer.Crosses)
            {
                continue;
            }

            saves++;
            for (int i = 0; i <= 500; i++)
            {
                double later = answer.LatestReaction + 1e-5 + (i * (answer.Crossing.Time - answer.LatestReaction) / 500);
                Assert.False(later < answer.Crossing.Time && query.FindSave(path, keeper.Reacting(later), goal).Saves, $"{k}: {answer.LatestReaction} s, and {later} s");
            }
        }

        Assert.True(saves > 40, $"{saves}");
    }
}
