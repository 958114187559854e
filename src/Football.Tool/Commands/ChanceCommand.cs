using System.CommandLine;
using FootballPhysics.Tool.Chance;

namespace FootballPhysics.Tool.Commands;

/// <summary>football chance: computes the probability of a goal for each shot of a file.</summary>
internal static class ChanceCommand
{
    private const string Example =
        """{"goals": [{"center": [0, 0, -20], "facing": [0, 0, 1]}], "launch": {"position": [0, 0.11, 0], "velocity": [2, 4, -24]}, "chance": {"keeper": {"position": [0, 0, -19.5], "heights": [0, 2.7], "reach": 1}, "spread": {"azimuthDegrees": 2}, "kicks": 500}}""";

    public static Command Create(Terminal terminal) =>
        new BatchRunner<GoalChanceResult>(ChanceRun.Find, ChanceRun.Line, ChanceRun.Print)
        .Of(
            new ExampleCommand(
                "chance",
                "Compute the probabilities of goal, save, post and wide",
                $"echo '{Example}' | football chance -",
                $"echo '{Example}' | football chance - --set chance.spread.azimuthDegrees=4"),
            terminal);
}
