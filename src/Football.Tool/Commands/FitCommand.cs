using FootballPhysics.Scenarios.Input;
using System.CommandLine;
using FootballPhysics.Tool.Cameras;
using FootballPhysics.Tool.Fit;

namespace FootballPhysics.Tool.Commands;

/// <summary>football fit: estimates the launch of a ball, and parameters of the scene, from camera observations.</summary>
internal static class FitCommand
{
    private const string Example =
        """{"track": [{"time": 0, "position": [0, 0.11, 0]}, {"time": 0.2, "position": [0.6, 1.31, -4.2]}, {"time": 0.4, "position": [1.2, 2.12, -8.1]}, {"time": 0.6, "position": [1.8, 2.57, -11.8]}]}""";

    public static Command Create(Terminal terminal)
    {
        var match = new MatchCommand();
        var command = new ExampleCommand(
            "fit",
            "Estimate launch and spin from camera tracks",
            $"echo '{Example}' | football fit -",
            $"echo '{Example}' | football fit - --set fit.noise=0.05",
            "echo '{}' | football fit - --cameras CAMERAS.csv --pixels PIXELS.csv",
            "football fit --match TRACK.csv --ball modern --plot match.svg");
        command.Details = "The result has uncertainties. With cameras, the track has pixels. --match reads the track of a whole match and writes one line per flight, impact or touch.";
        match.AddTo(command);
        return new BatchRunner<TrackFitResult>(Find, FitWriter.Result, FitTable.Print)
        {
            Tables = [CameraTables.Cameras(), CameraTables.Pixels()],
        }
            .Of(command, terminal, (match.Option, (parsed, overrides, json) => match.Run(parsed, overrides, json, terminal)));
    }

    private static TrackFitResult Find(InputFields fields) => FitScenario.Read(fields).Find();
}
