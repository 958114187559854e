using System.Text.Json;
using System.Text.Json.Nodes;

namespace FootballPhysics.Tool.Tests.Replay;

/// <summary>football replay --gltf: the file follows the rules of glTF 2.0, and its animation is the shot.</summary>
public sealed class GltfTests
{
    private const string Shot = """
        {"launch": {"position": [0, 0.11, 0], "velocity": [3.85, 6, -24], "spin": [30, 90, 0]}, "goals": [{"center": [0, 0, -22], "facing": [0, 0, 1]}],
         "obstacles": [{"name": "keeper", "shape": "box", "center": [1, 1, -21], "halfSize": [0.3, 1, 0.2], "velocity": [1, 0, 0]},
                       {"shape": "sphere", "center": [-3, 0.5, -12], "radius": 0.5}, {"shape": "plane", "point": [0, 0, -30], "normal": [0, 0, 1]}]}
        """;

    private static readonly string s_file = Written();

    [Theory]
    [InlineData("rest")]
    [InlineData("impact")]
    public void It_follows_the_rules(string stop) => Assert.Empty(new GltfRules(Written("--set", $"stop.at={stop}")).Broken());

    [Fact]
    public void Its_animation_is_the_shot()
    {
        var rules = new GltfRules(s_file);
        Assert.Empty(rules.Broken());
        JsonElement root = JsonDocument.Parse(s_file).RootElement;
        JsonElement[] nodes = [.. root.GetProperty("nodes").EnumerateArray()];
        int ball = Array.FindIndex(nodes, node => node.TryGetProperty("scale", out _));
        JsonElement[] channels = [.. root.GetProperty("animations")[0].GetProperty("channels").EnumerateArray()];
        Assert.Equal(3, channels.Length);
        JsonElement moving = channels.Single(channel => channel.GetProperty("target").GetProperty("node").GetInt32() == ball
            && channel.GetProperty("target").GetProperty("path").GetString() == "translation");
        JsonElement sampler = root.GetProperty("animations")[0].GetProperty("samplers")[moving.GetProperty("sampler").GetInt32()];
        double[] values = rules.Numbers(sampler.GetProperty("output").GetInt32());
        JsonElement final = FootballCommand.Play(Shot).GetProperty("final");
        for (int i = 0; i < 3; i++)
        {
            Assert.Equal(final.GetProperty("position")[i].GetDouble(), values[^(6 - i)], 1e-5);
        }

        string[] names = [.. nodes.Select(node => node.GetProperty("name").GetString()!)];
        Assert.Contains("keeper", names);
        Assert.Contains("crossbar", names);
        Assert.Contains(names, name => name.Contains("impact at", StringComparison.Ordinal));
    }

    /// <summary>The rules see what is broken: each of these changes breaks one.</summary>
    [Theory]
    [InlineData("asset.version", "\"1.0\"")]
    [InlineData("scene", "7")]
    [InlineData("nodes.0.mesh", "999")]
    [InlineData("nodes.0.colour", "1")]
    [InlineData("accessors.0.count", "100000")]
    [InlineData("accessors.0.min.0", "-12345")]
    [InlineData("accessors.0.componentType", "5124")]
    [InlineData("bufferViews.0.byteOffset", "3")]
    [InlineData("buffers.0.byteLength", "1")]
    [InlineData("materials.0.pbrMetallicRoughness.roughnessFactor", "2")]
    [InlineData("meshes.0.primitives.0.mode", "9")]
    [InlineData("animations.0.samplers.0.interpolation", "\"SPLINE\"")]
    [InlineData("animations.0.samplers.1.interpolation", "\"LINEAR\"")]
    [InlineData("animations.0.channels.0.target.path", "\"weights\"")]
    public void A_broken_rule_is_found(string path, string value)
    {
        JsonNode root = JsonNode.Parse(s_file)!;
        string[] parts = path.Split('.');
        JsonNode at = parts[..^1].Aggregate(root, (node, part) => int.TryParse(part, out int index) ? node[index]! : node[part]!);
        if (int.TryParse(parts[^1], out int last))
        {
            at[last] = JsonNode.Parse(value);
        }
        else
        {
            at[parts[^1]] = JsonNode.Parse(value);
        }

        Assert.NotEmpty(new GltfRules(root.ToJsonString()).Broken());
    }

    private static string Written(params string[] more)
    {
        string folder = Directory.CreateTempSubdirectory("football-gltf-").FullName;
        string file = Path.Combine(folder, "shot.gltf");
        FootballCommand done = FootballCommand.Run(Shot, ["replay", "-", "-o", Path.Combine(folder, "page.html"), "--gltf", file, .. more]);
        Assert.Equal(0, done.ExitCode);
        string text = File.ReadAllText(file);
        Directory.Delete(folder, recursive: true);
        return text;
    }
}
