using System.CommandLine;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Replay;
using FootballPhysics.Tool.Replay.Gltf;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Commands;

/// <summary>football replay: writes shots as an animated page, and as a glTF scene for other programs.</summary>
internal static class ReplayCommand
{
    private const string Kick = """{"launch": {"position": [0, 0.11, 0], "velocity": [5, 7, -24], "spin": [0, 60, 0]}, "goals": [{"center": [0, 0, -22], "facing": [0, 0, 1]}]}""";
    private const string DefaultPage = "replay.html";

    public static Command Create(Terminal terminal)
    {
        var files = new Argument<string[]>("FILE") { Description = "JSON files with one scenario each; - is standard input.", Arity = ArgumentArity.OneOrMore };
        var page = new Option<string>("--output", "-o")
        {
            HelpName = "PAGE",
            Description = "Page to write, a single file that works offline.",
            DefaultValueFactory = _ => DefaultPage,
        };
        var gltf = new Option<string?>("--gltf") { HelpName = "FILE", Description = "Also write an animated glTF 2.0 file." };
        var svg = new Option<string?>("--svg") { HelpName = "FILE", Description = "Also write an animated SVG drawing, for pages without scripts." };
        Option<FieldOverride[]> profile = Arguments.Profile();
        Option<FieldOverride[]> set = Arguments.Set("stop.at=rest");
        var command = new ExampleCommand(
            "replay",
            "Write an animated page from scenarios",
            $"echo '{Kick}' | football replay - -o kick.html --set stop.at=rest",
            $"echo '{Kick}' | football replay - -o kick.html --gltf kick.gltf --svg kick.svg --set stop.at=time --set stop.time=3")
        {
            files, page, gltf, svg, profile, set,
        };
        command.Details = "The page shows the shots in 3D; you can turn the view, slow them down and stop them.";
        command.SetAction(parsed =>
        {
            OutputFile.RefuseSame(
                parsed.GetRequiredValue(files),
                ("--output", parsed.GetRequiredValue(page)),
                ("--gltf", parsed.GetValue(gltf)),
                ("--svg", parsed.GetValue(svg)));
            using OutputFile written = OutputFile.Open("--output", parsed.GetRequiredValue(page))!;
            using var scene = OutputFile.Open("--gltf", parsed.GetValue(gltf));
            using var drawing = OutputFile.Open("--svg", parsed.GetValue(svg));
            FieldOverride[] overrides = [.. parsed.GetRequiredValue(profile), .. parsed.GetRequiredValue(set), FieldOverride.Parse("samples=true")!];
            List<(string Name, Scenario Scenario, Outcome Outcome)> played = Play(parsed.GetRequiredValue(files), overrides, terminal);
            var picture = ReplayPicture.Of("replay", played.Count == 1 ? played[0].Name : "Replay", played);
            written.Write(ReplayPage.Html(picture.Name, [picture]));
            drawing?.Write(MovingDrawing.Draw(picture));
            scene?.Write(GltfFile.Text(picture));
            terminal.Person.WriteLine($"Page: {written.Path}");
            foreach ((string name, _, Outcome outcome) in terminal.OutputRedirected ? played : [])
            {
                terminal.Output.Write(ResultWriter.Result(name, outcome with { Samples = null, BallSamples = [] }).Span);
            }

            return ExitCode.Done;
        });
        return command;
    }

    private static List<(string Name, Scenario Scenario, Outcome Outcome)> Play(string[] files, FieldOverride[] overrides, Terminal terminal)
    {
        var played = new List<(string Name, Scenario Scenario, Outcome Outcome)>();
        foreach (string file in files)
        {
            using Stream input = Arguments.OpenInput(file, terminal);
            InputCase read = InputCase.Read(new LineReader(input).ReadToEnd(), overrides);
            InputFields fields = read.Scenario ?? throw read.Refusal!;
            played.Add(Arguments.Refusing(fields, () =>
            {
                var scenario = Scenario.Read(fields);
                string unnamed = scenario.Balls.Count > 0 ? FormattableString.Invariant($"{scenario.Balls.Count} balls") : KickNumbers.Of(scenario).Text;
                string name = read.Name ?? (file == "-" ? unnamed : Path.GetFileNameWithoutExtension(file));
                return (name, scenario, ScenarioRun.Play(scenario));
            }));
        }

        return played;
    }
}
