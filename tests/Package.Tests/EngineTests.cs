using FsCheck;
using FsCheck.Fluent;
using GodotBall = FootballPhysics.GodotAddon.FootballBall;
using GodotEngine = Godot.Engine;
using GodotFrame = FootballPhysics.GodotAddon.GodotFrame;
using GodotPreset = FootballPhysics.GodotAddon.FootballPreset;
using GodotVector = Godot.Vector3;
using UnityBall = FootballPhysics.Unity.FootballBall;
using UnityEvent = FootballPhysics.Unity.FootballEvent;
using UnityFrame = FootballPhysics.Unity.UnityFrame;
using UnityPreset = FootballPhysics.Unity.FootballPreset;
using UnityTime = UnityEngine.Time;
using UnityVector = UnityEngine.Vector3;

namespace FootballPhysics.Package.Tests;

/// <summary>The engine samples, run against shims of the engines: the same kick is the same kick, whatever the engine's frame.</summary>
[Collection(Statics)]
public sealed class EngineTests
{
    /// <summary>Tests that set the engines' clocks or the console, which are static: one after the other.</summary>
    public const string Statics = "statics";

    private const int Ticks = 400;

    /// <summary>A kick in the library's frame, of single-precision numbers as engines have them.</summary>
    private static Gen<(System.Numerics.Vector3 Velocity, System.Numerics.Vector3 Spin)> Kicks =>
        from v in Vector(25)
        from w in Vector(70)
        select (v, w);

    [Fact]
    public void The_same_kick_through_every_adapter_is_the_same_kick_to_the_last_bit()
    {
        Prop.ForAll(Kicks.ToArbitrary(), kick =>
        {
            var direct = new FixedStepRunner(timeStep: UnityPreset.DefaultTimeStep);
            direct.QueueKick(kick.Velocity, kick.Spin);
            UnityBall unity = InUnity();
            unity.Kick(Mirrored(kick.Velocity), MirroredSpin(kick.Spin));
            GodotBall godot = InGodot(UnityTime.fixedDeltaTime);
            godot.Runner.Restore(0, direct.State);
            godot.KickWith(new GodotVector(kick.Velocity.X, kick.Velocity.Y, kick.Velocity.Z), new GodotVector(kick.Spin.X, kick.Spin.Y, kick.Spin.Z));
            double timeStep = godot.Runner.TimeStep;
            var same = new FixedStepRunner(timeStep: timeStep);
            same.QueueKick(kick.Velocity, kick.Spin);
            for (int tick = 0; tick < 150; tick++)
            {
                direct.Step();
                unity.gameObject.Send("FixedUpdate");
                Assert.True(Snapshot.Same(direct.State, unity.Runner.State), $"Unity, tick {tick}");
                same.Step();
                godot._PhysicsProcess(timeStep);
                Assert.True(Snapshot.Same(same.State, godot.Runner.State), $"Godot, tick {tick}");
            }

            // Mapped back from the engine's frame, what the engine shows is what the library has, rounded once.
            Assert.Equal(direct.State.Position.ToVector3(), Numerics(UnityFrame.FromUnity(UnityFrame.ToUnity(direct.State.Position))));
            Assert.Equal(direct.State.Velocity.ToVector3(), Numerics(UnityFrame.FromUnity(unity.Velocity)));
            Assert.Equal(direct.State.Spin.ToVector3(), Numerics(UnityFrame.SpinFromUnity(unity.Spin)));
            Assert.Equal(same.State.Velocity.ToVector3(), Numerics(GodotFrame.FromGodot(godot.Velocity)));
            Assert.Equal(same.State.Spin.ToVector3(), Numerics(GodotFrame.SpinFromGodot(godot.Spin)));
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void A_kick_in_numbers_is_the_same_in_every_engine()
    {
        float timeStep = UnityTime.fixedDeltaTime;
        var direct = new FixedStepRunner(timeStep: UnityPreset.DefaultTimeStep);
        direct.QueueKick(25f, new System.Numerics.Vector3(-0.2f, 0.3f, -1f), -10f, 40f);
        UnityBall unity = InUnity();
        unity.Kick(25f, new UnityVector(-0.2f, 0.3f, 1f), -10f, 40f);
        GodotBall godot = InGodot(timeStep);
        godot.Kick(25f, new GodotVector(-0.2f, 0.3f, -1f), -10f, 40f);
        var same = new FixedStepRunner(timeStep: godot.Runner.TimeStep);
        same.QueueKick(25f, new System.Numerics.Vector3(-0.2f, 0.3f, -1f), -10f, 40f);
        for (int tick = 0; tick < Ticks; tick++)
        {
            direct.Step();
            unity.gameObject.Send("FixedUpdate");
            same.Step();
            godot._PhysicsProcess(godot.Runner.TimeStep);
        }

        Assert.Equal(Snapshot.Hash(direct.State), Snapshot.Hash(unity.Runner.State));
        Assert.Equal(Snapshot.Hash(same.State), Snapshot.Hash(godot.Runner.State));
    }

    [Fact]
    public void An_inswinger_swings_in()
    {
        // A right-footed corner from the left, seen from the attack: the goal is on the taker's left, and the ball must bend to it.
        UnityBall unity = InUnity();
        unity.Kick(22f, new UnityVector(0f, 0.5f, 1f), 0f, 50f);
        UnityBall unityVector = InUnity();
        unityVector.Kick(new UnityVector(0f, 8f, 20f), new UnityVector(0f, -50f, 0f)); // left-handed: negative about y is counter-clockwise from above
        GodotBall godot = InGodot(0.02f);
        godot.Kick(22f, new GodotVector(0f, 0.5f, -1f), 0f, 50f);
        GodotBall godotVector = InGodot(0.02f);
        godotVector.KickWith(new GodotVector(0f, 8f, -20f), new GodotVector(0f, 50f, 0f));
        for (int tick = 0; tick < 60; tick++)
        {
            unity.gameObject.Send("FixedUpdate");
            unityVector.gameObject.Send("FixedUpdate");
            godot._PhysicsProcess(0.02);
            godotVector._PhysicsProcess(0.02);
        }

        unity.gameObject.Send("Update");
        unityVector.gameObject.Send("Update");
        GodotEngine.InterpolationFraction = 1;
        godot._Process(0);
        godotVector._Process(0);
        Assert.InRange(unity.transform.position.x, -5f, -1f);
        Assert.InRange(unity.transform.position.z, 15f, 25f);
        Assert.InRange(unityVector.transform.position.x, -5f, -1f);
        Assert.InRange(godot.GlobalPosition.X, -5f, -1f);
        Assert.InRange(godot.GlobalPosition.Z, -25f, -15f);
        Assert.InRange(godotVector.GlobalPosition.X, -5f, -1f);
    }

    [Fact]
    public void The_ball_is_seen_to_turn_the_same_way()
    {
        // A point on the ball's front, carried by the engine's own rotation: under topspin it goes down, in either engine.
        UnityBall unity = InUnity();
        unity.Kick(20f, new UnityVector(0f, 0.5f, 1f), 10f, 0f);
        GodotBall godot = InGodot(0.02f);
        godot.Kick(20f, new GodotVector(0f, 0.5f, -1f), 10f, 0f);
        unity.gameObject.Send("FixedUpdate");
        godot._PhysicsProcess(0.02);
        UnityTime.timeAsDouble = UnityTime.fixedTimeAsDouble + UnityTime.fixedDeltaTime;
        unity.gameObject.Send("Update");
        UnityTime.timeAsDouble = UnityTime.fixedTimeAsDouble;
        GodotEngine.InterpolationFraction = 1;
        godot._Process(0);
        UnityEngine.Quaternion u = unity.transform.rotation;
        Assert.InRange(new Quaterniond(u.x, u.y, u.z, u.w).Rotate(new Vector3d(0, 0, 1)).Y, -0.3, -0.1);
        Assert.InRange((godot.GlobalTransform.Basis * GodotVector.Forward).Y, -0.3f, -0.1f);
    }

    [Fact]
    public void Events_reach_the_game_in_the_engine_s_frame_and_in_order()
    {
        UnityBall unity = InUnity();
        var heard = new List<UnityEvent>();
        unity.Impact += (_, happened) => heard.Add(happened);
        unity.Slide += (_, happened) => heard.Add(happened);
        unity.Roll += (_, happened) => heard.Add(happened);
        unity.Rest += (_, happened) => heard.Add(happened);
        unity.Kick(12f, new UnityVector(0.3f, 0.5f, 1f), -10f, 20f);
        GodotBall godot = InGodot(0.02f);
        godot.Kick(12f, new GodotVector(0.3f, 0.5f, -1f), -10f, 20f);
        for (int tick = 0; tick < 3000; tick++)
        {
            unity.gameObject.Send("FixedUpdate");
            godot._PhysicsProcess(0.02);
        }

        Assert.Equal(MotionState.Rest, unity.Motion);
        Assert.Equal(MotionState.Rest, godot.Motion);
        Assert.Equal(BallEventKind.Impact, heard[0].Kind);
        Assert.Equal(BallEventKind.Rest, heard[^1].Kind);
        Assert.Contains(heard, happened => happened.Kind == BallEventKind.Roll);
        Assert.All(heard, happened => Assert.True(happened.Position.z > 0));
        Assert.Equal(heard.Select(happened => happened.Kind.ToString()), godot.Emitted.Select(emitted => emitted.Signal));
        var landing = (GodotVector)godot.Emitted[0].Arguments[0].Value;
        Assert.Equal(heard[0].Position.x, landing.X, 1e-4f);
        Assert.Equal(heard[0].Position.z, -landing.Z, 1e-4f);
    }

    [Fact]
    public void Presets_build_the_scene_they_say()
    {
        foreach (UnityPreset.BallChoice ball in Enum.GetValues<UnityPreset.BallChoice>())
        {
            var preset = new UnityPreset { ball = ball, ground = UnityPreset.GroundChoice.LongGrass, wind = new UnityVector(1, 0, 2), groundHeight = 3 };
            var resource = new GodotPreset
            {
                Ball = Enum.Parse<GodotPreset.BallChoice>(ball.ToString()),
                Surface = GodotPreset.GroundChoice.LongGrass,
                Wind = new GodotVector(1, 0, -2),
                GroundHeight = 3,
            };
            Assert.Equal(resource.Compile().Scene, preset.Compile().Scene);
            Assert.Equal(3 + preset.Compile().Scene.Ball.Radius, preset.Compile().ContactHeight);
        }

        Assert.Equal(Enum.GetNames<UnityPreset.AirChoice>(), Enum.GetNames<GodotPreset.AirChoice>());
        Assert.Equal(Enum.GetNames<UnityPreset.GroundChoice>(), Enum.GetNames<GodotPreset.GroundChoice>());
    }

    [Fact]
    public void The_gizmo_shows_the_path_that_the_ball_takes()
    {
        UnityBall unity = InUnity();
        unity.Kick(20f, new UnityVector(0f, 0.5f, 1f), 0f, 30f);
        unity.gameObject.Send("FixedUpdate");
        UnityEngine.Gizmos.Lines.Clear();
        unity.gameObject.Send("OnDrawGizmosSelected");
        var lines = UnityEngine.Gizmos.Lines.ToList();
        Assert.Equal(150, lines.Count);
        foreach ((UnityVector _, UnityVector to) in lines)
        {
            unity.gameObject.Send("FixedUpdate");
            Assert.Equal(to, UnityFrame.ToUnity(unity.Runner.State.Position));
        }

        GodotBall godot = InGodot(0.02f);
        godot.Kick(3f, new GodotVector(0f, 0f, -1f));
        godot._PhysicsProcess(0.02);
        var points = new GodotVector[5000];
        int count = godot.PredictPath(points);
        Assert.InRange(count, 50, 4999);
        Assert.True(points[count - 1].Z < points[0].Z);
    }

    [Fact]
    public void The_engines_draw_the_forces_of_the_next_step()
    {
        UnityBall unity = InUnity();
        unity.gameObject.Send("OnDrawGizmos");
        unity.Kick(20f, new UnityVector(0f, 0.5f, 1f), 0f, 60f);
        unity.gameObject.Send("FixedUpdate");
        UnityEngine.Gizmos.Lines.Clear();
        unity.gameObject.Send("OnDrawGizmos");
        BallForces forces = unity.Runner.Simulator.ForcesAt(unity.Runner.State, unity.Runner.TimeStep)!;
        UnityVector ball = UnityFrame.ToUnity(unity.Runner.State.Position);
        Assert.Equal(
            new[] { forces.Weight + forces.Buoyancy, forces.Drag, forces.Magnus }.Select(force => (ball, ball + (0.2f * UnityFrame.ToUnity(force)))),
            UnityEngine.Gizmos.Lines);

        GodotBall godot = InGodot(0.02f);
        godot.Kick(20f, new GodotVector(0f, 0.5f, -1f), 0f, 60f);
        godot._PhysicsProcess(0.02);
        var shown = new GodotAddon.FootballForces { Ball = godot };
        shown._Ready();
        shown._Process(0.02);
        Assert.Equal(GodotAddon.FootballForces.Kinds, shown.Lines.Length);
        Assert.StartsWith(FormattableString.Invariant($"{godot.Runner.Velocity.Length:F1} m/s, 60 rad/s, Re "), shown.Numbers, StringComparison.Ordinal);
        Assert.Contains("Airborne", shown.Numbers, StringComparison.Ordinal);
    }

    private static UnityBall InUnity() => new UnityEngine.GameObject().AddComponent<UnityBall>();

    private static GodotBall InGodot(float timeStep)
    {
        GodotEngine.PhysicsTicksPerSecond = (int)Math.Round(1 / timeStep);
        var ball = new GodotBall();
        ball._Ready();
        return ball;
    }

    private static UnityVector Mirrored(System.Numerics.Vector3 v) => new(v.X, v.Y, -v.Z);

    private static UnityVector MirroredSpin(System.Numerics.Vector3 w) => new(-w.X, -w.Y, w.Z);

    private static System.Numerics.Vector3 Numerics(Vector3d v) => v.ToVector3();

    private static Gen<System.Numerics.Vector3> Vector(float size) =>
        from x in Gen.Choose(-1000, 1000)
        from y in Gen.Choose(-1000, 1000)
        from z in Gen.Choose(-1000, 1000)
        select new System.Numerics.Vector3(x * size / 1000f, y * size / 1000f, z * size / 1000f);
}
