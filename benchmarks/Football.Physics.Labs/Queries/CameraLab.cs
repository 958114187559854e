using System.CommandLine;

namespace FootballPhysics.Labs.Queries;

/// <summary>football lab camera: launches found from pixels.</summary>
internal static class CameraLab
{
    private const double LeastSpins = 90;
    private const double LargestSpinError = 15;
    private const double Few = 0.18;

    private static readonly Kind[] s_kinds =
    [
        new("one, launch known to be on the ground", new CameraCheck(1, true), 10),
        new("one, kicks from the ground", new CameraCheck(1, false), 10),
        new("one, half of the flights in play", new CameraCheck(1, false, 0.5), 10),
        new("two, half of the flights in play", new CameraCheck(2, false, 0.5), 3),
        new("one, ten pictures, kicks from the ground", new CameraCheck(1, false, 0, Few), double.PositiveInfinity),
    ];

    public static Lab Create()
    {
        var lab = new Lab(
            "camera",
            "Fits of pixels from fixed cameras (25 m up, 60 m aside, 1920 × 1080 pixels, focal length 3000 pixels, 50 Hz, noise of 1 pixel): errors in space and of the spin.",
            ["football lab camera --flights 2 --seed 7"]);
        Option<long> flights = lab.Whole("--flights", "Flights of each kind.", 1, 1_000_000, 4);
        Option<long> jobs = lab.Jobs("Threads; default: one per processor.");
        return lab.Plays(run => Run(run, run.Int(flights), run.Int(jobs)));
    }

    private static void Run(LabRun run, int flights, int jobs)
    {
        LabTable table = run.Table(
            "Fits of pixels", "cameras", "flights", "rms, cm", "bound, cm", "spin within 15 rad/s, %", "depth given, %", "of these: rms, cm", "bound, cm ",
            "spin along velocity given, %", "given and off by 4 σ, %", "said to be doubtful, %", "worse than the truth", "verdict");
        LabTable limits = run.Table("By what the pixels contain", "cameras", "bounce seen", "flights", "rms, cm", "bound, cm", "depth given, %", "of these: rms, cm", "bound, cm ");
        foreach (Kind kind in s_kinds)
        {
            CameraFlight[] all = run.Parallel(flights, jobs, kind.Name, i => kind.Check.Run(run.Random(i)));
            double Share(Func<CameraFlight, bool> holds) => 100.0 * all.Count(holds) / all.Length;
            CameraFlight[] given = [.. all.Where(flight => flight.IsGood)];
            double rms = 100 * CameraFlight.Rms(given);
            double spins = Share(flight => flight.Spin <= LargestSpinError);
            table.Add(
                kind.Name, flights, 100 * CameraFlight.Rms(all), 100 * CameraFlight.Bound(all), spins, Share(flight => flight.HasDepth), rms, 100 * CameraFlight.Bound(given),
                Share(flight => !flight.Unidentified.Contains("spin.alongVelocity")), 100.0 * all.Sum(flight => flight.Wrong) / (9 * all.Length),
                Share(flight => flight.IsDoubtful), all.Count(flight => flight.Excess > 0.5), double.IsInfinity(kind.Most) ? "" : Verdict.Of(rms <= kind.Most && spins >= LeastSpins));
            foreach (bool bounces in (bool[])[true, false])
            {
                CameraFlight[] some = [.. all.Where(flight => flight.Bounces == bounces)];
                if (some.Length > 0)
                {
                    CameraFlight[] good = [.. some.Where(flight => flight.IsGood)];
                    limits.Add(
                        kind.Name, bounces ? "yes" : "no", some.Length, 100 * CameraFlight.Rms(some), 100 * CameraFlight.Bound(some), 100.0 * some.Count(flight => flight.HasDepth) / some.Length,
                        100 * CameraFlight.Rms(good), 100 * CameraFlight.Bound(good));
                }
            }
        }

        run.Notes.Add("Kicks from the ground: 14 to 28 m/s, 8 to 35° up, any azimuth, a spin of up to 60 rad/s about any axis, from 6 to 12 m before the centre of the image. In play: from 0.3 to 2.2 m up, 10 to 26 m/s, -5 to 35°. All bounces count that come before the ball leaves the image, or 3 s are over.");
        run.Notes.Add("Reached: where a fit gives the depth, the rms is at most 10 cm with one camera and 3 cm with two; and the spin of all flights is within 15 rad/s in 90 %.");
        run.Notes.Add("Bound: the rms of the best unbiased fit (Cramér and Rao), from derivatives at the true launch, with the prior knowledge that the fit has. A fit can be below it, because no launch is below the ground.");
        run.Notes.Add("A fit lists what its pixels do not reveal. The doubtful fits say so by their verdict. Worse than the truth: the number of fits with a higher cost than the true launch, which are other minima.");
    }

    /// <summary>A set of cameras and assumptions for the fits.</summary>
    private sealed record Kind(string Name, CameraCheck Check, double Most);
}
