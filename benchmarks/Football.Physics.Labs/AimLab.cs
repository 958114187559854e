using System.CommandLine;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Drawing;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Labs;

/// <summary>football lab aim: runs the thesis' experiments with predictors, and the library's own solver on the same requests.</summary>
internal static class AimLab
{
    private const int Requests = 10_000;
    private const int ScanEvery = 4;

    public static Command Create(Terminal terminal)
    {
        Option<bool> quick = LabOptions.Quick();
        var full = new Option<bool>("--full")
        {
            Description = "Compare every random request that was not hit with the dense scan, not one in four.",
        };
        var profiles = new Option<bool>("--profiles") { Description = "Only the random requests, in both profiles, with weather, wind by height and gusts." };
        return LabOptions.CreateDrawn(
            "aim",
            "Aims of the original thesis (tests 4.1.3, 4.2.3 and 4.3.2), and 10 000 random requests compared with a dense scan. The CSV lists every kick.",
            ["football lab aim --quick --csv kicks.csv", "football lab aim --profiles --quick"],
            terminal,
            (parsed, seed, progress) => parsed.GetValue(profiles)
                ? ProfileAims.Run(unchecked((int)seed), parsed.GetValue(quick) ? Requests / 20 : Requests, progress)
                : Run(unchecked((int)seed), parsed.GetValue(quick), parsed.GetValue(full), progress),
            quick,
            full,
            profiles);
    }

    private static LabReport Run(int seed, bool quick, bool full, Progress progress)
    {
        var experiments = new AimExperiments(seed, quick);
        var sections = new List<AimSection>();
        foreach ((string name, Func<IEnumerable<AimSection>> make) in new (string, Func<IEnumerable<AimSection>>)[]
        {
            ("4.1.3, Method A", () => [experiments.MethodA()]),
            ("4.1.3, high elevations", () => [experiments.HighElevations()]),
            ("4.1.3, the studio's setting", () => [experiments.Studio()]),
            ("4.2.3, Method B", () => [experiments.MethodB()]),
            ("4.3.2, two points", experiments.TwoPoints),
            ("two points, out of reach", () => [experiments.Targets()]),
        })
        {
            progress.Report(() => name);
            sections.AddRange(make());
        }

        int count = quick ? Requests / 20 : Requests;
        var verdicts = AimVerdicts.Of(seed, count, full ? 1 : ScanEvery, done => progress.Report(done, count, () => "random requests"));
        return Report(seed, sections, verdicts);
    }

    private static LabReport Report(int seed, List<AimSection> sections, AimVerdicts verdicts)
    {
        var report = new LabReport
        {
            Name = "aim",
            Seed = seed,
            Failed = !verdicts.Hold || sections.Any(section => section.Rows.Any(row => row.Reach is { Reached: false })),
            Rows = new LabTable(
                "kick",
                "section", "method", "distance", "speed", "status", "miss", "throughMiss", "elevation", "top", "side", "iterations", "simulations", "microseconds"),
            Picture = () => Figure.Stack(
                "Aiming", [.. sections.Where(section => section.Charts.Count > 0).Select(section => Figure.Tile(section.Title, section.Charts))]),
        };
        foreach (AimSection section in sections)
        {
            var table = new LabTable(section.Title, AimRow.Columns);
            report.Tables.Add(table);
            foreach (AimRow row in section.Rows)
            {
                table.Add(row.Cells);
                foreach (AimShot shot in row.Shots)
                {
                    report.Rows.Add(
                        section.Title, row.Name, shot.Distance, shot.Request.Speed, Words.Of(shot.Result.Status), shot.Miss, shot.Result.WaypointMiss,
                        shot.Elevation, shot.TopSpin, shot.SideSpin, shot.Result.Iterations, shot.Result.Simulations, shot.Microseconds);
                }
            }

            if (section.Remark.Length > 0)
            {
                report.Notes.Add($"{section.Title}: {section.Remark}");
            }
        }

        report.Tables.Add(verdicts.Table());
        report.Notes.AddRange(verdicts.Examples);
        return report;
    }
}
