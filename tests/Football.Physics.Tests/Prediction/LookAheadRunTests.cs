namespace FootballPhysics.Tests.Predictors;

/// <summary>A look-ahead in parts gives the bits of one in one go.</summary>
public sealed class LookAheadRunTests
{
    private static readonly Goal s_goal = new() { Center = new Vector3d(0, 0, -11), Facing = new Vector3d(0, 0, 1) };

    public static TheoryData<string, int> Cases()
    {
        var data = new TheoryData<string, int>();
        foreach (string name in new[] { "kick", "vacuum", "net", "bodies", "pushed", "moved", "stiff", "full", "plane", "passing", "impact" })
        {
            foreach (int steps in new[] { 1, 2, 7, 1000 })
            {
                data.Add(name, steps);
            }
        }

        return data;
    }

    /// <summary>Flights, bounces, rolls, nets, bodies, stiff forces and full buffers, with a game that plays on between the parts.</summary>
    [Theory]
    [MemberData(nameof(Cases))]
    public void Any_number_of_steps_per_call_gives_the_same_bits(string name, int steps)
    {
        var whole = new Case(name);
        whole.Simulator.LookAhead(in whole.Kick, whole.Request, whole.Path);
        var parts = new Case(name);
        var run = new LookAheadRun(parts.Simulator, parts.Path);
        run.Start(in parts.Kick, parts.Request);
        Assert.False(run.Path.IsComplete);
        int calls = 0;
        BallState played = parts.Kick;
        while (!run.Continue(steps))
        {
            Assert.False(run.Path.IsComplete);
            Assert.True(run.IsRunning);
            calls++;
            parts.Disturb(calls, ref played);
        }

        Assert.False(run.IsRunning);
        Assert.Equal(steps == 1000, calls == 0);
        Assert.InRange(run.Steps, (calls * steps) + 1, (calls + 1) * steps);
        Same(whole.Path, run.Path);
        Assert.True(whole.Path.Pieces.Length > 3);
    }

    /// <summary>The start calls MoveBodies at the time of the ball, for the look-ahead only.</summary>
    [Fact]
    public void A_start_leaves_the_bodies_of_the_game_where_they_are()
    {
        var bodies = new KinematicBodies();
        KinematicBody player = bodies.Add("player", BodyKind.Player.Shape, SurfaceMaterial.Boot);
        var simulator = new Simulator(new Scene { Bodies = bodies });
        player.MoveTo(new Vector3d(3, 0, 1), new Vector3d(0.5, 0, 0), 0);
        BallState ball = simulator.Launch(new Vector3d(0, 0.5, 0), new Vector3d(0, 1, -9), Vector3d.Zero);
        var run = new LookAheadRun(simulator);
        run.Start(in ball, new LookAheadRequest { MoveBodies = time => player.MoveTo(new Vector3d(9, 0, 9), new Vector3d(7, 0, 0), time) });
        Assert.Equal(new Vector3d(3, 0, 1), player.Position);
        Assert.Equal(new Vector3d(0.5, 0, 0), player.Velocity);
    }

    [Fact]
    public void The_path_so_far_is_the_beginning_of_the_whole_one()
    {
        var whole = new Case("kick");
        whole.Simulator.LookAhead(in whole.Kick, whole.Request, whole.Path);
        var run = new LookAheadRun(whole.Simulator);
        run.Start(in whole.Kick, whole.Request);
        Assert.Equal(Snapshot.Hash(whole.Kick), Snapshot.Hash(run.Path.Final));
        double end = 0;
        while (!run.Continue(3))
        {
            Assert.True(run.Path.EndTime > end);
            end = run.Path.EndTime;
            Assert.Equal(whole.Path.PositionAt(0.9 * end), run.Path.PositionAt(0.9 * end));
        }

        Assert.True(end > 1);
    }

    /// <summary>The balls meet, roll and rest; the group is stepped between the parts.</summary>
    [Theory]
    [InlineData(1, 512)]
    [InlineData(5, 512)]
    [InlineData(1000, 512)]
    [InlineData(2, 4)]
    public void Several_balls_too(int steps, int capacity)
    {
        (BallGroup Group, BallState[] From) Make()
        {
            var simulator = new Simulator(new Scene { Goals = [s_goal], Obstacles = [Box()] });
            return (new BallGroup(simulator, 3),
            [
                simulator.Launch(new Vector3d(-1, 0.6, 0), new Vector3d(4, 0, -6), Vector3d.Zero),
                simulator.Launch(new Vector3d(1, 0.6, 0.02), new Vector3d(-4, 0, -6), new Vector3d(0, 30, 0)),
                simulator.Launch(new Vector3d(0, 0.11, -3), Vector3d.Zero, Vector3d.Zero),
            ]);
        }

        var request = new LookAheadRequest { Duration = 4, TimeStep = 1 / 60.0, StopAt = StopAt.Rest };
        (BallGroup group, BallState[] from) = Make();
        Trajectory[] whole = [new Trajectory(capacity), new Trajectory(capacity), new Trajectory(capacity)];
        group.LookAhead(from, request, whole);
        (group, from) = Make();
        var run = new LookAheadRun(group, capacity);
        run.Start(from, request);
        BallState[] played = [.. from];
        var log = new StepLog();
        int calls = 0;
        while (!run.Continue(steps))
        {
            Assert.DoesNotContain(run.Paths, path => path.IsComplete);
            group.Step(played, 1 / 60.0, log);
            if (++calls == 10)
            {
                group.SimulatorOf(1).Kick(ref played[1], new Vector3d(3, 5, 2), Vector3d.Zero);
            }
        }

        for (int ball = 0; ball < whole.Length; ball++)
        {
            Same(whole[ball], run.Paths[ball]);
        }

        // The ball that the game has kicked has left its path.
        Assert.True(calls < 11 || !run.Follows(1, in played[1]));
        Assert.Throws<ArgumentOutOfRangeException>(() => run.Follows(3, in played[1]));
        Assert.Throws<InvalidOperationException>(() => run.Continue(1));
    }

    [Fact]
    public void A_kick_in_the_middle_is_noticed_and_a_new_start_predicts_it()
    {
        var simulator = new Simulator();
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(2, 6, -18), new Vector3d(0, 20, 0));
        var request = new LookAheadRequest { Duration = 2, TimeStep = 0.01, StopAt = StopAt.Time };
        var run = new LookAheadRun(simulator);
        Assert.False(run.Follows(in ball));
        run.Start(in ball, request);
        Assert.True(run.Follows(in ball));
        var log = new StepLog();
        for (int i = 0; i < 40; i++)
        {
            Assert.False(run.Continue(4));
            simulator.Step(ref ball, 0.01, log);
            Assert.True(run.Follows(in ball, 1e-9));
        }

        BallState saved = ball;
        simulator.Kick(ref ball, new Vector3d(5, 3, 4), Vector3d.Zero);
        Assert.False(run.Follows(in ball));

        // A rollback before the kick: the run is valid again, and ends with the same bits as ever.
        Assert.True(run.Follows(in saved, 1e-9));
        run.Start(in ball, request);
        Assert.True(run.Follows(in ball, 0));
        Assert.False(run.Follows(in saved));
        Assert.True(run.Continue(int.MaxValue));
        var path = new Trajectory();
        simulator.LookAhead(in ball, request, path);
        Same(path, run.Path);
    }

    [Fact]
    public void Wrong_use_is_rejected()
    {
        var simulator = new Simulator();
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(2, 6, -18), Vector3d.Zero);
        var path = new Trajectory();
        var run = new LookAheadRun(simulator, path);
        Assert.Contains("Call Start", Assert.Throws<InvalidOperationException>(() => run.Continue(1)).Message, StringComparison.Ordinal);
        run.Start(in ball, new LookAheadRequest());
        Assert.Throws<ArgumentOutOfRangeException>(() => run.Continue(0));
        Assert.False(run.Continue(1));
        run.Cancel();
        Assert.False(run.IsRunning);
        Assert.Throws<InvalidOperationException>(() => run.Continue(1));
        run.Start(in ball, new LookAheadRequest());
        simulator.LookAhead(in ball, new LookAheadRequest(), path);
        Assert.False(run.Follows(in ball));
        Assert.Contains("trajectory", Assert.Throws<InvalidOperationException>(() => run.Continue(1)).Message, StringComparison.Ordinal);
        Assert.True(path.IsComplete);
        Assert.Throws<ArgumentOutOfRangeException>(() => run.Start(in ball, new LookAheadRequest { Duration = -1 }));
        Assert.Throws<ArgumentOutOfRangeException>(() => run.Follows(in ball, -1));
    }

    /// <summary>The ball pushes a box away, comes back from a wall, and meets the box where it has gone.</summary>
    [Fact]
    public void A_box_that_the_ball_pushes_is_met_again_where_it_has_gone()
    {
        var wall = new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(0, 0, 2), new Vector3d(0, 0, -1)) };
        Obstacle box = Box() with { Shape = new BoxShape(new Vector3d(0, 0, -5), new Vector3d(0.3, 0.3, 0.3)) };
        var simulator = new Simulator(Scene.Vacuum with { Gravity = 0, Ground = Ground.None, Obstacles = [box, wall] });
        BallState ball = simulator.Launch(Vector3d.Zero, new Vector3d(0, 0, -20), Vector3d.Zero);
        var run = new LookAheadRun(simulator);
        run.Start(in ball, new LookAheadRequest { Duration = 4, StopAt = StopAt.Time });
        while (!run.Continue(5))
        {
        }

        Assert.True(run.Path.TryGetHit(0, out BallEvent first));
        Assert.True(run.Path.TryGetHit(1, out BallEvent atWall));
        Assert.True(run.Path.TryGetHit(2, out BallEvent again));
        Assert.Equal((1, 2, 1), (first.ColliderIndex, atWall.ColliderIndex, again.ColliderIndex));
        Assert.Equal(-5 + 0.3 + simulator.Scene.Ball.Radius, first.Position.Z, 1e-6);

        // The momentum that the ball has lost is that of the box.
        double gone = simulator.Scene.Ball.Mass * (20 + atWall.VelocityBefore.Z) / box.Mass * (again.Time - first.Time);
        Assert.Equal(first.Position.Z - gone, again.Position.Z, 1e-6);
    }

    /// <summary>A call takes as many steps as it is allowed to, for one ball and for several.</summary>
    [Fact]
    public void A_call_takes_no_more_steps_than_it_may()
    {
        var simulator = new Simulator();
        BallState[] from = [simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(2, 6, -18), Vector3d.Zero), simulator.Launch(new Vector3d(5, 0.11, 0), new Vector3d(2, 6, -18), Vector3d.Zero)];
        var request = new LookAheadRequest { Duration = 1, TimeStep = 0.01, StopAt = StopAt.Time };
        var one = new LookAheadRun(simulator);
        var several = new LookAheadRun(new BallGroup(simulator, 2));
        one.Start(in from[0], request);
        several.Start(from, request);
        long steps = 0;
        foreach (int count in new[] { 1, 3, 20 })
        {
            steps += count;
            Assert.False(one.Continue(count) || several.Continue(count));
            Assert.Equal((steps, steps), (one.Steps, several.Steps));
            Assert.Equal(0.01 * steps, several.Paths[1].EndTime, 1e-12);
        }

        Assert.Equal("from", Assert.Throws<ArgumentNullException>(() => several.Start(null!, request)).ParamName);
        Assert.Equal("request", Assert.Throws<ArgumentNullException>(() => several.Start(from, null!)).ParamName);
    }

    [Fact]
    public void A_force_that_throws_ends_the_run_before_its_step()
    {
        int calls = 0;
        IForce force = IForce.From(_ => calls++ > 200 ? throw new TimeoutException() : Vector3d.Zero);
        var simulator = new Simulator(new Scene { Forces = ForceSet.Measured with { CustomForces = [force] } });
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(2, 6, -18), Vector3d.Zero);
        var run = new LookAheadRun(simulator);
        calls = 0;
        run.Start(in ball, new LookAheadRequest { TimeStep = 0.02 });
        Assert.Throws<TimeoutException>(() =>
        {
            while (!run.Continue(2))
            {
            }
        });
        Assert.False(run.IsRunning);
        Assert.False(run.Path.IsComplete);
        Assert.True(run.Path.Pieces.Length > 3);
        Assert.Equal(run.Path.Pieces[^1].EndTime, run.Path.Final.Time);
    }

    [Fact]
    public void Parts_do_not_allocate()
    {
        var of = new Case("pushed");
        var run = new LookAheadRun(of.Simulator);
        Assert.Equal(0, Allocation.Of(() =>
        {
            run.Start(in of.Kick, of.Request);
            while (!run.Continue(3))
            {
            }
        }));
    }

    private static Obstacle Box() => new()
    {
        Name = "box",
        Shape = new BoxShape(new Vector3d(0.5, 0.3, -5), new Vector3d(0.3, 0.3, 0.3)),
        Surface = SurfaceMaterial.Wood,
        Mass = 4,
    };

    private static void Same(Trajectory expected, Trajectory actual)
    {
        Assert.Equal((expected.IsComplete, expected.Pieces.Length, expected.Events.Count), (actual.IsComplete, actual.Pieces.Length, actual.Events.Count));
        Assert.Equal(Snapshot.Hash(expected.Final), Snapshot.Hash(actual.Final));
        Assert.Equal(BitConverter.DoubleToInt64Bits(expected.EndTime), BitConverter.DoubleToInt64Bits(actual.EndTime));
        for (int i = 0; i < expected.Pieces.Length; i++)
        {
            PathSegment a = expected.Pieces[i];
            PathSegment b = actual.Pieces[i];
            Assert.Equal(
                (a.Time, a.Length, a.StartPosition, a.StartVelocity, a.StartAcceleration, a.EndPosition, a.EndVelocity),
                (b.Time, b.Length, b.StartPosition, b.StartVelocity, b.StartAcceleration, b.EndPosition, b.EndVelocity));
            Assert.Equal((a.EndAcceleration, a.Motion), (b.EndAcceleration, b.Motion));
        }

        for (int i = 0; i < expected.Events.Count; i++)
        {
            BallEvent a = expected.Events[i];
            BallEvent b = actual.Events[i];
            Assert.Equal((a.Kind, a.Time, a.Position, a.Velocity, a.ColliderIndex), (b.Kind, b.Time, b.Position, b.Velocity, b.ColliderIndex));
        }
    }

    /// <summary>A scene, a kick and a request; the game moves its bodies.</summary>
    private sealed class Case
    {
        private readonly KinematicBody? _player;
        private readonly StepLog _log = new();

        public Case(string name)
        {
            var bodies = new KinematicBodies();
            if (name is "bodies" or "pushed" or "moved")
            {
                _player = bodies.Add("player", BodyKind.Player.Shape, SurfaceMaterial.Boot, name == "pushed" ? 70 : double.PositiveInfinity);
                _player.MoveTo(new Vector3d(0.4, 0, -4), Quaterniond.Identity, new Vector3d(-0.4, 0, 0.5), Vector3d.Zero, 0);
            }

            var scene = new Scene();
            Request = new LookAheadRequest { Duration = 5, TimeStep = 1 / 60.0 };
            Vector3d velocity = name == "net" ? new Vector3d(1, 3, -16) : new Vector3d(0.3, 1.5, -9);
            scene = name switch
            {
                "vacuum" => Scene.Vacuum,
                "net" => scene with { Goals = [s_goal] },
                "bodies" or "moved" => scene with { Bodies = bodies },
                "pushed" => scene with { Bodies = bodies, Obstacles = [Box()] },
                "stiff" => scene with { Forces = ForceSet.Measured with { CustomForces = [IForce.From(ball => new Vector3d(-6 * ball.Position.X, 0, 0))] } },
                _ => scene,
            };
            Request = name switch
            {
                "moved" => Request with { MoveBodies = time => _player!.MoveTo(new Vector3d(0.2 + (0.1 * time), 0, -4 + (0.6 * time)), Vector3d.Zero, time) },
                "stiff" => Request with { TimeStep = 0.08 },
                "plane" => Request with { UntilPlane = new Plane3d(new Vector3d(0, 0, -7), new Vector3d(0, 0, 1)) },
                "passing" => Request with { UntilPassing = new Vector3d(1, 0.5, -4) },
                "impact" => Request with { StopAt = StopAt.Impact },
                _ => Request,
            };
            Simulator = new Simulator(scene);
            Kick = Simulator.Launch(new Vector3d(0.2, 0.5, 0), velocity, new Vector3d(5, 20, 3));
            Path = name == "full" ? new Trajectory(new PathSegment[11]) : new Trajectory();
        }

        public Simulator Simulator { get; }

        public LookAheadRequest Request { get; }

        public Trajectory Path { get; }

        public BallState Kick;

        /// <summary>Plays the game on: another ball flies, and may push the box; the player goes elsewhere.</summary>
        public void Disturb(int call, ref BallState played)
        {
            _player?.MoveTo(new Vector3d(0.1 * call, 0, -2), Quaterniond.Identity, new Vector3d(1, 0, 0), new Vector3d(0, 1, 0), played.Time);
            Simulator.Step(ref played, 1 / 60.0, _log);
            if (call % 20 == 0)
            {
                Simulator.Kick(ref played, new Vector3d(1, 2, -8), Vector3d.Zero);
            }
        }
    }
}
