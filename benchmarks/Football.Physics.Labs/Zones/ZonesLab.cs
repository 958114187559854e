using System.CommandLine;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Zones;

/// <summary>football lab zones: compares events of zones with dense samples of the path.</summary>
internal static class ZonesLab
{
    private const long Most = 10_000_000;

    public static Command Create(Terminal terminal)
    {
        Option<long> paths = Arguments.Whole("--paths", "Kicks through zones.", 1, Most, 1000);
        return LabOptions.Create(
            "zones",
            "Random kicks through zones of every shape, compared with a densely sampled path: each crossing is reported to within 1e-6 s, and no zone changes the path.",
            ["football lab zones", "football lab zones --paths 300 --seed 7"],
            terminal,
            (parsed, seed, progress) => Run(seed, (int)parsed.GetValue(paths), progress),
            paths);
    }

    private static LabReport Run(long seed, int paths, Progress progress)
    {
        var plays = new ZonePlays();
        for (int i = 0; i < paths; i++)
        {
            plays.Play(seed, i);
            progress.Report(i + 1, paths, () => FormattableString.Invariant($"path {i}"));
        }

        var claims = new LabTable("Zones", "what", "count", "worst", "verdict");
        claims.Add("paths", plays.Cases, null, null);
        for (int i = 0; i < ZoneDraw.Shapes.Length; i++)
        {
            claims.Add("events: " + ZoneDraw.Shapes[i], plays.Events[i], null, null);
        }

        claims.Add("crossings that were not reported", plays.Missed, null, Say(plays.Missed == 0));
        claims.Add("events without a crossing", plays.Wrong, null, Say(plays.Wrong == 0));
        claims.Add("events out of order", plays.Disordered, null, Say(plays.Disordered == 0));
        claims.Add("paths that zones changed", plays.Changed, null, Say(plays.Changed == 0));
        claims.Add("time of a crossing, s", null, plays.WorstTime, Say(plays.WorstTime <= ZonePlays.Allowed));
        claims.Add("distance of an event from the border or the path, m", null, plays.WorstPlace, null);
        claims.Add("grazes of less than 1e-8 m", plays.Grazes, null, null);
        claims.Add("visits between two samples, confirmed", plays.Short, null, null);
        var report = new LabReport { Name = "zones", Seed = seed, Tables = { claims }, Failed = plays.Failed };
        if (plays.Failed)
        {
            report.Notes.Add(FormattableString.Invariant($"First failure: path {plays.FirstFailure} of seed {seed}."));
        }

        return report;
    }

    private static string Say(bool holds) => holds ? "holds" : "fails";
}
