namespace FootballPhysics.Tests.Game;

/// <summary>What engines put together and draw: stages, keepers, nets, balls and lines.</summary>
public sealed class StageTests
{
    private const double TimeStep = 0.02;

    private static Goal Goal => new() { Center = new Vector3d(0, 0, -11), Facing = new Vector3d(0, 0, 1) };

    [Fact]
    public void A_stage_with_nothing_on_it_plays_the_default_scene()
    {
        var stage = new BallScene();
        stage.Compile();
        Assert.Same(Scene.Default, stage.Game.Scene);
        Assert.Same(stage.Game, stage.Ahead);
        Assert.Contains("already compiled", Assert.Throws<InvalidOperationException>(() => stage.Add(Goal)).Message, StringComparison.Ordinal);
        Assert.Contains("Compile", Assert.Throws<InvalidOperationException>(() => new BallScene().Game).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_place_has_its_nearest_goal()
    {
        var stage = new BallScene();
        Assert.Equal(-1, stage.NearestGoal(Vector3d.Zero));
        stage.Add(Goal);
        stage.Add(Goal with { Center = new Vector3d(0, 0, 11) });
        stage.Add(Goal with { Center = new Vector3d(30, 0, 0) });
        Assert.Equal(0, stage.NearestGoal(new Vector3d(0, 0, -1)));
        Assert.Equal(1, stage.NearestGoal(new Vector3d(0, 0, 1)));
        Assert.Equal(2, stage.NearestGoal(new Vector3d(25, 0, 0)));

        // As near to the first as to the second: the first.
        Assert.Equal(0, stage.NearestGoal(Vector3d.Zero));
    }

    [Fact]
    public void Every_part_of_a_goal_belongs_to_it()
    {
        var stage = new BallScene(Scene.Default with { Goals = [Goal with { Center = new Vector3d(50, 0, 0), HasNet = false }] });
        stage.Add(Goal);
        stage.Add(Goal with { Center = new Vector3d(0, 0, 11), Facing = new Vector3d(0, 0, -1) });
        stage.AddPlayer("wall 1", new Vector3d(3, 0, 5));
        stage.AddKeeper(0, new Vector3d(0, 0, -10.5));
        stage.Compile();
        Assert.Equal(0, stage.FirstNetOf(0));
        Assert.Equal(4, stage.FirstNetOf(1));
        var seen = new Dictionary<int, HashSet<string>> { [-1] = [], [0] = [], [1] = [] };
        foreach ((double x, double y, double z, double side) in new[] { (0.0, 1.2, -11.0, -1.0), (3.72, 1.0, -11.0, -1), (0.0, 2.5, -11.0, -1), (1.0, 0.8, 11.0, 1), (3.72, 1.0, 11.0, 1), (3.0, 0.9, 5.0, 1), (6.0, 0.2, 2.0, 1) })
        {
            // Straight at the place, from 4 m before it; the ball is not to be saved, so the stage's look at it is left out.
            BallState ball = stage.Game.Launch(new Vector3d(x, y, z - (side * 4)), new Vector3d(0, 0.6, side * 25), Vector3d.Zero);
            var log = new StepLog();
            for (int i = 0; i < 40; i++)
            {
                stage.BeforeStep(in ball);
                stage.Game.Step(ref ball, TimeStep, log);
            }

            foreach (BallEvent happened in log.Events)
            {
                seen[stage.GoalOf(in happened)].Add(happened.ColliderIndex < 0 ? "" : stage.Game.NameOf(happened.ColliderIndex)!);
            }
        }

        Assert.Contains("goal", seen[1]);
        Assert.Contains("back net", seen[1]);
        Assert.Contains("crossbar", seen[0]);
        Assert.Contains("wall 1", seen[-1]);
        Assert.Contains("ground", seen[-1]);
        Assert.DoesNotContain("keeper", seen[0]);
        Assert.DoesNotContain("goal", seen[-1]);
    }

    [Fact]
    public void A_keeper_saves_what_he_can_reach_and_dives_in_vain_for_what_he_cannot()
    {
        // To his left and right at a height where hands are, slow enough; and hard into the corner.
        Assert.Equal((true, false), Shot(new Vector3d(1.3, 1.0, -11), 16));
        Assert.Equal((true, false), Shot(new Vector3d(-1.6, 0.5, -11), 16));
        Assert.Equal((true, false), Shot(new Vector3d(0.05, 1.2, -11), 22));
        Assert.Equal((true, true), Shot(new Vector3d(3.4, 2.1, -11), 30));
        Assert.Equal((false, false), Shot(new Vector3d(6, 1.0, -11), 20));
    }

    [Fact]
    public void A_keeper_and_nets_follow_the_ball_without_allocating()
    {
        BallScene stage = WithKeeper();
        var runner = new FixedStepRunner(stage.Game, TimeStep);
        long least = long.MaxValue;
        for (int shot = 0; shot < 4; shot++)
        {
            runner.Place(new Vector3d(0, 0.11, 0));
            runner.QueueKick(17, new Vector3d(0.12, 0.12, -1));
            runner.Step();
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < 50; i++)
            {
                stage.BeforeStep(runner.State);
                runner.Step();
                stage.AfterStep(runner.State);
            }

            least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
        }

        Assert.Equal(0, least);
    }

    [Fact]
    public void A_net_bulges_where_the_ball_is_and_hangs_flat_again()
    {
        var stage = new BallScene();
        stage.Add(Goal);
        stage.Compile();
        Net back = Goal.Nets().First();
        var mesh = new NetMesh(back);
        Vector3d[] flat = mesh.Points.ToArray();
        Assert.All(flat, point => Assert.Equal(0, Vector3d.Dot(point - back.Center, back.Normal.Normalized()), 1e-9));
        Assert.All(mesh.Threads.ToArray(), index => Assert.InRange(index, 0, flat.Length - 1));
        BallState ball = stage.Game.Launch(new Vector3d(0.5, 0.8, -9), new Vector3d(0, 2, -25), Vector3d.Zero);
        var log = new StepLog();
        double deepest = 0;
        for (int i = 0; i < 400; i++)
        {
            stage.Game.Step(ref ball, TimeStep, log);
            stage.AfterStep(in ball);
            mesh.Follow(stage.Bulges[stage.FirstNetOf(0)]);
            double depth = 0;
            for (int k = 0; k < flat.Length; k++)
            {
                depth = Math.Max(depth, Vector3d.Distance(mesh.Points[k], in flat[k]));
            }

            Assert.InRange(depth, 0, stage.Bulges[0].Depth + 1e-9);
            deepest = Math.Max(deepest, depth);
        }

        Assert.True(deepest > 0.1, $"{deepest} m");
        Assert.Equal(flat, mesh.Points.ToArray());
        Assert.False(mesh.Follow(stage.Bulges[0]));
        Assert.Contains("mesh", Assert.Throws<ArgumentOutOfRangeException>(() => new NetMesh(back, 0)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_ball_has_as_much_dark_as_twelve_pentagons_have()
    {
        // Twelve pentagons take 0.28 of a truncated icosahedron, less the seams; twenty hexagons the rest.
        byte[] picture = BallPattern.Picture(256, 128);
        double dark = 0, light = 0, all = 0;
        for (int y = 0; y < 128; y++)
        {
            double weight = Math.Sin(Math.PI * (y + 0.5) / 128);
            for (int x = 0; x < 256; x++)
            {
                byte at = picture[(y * 256) + x];
                all += weight;
                dark += at == (byte)((255 * BallPattern.Dark) + 0.5) ? weight : 0;
                light += at == (byte)((255 * BallPattern.Light) + 0.5) ? weight : 0;
            }
        }

        Assert.InRange(dark / all, 0.23, 0.30);
        Assert.InRange(light / all, 0.60, 0.70);
        Assert.Equal(BallPattern.Dark, BallPattern.At(new Vector3d(0, 1, 0.5 * (1 + Math.Sqrt(5)))));
        Assert.Equal(BallPattern.Light, BallPattern.At(new Vector3d(1, 1, 1)));
    }

    [Fact]
    public void Surfaces_are_closed_and_wound_clockwise_seen_from_outside()
    {
        (string Name, ShapeMesh Mesh, double Volume)[] shapes =
        [
            ("ball", ShapeMesh.OfBall(0.5), 4.0 / 3.0 * Math.PI * 0.125),
            ("post", ShapeMesh.Of(new CapsuleShape(new Vector3d(1, 0, 2), new Vector3d(1, 3, 2), 0.5)), (4.0 / 3.0 * Math.PI * 0.125) + (3 * Math.PI * 0.25)),
            ("bar", ShapeMesh.Of(new CapsuleShape(new Vector3d(2, 0, 2), new Vector3d(-1, 0, 2), 0.5)), (4.0 / 3.0 * Math.PI * 0.125) + (3 * Math.PI * 0.25)),
            ("box", ShapeMesh.Of(new BoxShape(new Vector3d(1, 2, 3), new Vector3d(1, 0.5, 2))), 8),
        ];
        foreach ((string name, ShapeMesh mesh, double volume) in shapes)
        {
            double signed = 0;
            for (int i = 0; i < mesh.Triangles.Length; i += 3)
            {
                Vector3d a = mesh.Points[mesh.Triangles[i]], b = mesh.Points[mesh.Triangles[i + 1]], c = mesh.Points[mesh.Triangles[i + 2]];
                signed -= Vector3d.Dot(a, Vector3d.Cross(b, c)) / 6;
                Vector3d outwards = mesh.Normals[mesh.Triangles[i]];
                Assert.True(Vector3d.Dot(Vector3d.Cross(b - a, c - a), outwards) <= 1e-12, $"{name}, triangle {i / 3}");
            }

            Assert.InRange(signed, 0.96 * volume, 1.0001 * volume);
        }
    }

    [Fact]
    public void The_lines_of_a_pitch_lie_on_it_and_are_seen_from_above()
    {
        foreach (Pitch pitch in (Pitch[])[Pitch.Standard, Pitch.Futsal])
        {
            ShapeMesh lines = ShapeMesh.LinesOf(pitch);
            Assert.All(lines.Points.ToArray(), point =>
            {
                Assert.Equal(0, point.Y);
                Assert.InRange(Math.Abs(point.X), 0, (0.5 * pitch.Width) + 0.0601);
                Assert.InRange(Math.Abs(point.Z), 0, (0.5 * pitch.Length) + 0.0601);
            });
            double area = 0;
            for (int i = 0; i < lines.Triangles.Length; i += 3)
            {
                Vector3d a = lines.Points[lines.Triangles[i]], b = lines.Points[lines.Triangles[i + 1]], c = lines.Points[lines.Triangles[i + 2]];
                double up = Vector3d.Cross(b - a, c - a).Y;
                Assert.True(up <= 0, "clockwise seen from above");
                area -= 0.5 * up;
            }

            // Some 700 m of lines on a pitch of Law 1, 260 m in futsal.
            Assert.InRange(area / 0.12, pitch == Pitch.Standard ? 600 : 200, pitch == Pitch.Standard ? 850 : 320);
        }
    }

    [Fact]
    public void A_drag_curve_is_the_one_that_flights_have()
    {
        // Below and above the crisis of the generic curve, and without air.
        var simulator = new Simulator(Support.Profiles.Tunnel);
        Assert.InRange(AirCurve.Drag(simulator, 5), 0.45, 0.5);
        Assert.InRange(AirCurve.Drag(simulator, 25), 0.14, 0.2);
        Assert.InRange(AirCurve.Lift(simulator, 25, 60), 0.1, 0.4);
        Assert.Equal(0, AirCurve.Drag(new Simulator(Scene.Vacuum), 20));
        BallState ball = simulator.Launch(new Vector3d(0, 10, 0), new Vector3d(0, 0, -20), Vector3d.Zero);
        simulator.Step(ref ball, 1e-4, new StepLog());
        double force = 0.43 * (20 + ball.Velocity.Z) / 1e-4;
        Assert.Equal(force, 0.5 * 1.2 * Math.PI * 0.11 * 0.11 * 400 * AirCurve.Drag(simulator, 20), 1e-3);
        Assert.Contains("speed", Assert.Throws<ArgumentOutOfRangeException>(() => AirCurve.Drag(simulator, 0)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_segment_is_played_to_any_tick_and_a_false_one_is_found()
    {
        var runner = new FixedStepRunner(new Simulator(Pitch.Standard.On()), TimeStep);
        Recording segment = runner.Record();
        runner.QueueKick(25, new Vector3d(0.1, 0.4, -1), -10, 30);
        var states = new List<BallState> { runner.State };
        for (int i = 0; i < 300; i++)
        {
            if (i == 150)
            {
                runner.QueueKick(20, new Vector3d(0.3, 0.1, 1));
            }

            runner.Step();
            states.Add(runner.State);
        }

        var player = new RecordingPlayer(Recording.FromBytes(segment.ToBytes()), new Simulator(Pitch.Standard.On()));
        Assert.Equal(6, player.Duration, 1e-9);
        foreach (long tick in (long[])[200, 40, 300, 0, 151])
        {
            player.Seek(tick);
            Assert.True(Snapshot.Same(states[(int)tick], player.State) && player.IsTrue);
        }

        player.Seek(10);
        player.Advance(1.01);
        Assert.Equal(60, player.Tick);
        Assert.Equal(1.21, player.Time, 1e-9);
        Assert.InRange(Vector3d.Distance(player.Pose.Position, 0.5 * (states[59].Position + states[60].Position)), 0, 1e-2);
        Assert.Null(player.FindDivergence());
        Assert.Equal(60, player.Tick);
        player.Advance(100);
        Assert.True(player.IsOver && player.Tick == 300);
        Assert.Throws<ArgumentException>(() => new RecordingPlayer(segment, new Simulator()));
        segment.Kicks.Add(new KickInput(150, new Vector3d(0, 5, 5), Vector3d.Zero, player: 3));
        Assert.Equal(151, new RecordingPlayer(segment, new Simulator(Pitch.Standard.On())).FindDivergence());
    }

    private static BallScene WithKeeper()
    {
        var stage = new BallScene();
        stage.Add(Goal);
        stage.AddKeeper(0, new Vector3d(0, 0, -10.4));
        stage.Compile();
        return stage;
    }

    /// <summary>A shot from the spot: whether he dived, and whether it was a goal.</summary>
    private static (bool Dived, bool Scored) Shot(Vector3d at, double speed)
    {
        BallScene stage = WithKeeper();
        var spot = new Vector3d(0, 0.11, 0);
        AimResult aim = new Aimer(stage.Ahead).Find(new AimRequest { From = spot, Target = at, Speed = speed });
        var runner = new FixedStepRunner(stage.Game, TimeStep);
        runner.Place(spot);
        runner.QueueKick(aim.Velocity, aim.Spin);
        bool scored = false;
        for (int i = 0; i < 150; i++)
        {
            stage.BeforeStep(runner.State);
            runner.Step();
            foreach (BallEvent happened in runner.Events)
            {
                scored |= happened.Kind == BallEventKind.Goal;
            }
        }

        return (stage.Keepers[0].Count > 0, scored);
    }

    [Fact]
    public void Bodies_of_a_scene_and_keepers_are_not_mixed_up()
    {
        var stage = new BallScene(Scene.Default with { Bodies = new KinematicBodies() });
        stage.Add(Goal);
        stage.AddKeeper(0, new Vector3d(0, 0, -10.4));
        Assert.Contains("bodies", Assert.Throws<InvalidOperationException>(stage.Compile).Message, StringComparison.Ordinal);
    }

    /// <summary>A keeper reaches as high over his feet on any ground; and one whose time goes back dives for the same shot again.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(12)]
    [InlineData(-5)]
    public void A_keeper_saves_on_any_level_and_again_after_a_rollback(double level)
    {
        var stage = new BallScene(Scene.Default with { Ground = new Ground { Material = SurfaceMaterial.DryTurf, Height = level } });
        stage.Add(Goal with { Center = new Vector3d(0, level, -11) });
        stage.AddKeeper(0, new Vector3d(0, level, -10.4));
        stage.Compile();
        BallState ball = stage.Game.Launch(new Vector3d(0, level + 0.11, 0), new Vector3d(1.5, 2.5, -14), Vector3d.Zero);
        var runner = new FixedStepRunner(stage.Game, 1 / 240.0);
        runner.Restore(0, ball);
        for (int i = 0; i < 12; i++)
        {
            stage.BeforeStep(runner.State);
            runner.Step();
        }

        Assert.Equal(1, stage.Keepers[0].Count);
        Assert.True(stage.Keepers[0].Answer.Saves);
        runner.Restore(11, runner.State with { Time = runner.State.Time - (1 / 240.0) });
        for (int i = 0; i < 40; i++)
        {
            stage.BeforeStep(runner.State);
            runner.Step();
        }

        Assert.True(stage.Keepers[0].Dives, "he stands");
    }
}
