using System.Text.Json;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Gallery;

namespace FootballPhysics.Tool.Tests;

/// <summary>A scene that a game writes as JSON is the same scene for the tool, and plays the same kick.</summary>
public sealed class SceneJsonTests
{
    private static readonly Vector3d s_velocity = new(1.5, 6, -21);
    private static readonly Vector3d s_spin = new(-7, 40, 3);

    public static TheoryData<string> Scenes => [.. BundleTests.s_scenes.Keys];

    public static TheoryData<string> Shots => [.. GalleryShots.All.Select(shot => shot.Id)];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void A_scene_reads_back_with_the_same_hash(string name) => AssertSame(BundleTests.s_scenes[name]());

    [Theory]
    [MemberData(nameof(Shots))]
    public void A_scene_of_the_gallery_reads_back_with_the_same_hash(string id)
    {
        GalleryShot shot = GalleryShots.All.Single(item => item.Id == id);
        AssertSame(shot.Scenario.Scene);
        Assert.Equal(Hash(shot.Comparison?.Scene ?? Scene.Default), Hash(Read((shot.Comparison?.Scene ?? Scene.Default).ToJson())));
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void The_tool_plays_the_kick_of_a_game_to_the_same_bits(string name)
    {
        var simulator = new Simulator(BundleTests.s_scenes[name](), new SolverSettings { Integrator = Integrator.Rk2, RollingTransition = RollingTransition.Heuristic });
        BallState ball = simulator.Launch(new Vector3d(0, 1, 0), s_velocity, s_spin);
        string json = simulator.ToJson(in ball, 1.0 / 60);
        var log = new StepLog();
        simulator.Run(ref ball, 1.0 / 60, 0.7, StopAt.Time, log);

        JsonElement played = FootballCommand.Play(json, "--set", "stop.at=time", "--set", "stop.time=0.7").GetProperty("final");
        double[] position = [.. played.GetProperty("position").EnumerateArray().Select(item => item.GetDouble())];
        Assert.Equal([ball.Position.X, ball.Position.Y, ball.Position.Z], position);
    }

    [Fact]
    public void Bodies_are_where_the_game_has_moved_them()
    {
        var bodies = new KinematicBodies();
        KinematicBody wall = bodies.Add("wall", new BoxShape(Vector3d.Zero, new Vector3d(2, 1, 0.2)), SurfaceMaterial.Wood);
        KinematicBody leg = bodies.Add("leg", BodyKind.Boot);
        KinematicBody away = bodies.Add("substitute", BodyKind.Player);
        var simulator = new Simulator(new Scene { Bodies = bodies });
        BallState ball = simulator.Launch(new Vector3d(0, 0.5, 9), new Vector3d(0, 3, 1), Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref ball, 0.25, 0.5, StopAt.Time, log);
        wall.MoveTo(new Vector3d(0, 1, -8), Quaterniond.FromAxisAngle(Vector3d.Up, 0.3), new Vector3d(0.5, 0, 0), new Vector3d(0, 0.2, 0), 0.5);
        leg.MoveTo(new Vector3d(5, 0.1, -3), Vector3d.Zero, 0.5);
        away.Withdraw();
        simulator.Kick(ref ball, new Vector3d(0, 1, -18), Vector3d.Zero);
        string json = simulator.ToJson(in ball);

        Scene read = Read(json);
        Assert.Equal(simulator.SceneHash, new Simulator(read).SceneHash);
        Assert.Equal((new Vector3d(0, 1, -8), new Vector3d(0.5, 0, 0), 0.0), (read.Bodies![0].Position, read.Bodies[0].Velocity, read.Bodies[0].Time));
        Assert.Equal(wall.Orientation.Y, read.Bodies[0].Orientation.Y, 1e-15);
        Assert.Equal((new Vector3d(5, 0.1, -3), true), (read.Bodies[1].Position, read.Bodies[2].IsWithdrawn));

        // The wall is a quarter of a second farther if the ball is.
        simulator.Run(ref ball, 0.25, 0.25, StopAt.Time, log);
        Assert.Equal(0.125, Read(simulator.ToJson(in ball)).Bodies![0].Position.X, 1e-12);
    }

    [Fact]
    public void Replay_draws_the_bodies_and_the_ball_hits_them()
    {
        var bodies = new KinematicBodies();
        bodies.Add("wall", new BoxShape(Vector3d.Zero, new Vector3d(2, 1, 0.2)), SurfaceMaterial.Wood).MoveTo(new Vector3d(0, 1, -8), Vector3d.Zero, 0);
        var simulator = new Simulator(new Scene { Bodies = bodies });
        BallState ball = simulator.Launch(new Vector3d(0, 0.5, 0), new Vector3d(0, 2, -20), Vector3d.Zero);
        string page = Path.Combine(Directory.CreateTempSubdirectory("football-json-").FullName, "replay.html");
        var done = FootballCommand.Run(simulator.ToJson(in ball), "replay", "-", "-o", page);
        Assert.Equal(0, done.ExitCode);
        Assert.Equal("wall", done.Result.GetProperty("events")[0].GetProperty("surface").GetString());
        Assert.Contains("\"wall\"", File.ReadAllText(page), StringComparison.Ordinal);
    }

    [Fact]
    public void An_error_names_the_part_that_is_code()
    {
        AssertRejects("forces.customForces[0] (FunctionForce)", new Scene { Forces = ForceSet.Measured with { CustomForces = [IForce.From(_ => Vector3d.Zero)] } });
        AssertRejects("air.windField", new Scene { Air = new Air { WindField = new Whirl() } });
        AssertRejects("ground.pattern", new Scene { Ground = new Ground { Pattern = new Plain() } });
        AssertRejects("obstacles.shape (Bump)", new Scene { Obstacles = [new Obstacle { Shape = new Bump() }] });
        AssertRejects("zones.shape (Bump)", new Scene { Zones = [new Zone { Shape = new Bump() }] });
    }

    [Fact]
    public void A_scene_that_has_changed_since_time_0_is_rejected()
    {
        var simulator = new Simulator(new Scene { Obstacles = [new Obstacle { Name = "sledge", Shape = new SphereShape(new Vector3d(9, 1, 0), 1), Velocity = new Vector3d(1, 0, 0) }] });
        BallState ball = simulator.Launch(new Vector3d(0, 0.5, 0), new Vector3d(0, 2, -20), Vector3d.Zero);
        Assert.Contains("sledge", simulator.ToJson(in ball), StringComparison.Ordinal);
        simulator.Run(ref ball, 0.1, 0.1, StopAt.Time, new StepLog());
        Assert.Contains("obstacles[0] (sledge) has moved", Assert.Throws<InvalidOperationException>(() => simulator.ToJson(in ball)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_scene_out_of_range_and_a_ball_that_was_never_launched_are_rejected()
    {
        Assert.Equal("ball.mass", Assert.Throws<ArgumentOutOfRangeException>(() => new Scene { Ball = new BallProperties { Mass = -1 } }.ToJson()).ParamName);
        BallState none = default;
        Assert.Throws<ArgumentException>(() => new Simulator().ToJson(in none));
        BallState ball = new Simulator().Launch(Vector3d.Up, Vector3d.Zero, Vector3d.Zero);
        Assert.Throws<ArgumentOutOfRangeException>(() => new Simulator().ToJson(in ball, 0));
    }

    private static void AssertSame(Scene scene)
    {
        string json = scene.ToJson();
        Scene read = Read(json);
        Assert.Equal(Hash(scene), Hash(read));
        Assert.Equal(json, read.ToJson());
    }

    private static void AssertRejects(string part, Scene scene) =>
        Assert.Contains($"because {part} is code", Assert.Throws<InvalidOperationException>(scene.ToJson).Message, StringComparison.Ordinal);

    private static ulong Hash(Scene scene) => new Simulator(scene).SceneHash;

    /// <summary>Reads the members of a scene as C, Python and the npm package do; a scenario may also have its solver and its launch.</summary>
    private static Scene Read(string json)
    {
        var fields = new InputFields(JsonDocument.Parse(json).RootElement);
        Scene scene = SceneInput.Scene(fields.Root) with { Bodies = WorldInput.Bodies(fields.Root) };
        SceneInput.Solver(fields.Root, out _);
        InputObject launch = fields.Root.Object("launch");
        foreach (string name in (string[])["position", "velocity", "spin", "orientation"])
        {
            launch.Has(name);
        }

        fields.Check();
        return scene;
    }

    private sealed class Whirl : IWind
    {
        public double MaximumSpeed => 1;

        public Vector3d At(double time, in Vector3d position) => new(1, 0, 0);
    }

    private sealed class Plain : ISurfacePattern
    {
        public IReadOnlyList<SurfaceMaterial> Surfaces { get; } = [SurfaceMaterial.DryTurf];

        public double MinimumWidth => 1;

        public int At(double x, double z) => 0;
    }

    private sealed class Bump : IShape
    {
        private static readonly SphereShape s_sphere = new(new Vector3d(0, 1, -30), 1);

        public Bounds3d Bounds => s_sphere.Bounds;

        public double MaximumConcaveCurvature => 0;

        public ShapePoint At(in Vector3d point) => s_sphere.At(in point);
    }
}
