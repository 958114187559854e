using System.Text;
using FootballPhysics.Package.Tests;

namespace FootballPhysics.Native.Tests;

/// <summary>The kick of samples/Love and samples/Pygame, in C#: its hash is the one that the samples print.</summary>
public sealed class SampleTests
{
    private const string Scene = """
        {"goals": [{"center": [0, 0, -22.0], "facing": [0, 0, 1]}],
         "obstacles": [{"name": "wall", "shape": "box", "center": [1, 0.92, -9.15], "halfSize": [1.3, 0.92, 0.2]}]}
        """;

    private const string Request = """{"from": [0.0, 0.11, 0.0], "target": [2.9, 1.7, -22.0], "speed": 24, "spin": {"side": -45}}""";

    [Theory]
    [InlineData("samples/Love/main.lua", "samples/Love/conf.lua")]
    [InlineData("samples/Pygame/free_kick.py")]
    public void A_sample_prints_the_hash_of_CSharp(params string[] files)
    {
        CompiledScene scene = Requests.Scene(Encoding.UTF8.GetBytes(Scene));
        AimResult aim = Requests.Aim(scene, Encoding.UTF8.GetBytes(Request));
        BallState ball = scene.Simulator.Launch(new Vector3d(0, 0.11, 0), Vector3d.Zero, Vector3d.Zero);
        scene.Simulator.Kick(ref ball, aim.Velocity, aim.Spin);
        var log = new StepLog();
        bool scores = false;
        for (int i = 0; i < 240; i++)
        {
            log.Clear();
            scene.Simulator.Step(ref ball, 1.0 / 60, log);
            for (int k = 0; k < log.Events.Count; k++)
            {
                scores |= log.Events[k].Kind == BallEventKind.Goal;
            }
        }

        Assert.True(scores);
        string[] texts = [.. files.Select(Repository.Text)];
        Assert.Contains($"Goal! hash {Snapshot.Hash(in ball):x16}", texts[0]);
        Assert.InRange(texts.Sum(text => text.Count(character => character == '\n')), 50, 150);
    }
}
