using System.CommandLine;
using FootballPhysics.Drawing;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Tool.Fit.Reading;

namespace FootballPhysics.Tool.Fit;

/// <summary>football fit --match: the analysis of a complete match track.</summary>
internal sealed class MatchCommand
{
    private static readonly string[] s_ofBatches = ["--batch", "--jobs", "--cameras", "--pixels"];

    private readonly Option<string?> _match = new("--match")
    {
        HelpName = "TRACK.csv",
        Description = "Fit the track of a whole match instead of FILE: CSV of t, x, y, z in most notations, or the layout of a provider (TRACAB, Sportec/DFL, Second Spectrum, Hawk-Eye, Stats Perform, SkillCorner, the Common Data Format); - is standard input.",
    };

    private readonly Option<string?> _ball = new("--ball") { HelpName = "TYPE", Description = "With --match: the ball, short for --set ball.type=TYPE, e.g. modern." };
    private readonly Option<double?> _altitude = new("--altitude") { HelpName = "M", Description = "With --match: metres above sea level, short for --set air.weather.altitude=M." };
    private readonly Option<double?> _temperature = new("--temperature") { HelpName = "C", Description = "With --match: degrees Celsius, short for --set air.weather.temperature=C." };

    private readonly Option<string?> _free = new("--free")
    {
        HelpName = "NAMES",
        Description = "With --match: quantities to estimate for the whole track: wind, drag (with its crisis), crisis, lift, surface, height, or none; default: wind,drag,surface,height.",
    };

    private readonly Option<string?> _plot = new("--plot") { HelpName = "FILE.svg", Description = "With --match: draw the track, the fit and their distances." };

    private readonly Option<string?> _unit = new("--unit") { HelpName = "UNIT", Description = "With --match: unit of the positions: m, cm, mm, km, ft, yd, in, pitch (0 to 1) or percent (0 to 100); default: found." };
    private readonly Option<string?> _timeUnit = new("--time-unit") { HelpName = "UNIT", Description = "With --match: unit of the times: s, ms, us, ns or min; default: found." };
    private readonly Option<string?> _rate = new("--rate") { HelpName = "HZ", Description = "With --match: frames a second, if the file has frame numbers; also a ratio, such as 30000/1001." };
    private readonly Option<string?> _pitch = new("--pitch") { HelpName = "LxW", Description = "With --match: metres of the pitch for --unit pitch and percent; default 105x68." };
    private readonly Option<string?> _y = new("--y") { HelpName = "SIDE", Description = "With --match: left or right, the side of x to which y points, seen from above; default left. The wrong side mirrors sidespins." };
    private readonly Option<string?> _up = new("--up") { HelpName = "AXIS", Description = "With --match: z or y, the axis that points up; default: found." };
    private readonly Option<string?> _decimal = new("--decimal") { HelpName = "MARK", Description = "With --match: point or comma, the decimal mark; default: found." };
    private readonly Option<string?> _columns = new("--columns") { HelpName = "T,X,Y,Z", Description = "With --match: names, or numbers from 1, of the columns; default: found." };

    private readonly Option<string?> _object = new("--object") { HelpName = "COLUMN=BALL", Description = "With --match: the column that names the object of a line, and the name of the ball in it; default: found, with the name ball." };
    private readonly Option<string?> _period = new("--period") { HelpName = "COLUMN", Description = "With --match: the column of the half; default: found." };
    private readonly Option<string?> _records = new("--records") { HelpName = "LIST", Description = "With --match: the list of moments in a JSON document, such as samples.ball; default: found." };
    private readonly Option<bool> _list = new("--list") { Description = "With --match: print the lists and columns of TRACK, and fit nothing." };

    private Option[] Own => [_ball, _altitude, _temperature, _free, _plot, _unit, _timeUnit, _rate, _pitch, _y, _up, _decimal, _columns, _object, _period, _records, _list];

    /// <summary>Adds the options to a command.</summary>
    public void AddTo(Command command)
    {
        command.Add(_match);
        foreach (Option option in Own)
        {
            command.Add(option);
        }

        command.Validators.Add(result =>
        {
            bool match = result.GetResult(_match) is not null;
            foreach (Option option in Own)
            {
                if (!match && result.GetResult(option) is not null)
                {
                    result.AddError($"{option.Name} requires --match.");
                }
            }

            // A match is a single track, and one thread fits it.
            foreach (Option option in match ? command.Options.Where(option => s_ofBatches.Contains(option.Name)) : [])
            {
                if (result.GetResult(option) is { Implicit: false })
                {
                    result.AddError($"{option.Name} cannot be combined with --match. Remove one of them.");
                }
            }
        });
    }

    public Option<string?> Option => _match;

    public int Run(ParseResult parsed, FieldOverride[] given, bool json, Terminal terminal)
    {
        string file = parsed.GetValue(_match)!;
        OutputFile.RefuseSame([file], ("--plot", parsed.GetValue(_plot)));
        MatchFitRequest request = Request(parsed.GetValue(_free));
        TrackFormat format = TrackFormat.Of(
            parsed.GetValue(_unit), parsed.GetValue(_timeUnit), parsed.GetValue(_rate), parsed.GetValue(_pitch),
            parsed.GetValue(_y), parsed.GetValue(_up), parsed.GetValue(_decimal), parsed.GetValue(_columns), parsed.GetValue(_object), parsed.GetValue(_period), parsed.GetValue(_records));
        if (parsed.GetValue(_list))
        {
            return List(file, format, terminal);
        }

        List<FieldOverride> overrides = [];
        void Set(string path, object? value)
        {
            if (value is not null)
            {
                overrides.Add(FieldOverride.Parse(FormattableString.Invariant($"{path}={value}"))!);
            }
        }

        Set("ball.type", parsed.GetValue(_ball));
        Set("air.weather.altitude", parsed.GetValue(_altitude));
        Set("air.weather.temperature", parsed.GetValue(_temperature));
        using var plot = OutputFile.Open("--plot", parsed.GetValue(_plot));
        InputCase input = InputCase.Read(new InputLine("{}"u8.ToArray(), false), [.. overrides, .. given]);
        InputFields fields = input.Scenario ?? throw input.Refusal!;
        Scene scene = Arguments.Refusing(fields, () =>
        {
            Scene taken = SceneInput.Scene(fields.Root);
            fields.Check();
            return taken;
        });

        // Print the guesses only after the track was read, because a rejected track prints one line.
        List<string> guesses = [];
        using Stream stream = Arguments.OpenInput(file, terminal);
        TrackReading reading = TrackReader.Reading(stream, guesses.Add, format, scene.Gravity);
        TrackPoint[] track = reading.Points;
        MatchFitResult fit = Arguments.Refusing(fields, () =>
        {
            MatchFitResult found = Progress.Show(terminal, "fit", progress => new MatchFit(scene).Find(track, request, new ProgressReport(progress)));
            UnitRivals.Check(scene, request, reading, found, guesses.Add);
            return found;
        });

        guesses.ForEach(terminal.Person.WriteLine);
        if (json)
        {
            foreach (MatchPiece piece in fit.Pieces)
            {
                terminal.Output.Write(MatchWriter.Piece(piece, fit).Span);
            }

            terminal.Output.Write(MatchWriter.Summary(fit).Span);
        }
        else
        {
            MatchTable.Print(fit, terminal);
        }

        terminal.Person.WriteLine(MatchTable.Summary(fit));
        plot?.Write(Svg.Standing("Fit of a match", MatchPicture.Draw(MatchTable.Summary(fit), fit)));
        return ExitCode.Done;
    }

    private static int List(string file, TrackFormat format, Terminal terminal)
    {
        using Stream track = Arguments.OpenInput(file, terminal);
        List<string> guesses = [];
        string[] lines = [.. TrackReader.Describe(track, format, guesses.Add)];
        guesses.ForEach(terminal.Person.WriteLine);
        terminal.Output.Write(System.Text.Encoding.UTF8.GetBytes(string.Join('\n', lines) + "\n"));
        return ExitCode.Done;
    }

    private static MatchFitRequest Request(string? free)
    {
        if (free is null)
        {
            return new MatchFitRequest();
        }

        string[] names = free == "none" ? [] : [.. free.Split(',').Select(name => name.Trim())];
        string? unknown = Array.Find(names, name => !FitInput.Free.Contains(name));
        return unknown is null
            ? FitInput.Match(names)
            : throw new RefusedException("--free", Quote.Short(unknown), string.Join(" | ", FitInput.Free) + " | none");
    }

    /// <summary>Reports the progress in the thread of the computation.</summary>
    private sealed class ProgressReport(Progress progress) : IProgress<double>
    {
        public void Report(double value) => progress.Report(value, 1);
    }
}
