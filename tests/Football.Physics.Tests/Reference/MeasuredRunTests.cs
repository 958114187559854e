using System.Text.Json;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Reference;

/// <summary>Whole runs of the measured profile, bounces, slides and rolls included, against an independent solver.</summary>
public sealed class MeasuredRunTests
{
    private static readonly IReadOnlyList<JsonElement> s_cases = [.. ReferenceCase.Lines("measured.ndjson")];

    [Fact]
    public void All_cases_are_there() => Assert.Equal(57, s_cases.Count);

    [Theory]
    [InlineData(Integrator.Rk4, 0.01, 1)]
    [InlineData(Integrator.Rk4, 0.04, 8)]
    [InlineData(Integrator.Rk2, 0.01, 1e4)]
    public void Every_event_and_the_end_are_within_the_bound_of_each_case(Integrator integrator, double timeStep, double bounds) =>
        WholeRun.HoldAll("measured.ndjson", integrator, timeStep, bounds);

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
