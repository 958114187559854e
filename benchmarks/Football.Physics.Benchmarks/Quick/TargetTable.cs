using System.Globalization;

namespace FootballPhysics.Benchmarks;

/// <summary>The rows of "Time for one ball".</summary>
internal static class TargetTable
{
    private const double H = ShotSets.TimeStep;
    private static readonly IReadOnlyList<Shot> Fast = ShotSets.Fast;
    private static readonly IReadOnlyList<Shot> Mixed = ShotSets.Mixed;

    public static IReadOnlyList<TargetRow> Rows { get; } =
    [
        Flight("Euler", Integrator.Euler, "fast", Fast, 0.26, "11.2 µs"),
        Flight("semi-implicit Euler", Integrator.SemiImplicitEuler, "fast", Fast, 0.26, "12.0 µs"),
        Flight("RK2", Integrator.Rk2, "fast", Fast, 0.23, "14.7 µs"),
        Flight("RK4", Integrator.Rk4, "fast", Fast, 0.22, "20.9 µs"),
        Flight("Euler", Integrator.Euler, "mixed", Mixed, 0.30, "–"),
        Flight("semi-implicit Euler", Integrator.SemiImplicitEuler, "mixed", Mixed, 0.30, "–"),
        Flight("RK2", Integrator.Rk2, "mixed", Mixed, 0.30, "–"),
        Flight("RK4", Integrator.Rk4, "mixed", Mixed, 0.30, "–"),
        Flight("RK4 without 512-bit registers", Integrator.Rk4, "fast", Fast, 0.25, "–") with { Without512Bit = true },
        new("constant coefficients, RK2, of plain all-forces RK2", () => Workloads.Flight(PlainFlight.SceneOf(PlainLawKind.Constant), Integrator.Rk2, Fast), PlainRk2)
        {
            Target = 0.17,
            Error = () => Errors.Landing(Integrator.Rk2, PlainLawKind.Constant, H, Fast),
        },
        new("vacuum, RK2, of plain all-forces RK2", () => Workloads.Flight(Scene.Vacuum, Integrator.Rk2, Fast), PlainRk2)
        {
            Target = 0.03,
            Error = () => Errors.Landing(Integrator.Rk2, PlainLawKind.Vacuum, H, Fast),
        },
        new("stopped ball, of plain all-forces RK2", () => Workloads.Stopped(Integrator.Rk2), PlainRk2) { Target = 0.006, Thesis = "\"paused\"" },
        .. LookAhead("RK4, 40 ms steps", Integrator.Rk4, 0.04),
        .. LookAhead("RK4, 80 ms steps", Integrator.Rk4, 0.08, 32),
        .. LookAhead("RK4, 10 ms steps", Integrator.Rk4, 0.01),
        .. LookAhead("RK2, 10 ms steps", Integrator.Rk2, 0.01),
        .. Impact("RK2", Integrator.Rk2),
        .. Impact("RK4", Integrator.Rk4),
        Independent("RK2", Integrator.Rk2),
        Independent("RK4", Integrator.Rk4),
        Regularised("RK2", Integrator.Rk2),
        Regularised("RK4", Integrator.Rk4),
        OfPublished("fast: RK2", Integrator.Rk2, Fast),
        OfPublished("fast: RK4", Integrator.Rk4, Fast),
        OfPublished("mixed: RK2", Integrator.Rk2, Mixed),
        OfPublished("mixed: RK4", Integrator.Rk4, Mixed),
        Thesis("Euler", Integrator.Euler, "11.2 µs"),
        Thesis("RK2", Integrator.Rk2, "14.7 µs"),
        Thesis("RK4", Integrator.Rk4, "20.9 µs"),
        MathNet("RK2 (Heun)", Integrator.Rk2),
        MathNet("RK4", Integrator.Rk4),
        new("a rigid-body engine's way, 60 Hz (no curl, no drag law)", () => Workloads.Engine(Fast), PlainRk2)
        {
            Error = () => Errors.EngineLanding(1.0 / RigidBodyEngine.FrameRate, Fast),
        },
        .. BatchRows.All,
        .. QueryRows.All,
        .. MeasuredRows.All,
    ];

    /// <summary>Times the rows.</summary>
    public static void Print(Action<string> print, IReadOnlyList<TargetRow> rows, double share)
    {
        (TargetRow Row, Workload Subject, Workload Yardstick)[] work = [.. rows.Select(row => (row, row.Subject(), row.Yardstick()))];
        Stopwatching.WarmUp([.. work.SelectMany(w => new[] { w.Subject, w.Yardstick })]);
        print("");
        print("## Time for one ball");
        print("");
        print("10 ms steps through the public `Simulator.Step`, with events, and with the jump of the drag law located.");
        print("Error: the mean distance between the landings (for a look-ahead: the ends) and those of RK4 at 0.5 ms.");
        print("");
        print("| | ns | yardstick, ns | ratio | reach | | bytes | error | thesis (Unity) |");
        print("|---|--:|--:|--:|--:|---|--:|--:|--:|");
        foreach ((TargetRow row, Workload subject, Workload yardstick) in work)
        {
            Timing time = row.Without512Bit ? InChild(row) : Stopwatching.Measure(subject, yardstick, share);
            string verdict = row.Target is { } target ? (time.Ratio <= target ? "reached" : "**missed**") : "";
            string reach = row.Target is { } t ? $"≤ {Text.Number(t)}" : "";
            string error = row.Error is { } of ? Text.Length(of()) + (row.Note is { } note ? ", " + note() : "") : "";
            print($"| {row.Name} | {Text.Number(time.Nanoseconds)} | {Text.Number(time.YardstickNanoseconds)} | {Text.Number(time.Ratio)} | {reach} | {verdict} | {Text.Number(time.Bytes)} | {error} | {row.Thesis} |");
        }
    }

    private static Workload PlainRk2() => Workloads.Plain(PlainLawKind.Published, Integrator.Rk2, Fast);

    private static TargetRow Flight(string name, Integrator integrator, string set, IReadOnlyList<Shot> shots, double target, string thesis) =>
        new($"flight step, {set}: {name}", () => Workloads.Flight(Scene.Published, integrator, shots), () => Workloads.Plain(PlainLawKind.Published, integrator, shots))
        {
            Target = target,
            Thesis = thesis,
            Error = () => Errors.Landing(integrator, PlainLawKind.Published, H, shots),
        };

    /// <summary>Returns the rows in the default scene, and in the published one.</summary>
    private static IEnumerable<TargetRow> LookAhead(string name, Integrator integrator, double h, double? target = null) =>
        Scenes().Select(of => new TargetRow($"3 s look-ahead, {of.Name}, {name}, in plain RK2 steps", () => Workloads.LookAhead(of.Scene, integrator, h), PlainRk2)
        {
            Target = of.Scene == Scene.Published ? null : target,
            Error = () => Errors.LookAhead(of.Scene, integrator, h, Mixed),
        });

    private static IEnumerable<TargetRow> Impact(string name, Integrator integrator) =>
        Scenes().Select(of => new TargetRow($"step with an impact in it, {of.Name}, {name}, in plain RK2 steps", () => Workloads.Impacts(of.Scene, integrator), PlainRk2));

    private static (string Name, Scene Scene)[] Scenes() => [("default scene", new Scene()), ("published", Scene.Published)];

    private static TargetRow Independent(string name, Integrator integrator) =>
        new(
            $"independent flight steps, fast: {name}",
            () => Workloads.Independent(Scene.Published, integrator, Fast),
            () => Workloads.PlainIndependent(PlainLawKind.Published, integrator, Fast));

    private static TargetRow Regularised(string name, Integrator integrator) =>
        new(
            $"regularised law, mixed: {name}",
            () => Workloads.Flight(PlainFlight.SceneOf(PlainLawKind.Regularised), integrator, Mixed),
            () => Workloads.Plain(PlainLawKind.Regularised, integrator, Mixed))
        {
            Error = () => Errors.Landing(integrator, PlainLawKind.Regularised, H, Mixed),
        };

    private static TargetRow OfPublished(string name, Integrator integrator, IReadOnlyList<Shot> shots) =>
        new(
            $"regularised law, of the published law, {name}",
            () => Workloads.Flight(PlainFlight.SceneOf(PlainLawKind.Regularised), integrator, shots),
            () => Workloads.Flight(Scene.Published, integrator, shots))
        {
            Target = 1.3,
        };

    private static TargetRow Thesis(string name, Integrator integrator, string thesis) =>
        new($"the thesis' way, fast: {name}", () => Workloads.Thesis(integrator, Fast), () => Workloads.Plain(PlainLawKind.Published, integrator, Fast))
        {
            Thesis = thesis,
            Error = () => Errors.ThesisLanding(integrator, H, Fast),
        };

    private static TargetRow MathNet(string name, Integrator integrator) =>
        new($"MathNet.Numerics, fast: {name}", () => Workloads.MathNet(integrator, Fast), () => Workloads.Plain(PlainLawKind.Published, integrator, Fast))
        {
            Error = () => Errors.MathNetLanding(integrator, H, Fast),
        };

    private static Timing InChild(TargetRow row)
    {
        // .NET 10 renamed the switch; each runtime ignores the other name.
        var environment = new Dictionary<string, string> { ["DOTNET_EnableAVX512"] = "0", ["DOTNET_EnableAVX512F"] = "0" };
        int index = Rows.TakeWhile(r => r != row).Count();
        double[] values = [.. Child.Run(environment, "quick", "--child", "target", index.ToString(CultureInfo.InvariantCulture))
            .Split(' ').Select(v => double.Parse(v, CultureInfo.InvariantCulture))];
        return new Timing(values[0], values[1], values[2], values[3]);
    }
}
