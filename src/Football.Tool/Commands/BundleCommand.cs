using System.CommandLine;
using System.Globalization;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Commands;

/// <summary>football bundle: replays a match that was attached to an issue.</summary>
internal static class BundleCommand
{
    public static Command Create(Terminal terminal)
    {
        var file = new Argument<string>("FILE") { Description = "Bundle that Recording.ToBundle wrote; - is standard input." };
        Option<long?> tick = Arguments.Whole("--tick", "Print the ball at this tick; default: the end of the match.", 0, 1_000_000_000_000_000);
        var command = new ExampleCommand(
            "bundle",
            "Replay a recorded match and check it bit for bit",
            "football bundle match.zip",
            "football bundle match.zip --tick 1200 | jq .ball.position")
        {
            file, tick,
        };
        command.Details = "If the replay diverges, it names the first tick and field that differ, and the exit code is 1.";
        command.SetAction(parsed =>
        {
            using Stream input = Arguments.OpenInput(parsed.GetRequiredValue(file), terminal);
            using var whole = new MemoryStream();
            CopyBounded(input, whole);
            return Report(MatchBundle.Read(whole), parsed.GetValue(tick), terminal);
        });
        return command;
    }

    /// <summary>Reads at most one byte more than a bundle may have; <see cref="MatchBundle.Read"/> rejects such a file.</summary>
    private static void CopyBounded(Stream input, MemoryStream whole)
    {
        byte[] part = new byte[64 * 1024];
        for (int read = input.Read(part); read > 0 && whole.Length <= MatchBundle.LargestFile; read = input.Read(part))
        {
            whole.Write(part, 0, read);
        }
    }

    private static int Report(MatchBundle bundle, long? requested, Terminal terminal)
    {
        Recording segment = bundle.Segment;
        long tick = requested ?? segment.EndTick;
        if (tick < segment.StartTick || tick > segment.EndTick)
        {
            throw new RefusedException("--tick", tick.ToString(CultureInfo.InvariantCulture), FormattableString.Invariant($"{segment.StartTick} … {segment.EndTick}"));
        }

        long? diverges = segment.FirstDivergence(bundle.NewSimulator());
        StateDifference? difference = diverges is { } first ? DifferenceAfter(bundle, first) : null;
        FixedStepRunner runner = segment.Replay(bundle.NewSimulator());
        segment.Seek(runner, tick);
        if (terminal.OutputRedirected)
        {
            terminal.Output.Write(ResultWriter.Line(json =>
            {
                json.WriteString("library", bundle.Library);
                json.WriteString("runtime", bundle.Runtime);
                json.WriteString("system", bundle.System);
                json.WriteNumber("from", segment.StartTick);
                json.WriteNumber("to", segment.EndTick);
                json.WriteNumber("kicks", segment.Kicks.Count);
                json.WriteBoolean("same", diverges is null);
                if (diverges is { } at)
                {
                    json.WriteNumber("firstDivergence", at);
                    json.WriteString("difference", difference?.ToString());
                }

                json.WriteNumber("tick", tick);
                json.WritePropertyName("ball");
                ResultWriter.WriteMoment(json, Moment.Of(runner.State));
            }).Span);
        }

        terminal.Person.WriteLine($"Recorded by {bundle.Library} on {bundle.Runtime}, {bundle.System}.");
        terminal.Person.WriteLine(FormattableString.Invariant($"Ticks {segment.StartTick} to {segment.EndTick}, {segment.Kicks.Count} kicks."));
        terminal.Person.WriteLine(diverges is { } differs
            ? FormattableString.Invariant($"Tick {differs} is the first that differs here{(difference is { } found ? $"; the next state in the recording, {found}" : "")}.")
            : "The same match, to the last bit.");
        terminal.Person.WriteLine(FormattableString.Invariant($"At tick {tick}: {runner.State}"));
        return diverges is null ? ExitCode.Done : ExitCode.Refused;
    }

    /// <summary>The difference in the first recorded state after a tick; null if the recording has none.</summary>
    private static StateDifference? DifferenceAfter(MatchBundle bundle, long tick)
    {
        Recording segment = bundle.Segment;
        long left = (tick - segment.StartTick) % Recording.KeyframeTicks;
        long keyframe = left == 0 ? tick : tick + Recording.KeyframeTicks - left;
        if (keyframe > segment.EndTick)
        {
            return null;
        }

        FixedStepRunner recorded = segment.Replay(bundle.NewSimulator());
        segment.Seek(recorded, keyframe);
        FixedStepRunner played = segment.Replay(bundle.NewSimulator());
        while (played.Tick < keyframe)
        {
            played.Step();
        }

        return Snapshot.Difference(recorded.State, played.State);
    }
}
