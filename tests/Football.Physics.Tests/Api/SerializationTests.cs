using Newtonsoft.Json;

namespace FootballPhysics.Tests.Api;

/// <summary>Scenes, requests and results come out of a serializer as they went in, without options or converters.</summary>
public sealed class SerializationTests
{
    public static TheoryData<string> Scenes() => new("default", "measured", "windy", "vacuum");

    [Theory]
    [MemberData(nameof(Scenes))]
    public void A_scene_flies_the_same_after_it(string name)
    {
        Scene scene = name switch
        {
            "measured" => Scene.Measured,
            "windy" => Scene.Windy(new Vector3d(3, 0.5, -7)) with { Ball = BallProperties.BeachBall },
            "vacuum" => Scene.Vacuum,
            _ => Scene.Default,
        };
        foreach (Scene read in Both(scene))
        {
            Assert.Equal(Fly(scene), Fly(read));
            Assert.Equal(scene.Ground, read.Ground);
        }
    }

    [Fact]
    public void Reading_a_scene_changes_no_preset()
    {
        string before = JsonConvert.SerializeObject(new Scene());
        Both(new Scene { Ball = BallProperties.BeachBall, Forces = ForceSet.Constant, Ground = Ground.PublishedTurf with { Material = SurfaceMaterial.PublishedTurf with { SlidingFriction = 0.1 } } });
        Assert.Equal(before, JsonConvert.SerializeObject(new Scene()));
        Assert.Equal(0.11, BallProperties.Tunnel.Radius);
    }

    [Fact]
    public void Requests_are_the_same_after_it()
    {
        var aim = new AimRequest { From = new Vector3d(1, 0.11, -2), Target = new Vector3d(3, 1.5, -20), Waypoint = new Vector3d(2, 2, -9), TopSpin = 0.1, Arc = AimArc.High };
        Assert.All(Both(aim), read => Assert.Equal(aim, read));
        Assert.All(Both(new AimRequest()), read => Assert.True(double.IsNaN(read.Target.X)));
        var look = new LookAheadRequest { UntilPlane = new Plane3d(new Vector3d(0, 0, -11), new Vector3d(0, 0, 1)), Duration = 1.0 / 3 };
        Assert.All(Both(look), read => Assert.Equal(look, read));
        var settings = new SolverSettings { Integrator = Integrator.Rk2 };
        Assert.All(Both(settings), read => Assert.Equal(settings, read));
    }

    [Fact]
    public void Results_are_the_same_after_it()
    {
        AimResult result = new Aimer().Find(new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(3, 1.5, -20), Waypoint = new Vector3d(2, 2, -9) });
        foreach (AimResult read in Both(result))
        {
            Assert.Equal((result.Status, result.Velocity, result.Spin, result.Miss), (read.Status, read.Velocity, read.Spin, read.Miss));
            Assert.Equal((result.Time, result.Closest, result.WaypointMiss, result.Simulations), (read.Time, read.Closest, read.WaypointMiss, read.Simulations));
        }
    }

    [Fact]
    public void Vectors_and_rotations_are_their_components()
    {
        Assert.Equal("""{"X":1,"Y":2.5,"Z":-3}""", System.Text.Json.JsonSerializer.Serialize(new Vector3d(1, 2.5, -3)));
        Assert.Equal("""{"X":1.0,"Y":2.5,"Z":-3.0}""", JsonConvert.SerializeObject(new Vector3d(1, 2.5, -3)));
        Assert.All(Both(new Quaterniond(0.5, -0.5, 0.5, 0.5)), read => Assert.Equal(new Quaterniond(0.5, -0.5, 0.5, 0.5), read));
    }

    private static T[] Both<T>(T value) =>
    [
        System.Text.Json.JsonSerializer.Deserialize<T>(System.Text.Json.JsonSerializer.Serialize(value))!,
        JsonConvert.DeserializeObject<T>(JsonConvert.SerializeObject(value))!,
    ];

    private static ulong Fly(Scene scene)
    {
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(4, 6, -20), new Vector3d(5, 20, 3));
        simulator.Run(ref state, 0.01, 4, StopAt.Rest, new StepLog());
        return Snapshot.Hash(in state);
    }
}
