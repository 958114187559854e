using System.CommandLine;
using System.Globalization;
using System.Text;
using Football.Physics.Headless.Commands;
using Football.Physics.Headless.Input;
using Football.Physics.Headless.Json;
using Football.Physics.Headless.Schema;

namespace Football.Physics.Headless.Sweep;

/// <summary>football sweep: many launches drawn from ranges, flown to the first impact, one row each.</summary>
internal static class SweepCommand
{
    /// <summary>Rows that a thread makes before they are written.</summary>
    private const int Run = 4096;

    public static Command Create(Terminal terminal)
    {
        var command = new Command("sweep", "Draws launches from ranges, flies them to the first impact, and writes one JSON object a line.");
        var options = new SweepOptions();
        options.AddTo(command);
        command.SetAction(parsed => Sweep(
            Read(parsed.GetValue(options.File), parsed.GetValue(options.Set) ?? [], terminal),
            parsed.GetValue(options.Count),
            parsed.GetValue(options.Seed),
            parsed.GetValue(options.Shard) ?? (1, 1),
            (int)parsed.GetValue(options.Jobs),
            terminal));
        return command;
    }

    private static SweepScenario Read(string? file, FieldOverride[] overrides, Terminal terminal)
    {
        using Stream input = file is null ? new MemoryStream(Encoding.UTF8.GetBytes("{}")) : file == "-" ? terminal.Input : Open(file);
        InputLine text = new LineReader(input).ReadToEnd();
        var one = InputCase.Read(text.Text, text.Length, SweepScenario.Fields, overrides);
        return SweepScenario.Read(one.Scenario ?? throw one.Refusal!);
    }

    private static FileStream Open(string file)
    {
        try
        {
            return File.OpenRead(file);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            throw new RefusedException("FILE", $"{Quote.Short(file)}, which cannot be read", "a file that can be read, or - for the standard input");
        }
    }

    private static int Sweep(SweepScenario sweep, long count, long seed, (int Index, int Of) shard, int jobs, Terminal terminal)
    {
        // Parts that follow one another.
        long first = (long)((Int128)count * (shard.Index - 1) / shard.Of);
        long end = (long)((Int128)count * shard.Index / shard.Of);
        jobs = (int)Math.Max(1, Math.Min(jobs, (end - first + Run - 1) / Run));
        SweepWorker[] workers = [.. Enumerable.Range(0, jobs).Select(_ => new SweepWorker(sweep, seed, Run))];
        using var progress = new Progress(terminal);
        for (long from = first; from < end; from += (long)jobs * Run)
        {
            long start = from;
            int active = (int)Math.Min(jobs, (end - start + Run - 1) / Run);
            Parallel.For(0, active, i =>
            {
                long at = start + ((long)i * Run);
                workers[i].Run(at, (int)Math.Min(Run, end - at));
            });
            for (int i = 0; i < active; i++)
            {
                terminal.Output.Write(workers[i].Rows);
            }

            terminal.Output.Flush();
            progress.Report(() => string.Create(CultureInfo.InvariantCulture, $"{Math.Min(end, start + ((long)jobs * Run)) - first} of {end - first} rows"));
        }

        return ExitCode.Done;
    }
}
