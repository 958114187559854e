namespace FootballPhysics.Benchmarks;

/// <summary>The rows of "A kick", from foot to rest: with the default scene and settings, and with the published profile.</summary>
internal static class KickTable
{
    public static IReadOnlyList<KickRow> Rows { get; } = [.. Of(Integrator.Rk2, "RK2"), .. Of(Integrator.Rk4, "RK4")];

    /// <summary>Times the rows.</summary>
    public static void Print(Action<string> print, IReadOnlyList<KickRow> rows, double share)
    {
        Scene[] scenes = [new Scene(), Scene.Published];
        (KickRow Row, Workload[] Subjects, Workload[] Yardsticks)[] work =
            [.. rows.Select(row => (row, scenes.Select(row.Subject).ToArray(), scenes.Select(row.Yardstick).ToArray()))];
        Stopwatching.WarmUp([.. work.SelectMany(w => w.Subjects.Concat(w.Yardsticks))]);
        print("");
        print("## A kick");
        print("");
        print("A free kick of 27 m/s with spin, from the foot to rest, at 60 Hz. The ratio is the time per step, relative to a flight step of 10 ms in the same scene with the same method. The scenes are the default, `new Scene()`, and the published one. Rolling and sliding use 10 ms.");
        print("");
        print("| | ns a step | yardstick, ns | ratio | reach | | bytes | published: ns | ratio |");
        print("|---|--:|--:|--:|--:|---|--:|--:|--:|");
        foreach ((KickRow row, Workload[] subjects, Workload[] yardsticks) in work)
        {
            Timing time = Stopwatching.Measure(subjects[0], yardsticks[0], 0.5 * share);
            Timing published = Stopwatching.Measure(subjects[1], yardsticks[1], 0.5 * share);
            string verdict = time.Ratio <= row.Target ? "reached" : "**missed**";
            print($"| {row.Name} | {Text.Number(time.Nanoseconds)} | {Text.Number(time.YardstickNanoseconds)} | {Text.Number(time.Ratio)} | ≤ {Text.Number(row.Target)} | {verdict} | {Text.Number(time.Bytes)} | {Text.Number(published.Nanoseconds)} | {Text.Number(published.Ratio)} |");
        }
    }

    private static KickRow[] Of(Integrator integrator, string name)
    {
        Workload Flight(Scene scene) => Workloads.Flight(scene, integrator, ShotSets.Fast);
        Workload Kick(Scene scene) => Workloads.Kick(scene, integrator);
        return
        [
            new($"a kick from foot to rest at 60 Hz, {name}, of a flight step", 2.2, Kick, Flight),
            new($"the same kick on `Pitch.Standard`, {name}, of that on the bare pitch", 1.2, scene => Kick(Pitch.Standard.On(scene)), Kick),
            new($"rolling, {name}, of a flight step", 2, scene => Workloads.Chain(scene, integrator, ShotSets.Rolling), Flight),
            new($"sliding, {name}, of a flight step", 3, scene => Workloads.Chain(scene, integrator, ShotSets.Sliding), Flight),
        ];
    }
}
