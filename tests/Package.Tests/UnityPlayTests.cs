using FootballPhysics.Unity;
using UnityEngine;
using Vector3 = UnityEngine.Vector3;

namespace FootballPhysics.Package.Tests;

/// <summary>Unity's prefabs and components, played against the shims: a goal that is dragged in scores, a post stops the ball, and whatever is set counts.</summary>
[Collection(EngineTests.Statics)]
public sealed class UnityPlayTests : IDisposable
{
    public UnityPlayTests() => Dispose();

    public static TheoryData<string> Files => [.. UnityAsset.Files];

    public void Dispose()
    {
        GameObject.DestroyAll();
        UnityEngine.Physics.All.Clear();
        Debug.Warned.Clear();
        Camera.main = null;
        Input.Held = -1;
        Time.timeAsDouble = Time.fixedTimeAsDouble = 0;
    }

    [Theory]
    [MemberData(nameof(Files))]
    public void Every_script_field_and_reference_of_its_files_is_there(string file)
    {
        if (file.EndsWith(".asset", StringComparison.Ordinal))
        {
            Assert.NotNull(((FootballPreset)UnityAsset.LoadAsset(file)).Compile());
        }
        else
        {
            Assert.NotEmpty(UnityAsset.Load(file));
            Assert.DoesNotContain(Debug.Warned, said => !said.Contains("has no goal to guard", StringComparison.Ordinal));
        }
    }

    [Fact]
    public void A_goal_that_is_dragged_in_scores()
    {
        FootballBall ball = UnityAsset.Load("Prefabs/Football.prefab")["Football"].GetComponent<FootballBall>();
        FootballGoal goal = UnityAsset.Load("Prefabs/Goal.prefab")["Goal"].GetComponent<FootballGoal>();
        var told = new List<string>();
        ball.Goal += (_, happened) => told.Add("ball " + happened.Surface);
        ball.Net += (_, happened) => told.Add("ball " + happened.Surface);
        goal.Scored += (who, happened) => told.Add("goal " + (happened.Goal == who));
        goal.NetMet += (_, _) => told.Add("net");
        int raised = 0;
        ball.Events.goal.AddListener(_ => raised++);
        Mesh back = NetOf("back net");
        Vector3[] flat = back.vertices;
        ball.KickAsPreviewed();
        float deepest = 0;
        Play(180, () => deepest = Math.Max(deepest, back.vertices.Zip(flat, (a, b) => (a - b).magnitude).Max()));
        Assert.Equal(1, goal.Goals);
        Assert.Equal(1, raised);
        Assert.Equal(["ball goal", "goal True", "ball back net", "net"], told.Take(4));
        Assert.InRange(deepest, 0.05f, 2f);
        Assert.InRange(ball.transform.position.z, 20f, 22.2f);
        Assert.Empty(Debug.Warned);
    }

    [Theory]
    [InlineData(3.72f, 1.2f, "left post")] // Left is that of who stands in the goal and looks at the pitch.
    [InlineData(-3.72f, 1.2f, "right post")]
    [InlineData(0f, 2.5f, "crossbar")]
    public void A_post_stops_the_ball(float x, float y, string part)
    {
        (FootballBall ball, FootballGoal goal) = BallAndGoal();
        var hits = new List<FootballEvent>();
        goal.FrameHit += (_, happened) => hits.Add(happened);
        Shoot(ball, new Vector3d(x, y, -20), 25);
        Play(100);
        Assert.NotEmpty(hits);

        Assert.Equal(part, hits[0].Surface);
        Assert.True(hits[0].Velocity.z < hits[0].VelocityBefore.z - 5f);
        Assert.True(hits[0].ApproachSpeed > 5f);
    }

    [Fact]
    public void A_fresh_preset_is_no_preset_to_the_last_bit_among_goals_too()
    {
        BallAndGoal();
        UnityAsset.Load("Prefabs/Wall.prefab");
        FootballBall bare = NewBall();
        FootballBall preset = NewBall();
        preset.Preset = new FootballPreset();
        bare.Kick(24f, new Vector3(0.12f, 0.2f, 1f), -20f, 30f);
        preset.Kick(24f, new Vector3(0.12f, 0.2f, 1f), -20f, 30f);
        Play(400, () => Assert.True(Netcode.Snapshot.Same(bare.Runner.State, preset.Runner.State)));
        Assert.Equal(400, preset.Runner.Tick);
    }

    [Fact]
    public void What_is_set_after_creation_counts_from_the_next_step_on()
    {
        // A preset that is given, then changed.
        FootballBall ball = NewBall();
        ball.Preset = new FootballPreset { ground = FootballPreset.GroundChoice.LongGrass };
        Play(1);
        Assert.Equal(Ground.Of(SurfaceMaterial.LongGrass), ball.Runner.Simulator.Scene.Ground);
        ball.Preset.gravity = 1.62f;
        Play(1);
        Assert.Equal(1.62, ball.Runner.Simulator.Scene.Gravity);

        // Its time step, with a kick that waits: the ball goes on where it is.
        ball.Kick(20f, new Vector3(0f, 0.3f, 1f));
        ball.Preset.timeStep = 0.01;
        Play(5);
        Assert.Equal(0.01, ball.Runner.TimeStep);
        Assert.Equal(10, ball.Runner.Tick);
        Assert.True(ball.Velocity.z > 10f);
        Vector3 before = ball.transform.position;

        // Colliders.
        var wall = new GameObject("mesh");
        UnityEngine.Physics.All.Add(wall.Attach<SphereCollider>());
        ((SphereCollider)UnityEngine.Physics.All[0]).radius = 2f;
        wall.transform.position = before + new Vector3(0f, 0f, 6f);
        var hit = new List<string?>();
        ball.Impact += (_, happened) => hit.Add(happened.Collider == null ? null : happened.Surface);
        ball.Hits = 1;
        Play(30);
        Assert.Contains("mesh", hit);

        // A goal that comes, moves and goes.
        FootballGoal goal = UnityAsset.Load("Prefabs/Goal.prefab")["Goal"].GetComponent<FootballGoal>();
        Play(1);
        Assert.Equal(-20, Assert.Single(ball.Runner.Simulator.Scene.Goals).Center.Z);
        goal.transform.position = new Vector3(0f, 0f, 33f);
        goal.Width = 5f;
        Play(1);
        Assert.Equal((-33, 5), (ball.Runner.Simulator.Scene.Goals[0].Center.Z, ball.Runner.Simulator.Scene.Goals[0].Width));
        goal.enabled = false;
        Play(1);
        Assert.Empty(ball.Runner.Simulator.Scene.Goals);

        // What is out of range is said once, and the ball goes on.
        ball.Preset.customRadius = 99f;
        ball.Preset.ball = FootballPreset.BallChoice.Custom;
        long tick = ball.Runner.Tick;
        Play(3);
        Assert.Equal(tick + 6, ball.Runner.Tick);
        Assert.Contains("ball.radius", Assert.Single(Debug.Warned), StringComparison.Ordinal);
    }

    [Fact]
    public void Every_number_of_a_preset_changes_what_a_ball_sees_of_it()
    {
        foreach (System.Reflection.FieldInfo field in typeof(FootballPreset).GetFields(System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.Public))
        {
            FootballBall ball = NewBall();
            ball.Preset = new FootballPreset();
            ball.Apply();
            Simulator before = ball.Runner.Simulator;
            Play(1);
            Assert.Same(before, ball.Runner.Simulator);
            object? value = field.GetValue(ball.Preset);
            field.SetValue(ball.Preset, value switch
            {
                float number => number + 0.25f,
                double => 0.005,
                Vector3 => new Vector3(1f, 0f, 0f),
                _ => Enum.ToObject(field.FieldType, field.FieldType == typeof(Integrator) ? 1 : 3 % Enum.GetValues(field.FieldType).Length),
            });
            Play(1);
            Assert.True(!ReferenceEquals(before, ball.Runner.Simulator), field.Name);
            GameObject.DestroyAll();
        }
    }

    [Fact]
    public void Who_moves_the_transform_in_play_is_told_once_what_to_call()
    {
        FootballBall ball = NewBall();
        ball.name = "Ball 3";
        Play(2);
        Assert.Empty(Debug.Warned);
        ball.transform.position = new Vector3(3f, 1f, 0f);
        Play(2);
        ball.transform.position = new Vector3(4f, 1f, 0f);
        Play(2);
        Assert.Contains("\"Ball 3\"", Assert.Single(Debug.Warned), StringComparison.Ordinal);
        Assert.Contains("Place(position)", Debug.Warned[0], StringComparison.Ordinal);
        Assert.Equal(0f, ball.transform.position.x);
        ball.Place(new Vector3(3f, 1f, 0f));
        Play(1);
        Assert.Equal(3f, ball.transform.position.x);
    }

    [Fact]
    public void The_preview_follows_the_preset_goals_and_colliders()
    {
        FootballBall ball = new GameObject().Attach<FootballBall>();
        ball.transform.position = new Vector3(0f, 0.11f, 0f);
        ball.Preset = new FootballPreset();
        ball.PreviewedKick.elevation = 12f;
        var path = new Vector3[150];
        int Preview() => ball.PreviewPath(path);
        Assert.Equal(150, Preview());
        Vector3 still = path[149];
        ball.Preset.wind = new Vector3(8f, 0f, 0f);
        Preview();
        Assert.True(path[149].x > still.x + 1f);
        ball.Preset.wind = default;
        GameObject goal = UnityAsset.Load("Prefabs/Goal.prefab")["Goal"];
        Assert.InRange(path[Preview() - 1].z, 20f, 22.2f);
        UnityEngine.Object.DestroyImmediate(goal);
        Preview();
        Assert.Equal(still, path[149]);
        var holder = new GameObject("block");
        UnityEngine.Physics.All.Add(holder.Attach<BoxCollider>());
        ((BoxCollider)UnityEngine.Physics.All[0]).size = new Vector3(8f, 8f, 1f);
        holder.transform.position = new Vector3(0f, 0f, 10f);
        ball.Hits = 1;
        Assert.True(path[Preview() - 1].z < 10f);

        // It is the way that the kick then takes.
        ball.gameObject.WakeUp();
        ball.KickAsPreviewed();
        for (int i = 1; i < 100; i++)
        {
            Play(1);
            Assert.InRange((path[i] - UnityFrame.ToUnity(ball.Runner.State.Position)).magnitude, 0f, 1e-4f);
        }
    }

    [Fact]
    public void A_step_among_goal_wall_and_keeper_allocates_nothing()
    {
        (FootballBall ball, _) = BallAndGoal();
        UnityAsset.Load("Prefabs/Wall.prefab");
        UnityAsset.Load("Prefabs/Keeper.prefab");
        Action step = Message(ball, "FixedUpdate");
        Action draw = Message(ball, "Update");
        long least = long.MaxValue;
        for (int shot = 0; shot < 5; shot++)
        {
            ball.Place(new Vector3(0f, 0.11f, 0f));
            step();
            long before = GC.GetAllocatedBytesForCurrentThread();
            ball.Kick(19f, new Vector3(0.1f, 0.2f, 1f));
            for (int i = 0; i < 100; i++)
            {
                step();
            }

            least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
            draw();
        }

        Assert.Equal(0, least);
    }

    /// <summary>The keeper of the scene saves the same late kick as one in time, and a place in between is an input of its tick.</summary>
    [Fact]
    public void A_keeper_and_a_place_under_rollback_end_in_the_same_bits_however_late_the_kick_is()
    {
        var ends = new List<(ulong Hash, int Dives)>();
        foreach (int late in (int[])[0, 4, 20])
        {
            Dispose();
            GameObject.DestroyAll();
            (FootballBall ball, _) = BallAndGoal();
            FootballKeeper keeper = UnityAsset.Load("Prefabs/Keeper.prefab")["Keeper"].GetComponent<FootballKeeper>();
            Action step = Message(ball, "FixedUpdate");
            ball.Place(new Vector3(0f, 0.11f, 0f));
            step();
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
                    ball.Place(new Vector3(0f, 0.11f, 2f));
                    Assert.Equal((1, first), (ball.Runner.Kicks.PlaceCount, rollback.OldestTick > first ? first : rollback.OldestTick));
                }

                step();
            }

            Message(ball, "Update")();
            Assert.Null(rollback.SyncTest(64));
            ends.Add((rollback.HashAt(first + 100), keeper.Dives));
        }

        Assert.Equal((ends[0], ends[0]), (ends[1], ends[2]));
        Assert.Equal(1, ends[0].Dives);
    }

    /// <summary>Unity's colliders cannot go back in time by themselves: a rollback throws, until the game moves them, and the keepers, in its own callback.</summary>
    [Fact]
    public void Among_colliders_a_rollback_needs_the_callback_of_the_game()
    {
        (FootballBall ball, _) = BallAndGoal();
        UnityAsset.Load("Prefabs/Keeper.prefab");
        UnityEngine.Physics.All.Add(new GameObject("cone").Attach<SphereCollider>());
        ball.Hits = 1;
        Action step = Message(ball, "FixedUpdate");
        step();
        var rollback = new FootballPhysics.Netcode.Rollback(ball.Runner);
        step();
        Assert.Null(ball.Runner.MoveBodies);
        var late = new FootballPhysics.Netcode.KickInput(ball.Runner.Tick - 1, new Vector3d(0, 3, -9), default);
        Assert.Contains("MoveBodies", Assert.Throws<InvalidOperationException>(() => rollback.ApplyKick(in late)).Message, StringComparison.Ordinal);
        int calls = 0;
        ball.Runner.MoveBodies = _ =>
        {
            calls++;
            ball.MoveKeepers();
        };
        step();
        Assert.Equal(1, calls);
        Assert.NotNull(rollback.ApplyKick(in late));
        Assert.Equal(3, calls);
        ball.Hits = 0;
        step();
        Assert.Equal(4, calls);
    }

    [Fact]
    public void A_body_that_moves_freely_gets_the_impulse_and_a_kinematic_one_does_not()
    {
        var rebounds = new List<float>();
        foreach (bool kinematic in (bool[])[false, true])
        {
            UnityEngine.Physics.All.Clear();
            FootballBall ball = NewBall(new Vector3(0f, 0.11f, 0f));
            var holder = new GameObject("cone");
            SphereCollider cone = holder.Attach<SphereCollider>();
            Rigidbody body = holder.Attach<Rigidbody>();
            body.mass = 0.5f;
            body.isKinematic = kinematic;
            holder.transform.position = new Vector3(0f, 0.5f, 6f);
            UnityEngine.Physics.All.Add(cone);
            ball.Hits = 1;
            FootballEvent hit = default;
            ball.Impact += (_, happened) => hit = happened.Collider != null && hit.Collider == null ? happened : hit;
            ball.Kick(new Vector3(0f, 1f, 20f), Vector3.zero);
            for (int i = 0; i < 30 && hit.Collider == null; i++)
            {
                ball.gameObject.Send("FixedUpdate");
            }

            Assert.Equal(holder, hit.Collider!.gameObject);
            Vector3 momentum = body.velocity * body.mass;
            Assert.Equal(kinematic ? 0 : -hit.Impulse.z, momentum.z, 1e-4f);
            Assert.True(hit.Impulse.z < -1f);
            rebounds.Add(hit.Velocity.z);
        }

        // Half a kilogram that gives way sends the ball back more slowly than what does not.
        Assert.True(rebounds[0] > rebounds[1] + 5f, $"{rebounds[0]}, {rebounds[1]} m/s");
    }

    [Fact]
    public void A_keeper_dives_and_is_seen_to()
    {
        (FootballBall ball, FootballGoal goal) = BallAndGoal();
        FootballKeeper keeper = UnityAsset.Load("Prefabs/Keeper.prefab")["Keeper"].GetComponent<FootballKeeper>();
        Transform figure = GameObject.All.Single(item => item.name == "keeper").transform;
        Assert.Equal(19.4f, figure.position.z, 1e-4f);
        var met = new List<string>();
        ball.Impact += (_, happened) => met.Add(happened.Surface);
        Shoot(ball, new Vector3d(1.6, 0.9, -20), 20);
        float furthest = 0;
        Play(80, () => furthest = Math.Max(furthest, figure.position.x));
        Assert.Contains("keeper", met);
        Assert.Equal(0, goal.Goals);
        Assert.Equal(1, keeper.Dives);
        Assert.True(furthest > 0.5f, $"{furthest} m");
    }

    [Fact]
    public void A_wall_stops_a_low_shot()
    {
        (FootballBall ball, FootballGoal goal) = BallAndGoal();
        UnityAsset.Load("Prefabs/Wall.prefab")["Wall"].transform.position = new Vector3(0f, 0f, 9.15f);
        var met = new List<string>();
        ball.Impact += (_, happened) => met.Add(happened.Surface);
        ball.Kick(25f, new Vector3(0f, 0.06f, 1f));
        Play(100);
        Assert.Contains("Wall 3", met);
        Assert.Equal(0, goal.Goals);
    }

    [Fact]
    public void A_pitch_is_the_ground_and_its_boards_and_goals_stand_on_it()
    {
        Dictionary<string, GameObject> pitch = UnityAsset.Load("Prefabs/Pitch.prefab");
        pitch["Pitch"].transform.position = new Vector3(0f, 2f, 0f);
        pitch["Pitch"].GetComponent<FootballPitch>().Surface = FootballPreset.GroundChoice.Indoor;
        FootballBall ball = NewBall(new Vector3(30f, 2.4f, 0f));
        Play(1);
        Scene scene = ball.Runner.Simulator.Scene;
        Assert.Equal(new Ground { Material = SurfaceMaterial.Indoor, Height = 2 }, scene.Ground);
        Assert.Equal(4, scene.Obstacles.Count);
        Assert.Equal([52.5, -52.5], scene.Goals.Select(goal => goal.Center.Z).Order().Reverse());
        Assert.All(scene.Goals, goal => Assert.True(goal.Facing.Z * goal.Center.Z < 0)); // Both open towards the middle.
        var met = new List<string>();
        ball.Impact += (_, happened) => met.Add(happened.Surface);
        ball.Kick(new Vector3(20f, 0f, 0f), Vector3.zero);
        Play(150);
        Assert.Contains("right board", met);
        Assert.Contains("lines", GameObject.All.Select(item => item.name));
    }

    [Fact]
    public void A_ball_without_a_renderer_is_seen_and_seen_to_spin()
    {
        FootballBall ball = NewBall();
        Mesh mesh = ball.GetComponent<MeshFilter>().sharedMesh!;
        Assert.All(mesh.vertices, point => Assert.Equal(0.11f, point.magnitude, 1e-5f));
        Assert.Equal(mesh.vertices.Length, mesh.uv.Length);
        var texture = (Texture2D)ball.GetComponent<MeshRenderer>().sharedMaterial!.mainTexture!;
        Assert.InRange(texture.Pixels.Count(pixel => pixel.r < 60) / (double)texture.Pixels.Length, 0.1, 0.5);
        ball.Kick(20f, new Vector3(0f, 0.3f, 1f), 0f, 60f);
        Play(10);
        UnityEngine.Quaternion turned = ball.transform.rotation;
        Assert.True(Math.Abs(turned.w) < 0.99f);

        // Another ball, another size; and who brings a renderer keeps it.
        ball.Preset = new FootballPreset { ball = FootballPreset.BallChoice.BeachBall };
        Play(1);
        Assert.Equal(0.2f, ball.GetComponent<MeshFilter>().sharedMesh!.vertices[0].magnitude, 1e-5f);
        var own = new GameObject();
        own.Attach<MeshRenderer>();
        own.AddComponent<FootballBall>();
        Assert.False(own.TryGetComponent(out FootballSkin? _));
    }

    [Fact]
    public void In_the_demo_one_presses_shoots_and_scores()
    {
        Dictionary<string, GameObject> demo = UnityAsset.Load("Samples~/Demo/Demo.unity");
        FootballBall ball = demo["Football"].GetComponent<FootballBall>();
        Camera eyeCamera = demo["Main Camera"].GetComponent<Camera>();
        Camera.main = eyeCamera;
        FootballScore score = demo["Shooting"].GetComponent<FootballScore>();
        FootballPath path = demo["Shooting"].GetComponent<FootballPath>();

        // At the free corner, from where the camera is.
        Vector3 eye = demo["Main Camera"].transform.position;
        Vector3 towards = new Vector3(3.1f, 1.6f, 20f) - eye;
        eyeCamera.Pointing = new Ray(eye, towards * (1f / towards.magnitude));
        Input.Held = 0;
        Play(45);
        Assert.Equal(MotionState.Rest, ball.Motion);
        Assert.All(path.Lines, line => Assert.True(line.positionCount > 50));
        float[] ends = [.. path.Lines.Select(line => line.GetPosition(30).x)];
        Assert.True(ends.Max() > ends[0] && ends.Min() < ends[0]); // The cone is around the line.
        Vector3[] aimed = [.. Enumerable.Range(0, 40).Select(path.Lines[0].GetPosition)];
        Input.Held = -1;
        Play(1);
        Play(20);
        Assert.InRange((UnityFrame.ToUnity(ball.Runner.State.Position) - aimed[20]).magnitude, 0f, 1e-3f);
        Assert.Equal(0, path.Lines[1].positionCount);
        Play(60);
        Assert.Equal(1, score.Goals);
        demo["Shooting"].Send("OnGUI");
        Assert.StartsWith("Goals 1", GUI.Written[^1], StringComparison.Ordinal);

        // And again by itself.
        Play(150);
        Assert.Equal(0f, ball.transform.position.z);
        Assert.Equal(1, score.Shots);
        Assert.Empty(Debug.Warned);
    }

    [Fact]
    public async Task The_library_is_warmed_up_beside_the_game()
    {
        FootballWarmUp.Begin();
        await FootballWarmUp.Done;
        Assert.True(FootballWarmUp.Done.IsCompletedSuccessfully);
        Assert.Equal(RuntimeInitializeLoadType.BeforeSceneLoad, ((RuntimeInitializeOnLoadMethodAttribute)Attribute.GetCustomAttribute(
            typeof(FootballWarmUp).GetMethod(nameof(FootballWarmUp.Begin))!, typeof(RuntimeInitializeOnLoadMethodAttribute))!).loadType);
    }

    [Fact]
    public void What_is_drawn_is_gone_when_its_component_is()
    {
        int before = GameObject.All.Count;
        GameObject goal = UnityAsset.Load("Prefabs/Goal.prefab")["Goal"];
        Assert.Equal(before + 1 + 7, GameObject.All.Count); // The goal; two posts, a bar, four nets.
        goal.GetComponent<FootballGoal>().enabled = false;
        Assert.Equal(before + 1, GameObject.All.Count);
        goal.GetComponent<FootballGoal>().enabled = true;
        UnityEngine.Object.DestroyImmediate(goal);
        Assert.Equal(before, GameObject.All.Count);
    }

    /// <summary>Fixed updates, and a frame after each, with the clock of the engine.</summary>
    private static void Play(int updates, Action? after = null)
    {
        for (int i = 0; i < updates; i++)
        {
            Time.deltaTime = Time.fixedDeltaTime;
            GameObject.SendAll("FixedUpdate");
            GameObject.SendAll("Update");
            GameObject.SendAll("LateUpdate");
            after?.Invoke();
        }
    }

    private static (FootballBall Ball, FootballGoal Goal) BallAndGoal() =>
        (UnityAsset.Load("Prefabs/Football.prefab")["Football"].GetComponent<FootballBall>(), UnityAsset.Load("Prefabs/Goal.prefab")["Goal"].GetComponent<FootballGoal>());

    private static FootballBall NewBall(Vector3 place = default)
    {
        var holder = new GameObject("ball");
        holder.transform.position = place;
        return holder.AddComponent<FootballBall>();
    }

    /// <summary>A kick that hits a point, in the library's frame.</summary>
    private static void Shoot(FootballBall ball, Vector3d at, double speed)
    {
        Play(1);
        AimResult aim = new Aimer(new Simulator()).Find(new AimRequest { From = ball.Runner.State.Position, Target = at, Speed = speed });
        ball.Runner.QueueKick(aim.Velocity, aim.Spin);
    }

    private static Mesh NetOf(string name) => GameObject.All.Single(item => item.name == name).GetComponent<MeshFilter>().sharedMesh!;

    private static Action Message(Component component, string message) =>
        component.GetType().GetMethod(message, System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic)!.CreateDelegate<Action>(component);
}
