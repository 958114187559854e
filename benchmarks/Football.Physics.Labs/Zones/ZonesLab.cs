using System.CommandLine;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Zones;

/// <summary>football lab zones: compares events of zones with dense samples of the path.</summary>
internal static class ZonesLab
{
    private const long Most = 10_000_000;

    public static Command Create(Terminal terminal)
    {
        var lab = new Lab(
            "zones",
            "Random kicks through zones of every shape, compared with a densely sampled path: each crossing is reported to within 1e-6 s, and no zone changes the path.",
            ["football lab zones", "football lab zones --paths 300 --seed 7"]);
        Option<long> paths = lab.Whole("--paths", "Kicks through zones.", 1, Most, 1000);
        return lab.Command(terminal, run => Run(run, run.Int(paths)));
    }

    private static void Run(LabRun run, int paths)
    {
        var plays = new ZonePlays();
        run.Each(paths, "path", (_, i) => plays.Play(run.Seed, i));
        LabTable claims = run.Table("Zones", "what", "count", "worst", "verdict");
        foreach (string row in (string[])["paths", .. ZoneDraw.Shapes.Select(shape => "events: " + shape), .. ZonePlays.Faults])
        {
            claims.Add(row, plays.Counts[row], null, ZonePlays.Faults.Contains(row) ? Say(plays.Counts[row] == 0) : null);
        }

        claims.Add("time of a crossing, s", null, plays.WorstTime, Say(plays.WorstTime <= ZonePlays.Allowed));
        claims.Add("distance of an event from the border or the path, m", null, plays.WorstPlace, null);
        claims.Add(ZonePlays.Grazes, plays.Counts[ZonePlays.Grazes], null, null);
        claims.Add(ZonePlays.Short, plays.Counts[ZonePlays.Short], null, null);
        run.Failed = plays.Failed;
        if (plays.Failed)
        {
            run.Notes.Add(FormattableString.Invariant($"First failure: path {plays.FirstFailure} of seed {run.Seed}."));
        }
    }

    private static string Say(bool holds) => holds ? "holds" : "fails";
}
