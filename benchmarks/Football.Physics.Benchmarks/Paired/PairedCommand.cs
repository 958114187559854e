namespace FootballPhysics.Benchmarks;

/// <summary>`quick --against FOLDER`: times the kicks of this build and of another one, which alternate in one process.</summary>
internal static class PairedCommand
{
    /// <summary>A kick that takes longer than this, relative to the other build, is a regression.</summary>
    public const double Most = 1.05;

    /// <summary>Times the kicks that both builds have.</summary>
    /// <returns>0; 1 if a kick takes longer than <see cref="Most"/>; 2 if the folder has no build to compare with.</returns>
    public static int Run(string folder, double seconds)
    {
        try
        {
            return Compare(folder, seconds);
        }
        catch (InvalidOperationException refused)
        {
            Console.Error.WriteLine(refused.Message);
            return 2;
        }
    }

    private static int Compare(string folder, double seconds)
    {
        // Load both in the same way, so that both have the same extra code.
        IReadOnlyDictionary<string, Workload> now = Build.Kicks(AppContext.BaseDirectory);
        IReadOnlyDictionary<string, Workload> then = Build.Kicks(folder);
        string[] names = [.. now.Keys.Where(then.ContainsKey)];
        if (names.Length == 0)
        {
            throw new InvalidOperationException($"--against: the builds have no kick in common. Names in {folder}: {string.Join(" | ", then.Keys)}.");
        }

        Stopwatching.WarmUp([.. names.SelectMany(name => new[] { now[name], then[name] })]);
        int regressions = 0;
        Console.WriteLine("| kick: | ns a step | before | ratio | |");
        Console.WriteLine("|---|--:|--:|--:|---|");
        foreach (string name in names)
        {
            Timing time = Stopwatching.Measure(now[name], then[name], seconds / names.Length);
            bool slower = time.Ratio > Most;
            regressions += slower ? 1 : 0;
            Console.WriteLine($"| {name} | {Text.Number(time.Nanoseconds)} | {Text.Number(time.YardstickNanoseconds)} | {time.Ratio:F3} | {(slower ? "**slower**" : "")} |");
        }

        return regressions == 0 ? 0 : 1;
    }
}
