using System.CommandLine;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Queries;

/// <summary>football lab camera: launches found from pixels.</summary>
internal static class CameraLab
{
    public static Command Create(Terminal terminal)
    {
        Option<long> flights = Arguments.Whole("--flights", "Flights of each kind.", 1, 1_000_000, 4);
        return LabOptions.Create(
            "camera",
            "Fits of pixels from fixed broadcast cameras (25 m up, 60 m aside, 1920 × 1080 pixels, focal length 3000 pixels, 50 Hz, noise of 1 pixel): errors in space and of the spin.",
            ["football lab camera --flights 2 --seed 7"],
            terminal,
            (parsed, seed, progress) => Run(seed, (int)parsed.GetValue(flights), progress),
            flights);
    }

    private static LabReport Run(long seed, int flights, Progress progress)
    {
        var table = new LabTable(
            "Fits of pixels", "cameras", "seen for, s", "flights", "rms in space, cm", "of nine in ten flights, cm", "spin within 15 rad/s, %", "across the velocity, %",
            "4 σ exceeded, %", "depth unidentified, %", "spin along velocity unidentified, %", "not converged", "verdict");
        var report = new LabReport { Name = "camera", Seed = seed, Tables = { table } };
        foreach ((int cameras, bool fromGround, double longest, double most) in ((int, bool, double, double)[])[(1, true, 3, 10), (1, false, 3, double.PositiveInfinity), (2, false, 3, 3), (1, false, 0.2, double.PositiveInfinity)])
        {
            var check = new CameraCheck(cameras, fromGround, longest);
            for (int i = 0; i < flights; i++)
            {
                progress.Report(i, flights, () => $"{cameras} cameras");
                check.Run(new SeededRandom(SeededRandom.Mix(seed, i)));
                if (Environment.GetEnvironmentVariable("CAMDEBUG") is not null) Console.Error.WriteLine($"{cameras} {fromGround} {longest} {i} {check.Flights[^1]} {string.Join(',', check.Flights[^1].Unidentified)}");
            }

            List<CameraFlight> all = check.Flights;
            double[] rms = [.. all.Select(flight => flight.Rms).Order()];
            double Share(Func<CameraFlight, bool> holds) => 100.0 * all.Count(holds) / all.Count;
            table.Add(
                cameras, longest, flights, 100 * check.Rms, 100 * rms[(int)(0.9 * (rms.Length - 1))], Share(flight => flight.Spin <= 15), Share(flight => flight.SpinAcross <= 15),
                100.0 * all.Sum(flight => flight.Wrong) / (9 * all.Count), Share(flight => flight.Unidentified.Contains("position.depth")),
                Share(flight => flight.Unidentified.Contains("spin.alongVelocity")), all.Count(flight => !flight.Converged), Verdict.Of(100 * check.Rms <= most));
        }

        return report;
    }
}
