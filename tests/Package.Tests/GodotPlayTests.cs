using FootballPhysics.GodotAddon;
using Godot;
using UnityPreset = FootballPhysics.Unity.FootballPreset;
using Vector3 = Godot.Vector3;

namespace FootballPhysics.Package.Tests;

/// <summary>Godot's scenes and nodes, played against the shims: a goal that is dragged in scores, a post stops the ball, and whatever is set counts.</summary>
[Collection(EngineTests.Statics)]
public sealed class GodotPlayTests : IDisposable
{
    private const double Frame = 1 / 60.0;

    public GodotPlayTests() => Dispose();

    public static TheoryData<string> Files => [.. GodotAsset.Files];

    public void Dispose()
    {
        foreach (Node node in Node.Root.GetChildren())
        {
            node.QueueFree();
        }

        World3D.Only.DirectSpaceState.All.Clear();
        GD.Pushed.Clear();
        Engine.PhysicsTicksPerSecond = 60;
        Engine.InEditor = false;
        Engine.InterpolationFraction = 1;
        Input.PressedButton = MouseButton.None;
        Input.PressedKey = Key.None;
        Viewport.Only.Camera = null;
    }

    [Theory]
    [MemberData(nameof(Files))]
    public void Every_script_property_and_reference_of_its_files_is_there(string file)
    {
        if (file.EndsWith(".tres", StringComparison.Ordinal))
        {
            Assert.NotNull(((FootballPreset)GodotAsset.LoadResource(file)).Compile());
        }
        else
        {
            Assert.True(GodotAsset.Load(file).IsInsideTree());
            Node.Play(2, Frame);
            Assert.DoesNotContain(GD.Pushed, said => !said.Contains("has no goal to guard", StringComparison.Ordinal));
        }
    }

    [Theory]
    [InlineData("Match Ball Modern", "match_ball_modern")]
    [InlineData("Match Ball Tunnel", "match_ball_tunnel")]
    [InlineData("Futsal", "futsal")]
    [InlineData("Rain", "rain")]
    [InlineData("Altitude", "altitude")]
    [InlineData("Arcade", "arcade")]
    public void A_ready_preset_is_the_same_scene_in_both_engines(string unity, string godot)
    {
        Simulator one = ((UnityPreset)UnityAsset.LoadAsset($"Presets/{unity}.asset")).Compile();
        Simulator two = ((FootballPreset)GodotAsset.LoadResource($"addons/football_physics/presets/{godot}.tres")).Compile();
        Assert.Equal(one.SceneHash, two.SceneHash);
        Assert.Equal(unity == "Match Ball Modern", new Simulator().SceneHash == one.SceneHash);
    }

    [Fact]
    public void A_goal_that_is_dragged_in_scores()
    {
        (FootballBall ball, FootballGoal goal) = BallAndGoal();
        MeshInstance3D[] nets = [.. goal.GetChildren(true).OfType<MeshInstance3D>().Where(part => ((ArrayMesh)part.Mesh).Surfaces[0].Primitive == Mesh.PrimitiveType.Lines)];
        Assert.Equal(4, nets.Length);
        Vector3[] flat = ((ArrayMesh)nets[0].Mesh).Surfaces[0].Points;
        ball.KickAsPreviewed();
        float deepest = 0;
        Play(200, () => deepest = MathF.Max(deepest, ((ArrayMesh)nets[0].Mesh).Surfaces[0].Points.Zip(flat, (a, b) => (a - b).Length()).Max()));
        Assert.Equal(1, goal.Count);
        Assert.Equal(["Scored", "NetMet"], goal.Emitted.Take(2).Select(emitted => emitted.Signal));
        Assert.Same(ball, goal.Emitted[0].Arguments[0].Value);
        Assert.Contains("Goal", ball.Emitted.Select(emitted => emitted.Signal));
        Assert.Contains("Net", ball.Emitted.Select(emitted => emitted.Signal));
        Assert.InRange(deepest, 0.05f, 2f);
        Assert.InRange(ball.GlobalPosition.Z, -22.2f, -20f);
        Assert.Empty(GD.Pushed);
    }

    [Theory]
    [InlineData(3.72, 1.2)]
    [InlineData(-3.72, 1.2)]
    [InlineData(0, 2.5)]
    public void A_post_stops_the_ball(double x, double y)
    {
        (FootballBall ball, FootballGoal goal) = BallAndGoal();
        Shoot(ball, new Vector3d(x, y, -20), 25);
        float before = 0, after = 0;
        Play(120, () =>
        {
            before = goal.Emitted.Count == 0 ? ball.Velocity.Z : before;
            after = goal.Emitted.Count > 0 && after == 0 ? ball.Velocity.Z : after;
        });
        Assert.Equal("FrameHit", goal.Emitted[0].Signal);
        Assert.True(after > before + 5, $"{before}, {after} m/s");
    }

    [Fact]
    public void A_fresh_preset_is_no_preset_to_the_last_bit_among_goals_too()
    {
        BallAndGoal();
        GodotAsset.Load("addons/football_physics/scenes/wall.tscn");
        FootballBall bare = NewBall();
        FootballBall preset = NewBall();
        preset.Preset = new FootballPreset();
        bare.Kick(24, new Vector3(0.12f, 0.2f, -1), -20, 30);
        preset.Kick(24, new Vector3(0.12f, 0.2f, -1), -20, 30);
        Play(400, () => Assert.True(Netcode.Snapshot.Same(bare.Runner.State, preset.Runner.State)));
        Assert.Equal(400, preset.Runner.Tick);
    }

    [Fact]
    public void What_is_set_after_creation_counts_from_the_next_step_on()
    {
        FootballBall ball = NewBall();
        ball.Preset = new FootballPreset { Surface = FootballPreset.GroundChoice.LongGrass };
        Play(1);
        Assert.Equal(Ground.Of(SurfaceMaterial.LongGrass), ball.Runner.Simulator.Scene.Ground);
        ball.Preset.Gravity = 1.62f;
        Play(1);
        Assert.Equal(1.62, ball.Runner.Simulator.Scene.Gravity);

        var wall = new StaticBody3D { Name = "wall", GlobalPosition = new Vector3(0, 1, -6) };
        wall.Add(new SphereShape3D { Radius = 2 }, Transform3D.Identity);
        World3D.Only.DirectSpaceState.All.Add(wall);
        ball.Kick(20, new Vector3(0, 0.1f, -1));
        ball.HitMask = 1;
        Play(40);
        Assert.True(ball.Velocity.Z > 0);

        FootballGoal goal = Goal();
        Play(1);
        Assert.Equal(-20, Assert.Single(ball.Runner.Simulator.Scene.Goals).Center.Z);
        goal.GlobalPosition = new Vector3(0, 0, -33);
        goal.Width = 5;
        Play(1);
        Assert.Equal((-33, 5), (ball.Runner.Simulator.Scene.Goals[0].Center.Z, ball.Runner.Simulator.Scene.Goals[0].Width));
        goal.QueueFree();
        Play(1);
        Assert.Empty(ball.Runner.Simulator.Scene.Goals);

        ball.Preset.CustomRadius = 99;
        ball.Preset.Ball = FootballPreset.BallChoice.Custom;
        long tick = ball.Runner.Tick;
        Play(3);
        Assert.Equal(tick + 3, ball.Runner.Tick);
        Assert.Contains("ball.radius", Assert.Single(GD.Pushed), StringComparison.Ordinal);
    }

    [Fact]
    public void Every_number_of_a_preset_changes_what_a_ball_sees_of_it()
    {
        foreach (System.Reflection.PropertyInfo property in typeof(FootballPreset).GetProperties().Where(property => property.IsDefined(typeof(ExportAttribute), false)))
        {
            FootballBall ball = NewBall();
            ball.Preset = new FootballPreset();
            Play(1);
            Simulator before = ball.Runner.Simulator;
            Play(1);
            Assert.Same(before, ball.Runner.Simulator);
            object? value = property.GetValue(ball.Preset);
            property.SetValue(ball.Preset, value switch
            {
                float number => number + 0.25f,
                Vector3 => new Vector3(1, 0, 0),
                _ => Enum.ToObject(property.PropertyType, property.PropertyType == typeof(Integrator) ? 1 : 3 % Enum.GetValues(property.PropertyType).Length),
            });
            Play(1);
            Assert.True(!ReferenceEquals(before, ball.Runner.Simulator), property.Name);
            Dispose();
        }
    }

    [Fact]
    public void Who_moves_the_node_in_play_is_told_once_what_to_call()
    {
        FootballBall ball = NewBall();
        ball.Name = "Ball 3";
        Play(2);
        ball.GlobalPosition = new Vector3(3, 1, 0);
        Play(2);
        ball.GlobalPosition = new Vector3(4, 1, 0);
        Play(2);
        Assert.Contains("\"Ball 3\"", Assert.Single(GD.Pushed), StringComparison.Ordinal);
        Assert.Contains("Place(position)", GD.Pushed[0], StringComparison.Ordinal);
        Assert.Equal(0, ball.GlobalPosition.X);
    }

    [Fact]
    public void The_editor_shows_the_kick_and_follows_preset_goals_and_place()
    {
        Engine.InEditor = true;
        var ball = (FootballBall)GodotAsset.Load("addons/football_physics/scenes/football.tscn");
        ball.Preset = new FootballPreset();
        Node.Play(2, Frame);
        Vector3[] Line() => [.. ball.GetChildren(true).OfType<MeshInstance3D>().Select(part => (ArrayMesh)part.Mesh)
            .Single(mesh => mesh.Surfaces.Count == 1 && mesh.Surfaces[0].Primitive == Mesh.PrimitiveType.Lines).Surfaces[0].Points];
        Vector3[] still = Line();
        Assert.Equal(181, still.Length);
        ball.Preset.Wind = new Vector3(8, 0, 0);
        Node.Play(1, Frame);
        Assert.True(Line()[180].X > still[180].X + 1);
        ball.Preset.Wind = Vector3.Zero;
        FootballGoal goal = Goal();
        Node.Play(1, Frame);
        Assert.InRange(Line()[^1].Z, -22.2f, -20);
        goal.QueueFree();
        ball.KickHeading = 90;
        Node.Play(1, Frame);
        Assert.True(Line()[180].X > 30 && MathF.Abs(Line()[180].Z) < 1);
        ball.GlobalPosition = new Vector3(0, 0.11f, 5);
        Node.Play(1, Frame);
        Assert.Equal(5, Line()[0].Z);
        Assert.Throws<InvalidOperationException>(() => ball.Runner);
    }

    [Fact]
    public void A_step_among_goal_wall_and_keeper_allocates_nothing()
    {
        (FootballBall ball, _) = BallAndGoal();
        GodotAsset.Load("addons/football_physics/scenes/wall.tscn");
        GodotAsset.Load("addons/football_physics/scenes/keeper.tscn");
        long least = long.MaxValue;
        for (int shot = 0; shot < 5; shot++)
        {
            ball.Place(new Vector3(0, 0.11f, 0));
            ball._PhysicsProcess(Frame);
            ball.Emitted.Clear();
            ball.Kick(17, new Vector3(0.1f, 0.2f, -1));
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < 30; i++)
            {
                ball._PhysicsProcess(Frame);
            }

            least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);

            // The shim's signals keep what was emitted, and so allocate.
            Assert.Empty(ball.Emitted);
        }

        Assert.Equal(0, least);
    }

    /// <summary>The keeper in the tree saves the same late kick as one in time, and a place in between is an input of its tick.</summary>
    [Fact]
    public void A_keeper_and_a_place_under_rollback_end_in_the_same_bits_however_late_the_kick_is()
    {
        var ends = new List<ulong>();
        foreach (int late in (int[])[0, 4, 20])
        {
            Dispose();
            (FootballBall ball, _) = BallAndGoal();
            GodotAsset.Load("addons/football_physics/scenes/keeper.tscn");
            ball.Place(new Vector3(0, 0.11f, 0));
            ball._PhysicsProcess(Frame);
            var rollback = new FootballPhysics.Netcode.Rollback(ball.Runner, 64);
            long first = ball.Runner.Tick;
            for (int i = 0; i < 100; i++)
            {
                if (i == 10 + late)
                {
                    rollback.ApplyKick(new FootballPhysics.Netcode.KickInput(first + 10, new Vector3d(1.5, 3, -19), default));
                }

                if (i == 70)
                {
                    ball.Place(new Vector3(0, 0.11f, 2));
                    Assert.Equal(1, ball.Runner.Kicks.PlaceCount);
                }

                ball._PhysicsProcess(Frame);
            }

            Assert.Null(rollback.SyncTest(64));
            ends.Add(rollback.HashAt(first + 100));
        }

        Assert.Equal((ends[0], ends[0]), (ends[1], ends[2]));
    }

    [Fact]
    public void A_body_that_moves_freely_gets_the_impulse_and_a_frozen_one_does_not()
    {
        var rebounds = new List<float>();
        foreach (bool frozen in (bool[])[false, true])
        {
            Dispose();
            FootballBall ball = NewBall();
            var cone = new RigidBody3D { Name = "cone", Mass = 0.5f, Freeze = frozen, GlobalPosition = new Vector3(0, 0.5f, -6) };
            cone.Add(new SphereShape3D { Radius = 0.5f }, Transform3D.Identity);
            World3D.Only.DirectSpaceState.All.Add(cone);
            ball.HitMask = 1;
            ball.KickWith(new Vector3(0, 2, -20), Vector3.Zero);
            for (int i = 0; i < 40 && ball.Emitted.Count == 0; i++)
            {
                ball._PhysicsProcess(Frame);
            }

            Assert.Equal("Impact", ball.Emitted[0].Signal);
            Vector3 change = (Vector3)ball.Emitted[0].Arguments[2].Value - (Vector3)ball.Emitted[0].Arguments[1].Value;
            Assert.Equal(frozen ? 0 : -0.43f * change.Z, cone.LinearVelocity.Z * cone.Mass, 1e-3f);
            rebounds.Add(((Vector3)ball.Emitted[0].Arguments[2].Value).Z);
        }

        Assert.True(rebounds[0] < rebounds[1] - 5, $"{rebounds[0]}, {rebounds[1]} m/s");
    }

    /// <summary>What the ball has met before is frozen, or set free: it counts from then on.</summary>
    [Fact]
    public void A_body_that_is_frozen_after_it_was_met_gives_way_no_more()
    {
        FootballBall ball = NewBall();
        var cone = new RigidBody3D { Name = "cone", Mass = 0.5f, GlobalPosition = new Vector3(0, 0.5f, -6) };
        cone.Add(new SphereShape3D { Radius = 0.5f }, Transform3D.Identity);
        World3D.Only.DirectSpaceState.All.Add(cone);
        ball.HitMask = 1;
        var rebounds = new List<float>();
        foreach (bool frozen in (bool[])[false, true, false])
        {
            cone.Freeze = frozen;
            cone.LinearVelocity = Vector3.Zero;
            ball.Place(new Vector3(0, 0.11f, 0));
            ball.Emitted.Clear();
            ball.KickWith(new Vector3(0, 2, -20), Vector3.Zero);
            for (int i = 0; i < 40 && ball.Emitted.Count == 0; i++)
            {
                ball._PhysicsProcess(Frame);
            }

            rebounds.Add(((Vector3)ball.Emitted[0].Arguments[2].Value).Z);
        }

        Assert.True(rebounds[1] > rebounds[0] + 5 && rebounds[1] > rebounds[2] + 5, string.Join(", ", rebounds));
    }

    /// <summary>The surface of a bar that turns goes by ω × r where it is hit, and no faster.</summary>
    [Fact]
    public void A_bar_that_turns_hits_as_fast_as_its_surface_goes_there()
    {
        FootballBall ball = NewBall();
        var bar = new RigidBody3D { Name = "bar", Freeze = true, GlobalPosition = new Vector3(-1, 0.5f, -3), AngularVelocity = new Vector3(0, -4, 0) };
        bar.Add(new BoxShape3D { Size = new Vector3(4, 1, 0.2f) }, Transform3D.Identity);
        World3D.Only.DirectSpaceState.All.Add(bar);
        ball.HitMask = 1;
        ball.KickWith(new Vector3(0, 2, -10), Vector3.Zero);
        for (int i = 0; i < 40 && ball.Emitted.Count == 0; i++)
        {
            ball._PhysicsProcess(Frame);
        }

        // v' = u + e (u − v), with u = ω × r = 4 m/s towards the ball, a metre from the middle.
        var before = (Vector3)ball.Emitted[0].Arguments[1].Value;
        var after = (Vector3)ball.Emitted[0].Arguments[2].Value;
        double closing = 4 - before.Z;
        double e = SurfaceMaterial.GoalFrame.NormalRestitution;
        double v = SurfaceMaterial.GoalFrame.RestitutionSpeedScale;
        double restitution = e * Math.Sqrt(1 + (36 / (v * v))) / Math.Sqrt(1 + (closing * closing / (v * v)));
        Assert.Equal(4 + (restitution * closing), after.Z, 0.2);
    }

    /// <summary>A first scene that is refused is told once; the ball begins, where its node is, with the first one that is none.</summary>
    [Fact]
    public void A_ball_whose_first_scene_is_refused_begins_when_that_is_put_right()
    {
        var preset = new FootballPreset { Gravity = -3 };
        var ball = new FootballBall { Preset = preset, GlobalPosition = new Vector3(2, 0.11f, -4) };
        Assert.Throws<ArgumentOutOfRangeException>(ball._Ready);
        for (int i = 0; i < 5; i++)
        {
            ball._PhysicsProcess(Frame);
            ball._Process(Frame);
        }

        preset.Gravity = 9.81f;
        ball._PhysicsProcess(Frame);
        Assert.InRange(Vector3d.Distance(ball.Runner.State.Position, new Vector3d(2, 0.11, -4)), 0, 0.02);
        Assert.True(ball.Runner.Tick > 0);
    }

    [Fact]
    public void A_keeper_dives_and_is_seen_to_and_a_wall_stops_a_low_shot()
    {
        (FootballBall ball, FootballGoal goal) = BallAndGoal();
        var keeper = (FootballKeeper)GodotAsset.Load("addons/football_physics/scenes/keeper.tscn");
        var figure = (MeshInstance3D)keeper.GetChildren(true)[0];
        Shoot(ball, new Vector3d(1.6, 0.9, -20), 20);
        float furthest = 0;
        Play(100, () => furthest = MathF.Max(furthest, figure.GlobalPosition.X));
        Assert.Equal((0, 1), (goal.Count, keeper.Dives));
        Assert.True(furthest > 0.5f, $"{furthest} m");

        ((FootballWall)GodotAsset.Load("addons/football_physics/scenes/wall.tscn")).GlobalPosition = new Vector3(0, 0, -9.15f);
        ball.Place(new Vector3(0, 0.11f, 0));
        ball.Kick(25, new Vector3(0, 0.06f, -1));
        Play(100);
        Assert.True(ball.GlobalPosition.Z > -9);
    }

    [Fact]
    public void A_pitch_is_the_ground_and_its_boards_and_goals_stand_on_it()
    {
        var pitch = (FootballPitch)GodotAsset.Load("addons/football_physics/scenes/pitch.tscn");
        pitch.GlobalPosition = new Vector3(0, 2, 0);
        pitch.Surface = FootballPreset.GroundChoice.Indoor;
        FootballBall ball = NewBall(new Vector3(30, 2.4f, 0));
        Play(1);
        Scene scene = ball.Runner.Simulator.Scene;
        Assert.Equal(new Ground { Material = SurfaceMaterial.Indoor, Height = 2 }, scene.Ground);
        Assert.Equal(4, scene.Obstacles.Count);
        Assert.Equal([-52.5, 52.5], scene.Goals.Select(goal => goal.Center.Z).Order());
        Assert.All(scene.Goals, goal => Assert.True(goal.Facing.Z * goal.Center.Z < 0));
        ball.KickWith(new Vector3(20, 0, 0), Vector3.Zero);
        Play(150);
        Assert.True(ball.GlobalPosition.X < 38);
    }

    [Fact]
    public void A_ball_without_anything_to_be_seen_draws_itself_and_another_does_not()
    {
        FootballBall ball = NewBall();
        var skin = (MeshInstance3D)Assert.Single(ball.GetChildren(true));
        Assert.All(((ArrayMesh)skin.Mesh).Surfaces[0].Points, point => Assert.Equal(0.11f, point.Length(), 1e-5f));
        byte[] picture = ((ImageTexture)((StandardMaterial3D)skin.MaterialOverride!).AlbedoTexture!).Image.Data;
        Assert.InRange(picture.Count(bright => bright < 60) / (double)picture.Length, 0.1, 0.5);
        ball.Preset = new FootballPreset { Ball = FootballPreset.BallChoice.BeachBall };
        Play(1);
        Assert.Equal(0.2f, ((ArrayMesh)skin.Mesh).Surfaces[0].Points[0].Length(), 1e-5f);
        var own = new FootballBall();
        own.AddChild(new MeshInstance3D());
        Node.Root.AddChild(own);
        Assert.Single(own.GetChildren(true));
    }

    [Fact]
    public void In_the_demo_one_presses_shoots_and_scores()
    {
        Node demo = GodotAsset.Load("demo/Demo.tscn");
        FootballBall ball = demo.GetNode<FootballBall>("Football");
        Camera3D camera = demo.GetNode<Camera3D>("Camera");
        FootballShooter shooter = demo.GetNode<FootballShooter>("Shooting");
        FootballScore score = shooter.GetNode<FootballScore>("Score");
        Viewport.Only.Camera = camera;
        Vector3 towards = new Vector3(3.1f, 1.6f, -20) - camera.GlobalPosition;
        camera.Pointing = towards * (1 / towards.Length());
        Input.PressedButton = MouseButton.Left;
        Play(54);
        Assert.Equal(MotionState.Rest, ball.Motion);
        Vector3[][] lines = [.. shooter.Path!.Lines.Select(line => ((ArrayMesh)line.Mesh).Surfaces[0].Points)];
        Assert.Equal(1 + FootballPath.Sides, lines.Length);
        float[] ends = [.. lines.Select(line => line[36].X)];
        Assert.True(ends.Max() > ends[0] && ends.Min() < ends[0]);
        Input.PressedButton = MouseButton.None;
        Play(1);
        Play(20);
        Assert.InRange((lines[0][20] - GodotFrame.ToGodot(ball.Runner.State.Position)).Length(), 0, 1e-3f);
        Play(80);
        Assert.Equal(1, score.Goals);
        Assert.Equal("Goals 1   Shots 0", score.GetChildren(true).OfType<Label>().Single().Text);
        Play(150);
        Assert.Equal(0, ball.GlobalPosition.Z);
        Assert.Equal(1, score.Shots);
        Input.PressedKey = Key.R;
        ball.Kick(20, new Vector3(1, 0.2f, 0));
        Play(2);
        Assert.Equal(0, ball.GlobalPosition.X);
        Assert.Empty(GD.Pushed);
    }

    [Fact]
    public async Task The_library_is_warmed_up_beside_the_game()
    {
        NewBall();
        await FootballWarmUp.Done;
        Assert.True(FootballWarmUp.Done.IsCompletedSuccessfully);
    }

    [Fact]
    public void The_dock_plays_scrubs_and_validates_a_recording()
    {
        (FootballBall ball, _) = BallAndGoal();
        Play(1);
        Netcode.Recording segment = ball.Runner.Record();
        ball.KickAsPreviewed();
        Play(120);
        BallState end = ball.Runner.State;
        string file = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
        File.WriteAllBytes(file, segment.ToBytes());
        var plugin = new FootballPlugin();
        plugin._EnterTree();
        var holder = (EditorDock)Assert.Single(plugin.Docked);
        Assert.Equal(("Football Replay", EditorDock.DockSlot.RightUl), (holder.Title, holder.DefaultSlot));
        Node.Root.AddChild(holder);
        var dock = (FootballReplayDock)Assert.Single(holder.GetChildren());
        Button[] buttons = [.. dock.GetChildren().OfType<Button>()];
        HSlider slider = dock.GetChildren().OfType<HSlider>().Single();
        EditorFileDialog.Chosen = file;
        buttons[0].Click();
        EditorFileDialog.Chosen = "";
        File.Delete(file);
        Assert.Contains("2.00 s, 120 ticks", dock.Said, StringComparison.Ordinal);
        slider.Value = segment.EndTick;
        Assert.True(Netcode.Snapshot.Same(end, dock.Player!.State));
        buttons[1].Click();
        dock._Process(1.005);
        Assert.Equal((60, 60), (dock.Player.Tick - segment.StartTick, slider.Value - segment.StartTick));
        MeshInstance3D marker = ball.GetChildren(true).OfType<MeshInstance3D>().Last();
        Assert.Equal(GodotFrame.ToGodot(dock.Player.Pose.Position), marker.GlobalPosition);
        buttons[2].Click();
        Assert.Contains("matches the recording bit for bit", dock.Said, StringComparison.Ordinal);
        GodotAsset.Load("addons/football_physics/scenes/wall.tscn");
        dock.Load(segment.ToBytes(), ball);
        Assert.Contains("the same scene", dock.Said, StringComparison.Ordinal);
        dock.Load([1, 2, 3], ball);
        Assert.Null(dock.Player);
        plugin._ExitTree();
        Assert.Empty(plugin.Docked);
        Assert.Empty(plugin.Inspectors);
    }

    [Fact]
    public void The_inspector_of_a_preset_shows_its_drag_curve_and_where_its_numbers_come_from()
    {
        string root = Directory.CreateTempSubdirectory().FullName + "/";
        Directory.CreateDirectory(root + ".godot/mono/temp/bin/Debug");
        File.Copy(Path.ChangeExtension(typeof(Simulator).Assembly.Location, ".xml"), root + ".godot/mono/temp/bin/Debug/Football.Physics.xml");
        ProjectSettings.Root = root;
        var plugin = new FootballPlugin();
        plugin._EnterTree();
        EditorInspectorPlugin inspector = Assert.Single(plugin.Inspectors);
        var preset = new FootballPreset { Ball = FootballPreset.BallChoice.Jabulani };
        Assert.True(inspector._CanHandle(preset));
        Assert.False(inspector._CanHandle(new Node()));
        inspector._ParseBegin(preset);
        var curve = (FootballCurve)Assert.Single(inspector.Added);
        curve._Ready();
        curve._Process(0);
        Assert.Equal(2, curve.Drawn.Count);

        // Down the window is up in numbers: high at walking pace, low beyond the crisis at 18.7 m/s.
        Assert.True(curve.Drawn[1][10].Y < curve.Drawn[1][60].Y - 30);
        Assert.Contains("Jabulani (2010). Mass and radius: law. Drag: measured", curve.Notes, StringComparison.Ordinal);
        Assert.Contains("MatchTurf: ", curve.Notes, StringComparison.Ordinal);
        preset.Gravity = 2000;
        curve._Process(0);
        Assert.Contains("gravity", curve.Notes, StringComparison.Ordinal);
        Directory.Delete(root, true);
    }

    private static void Play(int frames, Action? after = null)
    {
        for (int i = 0; i < frames; i++)
        {
            Node.Play(1, Frame);
            after?.Invoke();
        }
    }

    private static FootballGoal Goal() => (FootballGoal)GodotAsset.Load("addons/football_physics/scenes/goal.tscn");

    private static (FootballBall Ball, FootballGoal Goal) BallAndGoal() => ((FootballBall)GodotAsset.Load("addons/football_physics/scenes/football.tscn"), Goal());

    private static FootballBall NewBall(Vector3 place = default)
    {
        var ball = new FootballBall { GlobalPosition = place };
        Node.Root.AddChild(ball);
        return ball;
    }

    private static void Shoot(FootballBall ball, Vector3d at, double speed)
    {
        Play(1);
        AimResult aim = new Aimer(new Simulator()).Find(new AimRequest { From = ball.Runner.State.Position, Target = at, Speed = speed });
        ball.Runner.QueueKick(aim.Velocity, aim.Spin);
    }
}
