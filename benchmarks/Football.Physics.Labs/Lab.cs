using System.Buffers;
using System.CommandLine;
using System.Text.Json;
using FootballPhysics.Labs.BankShots;
using FootballPhysics.Labs.Derivatives;
using FootballPhysics.Labs.Following;
using FootballPhysics.Labs.Forces;
using FootballPhysics.Labs.Goals;
using FootballPhysics.Labs.Groups;
using FootballPhysics.Labs.Intercept;
using FootballPhysics.Labs.Matches;
using FootballPhysics.Labs.Motions;
using FootballPhysics.Labs.Nets;
using FootballPhysics.Labs.Obstacles;
using FootballPhysics.Labs.Penalties;
using FootballPhysics.Labs.People;
using FootballPhysics.Labs.Peers;
using FootballPhysics.Labs.Pipes;
using FootballPhysics.Labs.Play;
using FootballPhysics.Labs.Queries;
using FootballPhysics.Labs.Rebounds;
using FootballPhysics.Labs.Scenes;
using FootballPhysics.Labs.Stress;
using FootballPhysics.Labs.Verdicts;
using FootballPhysics.Labs.Zones;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs;

/// <summary>The command of an experiment: its options, and the output of its report.</summary>
internal sealed class Lab
{
    private readonly ExampleCommand _command;
    private Action<LabRun> _play = _ => { };
    private readonly Option<long> _seed = Arguments.Whole("--seed", "Seed of the random values.", long.MinValue, long.MaxValue, 1);
    private readonly Option<string?> _json = new("--json") { HelpName = "FILE", Description = "Write the tables as JSON." };
    private readonly Option<string?> _csv = new("--csv") { HelpName = "FILE", Description = "Write the tables as CSV." };
    private readonly Option<string?> _plot = new("--plot") { HelpName = "FILE", Description = "Draw FILE.svg, or FILE.png if Chromium is installed." };

    /// <summary>Starts a command; the calls that follow add the options of the experiment itself.</summary>
    /// <param name="name">The name of the experiment.</param>
    /// <param name="description">Its purpose.</param>
    /// <param name="examples">The examples of its help.</param>
    /// <param name="isDrawn">True if the experiment has a picture.</param>
    public Lab(string name, string description, string[] examples, bool isDrawn = false)
    {
        _command = new ExampleCommand(name, description, examples) { _seed, _json, _csv };
        if (isDrawn)
        {
            _command.Add(_plot);
        }
    }

    /// <summary>Adds an option.</summary>
    public T Add<T>(T option)
        where T : Option
    {
        _command.Add(option);
        return option;
    }

    /// <summary>Creates an option for a whole number.</summary>
    public static Option<long> Number(string name, string description, long low, long high, long fallback) => Arguments.Whole(name, description, low, high, fallback);

    public Option<long> Whole(string name, string description, long low, long high, long fallback) => Add(Number(name, description, low, high, fallback));

    public Option<long?> WholeOrNone(string name, string description, long high) => Add(Arguments.Whole(name, description, 0, high));

    public Option<long> Jobs(string description) => Add(Arguments.Jobs(description));

    public Option<bool> Flag(string name, string description) => Add(new Option<bool>(name) { Description = description });

    /// <summary>Adds the option that runs a smaller sample of everything.</summary>
    public Option<bool> Quick() => Flag("--quick", "Run a small sample, only to check that the experiment works.");

    /// <summary>Adds the option that runs one part of the experiment.</summary>
    public Option<string?> Only(string helpName, string description, IEnumerable<string> names)
    {
        string[] all = [.. names];
        Option<string?> only = Add(new Option<string?>("--only") { HelpName = helpName, Description = $"{description}: {string.Join(", ", all)}." });
        Arguments.Among(only, all);
        return only;
    }

    /// <summary>Sets the experiment.</summary>
    public Lab Plays(Action<LabRun> play)
    {
        _play = play;
        return this;
    }

    /// <summary>Sets an experiment with one option, a number.</summary>
    public Lab Plays(Option<long> option, Action<LabRun, int> play)
    {
        Add(option);
        return Plays(run => play(run, run.Int(option)));
    }

    /// <summary>Sets an experiment whose option is a smaller sample.</summary>
    public Lab PlaysQuick(Action<LabRun, bool> play)
    {
        Option<bool> quick = Quick();
        return Plays(run => play(run, run.Get(quick)));
    }

    /// <summary>Returns the command.</summary>
    public Command Command(Terminal terminal)
    {
        _command.SetAction(parsed => Run(parsed, terminal));
        return _command;
    }

    private int Run(ParseResult parsed, Terminal terminal)
    {
        using PlotFile? plot = parsed.GetValue(_plot) is { } picture ? PlotFile.For(picture) : null;
        OutputFile.RefuseSame([], ("--json", parsed.GetValue(_json)), ("--csv", parsed.GetValue(_csv)));
        using var json = OutputFile.Open("--json", parsed.GetValue(_json));
        using var csv = OutputFile.Open("--csv", parsed.GetValue(_csv));
        LabRun run = Progress.Show(terminal, _command.Name, progress =>
        {
            var run = new LabRun(_command.Name, parsed.GetValue(_seed), progress, parsed, terminal);
            _play(run);
            return run;
        });
        foreach (LabTable table in run.Tables)
        {
            table.Print(terminal.PersonConsole);
        }

        foreach (string note in run.Notes)
        {
            terminal.Person.WriteLine(note);
        }

        ReadOnlyMemory<byte> document = Document(run);
        if (terminal.OutputRedirected)
        {
            terminal.Output.Write(document.Span);
        }

        json?.Write(document.Span);
        csv?.Write(string.Concat((run.Rows is { } rows ? [rows] : run.Tables).Select(table => table.Csv() + "\n")));
        if (plot is not null)
        {
            plot.Write(run.Picture?.Invoke() ?? throw new RefusedException($"--plot: there is nothing to draw of {run.Tables[0].Name}."));
            terminal.Person.WriteLine($"Picture: {plot.Path}");
        }

        return run.Failed ? ExitCode.Refused : ExitCode.Done;
    }

    private static ReadOnlyMemory<byte> Document(LabRun run)
    {
        var buffer = new ArrayBufferWriter<byte>();
        using (var json = new Utf8JsonWriter(buffer))
        {
            json.WriteStartObject();
            json.WriteString("lab", run.Name);
            json.WriteNumber("seed", run.Seed);
            json.WriteStartArray("tables");
            foreach (LabTable table in run.Tables)
            {
                table.WriteJson(json);
            }

            json.WriteEndArray();
            json.WritePropertyName("notes");
            JsonSerializer.Serialize(json, run.Notes);
            json.WriteEndObject();
        }

        buffer.Write("\n"u8);
        return buffer.WrittenMemory;
    }
}

/// <summary>football lab: the experiments that measure the library.</summary>
internal static class Laboratories
{
    public static Command Create(Terminal terminal)
    {
        var command = new ExampleCommand(
            "lab", "Run accuracy and stability experiments (needs a checkout)", "football lab", "football lab vacuum --seed 7 --csv vacuum.csv --plot vacuum.svg");
        foreach (Lab lab in (Lab[])
        [
            VacuumLab.Create(), ConsistencyLab.Create(), CostLab.Create(), PrecisionLab.Create(), StabilityLab.Create(), AimLab.Create(),
            AnswersLab.Create(), FuzzLab.Create(), BallsLab.Create(), KnuckleLab.Create(), BodiesLab.Create(), RigsLab.Create(), KicksLab.Create(), SweepLab.Create(),
            InterceptLab.Create(), DerivativesLab.Create(), BankShotLab.Create(), ScatterLab.Create(), FitLab.Create(), CameraLab.Create(),
            ObstaclesLab.Create(), GoalsLab.Create(), MatchesLab.Create(), PeersLab.Create(), PeopleLab.Create(), PlayLab.Create(), VerdictsLab.Create(), ScenesLab.Create(),
            StressLab.Create(), ZonesLab.Create(), GroupsLab.Create(), MotionsLab.Create(), NetsLab.Create(), PipesLab.Create(), ReboundsLab.Create(), ForcesLab.Create(), FollowLab.Create(), PenaltiesLab.Create(),
        ])
        {
            command.Add(lab.Command(terminal));
        }

        return command;
    }
}
