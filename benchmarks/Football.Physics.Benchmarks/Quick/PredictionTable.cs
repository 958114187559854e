using FootballPhysics.Labs;

namespace FootballPhysics.Benchmarks;

/// <summary>The rows of "Prediction", and their output.</summary>
internal static class PredictionTable
{
    private const int Seed = 1;
    private const int Count = 64;

    public static IReadOnlyList<PredictionRow> Rows { get; } =
    [
        Thesis("Method A, RK2 10 ms", AimMethod.Angle, 0.01, 120, "1.75 ms; 4.0 mm, worst 12"),
        Thesis("Method A, RK2 40 ms", AimMethod.Angle, 0.04, 35, "0.49 ms; 5.1 mm, worst 14"),
        new(
            "Method A, constant coefficients, semi-implicit 60 Hz",
            () => new ThesisAimer(AimSets.StudioScene, AimSets.StudioSettings, AimSets.StudioStep),
            () => AimSets.Studio(Seed, 4 * Count),
            AimMethod.Angle) { Target = 40, Thesis = "0.26 ms; 3.7 mm in its own integrator" },
        Thesis("Method B, RK2 10 ms", AimMethod.Bisection, 0.01, 280, "3.45 ms; 4.5 mm"),
        Thesis("Method B, RK2 40 ms", AimMethod.Bisection, 0.04, 80, "0.95 ms; 5 mm"),
        new("two-point, RK2 40 ms, both free kicks", () => Rk2(0.04), BothWalls, AimMethod.TwoPoint) { Target = 350, Thesis = "4.9 ms; 4.5–4.7 mm" },
        new("direct, one target, the thesis' kicks", () => new ThesisAimer(Scene.Published), () => AimSets.Thesis(Seed, Count), AimMethod.Direct) { Target = 13, Simulations = 2.5, Miss = 1e-3 },
        new("direct, two points, both free kicks", () => new ThesisAimer(Scene.Published), BothWalls, AimMethod.Direct) { Target = 26, Simulations = 4, Miss = 1e-3 },
        new("direct, two points within the spins' limits", () => new ThesisAimer(Scene.Published), () => AimSets.TwoPoint(Seed, Count), AimMethod.Direct)
        {
            Target = 26, Simulations = 4, Miss = 1e-3, ThroughMiss = 1e-2,
        },
        new("direct, one target, the thesis' kicks, miss measured", () => new ThesisAimer(Scene.Published), () => AimSets.Thesis(Seed, Count), AimMethod.Direct)
        {
            Target = 66, Miss = 1e-3, Question = (aimer, request) => aimer.Direct.Find(request),
        },
        new("FindSlowest, the thesis' kicks", () => new ThesisAimer(Scene.Published), () => AimSets.Thesis(Seed, Count), AimMethod.Direct)
        {
            Miss = 1e-3, Question = (aimer, request) => aimer.Direct.FindSlowest(request),
        },
        new("FindAtTime, the thesis' kicks at 1.3 times their time", () => new ThesisAimer(Scene.Published), () => AimSets.Thesis(Seed, Count), AimMethod.Direct)
        {
            Miss = 1e-3, Question = (aimer, request) => aimer.Direct.FindAtTime(request, 1.3 * (request.Target - request.From).Length / 22),
        },
        new("direct, verdict \"out of reach\"", () => new ThesisAimer(Scene.Published), () => AimSets.TooFar(Seed, Count), AimMethod.Direct) { Target = 90, OutOfReach = true },
    ];

    /// <summary>Times and measures all rows.</summary>
    public static void Print(Action<string> print, IReadOnlyList<PredictionRow> rows, double share)
    {
        Workload plain = Workloads.Plain(PlainLawKind.Published, Integrator.Rk2, ShotSets.Fast);
        (PredictionRow Row, Workload Subject)[] work = [.. rows.Select(row => (row, row.Subject()))];
        Stopwatching.WarmUp([plain, .. work.Select(w => w.Subject)]);
        print("");
        print("## Prediction");
        print("");
        print("The cost of an aim, in RK2 steps of `plain` in the same process. The true miss is the closest approach of the kick, simulated with RK4 at 5 ms; this check is not timed.");
        print("");
        print("| | µs | plain RK2 steps | reach | simulations | true miss, mm: mean | p95 | worst | at the point, worst | hit | out of reach | bytes | | thesis (Unity) |");
        print("|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|--:|");
        foreach ((PredictionRow row, Workload subject) in work)
        {
            print(Line(row, Stopwatching.Measure(subject, plain, share)));
        }
    }

    private static string Line(PredictionRow row, Timing time)
    {
        ThesisAimer aimer = row.Aimer();
        AimRequest[] requests = row.Requests();
        AimResult[] results = [.. requests.Select(request => row.Answer(aimer, request))];
        double[] misses = [.. results.Select(result => result.Miss).Order()];
        double simulations = results.Average(result => (double)result.Simulations);
        double? through = results.Max(result => result.WaypointMiss);
        int far = results.Count(result => result.Status == AimStatus.OutOfReach);
        bool reached = !(time.Ratio > row.Target) && !(simulations > row.Simulations) && !(misses[^1] > row.Miss) && !(through > row.ThroughMiss)
            && (!row.OutOfReach || far == results.Length);
        string verdict = row.Target is null ? "" : reached ? "reached" : "**missed**";
        double p95 = misses[Math.Max(0, (int)Math.Ceiling(0.95 * misses.Length) - 1)];
        int hits = results.Count(result => result.Status == AimStatus.Hit);
        return FormattableString.Invariant(
            $"| {row.Name} | {1e-3 * time.Nanoseconds:0.0} | {time.Ratio:0.0} | {Reach(row)} | {simulations:0.00} | {1e3 * misses.Average():0.000} | {1e3 * p95:0.000} | {1e3 * misses[^1]:0.000} | {(through is null ? "" : FormattableString.Invariant($"{1e3 * through:0.00}"))} | {hits} of {results.Length} | {far} | {time.Bytes:0} | {verdict} | {row.Thesis} |");
    }

    private static string Reach(PredictionRow row) => string.Join(", ", new[]
    {
        row.Target is { } steps ? FormattableString.Invariant($"≤ {steps}") : "",
        row.Simulations is { } simulations ? FormattableString.Invariant($"≤ {simulations} simulations") : "",
        row.Miss is { } miss ? FormattableString.Invariant($"≤ {1e3 * miss} mm") : "",
        row.ThroughMiss is { } through ? FormattableString.Invariant($"≤ {1e3 * through} mm at the point") : "",
    }.Where(part => part.Length > 0));

    private static ThesisAimer Rk2(double timeStep) => new(Scene.Published, new SolverSettings { Integrator = Integrator.Rk2 }, timeStep);

    private static AimRequest[] BothWalls() => [.. AimSets.AroundTheWall(41), .. AimSets.OverTheWall(41)];

    private static PredictionRow Thesis(string name, AimMethod method, double timeStep, double target, string thesis) =>
        new(name, () => Rk2(timeStep), () => AimSets.Thesis(Seed, Count), method) { Target = target, Thesis = thesis };
}
