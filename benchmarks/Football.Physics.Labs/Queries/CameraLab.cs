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

/// <summary>football lab scatter: compares the scatter of random shots with kicks that are drawn and simulated one by one in double precision.</summary>
internal static class ScatterLab
{
    public static Lab Create()
    {
        var lab = new Lab(
            "scatter",
            "Chances to score, by derivatives or SIMD batches, compared with random kicks that are simulated one by one.",
            ["football lab scatter --shots 1 --kicks 200 --seed 7"]);
        Option<long> shots = lab.Whole("--shots", "Number of shots; every second one has a narrow spread.", 1, 1000, 6);
        Option<long> kicks = lab.Whole("--kicks", "Kicks simulated for each shot.", 100, 100_000_000, 400);
        return lab.Plays(run => Run(run, run.Int(shots), run.Int(kicks)));
    }

    private static void Run(LabRun run, int shots, int kicks)
    {
        LabTable table = run.Table(
            "Scatter of shots", "spread, °", "method", "in", "in, flown", "scores", "scores, flown", "aside σ, m", "flown", "height σ, m", "flown", "off, σ of the count", "verdict");
        var scatter = new GoalChance(Scene.Measured);
        var simulator = new Simulator(Scene.Measured);
        run.Each(shots, "shot", (random, i) =>
        {
            double size = i % 2 == 0 ? 0.35 : random.Uniform(1.5, 4);
            var spread = new KickSpread { SpeedPercent = 3 * size, ElevationDegrees = size, AzimuthDegrees = size, SpinPercent = 10 * size, SpeedWithElevation = -0.4 };
            var goal = new Goal { Center = new Vector3d(0, 0, -random.Uniform(11, 22)), Facing = new Vector3d(0, 0, 1) };
            var keeper = new Player { Position = goal.Center, Acceleration = 8, Speed = 5, Reach = 0.9, MaximumHeight = 2.5 };
            var velocity = new Vector3d(random.Uniform(-5, 5), random.Uniform(3, 5), -random.Uniform(20, 27));
            Vector3d spin = random.Uniform(0, 40) * random.Direction();
            var from = new Vector3d(0, 0.11, 0);
            GoalChanceResult found = scatter.Find(from, velocity, spin, spread, goal, keeper);
            GoalChanceResult flown = Fly(simulator, from, velocity, spin, spread, goal, keeper, kicks, run.Seed + i);
            double Off(double a, double b) => (a - b) / Math.Sqrt(Math.Max(1.0, b * (1 - b) * kicks)) * kicks;
            double off = Math.Max(Math.Abs(Off(found.OnTarget, flown.OnTarget)), Math.Abs(Off(found.Scores, flown.Scores)));
            bool close = Math.Abs(found.OnTarget - flown.OnTarget) < 0.01 && Math.Abs(found.Scores - flown.Scores) < 0.01;
            table.Add(
                size, found.Method, found.OnTarget, flown.OnTarget, found.Scores, flown.Scores, found.AsideDeviation, flown.AsideDeviation, found.HeightDeviation,
                flown.HeightDeviation, off, Verdict.Of(close || off < 4));
        });
        run.Notes.Add("Reached: both chances within 0.01 of those flown, or within four standard deviations of their count.");
    }

    /// <summary>Computes the same with the single ball in double precision, and numbers of another generator.</summary>
    private static GoalChanceResult Fly(
        Simulator simulator, Vector3d from, Vector3d velocity, Vector3d spin, KickSpread spread, Goal goal, Player keeper, int kicks, long seed)
    {
        var random = new SeededRandom(SeededRandom.Mix(seed, 77));
        var plane = new GoalPlane(goal, keeper);
        var kick = new SpreadKick(in from, in velocity, in spin);
        double[] factor = new double[KickSpread.Count * KickSpread.Count];
        spread.Factor(factor);
        var path = new Trajectory();
        var request = new LookAheadRequest { Duration = 15, UntilPlane = plane.Plane };
        var sum = new GoalChanceSum();
        var frame = new FramePlays(simulator.Scene with { Goals = [goal] }, goal);
        for (int k = 0; k < kicks; k++)
        {
            double[] normal = [.. Enumerable.Range(0, KickSpread.Count).Select(_ => random.Normal())];
            double[] by = [.. normal.Select((_, i) => Enumerable.Range(0, i + 1).Sum(j => factor[(i * normal.Length) + j] * normal[j]))];
            kick.With(by, out Vector3d v, out Vector3d w);
            BallState ball = simulator.Launch(from, v, w);
            simulator.LookAhead(in ball, request, path);
            PlaneCrossingPoint at = path.TryGetCrossing(plane.Plane, out PathPoint crossing) ? new PlaneCrossingPoint(crossing.Time, crossing.Position) : new PlaneCrossingPoint(-1, in from);
            sum.Add(in plane, in at, frame.GoesIn(in kick, in v, in w, in at, out bool hitsFrame), hitsFrame);
        }

        return sum.Result(kicks);
    }
}
