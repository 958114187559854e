using System.CommandLine;
using System.Text.Json;
using FootballPhysics.Tool.Gallery;
using FootballPhysics.Tool.Replay;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Commands;

/// <summary>football kick: simulates one kick given by numbers, without a file.</summary>
internal static class KickCommand
{
    private const double Duration = 120;

    public static Command Create(Terminal terminal)
    {
        Option<double> speed = Arguments.Number("--speed", "Ball speed", KickNumbers.Speeds, 25);
        Option<double> elevation = Arguments.Number("--elevation", "Angle above the horizontal", KickNumbers.Elevations, 15);
        Option<double> azimuth = Arguments.Number("--azimuth", "Angle to the left, seen by the kicker", KickNumbers.Azimuths, 0);
        Option<double> top = Arguments.Number("--top-spin", "Topspin (negative: backspin)", KickNumbers.Spins, 0);
        Option<double> side = Arguments.Number("--side-spin", "Sidespin (positive bends to the left)", KickNumbers.Spins, 0);
        Option<FieldOverride[]> profile = Arguments.Profile();
        Option<FieldOverride[]> set = Arguments.Set("air.wind=[3,0,0]");
        var json = new Option<bool>("--json") { Description = "Write JSON in a terminal, too." };
        var svg = new Option<string?>("--svg") { HelpName = "FILE", Description = "Draw the path from the side and from above." };
        var command = new ExampleCommand(
            "kick",
            "Simulate one kick given by speed, angles and spin",
            "football kick --speed 27 --elevation 12 --azimuth 5 --top-spin -10 --side-spin 60",
            "football kick --speed 30 --elevation 35 --set 'air.wind=[5,0,0]' --set ground.rollingFriction=0.1 --svg kick.svg",
            "football kick --speed 12 --elevation 0 --set stop.time=1 --json")
        {
            speed, elevation, azimuth, top, side, profile, set, json, svg,
        };
        command.Details = "The ball starts on the ground and is simulated until it rests. A terminal shows a table and a sketch.";
        command.SetAction(parsed =>
        {
            double Of(Option<double> option) => parsed.GetValue(option);
            using var file = OutputFile.Open("--svg", parsed.GetValue(svg));
            var kick = new KickNumbers(Of(speed), Of(elevation), Of(azimuth), Of(top), Of(side));
            return Run(kick, [.. parsed.GetRequiredValue(profile), .. parsed.GetRequiredValue(set)], parsed.GetValue(json), file, terminal);
        });
        return command;
    }

    private static int Run(KickNumbers kick, FieldOverride[] overrides, bool json, OutputFile? svg, Terminal terminal)
    {
        kick.Vectors(out Vector3d velocity, out Vector3d spin);
        JsonElement scenario = JsonSerializer.SerializeToElement(new
        {
            launch = new { position = SceneShapeJson.Parts(Vector3d.Zero), velocity = SceneShapeJson.Parts(velocity), spin = SceneShapeJson.Parts(spin) },
            stop = new { at = "rest", time = Duration },
        });
        var fields = new InputFields(FieldOverride.Apply(scenario, overrides));
        (Scenario shot, Flight flight) = Arguments.Refusing(fields, () =>
        {
            var read = Scenario.Read(fields);
            return (read, new Flight(read));
        });
        if (!json)
        {
            new ShotReport(shot, ViewFrame.Direction(1, 0, 0)).Print(terminal.PersonConsole, flight.Outcome);
        }

        if (json || terminal.OutputRedirected)
        {
            terminal.Output.Write(ResultWriter.Result(null, shot.Samples ? flight.Outcome : flight.Outcome with { Samples = null }).Span);
        }

        svg?.Write(ShotDrawing.Draw(new GalleryShot { Id = "kick", Name = kick.Text, About = "", Scenario = shot }, flight, null, []));
        return ExitCode.Done;
    }
}
