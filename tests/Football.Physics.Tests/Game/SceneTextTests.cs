using System.Text.Json;
using FootballPhysics.Game;
using FootballPhysics.Scenes;

namespace FootballPhysics.Tests.Game;

/// <summary>The JSON text of a scene, read with another reader.</summary>
public sealed class SceneTextTests
{
    private static readonly SurfaceMaterial s_rough = SurfaceMaterial.Board with { NormalRestitution = 0.37, SlidingFriction = 0.83, SpinRestitution = 0.21 };

    private static readonly Scene s_scene = Scene.Default with
    {
        Air = new Air { Density = 1.07, Wind = new Vector3d(1, 2, -3) },
        Obstacles =
        [
            new Obstacle { Name = "a \"flat\"\tboard \\ one", Shape = new SphereShape(new Vector3d(0, 1, -9), 0.4), Surface = s_rough, Layer = 3 },
            new Obstacle { Name = "second", Shape = new PlaneShape(new Vector3d(0, 0, -30), new Vector3d(0, 0, 1)), Velocity = new Vector3d(0, 0, 0.5) },
        ],
        Zones =
        [
            new Zone { Name = "whole", Shape = new SphereShape(new Vector3d(0, 0, -20), 2), Of = ZonePart.Ball },
            new Zone { Name = "middle", Shape = new SphereShape(new Vector3d(9, 0, -20), 2), Of = ZonePart.Center, Layer = 2 },
        ],
    };

    private static readonly JsonElement s_text = Parsed(new SceneText().Begin().Add(new Simulator(s_scene)).End().ToString());

    [Fact]
    public void A_name_keeps_its_quotes_backslashes_and_control_characters() =>
        Assert.Equal(s_scene.Obstacles.Select(item => item.Name), Members("obstacles").Select(item => item.GetProperty("name").GetString()));

    [Fact]
    public void An_item_has_the_numbers_of_its_material()
    {
        JsonElement[] items = Members("obstacles");
        for (int i = 0; i < items.Length; i++)
        {
            JsonElement surface = items[i].GetProperty("surface");
            Assert.All(SceneFields.Material, field => AssertIs(field.Get(s_scene.Obstacles[i].Surface), surface.GetProperty(field.Name)));
        }
    }

    [Fact]
    public void Air_has_its_numbers_and_the_wind()
    {
        JsonElement air = s_text.GetProperty("scene").GetProperty("air");
        Assert.All(SceneFields.Air, field => AssertIs(field.Get(s_scene.Air), air.GetProperty(field.Name)));
        Assert.Equal([1.0, 2.0, -3.0], air.GetProperty("wind").EnumerateArray().Select(value => value.GetDouble()));
    }

    [Fact]
    public void A_zone_names_the_part_of_the_ball_and_its_layer()
    {
        JsonElement[] zones = Members("zones");
        Assert.Equal(["ball", "centre"], zones.Select(zone => zone.GetProperty("of").GetString()));
        Assert.False(zones[0].TryGetProperty("layer", out _));
        Assert.Equal(2, zones[1].GetProperty("layer").GetInt32());
        Assert.Equal(3, Members("obstacles")[0].GetProperty("layer").GetInt32());
    }

    [Theory]
    [InlineData("nodes", "values")]
    [InlineData("values", "nodes")]
    public void Hills_have_the_rows_of_their_heights(string member, string other)
    {
        double[,] given = { { 0, 0.1, 0.2 }, { 0.3, 0.4, 0.5 } };
        HeightField hills = member == "nodes" ? new HeightField(-1, -2, 10, given) : HeightField.FromControlValues(-1, -2, 10, given);
        Scene scene = Scene.Default with { Ground = new Ground { Heights = hills } };
        JsonElement heights = Parsed(new SceneText().Begin().Add(new Simulator(scene)).End().ToString()).GetProperty("scene").GetProperty("ground").GetProperty("heights");
        Assert.Equal([-1, -2], heights.GetProperty("origin").EnumerateArray().Select(value => value.GetDouble()));
        Assert.Equal([[0, 0.1, 0.2], [0.3, 0.4, 0.5]], heights.GetProperty(member).EnumerateArray().Select(row => row.EnumerateArray().Select(value => value.GetDouble()).ToArray()));
        Assert.False(heights.TryGetProperty(other, out _));
    }

    [Fact]
    public void Code_has_no_text()
    {
        Scene scene = Scene.Default with { Forces = ForceSet.Measured with { CustomForces = [IForce.From(_ => Vector3d.Zero)] } };
        Assert.Contains("is code or has no", Assert.Throws<InvalidOperationException>(() => new SceneText().Begin().Add(new Simulator(scene))).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Layers_that_a_ball_ignores_are_listed()
    {
        Scene scene = Scene.Default with { Ball = new BallProperties { Ignores = Layers.Of(1, 5, 31) } };
        JsonElement ball = Parsed(new SceneText().Begin().Add(new Simulator(scene)).End().ToString()).GetProperty("scene").GetProperty("ball");
        Assert.Equal([1, 5, 31], ball.GetProperty("ignores").EnumerateArray().Select(value => value.GetInt32()));
        Assert.False(s_text.GetProperty("scene").GetProperty("ball").TryGetProperty("ignores", out _));
    }

    private static JsonElement Parsed(string text) => JsonDocument.Parse(text).RootElement.Clone();

    private static JsonElement[] Members(string list) => [.. s_text.GetProperty("scene").GetProperty(list).EnumerateArray()];

    // Infinity has no number in JSON: it is null.
    private static void AssertIs(double expected, JsonElement actual)
    {
        if (double.IsPositiveInfinity(expected))
        {
            Assert.Equal(JsonValueKind.Null, actual.ValueKind);
        }
        else
        {
            Assert.Equal(expected, actual.GetDouble());
        }
    }
}
