using System.CommandLine;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Tool.Fit;
using FootballPhysics.Tool.Fit.Reading;

namespace FootballPhysics.Tool.Follow;

/// <summary>football follow: follows a ball through a stream of points, a line of output per point.</summary>
internal sealed class FollowCommand
{
    private readonly Argument<string> _track = new("TRACK") { Description = "CSV of t, x, y, z as for fit --match; - reads standard input line by line." };
    private readonly Option<string?> _scene = new("--scene") { HelpName = "FILE", Description = "The scene: JSON with the members of a scenario." };
    private readonly Option<FieldOverride[]> _set = Arguments.Set("ball.type=modern");
    private readonly Option<double?> _noise = new("--noise") { HelpName = "M", Description = "Standard deviation of a coordinate, in metres; default 0.02." };
    private readonly Option<string?> _rate = new("--rate") { HelpName = "HZ", Description = "Frames a second, if the track has frame numbers." };
    private readonly Option<double?> _ahead = new("--ahead") { HelpName = "S", Description = "Seconds to predict; default 1." };
    private readonly Option<double?> _kicks = new("--kicks-per-second") { HelpName = "R", Description = "Expected kicks per second; default 0.3." };
    private readonly Option<string?> _unit = new("--unit") { HelpName = "UNIT", Description = "Unit of the positions, as for fit --match; default: found in a file, metres in a stream." };
    private readonly Option<string?> _timeUnit = new("--time-unit") { HelpName = "UNIT", Description = "Unit of the times: s, ms, us, ns or min." };
    private readonly Option<string?> _pitch = new("--pitch") { HelpName = "LxW", Description = "Metres of the pitch for --unit pitch and percent; default 105x68." };
    private readonly Option<string?> _y = new("--y") { HelpName = "SIDE", Description = "left or right, the side of x to which y points; default left." };
    private readonly Option<string?> _up = new("--up") { HelpName = "AXIS", Description = "z or y, the axis that points up; default: found in a file, z in a stream." };
    private readonly Option<string?> _decimal = new("--decimal") { HelpName = "MARK", Description = "point or comma, the decimal mark." };
    private readonly Option<string?> _columns = new("--columns") { HelpName = "T,X,Y,Z", Description = "Names, or numbers from 1, of the columns." };

    public static Command Create(Terminal terminal)
    {
        var self = new FollowCommand();
        var command = new ExampleCommand(
            "follow", "Follow a ball live: kicks, spin and the path ahead", "football follow TRACK.csv --noise 0.05", "football follow - --set ball.type=modern --ahead 0.5 < TRACK.csv")
        {
            self._track,
        };
        command.Details = "Writes one line of JSON per point, at once. A file is read by the rules of fit --match. A stream has no later lines to guess units from: pass --unit if it is not in metres.";
        foreach (Option option in (Option[])[self._scene, self._noise, self._rate, self._ahead, self._kicks, self._unit, self._timeUnit, self._pitch, self._y, self._up, self._decimal, self._columns, self._set])
        {
            command.Add(option);
        }

        command.SetAction(parsed => self.Run(parsed, terminal));
        return command;
    }

    private int Run(ParseResult parsed, Terminal terminal)
    {
        var defaults = new BallFilterSettings();
        double ahead = parsed.GetValue(_ahead) ?? 1;
        if (!(ahead is > 0 and <= 60))
        {
            throw new RefusedException("--ahead", FormattableString.Invariant($"{ahead}"), "seconds above 0, at most 60");
        }

        var format = TrackFormat.Of(
            parsed.GetValue(_unit), parsed.GetValue(_timeUnit), parsed.GetValue(_rate), parsed.GetValue(_pitch),
            parsed.GetValue(_y), parsed.GetValue(_up), parsed.GetValue(_decimal), parsed.GetValue(_columns));
        Scene scene = ReadScene(parsed, terminal);
        var settings = defaults with { Noise = parsed.GetValue(_noise) ?? defaults.Noise, KicksPerSecond = parsed.GetValue(_kicks) ?? defaults.KicksPerSecond };
        BallFilter filter = Refusing("", () => new BallFilter(scene, settings));
        string file = parsed.GetValue(_track)!;
        using Stream stream = Arguments.OpenInput(file, terminal);
        var path = new Trajectory();
        foreach ((long line, double time, Vector3d position) in Points(stream, file, format, scene, terminal))
        {
            Include(filter, line, time, position);
            terminal.Output.Write(FollowWriter.Line(filter, ahead, path).Span);
            terminal.Output.Flush();
        }

        return ExitCode.Done;
    }

    /// <summary>Reads a file by the rules of fit --match, and any other stream line by line. A file has no line numbers, because its points are sorted.</summary>
    private static IEnumerable<(long Line, double Time, Vector3d Position)> Points(Stream stream, string file, TrackFormat format, Scene scene, Terminal terminal)
    {
        if (file == "-" || !stream.CanSeek)
        {
            return new FollowLines(new StreamReader(stream), format, terminal.Person.WriteLine).Points();
        }

        return TrackReader.Reading(stream, terminal.Person.WriteLine, format, scene.Gravity).Points.Select(point => (0L, point.Time, point.Position));
    }

    private Scene ReadScene(ParseResult parsed, Terminal terminal)
    {
        byte[] text = "{}"u8.ToArray();
        if (parsed.GetValue(_scene) is { } file)
        {
            using Stream stream = Arguments.OpenInput(file, terminal);
            using var memory = new MemoryStream();
            stream.CopyTo(memory);
            text = memory.ToArray();
        }

        InputCase input = InputCase.Read(new InputLine(text, false), parsed.GetRequiredValue(_set));
        InputFields fields = input.Scenario ?? throw input.Refusal!;
        return Arguments.Refusing(fields, () =>
        {
            Scene scene = SceneInput.Scene(fields.Root);
            fields.Check();
            return scene;
        });
    }

    private static void Include(BallFilter filter, long line, double time, Vector3d position) => Refusing(line > 0 ? FormattableString.Invariant($"line {line}, ") : "", () =>
    {
        filter.Update(time, position);
        return filter;
    });

    /// <summary>Translates an error of the library to one of the command, after the line that has it.</summary>
    private static T Refusing<T>(string where, Func<T> work)
    {
        try
        {
            return work();
        }
        catch (ArgumentException e)
        {
            throw new RefusedException(where + LibraryRefusal.Sentence(e));
        }
    }
}
