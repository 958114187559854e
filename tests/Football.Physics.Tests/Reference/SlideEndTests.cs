using System.Text.Json;
using Football.Physics.Headless.Input;
using Football.Physics.Headless.Simulate;

namespace Football.Physics.Tests.Reference;

/// <summary>Ends of slides of the measured profile whose slip turns ever faster towards its end, against the plain laws.</summary>
public sealed class SlideEndTests
{
    [Theory]
    [InlineData("measured-life-033")]
    [InlineData("measured-windlife-041")]
    [InlineData("measured-ground-047")]
    [InlineData("measured-ground-048")]
    [InlineData("measured-ground-056")]
    [InlineData("measured-skim-066")]
    public void The_ball_rolls_where_the_slip_of_the_plain_laws_ends(string name)
    {
        JsonElement line = ReferenceCase.Lines("measured.ndjson").Single(item => item.GetProperty("name").GetString() == name);
        Scenario scenario = Scenario.Read(new InputFields(line.GetProperty("scenario"))) with { Settings = new SolverSettings { Integrator = Integrator.Rk4 } };
        BallEvent[] events = [.. ScenarioRun.Play(scenario).Events];
        int rolls = Array.FindIndex(events, item => item.Kind == BallEventKind.Roll);
        (double start, Vector3d position, Vector3d velocity, Vector3d spin) = rolls == 0
            ? (0, scenario.Position, scenario.Velocity, scenario.Spin)
            : (events[rolls - 1].Time, events[rolls - 1].Position, events[rolls - 1].Velocity, events[rolls - 1].Spin);
        (double time, Vector3d place, Vector3d end) = new PlainSlide(scenario.Scene).ToItsEnd(position, velocity, spin);
        Assert.Equal(start + time, events[rolls].Time, 1e-8);
        Assert.InRange(Vector3d.Distance(place, events[rolls].Position), 0, 1e-7);
        Assert.InRange(Vector3d.Distance(end, events[rolls].Velocity), 0, 1e-7);
    }
}
