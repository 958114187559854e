using System.CommandLine;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Tool.Aim;

/// <summary>football aim: finds the kicks for the scenarios of a file.</summary>
internal static class AimCommand
{
    private const string Request = """{"aim": {"from": [0, 0.11, 0], "target": [20, 1.5, 3], "speed": 25}}""";

    public static Command Create(Terminal terminal) =>
        new BatchRunner<AimAnswer>(fields => AimAnswer.To(AimScenario.Read(fields)), AimWriter.Result, (answer, shown) => AimTable.Print(answer.Kick, shown))
        .Of(
            new ExampleCommand(
                "aim",
                "Find the kick that hits a target",
                $"echo '{Request}' | football aim -",
                $"echo '{Request}' | football aim - --set aim.spin.side=30 --set aim.method=angle"),
            terminal);
}
