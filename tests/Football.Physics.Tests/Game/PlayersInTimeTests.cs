namespace FootballPhysics.Tests.Game;

/// <summary>Twenty-two players who run while steps are played again.</summary>
public sealed class PlayersInTimeTests
{
    private const int Players = 22;
    private const int Ticks = 240;

    [Theory]
    [InlineData(0.01)]
    [InlineData(0.033)]
    [InlineData(0.1)]
    public void The_match_ends_at_the_same_bits_whatever_the_frames_and_however_late_a_kick(double frame)
    {
        FixedStepRunner inTime = Match(out _);
        inTime.Kicks.Add(Kick);
        FixedStepRunner late = Match(out _);
        var rollback = new Rollback(late);
        var states = new List<BallState>();
        bool arrived = false;
        while (late.Tick < Ticks)
        {
            late.Advance(frame);
            if (!arrived && late.Tick >= Kick.Tick + 8)
            {
                arrived = rollback.ApplyKick(Kick) is not null;
                Assert.True(arrived);
            }
        }

        while (inTime.Tick < late.Tick)
        {
            inTime.Step();
        }

        Assert.True(Snapshot.Same(inTime.State, late.State));
    }

    /// <summary>The game moves its bodies itself, before every step, in curves; the rollback has kept where.</summary>
    [Fact]
    public void Bodies_that_the_game_moves_are_put_where_they_were()
    {
        FixedStepRunner inTime = Match(out Action<double> moveInTime, asks: false);
        FixedStepRunner late = Match(out Action<double> move, asks: false);
        var rollback = new Rollback(late);
        inTime.Kicks.Add(Kick);
        for (int i = 0; i < Ticks; i++)
        {
            moveInTime(inTime.Time);
            inTime.Step();
            move(late.Time);
            if (late.Tick == Kick.Tick + 11)
            {
                // Between the move and the step: what was moved for the step to come counts too.
                Assert.NotNull(rollback.ApplyKick(Kick));
            }

            late.Step();
            Assert.True(late.Tick <= Kick.Tick + 11 || Snapshot.Same(inTime.State, late.State));
        }
    }

    [Fact]
    public void Without_places_a_rollback_among_bodies_that_moved_is_refused_by_name()
    {
        FixedStepRunner runner = Match(out Action<double> move, asks: false);
        var rollback = new Rollback(runner, keepsBodies: false);
        for (int i = 0; i < 12; i++)
        {
            move(runner.Time);
            runner.Step();
        }

        BallState before = runner.State;
        Assert.StartsWith("Bodies moved at tick 11, so that tick cannot be resimulated. ", Assert.Throws<InvalidOperationException>(() => rollback.ApplyKick(new KickInput(5, default, default))).Message, StringComparison.Ordinal);
        Assert.Equal(1, runner.Kicks.Count);
        Assert.True(Snapshot.Same(before, runner.State));
        runner.MoveBodies = move;
        Assert.NotNull(rollback.ApplyKick(new KickInput(5, new Vector3d(1, 2, 3), default)));
    }

    [Fact]
    public void A_segment_has_the_players_places_and_the_scenes_hash()
    {
        FixedStepRunner runner = Match(out Action<double> move, asks: false);
        runner.Kicks.Add(Kick);
        Recording segment = runner.Record();
        for (int i = 0; i < Ticks; i++)
        {
            move(runner.Time);
            runner.Step();
        }

        byte[] bytes = segment.ToBytes();
        var received = Recording.FromBytes(bytes);
        Assert.Equal(bytes, received.ToBytes());
        Assert.Null(received.FirstDivergence(Match(out _, asks: false).Simulator));
        Assert.NotNull(received.FirstDivergence(Match(out _, asks: false).Simulator, _ => { }));

        // Another scene is told, not a divergence.
        Simulator other = new(Scene.Default with { Gravity = 9.82 });
        Assert.StartsWith("The scene differs from the recorded one (balls ", Assert.Throws<ArgumentException>(() => received.FirstDivergence(other)).Message, StringComparison.Ordinal);
        Assert.NotEqual(other.SceneHash, new Simulator().SceneHash);
        Assert.Equal(new Simulator().SceneHash, new Simulator(new Scene()).SceneHash);
    }

    [Fact]
    public void Several_balls_are_kept_rolled_back_and_played_again()
    {
        FixedStepRunner New()
        {
            var runner = new FixedStepRunner(new BallGroup(Match(out Action<double> move).Simulator, 3)) { MoveBodies = move };
            runner.Place(new Vector3d(0, 0.11, 1), 1);
            runner.Place(new Vector3d(0, 0.11, -1), 2);
            return runner;
        }

        FixedStepRunner inTime = New();
        FixedStepRunner late = New();
        var rollback = new Rollback(late);
        Recording segment = late.Record();
        KickInput[] kicks = [new(20, new Vector3d(0, 0, -6), default, 3), new(20, new Vector3d(0, 2, -7), default, 3, ball: 1), new(60, new Vector3d(0, 1, 9), default, 5, ball: 2)];
        foreach (KickInput kick in kicks)
        {
            inTime.Kicks.Add(in kick);
        }

        while (late.Tick < Ticks)
        {
            inTime.Step();
            late.Step();
            foreach (KickInput kick in kicks.Where(kick => kick.Tick + 8 == late.Tick))
            {
                rollback.ApplyKick(in kick);
            }
        }

        Assert.Equal(Snapshot.Hash(inTime.States), Snapshot.Hash(late.States));
        Assert.Equal(rollback.HashAt(Ticks), Snapshot.Hash(late.States));
        Assert.Null(Recording.FromBytes(segment.ToBytes()).FirstDivergence(new BallGroup(Match(out _).Simulator, 3)));
        Assert.Throws<ArgumentException>(() => segment.Replay(new BallGroup(Match(out _).Simulator, 2)));
    }

    [Fact]
    public void Kicks_that_nobody_plays_again_are_forgotten()
    {
        var runner = new FixedStepRunner { KickTicks = 100 };
        for (int i = 0; i < 1000; i++)
        {
            runner.QueueKick(new Vector3d(1, 0, 0), default);
            runner.Step();
        }

        Assert.InRange(runner.Kicks.Count, 100, 102);
        Assert.Throws<ArgumentOutOfRangeException>(() => runner.KickTicks = 0);

        // A rollback, and a recording, keep theirs.
        var longer = new FixedStepRunner { KickTicks = 10 };
        _ = new Rollback(longer, 50);
        Recording segment = longer.Record();
        for (int i = 0; i < 200; i++)
        {
            longer.QueueKick(new Vector3d(1, 0, 0), default);
            longer.Step();
        }

        Assert.Equal(200, longer.Kicks.Count);
        Assert.Null(segment.FirstDivergence(longer.Simulator));
    }

    private static KickInput Kick => new(100, new Vector3d(3, 2, -9), new Vector3d(0, 30, 0), 7);

    private static FixedStepRunner Match(out Action<double> move, bool asks = true)
    {
        var bodies = new KinematicBodies();
        for (int i = 0; i < Players; i++)
        {
            bodies.Add("player", i % 2 == 0 ? BodyKind.Player : BodyKind.Boot);
        }

        move = time =>
        {
            for (int i = 0; i < Players; i++)
            {
                // On circles about places around the ball.
                double rate = 1 + (0.3 * i);
                double angle = i + (rate * time);
                var outward = new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
                bodies[i].MoveTo(new Vector3d(i % 5 - 2, i % 2 == 0 ? 0 : 0.06, i % 7 - 3) + outward, rate * new Vector3d(-outward.Z, 0, outward.X), time);
            }
        };
        var runner = new FixedStepRunner(new Simulator(Pitch.Standard.On(Scene.Default) with { Bodies = bodies }));
        runner.QueueKick(new Vector3d(2, 3, -4), new Vector3d(10, 0, 0));
        if (asks)
        {
            runner.MoveBodies = move;
        }

        return runner;
    }
}
