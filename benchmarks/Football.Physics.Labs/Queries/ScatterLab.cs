using System.CommandLine;

namespace FootballPhysics.Labs.Queries;

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
        double[] by = new double[KickSpread.Count];
        double[] normal = new double[KickSpread.Count];
        var path = new Trajectory();
        var request = new LookAheadRequest { Duration = 15, UntilPlane = plane.Plane };
        var sum = new GoalChanceSum();
        var frame = new FramePlays(simulator.Scene with { Goals = [goal] }, goal);
        for (int k = 0; k < kicks; k++)
        {
            for (int i = 0; i < normal.Length; i++)
            {
                normal[i] = random.Normal();
            }

            for (int i = 0; i < by.Length; i++)
            {
                by[i] = 0;
                for (int j = 0; j <= i; j++)
                {
                    by[i] += factor[(i * by.Length) + j] * normal[j];
                }
            }

            kick.With(by, out Vector3d v, out Vector3d w);
            BallState ball = simulator.Launch(from, v, w);
            simulator.LookAhead(in ball, request, path);
            PlaneCrossingPoint at = path.TryGetCrossing(plane.Plane, out PathPoint crossing) ? new PlaneCrossingPoint(crossing.Time, crossing.Position) : new PlaneCrossingPoint(-1, in from);
            sum.Add(in plane, in at, frame.GoesIn(in kick, in v, in w, in at));
        }

        return sum.Result(kicks);
    }
}
