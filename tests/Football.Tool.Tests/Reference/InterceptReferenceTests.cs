using System.Text.Json;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Intercept;
using FootballPhysics.Tests.Reference;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tool.Tests.Reference;

/// <summary>Who meets the ball when, against windows computed by an independent solver.</summary>
public sealed class InterceptReferenceTests
{
    [Theory]
    [InlineData(0.01)]
    [InlineData(0.08)]
    public void No_window_is_lost_or_invented_and_who_is_first_is_right(double timeStep)
    {
        int windows = 0;
        foreach (JsonElement line in ReferenceCase.Lines("intercept.ndjson"))
        {
            string name = line.GetProperty("name").GetString()!;
            JsonElement expected = line.GetProperty("expected");
            InterceptScenario scenario = InterceptScenario.Read(new InputFields(line.GetProperty("scenario")));
            InterceptOutcome outcome = InterceptRun.Find(scenario with { Shot = scenario.Shot with { TimeStep = timeStep } });
            Assert.Equal(expected.GetProperty("first").GetString(), outcome.First < 0 ? null : scenario.Names[outcome.First]);
            foreach ((JsonElement runner, InterceptWindow[] found) in expected.GetProperty("runners").EnumerateArray().Zip(outcome.Windows))
            {
                JsonElement[] wanted = [.. runner.GetProperty("windows").EnumerateArray()];
                Assert.True(wanted.Length == found.Length, $"{name}, {runner.GetProperty("name")}: {wanted.Length} windows, found {found.Length}");
                foreach ((JsonElement window, InterceptWindow got) in wanted.Zip(found))
                {
                    windows++;
                    Assert.InRange(got.From - ReferenceCase.Number(window, "from"), -1e-5, 1e-5);
                    Assert.InRange(got.To - ReferenceCase.Number(window, "to"), -1e-5, 1e-5);
                    Assert.InRange(Differences.Relative(got.Position, ReferenceCase.Vector(window.GetProperty("position"))), 0, 1e-4);
                }
            }
        }

        Assert.Equal(244, windows);
    }
}
