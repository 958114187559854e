using System.Text.Json;
using Football.Physics.Headless.Input;
using Football.Physics.Headless.Simulate;
using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Reference;

/// <summary>Whole runs of the measured profile, bounces, slides and rolls included, against an independent solver.</summary>
public sealed class MeasuredRunTests
{
    /// <summary>
    /// Slides whose slip turns by 0.5 rad and more before it ends: there the reference sees the end late, by so many seconds at most, in which its ball
    /// goes on without slip and without rolling resistance. <see cref="SlideEndTests"/> has the true ends.
    /// </summary>
    private static readonly Dictionary<string, double> s_lateRolls = new()
    {
        ["measured-life-033"] = 1e-5,
        ["measured-windlife-041"] = 5e-6,
        ["measured-ground-047"] = 4e-5,
        ["measured-ground-048"] = 4e-6,
        ["measured-ground-056"] = 1e-5,
        ["measured-skim-066"] = 8e-5,
    };

    private static readonly IReadOnlyList<JsonElement> s_cases = [.. ReferenceCase.Lines("measured.ndjson")];

    [Fact]
    public void All_cases_are_there() => Assert.Equal(66, s_cases.Count);

    [Theory]
    [InlineData(Integrator.Rk4, 0.01, 1e-6, 1e-4)]
    [InlineData(Integrator.Rk4, 0.04, 1e-4, 1e-3)]
    public void Every_event_happens_in_order_and_the_ball_ends_where_the_reference_says(Integrator integrator, double timeStep, double p95, double worst)
    {
        var places = new Errors("final place, m");
        var times = new Errors("times of events, s");
        foreach (JsonElement line in s_cases)
        {
            string name = line.GetProperty("name").GetString()!;
            JsonElement expected = line.GetProperty("expected");
            Outcome outcome = Play(line, integrator, timeStep);
            JsonElement[] events = [.. expected.GetProperty("events").EnumerateArray()];
            Assert.Equal(
                (name, string.Join(' ', events.Select(item => item.GetProperty("kind").GetString()))),
                (name, string.Join(' ', outcome.Events.Select(item => item.Kind.ToString().ToLowerInvariant()))));
            double time = events.Zip(outcome.Events, (a, b) => Math.Abs(a.GetProperty("time").GetDouble() - b.Time)).DefaultIfEmpty(0).Max();
            double place = Vector3d.Distance(outcome.Final.Position, ReferenceCase.Vector(expected.GetProperty("position")));
            bool late = s_lateRolls.TryGetValue(name, out double lateness);

            // So much later, at some metres a second, the ball is so much further.
            Assert.True(!late || (time <= lateness && place <= 5 * lateness), $"{name}: {time} s, {place} m");
            times.Add(name, late ? 0 : time);
            places.Add(name, late ? 0 : place);
        }

        times.Hold(p95: p95, worst: worst);
        places.Hold(p95: p95, worst: worst);
    }

    [Fact]
    public void Rk4_is_of_fourth_order_through_bounces_slides_and_rolls()
    {
        List<double> orders = [];
        foreach (JsonElement line in s_cases.Where(line => line.GetProperty("name").GetString()!.Contains("-life-", StringComparison.Ordinal)))
        {
            Vector3d exact = Play(line, Integrator.Rk4, 0.00125).Final.Position;
            orders.Add(Order.Observed(0.04, 2, step => 1e-12 + Vector3d.Distance(Play(line, Integrator.Rk4, step).Final.Position, exact)));
        }

        Order.Hold("final place, RK4, 40 … 10 ms", orders, 3.6, 4.6);
    }

    private static Outcome Play(JsonElement line, Integrator integrator, double timeStep) => ScenarioRun.Play(
        Scenario.Read(new InputFields(line.GetProperty("scenario"))) with { Settings = new SolverSettings { Integrator = integrator }, TimeStep = timeStep });
}
