using System.CommandLine;
using FootballPhysics.Tool.Intercept;

namespace FootballPhysics.Tool.Commands;

/// <summary>football intercept: computes which player reaches the ball first in each scenario of a file.</summary>
internal static class InterceptCommand
{
    private const string Example =
        """{"launch": {"position": [0, 0.11, 0], "velocity": [8, 7, -24]}, "stop": {"at": "time", "time": 3}, "runners": [{"name": "nine", "position": [10, 0, -30]}]}""";

    public static Command Create(Terminal terminal) =>
        new BatchRunner<InterceptOutcome>(fields => InterceptRun.Find(InterceptScenario.Read(fields)), InterceptWriter.Result, InterceptTable.Print)
        .Of(
            new ExampleCommand(
                "intercept",
                "Find which player reaches the ball first",
                $"echo '{Example}' | football intercept -",
                $"echo '{Example}' | football intercept - --set runners.0.speed=9"),
            terminal);
}
