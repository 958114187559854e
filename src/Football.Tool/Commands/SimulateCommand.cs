using System.CommandLine;
using FootballPhysics.Tool.Gallery;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Commands;

/// <summary>football simulate: simulates the scenarios of a file.</summary>
internal static class SimulateCommand
{
    private const string Launch = """{"launch": {"position": [0, 0.11, 0], "velocity": [8, 7, -24]}}""";

    public static Command Create(Terminal terminal) =>
        new BatchRunner<(Scenario Scenario, Outcome Outcome)>(
            fields =>
            {
                var scenario = Scenario.Read(fields);
                return (scenario, ScenarioRun.Play(scenario));
            },
            (name, played) => ResultWriter.Result(name, played.Outcome),
            (played, to) => new ShotReport(played.Scenario).Print(to.PersonConsole, played.Outcome))
        .Of(
            new ExampleCommand(
                "simulate",
                "Simulate scenarios from JSON",
                $"echo '{Launch}' | football simulate -",
                $"echo '{Launch}' | football simulate - --set stop.at=rest --set launch.velocity.1=9",
                $"echo '{{\"name\": \"one\", \"scenario\": {Launch}}}' | football simulate - --batch --jobs 2"),
            terminal);
}
