using System.CommandLine;
using Football.Physics.Headless.Simulate;

namespace Football.Physics.Headless.Commands;

/// <summary>football simulate: plays the scenarios of a file.</summary>
internal static class SimulateCommand
{
    public static Command Create(Terminal terminal)
    {
        var command = new Command("simulate", "Plays a scenario, or a batch of them, and writes what became of the ball as JSON.");
        var options = new BatchOptions();
        options.AddTo(command);
        var runner = new BatchRunner(Scenario.Fields, (name, scenario) => ResultWriter.Result(name, ScenarioRun.Play(Scenario.Read(scenario))));
        command.SetAction(parsed => runner.Run(options, parsed, terminal));
        return command;
    }
}
