using System.CommandLine;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Queries;

/// <summary>football lab camera: launches found from pixels.</summary>
internal static class CameraLab
{
    private const double LeastSpins = 90;
    private const double LargestSpinError = 15;

    private static readonly Kind[] s_kinds =
    [
        new("one, launch known to be on the ground", 1, true, 3, 10),
        new("one, nothing known", 1, false, 3, double.PositiveInfinity),
        new("two, nothing known", 2, false, 3, 3),
        new("one, ten pictures, nothing known", 1, false, 0.18, double.PositiveInfinity),
    ];

    public static Command Create(Terminal terminal)
    {
        Option<long> flights = Arguments.Whole("--flights", "Flights of each kind.", 1, 1_000_000, 4);
        return LabOptions.Create(
            "camera",
            "Fits of pixels from fixed cameras (25 m up, 60 m aside, 1920 × 1080 pixels, focal length 3000 pixels, 50 Hz, noise of 1 pixel): errors in space and of the spin.",
            ["football lab camera --flights 2 --seed 7"],
            terminal,
            (parsed, seed, progress) => Run(seed, (int)parsed.GetValue(flights), progress),
            flights);
    }

    private static LabReport Run(long seed, int flights, Progress progress)
    {
        var table = new LabTable(
            "Fits of pixels", "cameras", "flights", "rms in space, cm", "spin within 15 rad/s, %", "depth given, %", "of these: rms, cm", "spin along velocity given, %",
            "given and off by 4 σ, %", "said to be doubtful, %", "verdict");
        var report = new LabReport { Name = "camera", Seed = seed, Tables = { table } };
        foreach (Kind kind in s_kinds)
        {
            var check = new CameraCheck(kind.Cameras, kind.FromGround, kind.Longest);
            for (int i = 0; i < flights; i++)
            {
                progress.Report(i, flights, () => kind.Name);
                check.Run(new SeededRandom(SeededRandom.Mix(seed, i)));
            }

            List<CameraFlight> all = check.Flights;
            double Share(Func<CameraFlight, bool> holds) => 100.0 * all.Count(holds) / all.Count;
            double rms = 100 * CameraFlight.Rms(all);
            double spins = Share(flight => flight.Spin <= LargestSpinError);
            table.Add(
                kind.Name, flights, rms, spins, Share(flight => !flight.Unidentified.Contains("position.depth")), 100 * CameraFlight.Rms(all.Where(flight => flight.IsGood)),
                Share(flight => !flight.Unidentified.Contains("spin.alongVelocity")), 100.0 * all.Sum(flight => flight.Wrong) / (9 * all.Count),
                Share(flight => flight.Verdict is not (TrackVerdict.AsExpected or TrackVerdict.NoiseOverestimated)),
                double.IsInfinity(kind.Most) ? "" : Verdict.Of(rms <= kind.Most && spins >= LeastSpins));
        }

        report.Notes.Add("Reached: the rms of all flights is at most 10 cm with one camera and 3 cm with two, and the spin is within 15 rad/s in 90 % of the flights.");
        report.Notes.Add("A fit lists what its pixels do not reveal. The other numbers are given; the doubtful fits say so by their verdict.");
        return report;
    }

    /// <summary>A way to see and fit the flights.</summary>
    private sealed record Kind(string Name, int Cameras, bool FromGround, double Longest, double Most);
}
