using System.Text.Json;
using Football.Physics.Headless.Input;
using Football.Physics.Headless.Simulate;
using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Things;

/// <summary>Goals, nets, walls, things, slopes and bumps against trajectories computed by an independent solver.</summary>
public sealed class WorldReferenceTests
{
    public static TheoryData<Integrator, double> Methods() => new() { { Integrator.Rk4, 0.01 }, { Integrator.Rk4, 0.04 }, { Integrator.Rk2, 0.01 } };

    [Fact]
    public void All_cases_are_there() => Assert.Equal(118, Cases().Count());

    [Theory]
    [MemberData(nameof(Methods))]
    public void Every_event_happens_in_order_on_its_surface(Integrator integrator, double timeStep)
    {
        string[] wrong = [.. Cases().Select(line => Compare(line, integrator, timeStep).Events).OfType<string>()];
        Assert.True(wrong.Length == 0, string.Join('\n', wrong));
    }

    [Theory]
    [InlineData(0.01, 0)]
    [InlineData(0.04, 4)]
    public void Places_and_times_are_within_the_bound_of_each_case(double timeStep, int mayMiss)
    {
        string[] wrong = [.. Cases().Select(line => Compare(line, Integrator.Rk4, timeStep).Numbers).OfType<string>()];
        Assert.True(wrong.Length <= mayMiss, string.Join('\n', wrong));
    }

    private static IEnumerable<JsonElement> Cases() =>
        File.ReadLines(Path.Combine(AppContext.BaseDirectory, "Reference", "world.ndjson")).Select(line => JsonDocument.Parse(line).RootElement);

    private static (string? Events, string? Numbers) Compare(JsonElement line, Integrator integrator, double timeStep)
    {
        string name = line.GetProperty("name").GetString()!;
        JsonElement expected = line.GetProperty("expected");
        Scenario scenario = Scenario.Read(new InputFields(line.GetProperty("scenario"))) with
        {
            Settings = new SolverSettings { Integrator = integrator },
            TimeStep = timeStep,
        };
        Outcome outcome = ScenarioRun.Play(scenario);
        JsonElement[] wanted = [.. expected.GetProperty("events").EnumerateArray()];
        string[] kinds = [.. wanted.Select(item => $"{item.GetProperty("kind").GetString()}@{Surface(item)}")];
        string[] got = [.. outcome.Events.Select(item =>
            $"{item.Kind.ToString().ToLowerInvariant()}@{(item.Thing < 0 ? null : outcome.NameOf(item.Thing))}")];
        if (!kinds.SequenceEqual(got))
        {
            return ($"{name}: expected {string.Join(' ', kinds)}, got {string.Join(' ', got)}", null);
        }

        double bound = Math.Max(1e-6, 1e4 * expected.GetProperty("sensitivity").GetDouble());
        double time = wanted.Zip(outcome.Events, (a, b) => Math.Abs(a.GetProperty("time").GetDouble() - b.Time)).DefaultIfEmpty(0).Max();
        JsonElement place = expected.GetProperty("position");
        var end = new Vector3d(place[0].GetDouble(), place[1].GetDouble(), place[2].GetDouble());
        double off = Differences.Relative(outcome.Final.Position, end);
        return (null, time <= bound && off <= bound ? null : FormattableString.Invariant($"{name}: {off} m, {time} s; bound {bound}"));
    }

    private static string? Surface(JsonElement item) =>
        item.TryGetProperty("surface", out JsonElement surface) && surface.ValueKind == JsonValueKind.String ? surface.GetString() : null;
}
