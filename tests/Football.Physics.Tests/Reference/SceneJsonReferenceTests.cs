using System.Text.Json;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tests.Reference;

/// <summary>The scene of each reference case reads back from its own JSON with the same hash.</summary>
public sealed class SceneJsonReferenceTests
{
    [Theory]
    [InlineData("aims.ndjson", 41)]
    [InlineData("among.ndjson", 48)]
    [InlineData("derivatives.ndjson", 24)]
    [InlineData("flight.ndjson", 60)]
    [InlineData("intercept.ndjson", 60)]
    [InlineData("measured.ndjson", 57)]
    [InlineData("people.ndjson", 36)]
    [InlineData("pressed.ndjson", 40)]
    [InlineData("several.ndjson", 40)]
    [InlineData("trajectories.ndjson", 110)]
    [InlineData("world.ndjson", 118)]
    public void Scenes_read_back_with_their_hashes(string file, int scenarios)
    {
        int count = 0;
        foreach (JsonElement line in ReferenceCase.Lines(file))
        {
            Scene scene = SceneInput.Scene(new InputFields(line.GetProperty("scenario")).Root);
            string json = scene.ToJson();
            Scene read = SceneInput.Scene(new InputFields(JsonDocument.Parse(json).RootElement).Root);
            Assert.Equal(new Simulator(scene).SceneHash, new Simulator(read).SceneHash);
            Assert.Equal(json, read.ToJson());
            count++;
        }

        Assert.Equal(scenarios, count);
    }
}
