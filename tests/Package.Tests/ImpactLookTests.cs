using FootballPhysics.Engines;
using FootballPhysics.Netcode;
using FootballPhysics.Unity;
using UnityEngine;
using GodotBall = FootballPhysics.GodotAddon.FootballBall;
using GodotSound = FootballPhysics.GodotAddon.FootballSound;
using Node = Godot.Node;

namespace FootballPhysics.Package.Tests;

/// <summary>The sound and the drawn squash of an impact: the mapping of the library, and the components of both engines that use it.</summary>
[Collection(EngineTests.Statics)]
public sealed class ImpactLookTests : IDisposable
{
    private const double Frame = 1 / 60.0;
    private const int Rate = 48000;

    public ImpactLookTests() => Dispose();

    public void Dispose()
    {
        GameObject.DestroyAll();
        Debug.Warned.Clear();
        foreach (Node node in Node.Root.GetChildren())
        {
            node.QueueFree();
        }

        Godot.GD.Pushed.Clear();
        Godot.Engine.InterpolationFraction = 1;
        Godot.Engine.PhysicsTicksPerSecond = 60;
    }

    [Fact]
    public void A_sound_follows_from_force_duration_and_slip()
    {
        (BallEvent happened, Impact impact) = Drop(new Vector3d(6, -10, 0), new Vector3d(0, 0, 40));
        var sound = new ImpactSound(in impact);
        Assert.Equal(impact.PeakForce / 3000, sound.Loudness, 15);
        Assert.Equal(1 / 0.01069, sound.Brightness, 0.1);
        Assert.Equal(impact.TangentialImpulse * impact.SlipBefore / 50, sound.Brush, 15);
        Assert.InRange(sound.Brush, 0.1, 0.9);
        Assert.True(sound.IsAudible);
        Assert.Equal(BallEventKind.Impact, happened.Kind);

        // Nothing to hear: no impact, and a ball that hardly touches.
        Assert.False(new ImpactSound(default).IsAudible);
        Assert.All(Wave(default), sample => Assert.Equal(0, sample));
        Assert.False(new ImpactSound(Drop(new Vector3d(0, -0.06, 0)).Outputs).IsAudible);
    }

    [Fact]
    public void A_wave_is_as_loud_as_the_impact_and_higher_for_a_shorter_contact()
    {
        float[] hard = Wave(Drop(new Vector3d(0, -12, 0)).Outputs);
        float[] soft = Wave(Drop(new Vector3d(0, -6, 0)).Outputs);
        Assert.Equal(Rate / 4, hard.Length);
        Assert.Equal(2, hard.Max() / soft.Max(), 0.15);
        Assert.Equal(0, hard[0]);
        Assert.InRange(hard.Max(Math.Abs), 0.1f, 1f);
        Assert.InRange(Math.Abs(hard[^1]), 0, 1e-4f);
        Assert.Equal(hard, Wave(Drop(new Vector3d(0, -12, 0)).Outputs));

        // A beach ball is light: its contact is shorter, and its tone higher.
        float[] light = Wave(Drop(new Vector3d(0, -12, 0), default, BallProperties.BeachBall).Outputs);
        Assert.True(Crossings(light) > 1.5 * Crossings(hard));

        // A ball with spin brushes the ground: noise comes on top.
        Assert.True(Crossings(Wave(Drop(new Vector3d(0, -3, 0), new Vector3d(0, 0, 300)).Outputs)) > 3 * Crossings(soft));
        Assert.Equal("rate", Assert.Throws<ArgumentOutOfRangeException>(() => ImpactSound.SamplesAt(100)).ParamName);
    }

    [Fact]
    public void A_squash_is_as_deep_as_the_compression_and_keeps_the_volume()
    {
        (BallEvent happened, Impact impact) = Drop(new Vector3d(3, -19.2, 0));
        var squash = new BallSquash(new Simulator());
        Assert.True(squash.At(0).IsRound);
        squash.Follow(in happened);
        Assert.True(squash.At(happened.Time).IsRound);
        BallStretch deepest = squash.At(happened.Time + (0.5 * BallSquash.ShortestTime));
        Assert.Equal(1 - (impact.Compression / 0.22), deepest.Along, 12);
        Assert.Equal(1, deepest.Along * deepest.Across * deepest.Across, 12);
        Assert.Equal(Vector3d.Up, deepest.Axis);
        Assert.Equal(new Vector3d(deepest.Across, deepest.Along, 0), deepest.Apply(new Vector3d(1, 1, 0)));
        Assert.True(squash.At(happened.Time + BallSquash.ShortestTime).IsRound);
        Assert.True(squash.At(happened.Time - 0.01).IsRound);

        // A weaker impact in between changes nothing; a clock that begins again does.
        squash.Follow(Later(Drop(new Vector3d(0, -2, 0)).Event));
        Assert.Equal(deepest, squash.At(happened.Time + (0.5 * BallSquash.ShortestTime)));
        squash.Clear();
        Assert.True(squash.At(happened.Time + 0.03).IsRound);

        // Off a sphere, from all sides: the frame turns up to the normal.
        foreach (Vector3d way in (Vector3d[])[Vector3d.Up, -Vector3d.Up, new(1, 0, 0), new Vector3d(1, -2, 3) / Math.Sqrt(14)])
        {
            var thing = new Simulator(Scene.Vacuum with { Gravity = 0, Ground = Ground.None, Obstacles = [new Obstacle { Shape = new SphereShape(1.0 * way, 0.3) }] });
            BallState state = thing.Launch(Vector3d.Zero, 20 * way, Vector3d.Zero);
            var log = new StepLog();
            thing.Run(ref state, 0.01, 1, StopAt.Impact, log);
            squash = new BallSquash(thing);
            squash.Follow(in log.Events[0]);
            BallStretch stretch = squash.At(log.Events[0].Time + 0.03);
            Assert.InRange(stretch.Along, 0.4, 0.9);
            Assert.InRange((stretch.Frame.Rotate(Vector3d.Up) + way).Length, 0, 1e-12);
        }
    }

    [Fact]
    public void In_Unity_an_impact_sounds_and_flattens_only_the_drawn_ball()
    {
        FootballBall ball = UnityAsset.Load("Prefabs/Football.prefab")["Football"].GetComponent<FootballBall>();
        FootballBall plain = UnityAsset.Load("Prefabs/Football.prefab")["Football"].GetComponent<FootballBall>();
        plain.GetComponent<FootballSkin>().Squash = false;
        plain.GetComponent<FootballSound>().Volume = 0;
        List<(float[] Samples, int Rate, float Volume)> played = ball.GetComponent<AudioSource>().Played;
        int heard = 0;
        ball.Impact += (_, happened) =>
        {
            if (new ImpactSound(happened.Outputs).IsAudible)
            {
                heard++;
                Assert.Equal(Wave(happened.Outputs), played[^1].Samples);
            }
        };
        Mesh mesh = ball.GetComponent<MeshFilter>().sharedMesh!;
        float flattest = 1;
        float round = Radii(mesh).Min();
        ball.Kick(18f, new UnityEngine.Vector3(0f, 1f, 1f), 0f, 30f);
        plain.Kick(18f, new UnityEngine.Vector3(0f, 1f, 1f), 0f, 30f);
        for (int i = 0; i < 600; i++)
        {
            GameObject.SendAll("FixedUpdate");
            GameObject.SendAll("Update");
            GameObject.SendAll("LateUpdate");
            flattest = Math.Min(flattest, Radii(mesh).Min() / round);
            Assert.True(Snapshot.Same(ball.Runner.State, plain.Runner.State));
            Assert.Equal(1f, ball.transform.localScale.y);
        }

        Assert.InRange(flattest, 0.6f, 0.9f);
        Assert.Equal(1, Radii(mesh).Min() / round, 1e-5f);
        Assert.Equal(1, Radii(plain.GetComponent<MeshFilter>().sharedMesh!).Min() / round, 1e-5f);
        Assert.True(heard > 2);
        Assert.Equal(heard, played.Count);
        Assert.All(played, sound => Assert.Equal((Rate, 1f), (sound.Rate, sound.Volume)));
        Assert.Empty(plain.GetComponent<AudioSource>().Played);
        Assert.Empty(Debug.Warned);
    }

    [Fact]
    public void In_Godot_an_impact_sounds_and_flattens_only_the_drawn_ball()
    {
        var ball = (GodotBall)GodotAsset.Load("addons/football_physics/scenes/football.tscn");
        var plain = new GodotBall { Squash = false, GlobalPosition = ball.GlobalPosition };
        Node.Root.AddChild(plain);
        GodotSound sound = ball.GetChildren().OfType<GodotSound>().Single();
        var playback = (Godot.AudioStreamGeneratorPlayback)sound.GetChildren(true).OfType<Godot.AudioStreamPlayer3D>().Single().GetStreamPlayback()!;
        Godot.MeshInstance3D skin = ball.GetChildren(true).OfType<Godot.MeshInstance3D>().Single();
        float flattest = 1;
        ball.Kick(18, new Godot.Vector3(0, 1, -1), 0, 30);
        plain.Kick(18, new Godot.Vector3(0, 1, -1), 0, 30);
        int impacts = 0;
        double loudest = 0;
        for (int i = 0; i < 600; i++)
        {
            Node.Play(1, Frame);
            impacts = ball.Emitted.Count(emitted => emitted.Signal == "Impact");
            loudest = Math.Max(loudest, sound.Loudness);
            Godot.Vector3 up = skin.GlobalTransform.Basis.Transposed() * new Godot.Vector3(0, 1, 0);
            flattest = Math.Min(flattest, up.Length());
            Assert.True(Snapshot.Same(ball.Runner.State, plain.Runner.State));
            Assert.Equal(1f, ball.GlobalTransform.Basis.Scale.Y, 1e-5f);
        }

        Assert.True(impacts > 2);
        Assert.InRange(flattest, 0.6f, 0.9f);
        Assert.Equal(1f, skin.GlobalTransform.Basis.Scale.Y, 1e-5f);
        Assert.InRange(loudest, 0.1, 1);
        Assert.InRange(playback.Pushed.Max(frame => Math.Abs(frame.X)), 0.05f, 1f);
        Assert.All(playback.Pushed, frame => Assert.Equal(frame.X, frame.Y));
        Assert.True(playback.Pushed.Count >= ImpactSound.SamplesAt(44100));
        Assert.Empty(Godot.GD.Pushed);

        // Elsewhere it says that it has no ball.
        Node.Root.AddChild(new GodotSound { Name = "Lone" });
        Assert.Contains("\"Lone\" is not below a football", Assert.Single(Godot.GD.Pushed), StringComparison.Ordinal);
    }

    /// <summary>The first impact of a ball that is thrown at concrete.</summary>
    private static (BallEvent Event, Impact Outputs) Drop(Vector3d velocity, Vector3d spin = default, BallProperties? ball = null)
    {
        BallProperties used = ball ?? BallProperties.Modern;
        var simulator = new Simulator(Scene.Default with { Ball = used, Ground = Ground.Of(SurfaceMaterial.Concrete) });
        BallState state = simulator.Launch(new Vector3d(0, used.Radius + 0.001, 0), velocity, spin);
        var log = new StepLog();
        simulator.Run(ref state, 0.01, 1, StopAt.Impact, log);
        BallEvent happened = log.Events[0];
        return (happened, simulator.ImpactOf(in happened));
    }

    /// <summary>An impact 20 ms later.</summary>
    private static BallEvent Later(BallEvent happened)
    {
        var simulator = new Simulator(Scene.Default with { Ground = Ground.Of(SurfaceMaterial.Concrete) });
        BallState state = simulator.Launch(new Vector3d(0, 0.11 + 0.05, 0), happened.VelocityBefore, Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref state, 0.01, 1, StopAt.Impact, log);
        return log.Events[0];
    }

    private static float[] Wave(Impact impact)
    {
        float[] samples = new float[ImpactSound.SamplesAt(Rate)];
        new ImpactSound(in impact).Write(samples, Rate);
        return samples;
    }

    /// <summary>The number of changes of sign in the first 50 ms.</summary>
    private static int Crossings(float[] wave) => Enumerable.Range(1, Rate / 20).Count(i => wave[i] > 0 != wave[i - 1] > 0);

    private static IEnumerable<float> Radii(Mesh mesh) => mesh.vertices.Select(point => point.magnitude);
}
