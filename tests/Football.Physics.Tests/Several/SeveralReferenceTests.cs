using System.Text.Json;
using FootballPhysics.Tests.Reference;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tests.Several;

/// <summary>Several balls and bodies with a mass, against an independent solver: all that the scenario's reader and the result have of them.</summary>
public sealed class SeveralReferenceTests
{
    /// <summary>Places and times of the reference hold to this, m and s.</summary>
    private const double Close = 1e-6;

    [Fact]
    public void Balls_and_bodies_are_where_and_when_the_reference_says()
    {
        int balls = 0;
        int pushes = 0;
        IReadOnlyList<JsonElement> lines = [.. ReferenceCase.Lines("several.ndjson")];
        Assert.Equal(40, lines.Count);
        foreach (JsonElement line in lines)
        {
            var scenario = Scenario.Read(new InputFields(line.GetProperty("scenario")));
            Outcome outcome = ScenarioRun.Play(scenario);
            JsonElement expected = line.GetProperty("expected");
            string name = line.GetProperty("name").GetString()!;
            JsonElement[] finals = [.. expected.GetProperty("balls").EnumerateArray()];
            Assert.Equal(finals.Length, outcome.Balls.Count);
            for (int i = 0; i < finals.Length; i++)
            {
                Near(name, finals[i], "position", outcome.Balls[i].Position);
                Near(name, finals[i], "velocity", outcome.Balls[i].Velocity);
                Assert.InRange(Vector3d.Distance(ReferenceCase.Vector(finals[i].GetProperty("spin")), outcome.Balls[i].Spin), 0, 1e-4);
            }

            JsonElement[] events = [.. expected.GetProperty("events").EnumerateArray()];
            Assert.Equal(events.Length, outcome.Events.Count);
            for (int i = 0; i < events.Length; i++)
            {
                BallEvent item = outcome.Events[i];
                Assert.Equal(events[i].GetProperty("ball").GetInt32(), item.Ball);
                Assert.Equal(events[i].GetProperty("surface").GetString(), item.OtherBall >= 0 ? $"ball {item.OtherBall}" : outcome.NameOf(item.ColliderIndex));
                Assert.InRange(item.Time - ReferenceCase.Number(events[i], "time"), -Close, Close);
                Near(name, events[i], "position", item.Position);
                Near(name, events[i], "velocity", item.Velocity);
                Near(name, events[i], "normal", item.Normal);
                balls += item.OtherBall >= 0 ? 1 : 0;
                if (events[i].TryGetProperty("impulse", out _))
                {
                    Near(name, events[i], "impulse", outcome.ImpulseOf(item)!.Value);
                    pushes++;
                }
            }
        }

        Assert.InRange(balls, 30, 60);
        Assert.InRange(pushes, 20, 60);
    }

    private static void Near(string name, JsonElement expected, string member, in Vector3d found)
    {
        double off = Vector3d.Distance(ReferenceCase.Vector(expected.GetProperty(member)), found);
        Assert.True(off <= Close * Math.Max(1, found.Length), $"{name}: {member} is {off:e2} off");
    }
}
