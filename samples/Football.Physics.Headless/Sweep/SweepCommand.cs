using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using Football.Physics.Headless.Commands;
using Football.Physics.Headless.Input;

namespace Football.Physics.Headless.Sweep;

/// <summary>football sweep: draws launches from ranges and flies them to the first impact, one row each.</summary>
internal static class SweepCommand
{
    /// <summary>Rows that a thread makes before they are written.</summary>
    private const int Run = 4096;

    /// <summary>Most rows of a sweep: up to there every index is exact.</summary>
    private const long MostRows = 1_000_000_000_000_000;

    private const int MostShards = 1_000_000;

    public static Command Create(Terminal terminal)
    {
        var file = new Argument<string?>("FILE")
        {
            Description = "The scene and the ranges to draw from, as JSON; - is the standard input. Without it: the defaults.",
            Arity = ArgumentArity.ZeroOrOne,
        };
        Option<long> count = Arguments.Whole("--count", "Rows of the whole sweep.", 1, MostRows, 1000);
        Option<long> seed = Arguments.Whole("--seed", "What the launches are drawn from, with a row's index.", 0, long.MaxValue, 1);
        Option<long> jobs = Arguments.Jobs("Threads; default: one a processor. The rows do not depend on it.");
        Option<FieldOverride[]> set = Arguments.Set("launch.speed=[20,25]");
        var shard = new Option<(int Index, int Of)>("--shard")
        {
            HelpName = "i/n",
            Description = "Only the i-th of n parts; all parts one after the other are the whole, byte for byte. Without it: all rows.",
            DefaultValueFactory = _ => (1, 1),
            CustomParser = ParseShard,
        };
        var command = new ExampleCommand(
            "sweep",
            "Draws launches from ranges, flies them to the first impact, and writes one JSON object a line.",
            "football sweep --count 10",
            "football sweep --count 1000 --seed 7 --set 'launch.speed=[20,30]' --set 'air.wind=[3,0,0]' --shard 1/2",
            """echo '{"launch": {"speed": [20, 25], "elevation": 12}}' | football sweep - --count 5""")
        {
            file, count, seed, shard, jobs, set,
        };
        command.SetAction(parsed => Sweep(
            Read(parsed.GetValue(file), parsed.GetRequiredValue(set), terminal),
            parsed.GetValue(count),
            parsed.GetValue(seed),
            parsed.GetValue(shard),
            (int)parsed.GetValue(jobs),
            terminal));
        return command;
    }

    private static (int Index, int Of) ParseShard(ArgumentResult result)
    {
        string text = result.Tokens[0].Value;
        string[] parts = text.Split('/');
        if (parts.Length == 2
            && int.TryParse(parts[0], NumberStyles.None, CultureInfo.InvariantCulture, out int index)
            && int.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out int of)
            && of <= MostShards && index >= 1 && index <= of)
        {
            return (index, of);
        }

        result.AddError($"--shard is {Quote.Short(text)}; allowed: i/n with n from 1 to {MostShards} and i from 1 to n, like 3/8.");
        return (1, 1);
    }

    private static SweepScenario Read(string? file, FieldOverride[] overrides, Terminal terminal)
    {
        using Stream input = file is null ? new MemoryStream("{}"u8.ToArray()) : Arguments.OpenInput(file, terminal);
        InputCase one = InputCase.Read(new LineReader(input).ReadToEnd(), overrides);
        InputFields fields = one.Scenario ?? throw one.Refusal!;
        try
        {
            return SweepScenario.Read(fields);
        }
        catch (ArgumentException refusal) when (LibraryRefusal.Of(refusal, fields) is { } said)
        {
            throw said;
        }
    }

    private static int Sweep(SweepScenario sweep, long count, long seed, (int Index, int Of) shard, int jobs, Terminal terminal)
    {
        // Parts that follow one another.
        long first = (long)((Int128)count * (shard.Index - 1) / shard.Of);
        long end = (long)((Int128)count * shard.Index / shard.Of);
        jobs = (int)Math.Max(1, Math.Min(jobs, (end - first + Run - 1) / Run));
        SweepWorker[] workers = [.. Enumerable.Range(0, jobs).Select(_ => new SweepWorker(sweep, seed, Run))];
        return Progress.Show(
            terminal,
            "rows",
            progress =>
            {
                for (long from = first; from < end; from += (long)jobs * Run)
                {
                    long start = from;
                    int active = (int)Math.Min(jobs, (end - start + Run - 1) / Run);
                    Parallel.For(0, active, i =>
                    {
                        long at = start + ((long)i * Run);
                        workers[i].Run(at, (int)Math.Min(Run, end - at));
                    });
                    foreach (SweepWorker worker in workers.Take(active))
                    {
                        terminal.Output.Write(worker.Rows);
                    }

                    terminal.Output.Flush();
                    progress.Report(Math.Min(end, start + ((long)jobs * Run)) - first, end - first);
                }

                return ExitCode.Done;
            },
            writes: true);
    }
}
