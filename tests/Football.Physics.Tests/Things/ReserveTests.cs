namespace FootballPhysics.Tests.Things;

/// <summary>Bodies that come into play later, and leave it: added before the simulator is built, withdrawn, brought on by MoveTo.</summary>
public sealed class ReserveTests
{
    private const double Step = 1.0 / 60;

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void None_is_added_once_a_simulator_is_built_and_the_exception_says_how_else(int before)
    {
        var bodies = new KinematicBodies();
        for (int i = 0; i < before; i++)
        {
            bodies.Add("a", BodyKind.Player);
        }

        _ = new Ball(new Scene { Bodies = bodies });
        string message = Assert.Throws<InvalidOperationException>(() => bodies.Add("late", BodyKind.Player)).Message;
        Assert.Contains("Withdraw", message, StringComparison.Ordinal);
        Assert.Contains("MoveTo", message, StringComparison.Ordinal);
        Assert.Equal(before, bodies.Count);
    }

    [Fact]
    public void Empty_bodies_are_nothing_to_any_part_of_the_library()
    {
        var empty = new Scene { Bodies = new KinematicBodies() };
        Assert.Equal(new Simulator().SceneHash, new Simulator(empty).SceneHash);
        Assert.True(new Simulator(empty).World.IsBare);
        Assert.False(new Aiming.AimContext(new Simulator(empty)).HasThings);
        Assert.True(LaneFlight.Covers(empty));
        var one = new BatchFlights(64);
        var other = new BatchFlights(64);
        var launches = new BatchLaunches(64);
        for (int i = 0; i < 64; i++)
        {
            launches.Set(i, new Vector3d(0, 0.11, 0), new Vector3d(0, 5 + (0.1 * i), -20), new Vector3d(0, i, 0));
        }

        var batch = new BallBatch(empty);
        batch.Fly(launches, one, 64);
        new BallBatch(new Scene()).Fly(launches, other, 64);
        Assert.Equal(Enumerable.Range(0, 64).Select(i => other.Position[i]), Enumerable.Range(0, 64).Select(i => one.Position[i]));
        Assert.Equal(0, batch.ScalarFallbackCount);
        Assert.True(new PassFan(empty).Find(new PassFanRequest { From = new Vector3d(0, 0.11, 0), Direction = new Vector3d(0, 0, -1), Target = new Vector3d(0, 0, -20) }, [], []).IsFound);
    }

    [Fact]
    public void A_reserve_is_hit_by_nothing_until_he_comes_on_and_no_more_after_he_has_left()
    {
        var bodies = new KinematicBodies();
        KinematicBody reserve = bodies.Add("reserve", BodyKind.Player);
        reserve.MoveTo(new Vector3d(0, 0, -3), default, 0);
        reserve.Withdraw();
        var ball = new Ball(new Scene { Bodies = bodies });
        Assert.True(reserve.IsWithdrawn);
        Assert.Equal(0, Hits(ball, reserve, on: null));
        Assert.Equal(1, Hits(ball, reserve, on: new Vector3d(0, 0, -3)));
        Assert.False(reserve.IsWithdrawn);
        reserve.Withdraw();
        Assert.Equal(0, Hits(ball, reserve, on: null));

        // In the middle of a flight that was known to be free, in front of the ball.
        ball.Place(new Vector3d(0, 0.11, 0));
        ball.Kick(new Vector3d(0, 3, -20), default);
        ball.Step(Step);
        ball.Step(Step);
        reserve.MoveTo(new Vector3d(0, 0, ball.Position.Z - 0.6), default, ball.Time);
        ball.Step(Step);
        ball.Step(Step);
        Assert.True(ball.Velocity.Z > 0, $"{ball.Velocity}");
    }

    [Fact]
    public void A_ball_that_lies_on_a_body_falls_when_it_leaves_and_one_that_leans_on_it_rolls_on()
    {
        var bodies = new KinematicBodies();
        KinematicBody table = bodies.Add("table", new BoxShape(Vector3d.Zero, new Vector3d(1, 0.5, 1)));
        table.MoveTo(new Vector3d(0, 0.5, 0), default, 0);
        var ball = new Ball(new Scene { Bodies = bodies });
        ball.Place(new Vector3d(0, 1.11, 0));
        ball.Step(Step);
        Assert.Equal(MotionState.Rest, ball.Motion);
        table.Withdraw();
        for (int i = 0; i < 20; i++)
        {
            ball.Step(Step);
        }

        // ½ g t² of 20 steps, with air.
        Assert.Equal(1.11 - (0.5 * 9.81 * (20 * Step) * (20 * Step)), ball.Position.Y, 0.02);
    }

    [Fact]
    public void A_rollback_a_recording_and_a_look_ahead_keep_who_is_in_play()
    {
        // He comes on at tick 20 in front of the ball, leaves at tick 45, comes on again at tick 70 elsewhere; nobody says so by BodiesAt.
        static void Move(FixedStepRunner runner, KinematicBody body)
        {
            switch (runner.Tick)
            {
                case 20:
                    body.MoveTo(new Vector3d(0.1, 0, -6), new Vector3d(0, 0, 1), runner.Time);
                    break;
                case 45:
                    body.Withdraw();
                    break;
                case 70:
                    body.MoveTo(new Vector3d(0, 0, 4), new Vector3d(0, 0, -2), runner.Time);
                    break;
            }
        }

        static FixedStepRunner New(out KinematicBody body)
        {
            var bodies = new KinematicBodies();
            body = bodies.Add("reserve", BodyKind.Player);
            body.Withdraw();
            return new FixedStepRunner(new Simulator(new Scene { Bodies = bodies }), Step);
        }

        FixedStepRunner runner = New(out KinematicBody reserve);
        var rollback = new Rollback(runner, ticks: 100);
        Recording segment = runner.Record();
        runner.QueueKick(new Vector3d(0, 1, -14), default);
        var hashes = new List<ulong>();
        int hits = 0;
        while (runner.Tick < 100)
        {
            Move(runner, reserve);
            runner.Step();
            hashes.Add(Snapshot.Hash(runner.State));
            foreach (BallEvent item in runner.Events)
            {
                hits += item.Kind == BallEventKind.Impact && item.ColliderIndex == 1 ? 1 : 0;
            }
        }

        Assert.InRange(hits, 1, 5);

        // Played again from everywhere: the same bits, and in play as at the end.
        foreach (long from in (long[])[0, 10, 21, 30, 46, 60, 71, 99])
        {
            Assert.Null(rollback.ResimulateFrom(from));
            Assert.Equal(hashes[^1], Snapshot.Hash(runner.State));
            Assert.False(reserve.IsWithdrawn);
        }

        // As bytes, in another process's scene.
        Recording read = Recording.FromBytes(segment.ToBytes());
        FixedStepRunner fresh = New(out KinematicBody other);
        Assert.Null(read.FirstDivergence(fresh.Simulator));
        FixedStepRunner sought = read.Replay(fresh.Simulator);
        read.Seek(sought, 50);
        Assert.Equal(hashes[49], Snapshot.Hash(sought.State));
        Assert.True(other.IsWithdrawn);
        read.Seek(sought, 72);
        Assert.Equal(hashes[71], Snapshot.Hash(sought.State));
        Assert.False(other.IsWithdrawn);

        // A look-ahead that brings him on puts him back out of play.
        reserve.Withdraw();
        var path = new Trajectory();
        BallState from0 = runner.Simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(0, 1, -14), default);
        runner.Simulator.LookAhead(in from0, new LookAheadRequest { Duration = 1 }, path);
        Assert.False(path.TryGetHit(0, out _));
        var request = new LookAheadRequest { Duration = 1, TimeStep = Step, MoveBodies = time => { if (time > 0.1) { reserve.MoveTo(new Vector3d(0, 0, -6), default, time); } } };
        runner.Simulator.LookAhead(in from0, request, path);
        Assert.True(path.TryGetHit(0, out BallEvent hit));
        Assert.Equal(1, hit.ColliderIndex);
        Assert.True(reserve.IsWithdrawn);
    }

    [Fact]
    public void Several_balls_pass_where_a_withdrawn_body_was_and_hit_it_when_it_is_back()
    {
        var bodies = new KinematicBodies();
        KinematicBody post = bodies.Add("post", new SphereShape(Vector3d.Zero, 0.3), mass: 20);
        post.MoveTo(new Vector3d(0, 0.4, -3), default, 0);
        var group = new BallGroup(new Simulator(new Scene { Bodies = bodies }), 2);
        foreach (bool plays in (bool[])[true, false])
        {
            BallState[] states =
            [
                group.SimulatorOf(0).Launch(new Vector3d(0, 0.4, 0), new Vector3d(0, 1, -15), default),
                group.SimulatorOf(1).Launch(new Vector3d(0.5, 0.4, -6), new Vector3d(-1.5, 1, 10), default),
            ];
            if (plays)
            {
                post.MoveTo(new Vector3d(0, 0.4, -3), default, 0);
            }
            else
            {
                post.Withdraw();
            }

            var log = new StepLog();
            for (int i = 0; i < 30; i++)
            {
                group.Step(states, Step, log);
            }

            int hits = 0;
            foreach (BallEvent item in log.Events)
            {
                hits += item.Kind == BallEventKind.Impact && item.ColliderIndex == 1 ? 1 : 0;
            }

            Assert.Equal(plays, hits > 0);
        }
    }

    [Fact]
    public void Withdrawn_bodies_are_looked_at_by_no_step_and_allocate_nothing()
    {
        var bodies = new KinematicBodies();
        var asked = new Asked();
        KinematicBody[] reserves = [.. Enumerable.Range(0, 9).Select(i => bodies.Add($"reserve {i}", asked))];
        Array.ForEach(reserves, body => body.Withdraw());
        var ball = new Ball(new Scene { Bodies = bodies });
        var plain = new Ball();
        asked.Times = 0;
        ball.Kick(new Vector3d(1, 5, -20), new Vector3d(0, 20, 0));
        plain.Kick(new Vector3d(1, 5, -20), new Vector3d(0, 20, 0));
        for (int i = 0; i < 600; i++)
        {
            ball.Step(0.01);
            plain.Step(0.01);
        }

        Assert.Equal(0, asked.Times);
        Assert.Equal(plain.Position, ball.Position);
        Assert.Equal(0, Allocation.Of(() =>
        {
            reserves[3].MoveTo(new Vector3d(20, 0, 0), default, ball.Time);
            ball.Step(0.01);
            reserves[3].Withdraw();
            ball.Step(0.01);
        }));
    }

    private static int Hits(Ball ball, KinematicBody reserve, Vector3d? on)
    {
        ball.Place(new Vector3d(0, 0.11, 0));
        ball.Kick(new Vector3d(0, 0.5, -20), default);
        if (on is { } place)
        {
            reserve.MoveTo(place, default, 0);
        }

        int hits = 0;
        for (int i = 0; i < 12; i++)
        {
            ball.Step(Step);
            foreach (BallEvent item in ball.Events)
            {
                hits += item.Kind == BallEventKind.Impact && item.ColliderIndex == 1 ? 1 : 0;
            }
        }

        return hits;
    }

    /// <summary>A shape that counts how often it is asked.</summary>
    private sealed class Asked : IShape
    {
        private readonly SphereShape _shape = new(Vector3d.Zero, 0.4);

        public int Times { get; set; }

        public double MaximumConcaveCurvature => 0;

        public Bounds3d Bounds => _shape.Bounds;

        public ShapePoint At(in Vector3d point)
        {
            Times++;
            return _shape.At(in point);
        }
    }
}
