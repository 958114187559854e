using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Reflection;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep.Formats;
using FootballPhysics.Tool.Sweep.Output;

namespace FootballPhysics.Tool.Sweep;

/// <summary>football sweep: draws launches or aims from ranges, simulates or solves them, and writes one row each.</summary>
internal static class SweepCommand
{
    /// <summary>The program and its version, which determine the bytes of the output.</summary>
    private static string Program { get; } =
        $"football {typeof(Simulator).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()?.InformationalVersion ?? "?"}";

    public static Command Create(Terminal terminal)
    {
        var file = new Argument<string?>("FILE")
        {
            Description = "Scene, ranges and columns of a row as JSON; - is standard input; default: the default scene and ranges.",
            Arity = ArgumentArity.ZeroOrOne,
        };
        Option<long> count = Arguments.Whole("--count", "Rows of the whole sweep, all shards together.", 1, Manifest.MostRows, 1000);
        Option<long> seed = Arguments.Whole("--seed", "Seed of the random values; the same seed gives the same rows.", 0, long.MaxValue, 1);
        Option<long> jobs = Arguments.Jobs("Threads; default: one per processor. The rows do not depend on it.");
        Option<FieldOverride[]> profile = Arguments.Profile();
        Option<FieldOverride[]> set = Arguments.Set("launch.speed=[20,25]");
        Option<FieldOverride[]> range = Arguments.Range("air.wind[0]=[-5,5]");
        var output = new Option<string?>("--out")
        {
            HelpName = "DIR",
            Description = "Write data files, a schema and a manifest to this folder, each shard to its own subfolder. Repeat the command to resume an interrupted run.",
        };
        var format = new Option<string>("--format")
        {
            HelpName = string.Join('|', RowFormat.Names),
            Description = "Format of the rows: JSON lines, CSV, or (with --out) one NumPy file per column or a Parquet file.",
            DefaultValueFactory = _ => RowFormat.Names[0],
        };
        Arguments.Among(format, RowFormat.Names);
        var shard = new Option<(int Index, int Of)>("--shard")
        {
            HelpName = "i/n",
            Description = "Only part i of n; the parts in order are the whole sweep, byte for byte; default: all rows.",
            CustomParser = ParseShard,
        };
        var verify = new Option<bool>("--verify")
        {
            Description = "Check the checksums of a finished folder; default: only that the files exist and have the right length.",
        };
        var command = new ExampleCommand(
            "sweep",
            "Generate data sets from parameter ranges",
            "football sweep --count 10",
            "football sweep --count 1000 --seed 7 --set 'launch.speed=[20,30]' --range 'air.wind[0]={\"normal\": [0, 3]}' --shard 1/2",
            """echo '{"launch": {"speed": [20, 25], "elevation": 12}}' | football sweep - --count 5 --format csv""",
            "football sweep --count 1000 --format npy --out rows && ls rows")
        {
            file, count, seed, shard, jobs, profile, set, range, output, format, verify, SweepMerge.Create(terminal),
        };
        command.Details = "It draws launches or aims at random, simulates or solves them, and writes one row each.";
        command.Validators.Add(result =>
        {
            if (result.GetValue(output) is null && result.GetValue(verify))
            {
                result.AddError("--verify requires --out DIR.");
            }

            if (result.GetValue(output) is null && result.GetValue(format) is "npy" or "parquet")
            {
                result.AddError($"--format is {result.GetValue(format)}; allowed: ndjson | csv, or npy | parquet with --out DIR.");
            }
        });
        command.SetAction(parsed =>
        {
            SweepPlan plan = Read(parsed.GetValue(file), [.. parsed.GetRequiredValue(profile), .. parsed.GetRequiredValue(set), .. parsed.GetRequiredValue(range)], parsed.GetValue(seed), terminal);
            var run = new SweepRun(plan, parsed.GetRequiredValue(format), (int)parsed.GetValue(jobs));
            (int index, int of) = parsed.GetValue(shard);
            if (parsed.GetValue(output) is { } into && parsed.GetValue(file) is { } read)
            {
                RefuseInput(read, of == 0 ? into : Path.Combine(into, new Shard(index, of, 0).Folder), run.Format);
            }

            return parsed.GetValue(output) is { } folder
                ? ToFolder(plan, run, of == 0 ? folder : Path.Combine(folder, new Shard(index, of, 0).Folder), new Shard(Math.Max(index, 1), Math.Max(of, 1), parsed.GetValue(count)), parsed.GetValue(verify), terminal)
                : ToOutput(run, new Shard(Math.Max(index, 1), Math.Max(of, 1), parsed.GetValue(count)), terminal);
        });
        return command;
    }

    private static (int Index, int Of) ParseShard(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        string[] parts = text.Split('/');
        if (parts.Length == 2
            && int.TryParse(parts[0], NumberStyles.None, CultureInfo.InvariantCulture, out int index)
            && int.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out int of)
            && of <= Manifest.MostShards && index >= 1 && index <= of)
        {
            return (index, of);
        }

        result.AddError($"--shard is {Quote.Short(text)}; allowed: i/n with n from 1 to {Manifest.MostShards} and i from 1 to n, like 3/8.");
        return (1, 1);
    }

    private static SweepPlan Read(string? file, FieldOverride[] overrides, long seed, Terminal terminal)
    {
        using Stream input = file is null ? new MemoryStream("{}"u8.ToArray()) : Arguments.OpenInput(file, terminal);
        InputCase one = InputCase.Read(new LineReader(input).ReadToEnd(), overrides);
        return SweepInput.Read(one.Scenario ?? throw one.Refusal!, seed);
    }

    /// <summary>Throws if an output in the folder would overwrite the input, under any name.</summary>
    private static void RefuseInput(string file, string folder, RowFormat format)
    {
        string[] names = [.. format.Files, Schema.Name, Manifest.Done, Manifest.Unfinished, Manifest.Done + Manifest.New, Manifest.Unfinished + Manifest.New];
        OutputFile.RefuseSameAs(file, [.. names.Select(name => ("--out", Path.Combine(folder, name)))]);
    }

    private static int ToOutput(SweepRun run, Shard shard, Terminal terminal) => Progress.Show(
        terminal,
        "rows",
        progress =>
        {
            // The outputs of consecutive parts share one header, when joined.
            using var sink = new StreamSink(terminal.Output, shard.Index == 1 ? run.Format.Header(0, shard.Rows) : [], run.NoRows);
            run.RunAsync(shard, sink, rows => progress.Report(rows, shard.Rows)).GetAwaiter().GetResult();
            if (SweepReport.Unknown(sink) is { } unknown)
            {
                terminal.Person.WriteLine(unknown);
            }

            return ExitCode.Done;
        },
        writes: true);

    private static int ToFolder(SweepPlan plan, SweepRun run, string folder, Shard shard, bool verifies, Terminal terminal)
    {
        var identity = new Identity(Program, run.Format.Name, plan.Seed, shard.Count, plan.Text);
        using var sink = FolderSink.Open(folder, identity, shard, run.Format, Schema.Text(run.Columns, run.Format), run.NoRows, TimeProvider.System, verifies);
        string line = Progress.Show(
            terminal,
            "rows",
            progress =>
            {
                var report = new SweepReport(terminal, progress, sink, shard.Rows);
                run.RunAsync(shard, sink, report.Show).GetAwaiter().GetResult();
                return report.Line(folder);
            });
        terminal.Person.WriteLine(line);
        return ExitCode.Done;
    }
}
