using System.CommandLine;
using Football.Physics.Headless.Commands;

namespace Football.Physics.Headless.Aim;

/// <summary>football aim: finds the kicks that the scenarios of a file ask for.</summary>
internal static class AimCommand
{
    public static Command Create(Terminal terminal)
    {
        var command = new Command("aim", "Finds the kick that hits a target, or a batch of them, and writes it as JSON.");
        var options = new BatchOptions();
        options.AddTo(command);
        var runner = new BatchRunner(AimScenario.Fields, (name, scenario) => AimWriter.Result(name, AimRun.Find(AimScenario.Read(scenario))));
        command.SetAction(parsed => runner.Run(options, parsed, terminal));
        return command;
    }
}
