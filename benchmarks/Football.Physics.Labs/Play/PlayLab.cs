using System.CommandLine;
using System.Diagnostics;

namespace FootballPhysics.Labs.Play;

/// <summary>football lab play: compares tracks of real matches with the library's balls and surfaces; also simulated matches and damaged files.</summary>
internal static class PlayLab
{
    private static readonly double[] Noises = [0.005, 0.05];

    public static Lab Create()
    {
        var lab = new Lab(
            "play",
            "Fits of match tracks: your real ones with every ball and surface, simulated ones with known truth, and damaged files.",
            ["football lab play --matches 1 --damaged 2 --seed 7"]);
        Option<string[]> files = lab.Add(new Option<string[]>("--track")
        {
            HelpName = "FILE",
            Description = "Track of a real match as CSV (t, x, y, z); can be repeated.",
            DefaultValueFactory = _ => [],
        });
        Option<double?> altitude = lab.Add(new Option<double?>("--altitude") { HelpName = "M", Description = "Metres above sea level of those matches." });
        Option<bool> bounces = lab.Flag("--bounces", "Analyse only bounces, slides and rolls of the tracks, without comparing balls.");
        Option<long> matches = lab.Whole("--matches", "Simulated minutes per noise level.", 0, 1_000_000, 10);
        Option<long> damaged = lab.Whole("--damaged", "Number of damaged files.", 0, 10_000_000, 200);
        return lab.Plays(run =>
        {
            AddReal(run, run.Get(files)!, run.Get(altitude), run.Get(bounces));
            AddSimulated(run, run.Int(matches));
            AddDamaged(run, run.Int(damaged));
        });
    }

    private static void AddReal(LabRun run, string[] files, double? altitude, bool bounces)
    {
        if (files.Length == 0)
        {
            run.Notes.Add(
                "No track of a real match was given (--track), and none is shipped. Open ones: the test files of PySport/kloppy (Hawk-Eye, DFL, PFF), the DFL's seven matches (Bassek et al. 2025, Scientific Data 12, 195), SkillCorner's open data.");
            return;
        }

        var flights = new LabTable("Flights of real matches", "track", "ball", "fitted", "flights", "rms, cm", "covered, %", "drag", "crisis, Re", "verdict");
        var impacts = new LabTable(
            "Impacts of real matches: medians", "track", "along the ground", "surface", "impacts", "restitution", "kept", "friction", "off, restitution", "off, kept", "restitution is", "kept is");
        var windows = new LabTable("Slides and rolls of real matches", "track", "resistance", "windows", "m/s", "median", "least", "most", "together", "±", "default turf", "verdict");
        run.Tables.AddRange(bounces ? [impacts, windows] : [flights, impacts, windows]);
        foreach (string file in files)
        {
            RealTrack.Add(file, altitude, bounces ? null : flights, impacts, windows, run);
        }

        run.Notes.Add("To reach: modern at most 6 cm as it ships and 3 cm with its drag fitted; the default turf within 0.05 of the bounces of a track of millimetres, by classes, and 0.1 of one of centimetres; within two deviations of slides and rolls. A minute has a dozen impacts: a median of three is sure to about 0.05.");
    }

    private static void AddSimulated(LabRun run, int matches)
    {
        if (matches == 0)
        {
            return;
        }

        LabTable table = run.Table(
            "Simulated minutes", "noise, cm", "minutes", "flights", "found, %", "impacts found, %", "launches within the 95 % region, %", "wind and drag within 1.96 σ, %", "rms, cm", "s a minute", "verdict");
        foreach (double noise in Noises)
        {
            var check = new SyntheticCheck();
            long start = Stopwatch.GetTimestamp();
            double playing = 0;
            for (int i = 0; i < matches; i++)
            {
                run.Progress.Report(i, matches, () => "minutes");
                long before = Stopwatch.GetTimestamp();
                SyntheticMatch match = SyntheticMatch.Play(run.Random(i), noise);
                playing += Stopwatch.GetElapsedTime(before).TotalSeconds;
                check.Run(match);
            }

            double seconds = (Stopwatch.GetElapsedTime(start).TotalSeconds - playing) / matches;
            LabCounts counts = check.Counts;
            double found = counts.Percent("flights found", "flights");
            double within = counts.Percent("launches within", "launches");
            bool reached = found >= 95 && within >= 90;
            run.Failed |= !reached && matches >= 100;
            table.Add(
                100 * noise, matches, counts["flights"], found, counts.Percent("impacts found", "impacts"), within, counts.Percent("numbers within", "numbers"),
                100 * Math.Sqrt(check.Squares / matches), seconds, Verdict.Of(reached));
        }

        run.Notes.Add("Minutes of kicks, headers, bounces and rolls at 50 Hz, with gaps, seams of 2 to 10 cm, heights that are up to 8 cm wrong near the ground, and points that jump. To reach: 95 % of the flights of 0.3 s and longer that are seen whole and rise by five deviations, 80 % of them in common; velocity and spin within the box of 95 % in 90 %.");
    }

    private static void AddDamaged(LabRun run, int damaged)
    {
        if (damaged == 0)
        {
            return;
        }

        var check = new DamagedTracks();
        SyntheticMatch? match = null;
        for (int i = 0; i < damaged; i++)
        {
            run.Progress.Report(i, damaged, () => "damaged files");
            SeededRandom random = run.Random(7_000_001 + i);
            match = i % 50 == 0 ? SyntheticMatch.Play(random, 0.01) : match;
            check.Run(random, match!);
        }

        run.Table("Damaged files", "files", "fitted", "refused by the reader", "refused by the fit", "crashes", "slowest, s", "that file", "verdict").Judge(
            check.Faults.Count == 0, [damaged, .. check.Counts.Cells("fitted", "refused by the reader", "refused by the fit"), check.Faults.Count, check.Slowest.Most, check.Slowest.At]);
        run.Notes.AddRange(check.Faults.Distinct().Take(10));
    }
}
