using System.CommandLine;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Intercept;

/// <summary>football lab intercept: compares windows of random runners on random flights with a dense scan.</summary>
internal static class InterceptLab
{
    public static Command Create(Terminal terminal)
    {
        Option<long> flights = Arguments.Whole("--flights", "Number of flights, alternating between the profiles.", 2, 10_000_000, 100);
        return LabOptions.Create(
            "intercept",
            "Interception by random runners on random flights, compared with a scan in steps of 0.1 ms.",
            ["football lab intercept", "football lab intercept --flights 40 --seed 7"],
            terminal,
            (parsed, seed, progress) => Run(seed, (int)parsed.GetValue(flights), progress),
            flights);
    }

    private static LabReport Run(long seed, int flights, Progress progress)
    {
        var table = new LabTable(
            "Windows of meeting, against a scan in steps of 0.1 ms", "profile", "flights", "windows", "lost", "invented", "too short for the scan", "wrong first", "worst end, s", "verdict");
        var report = new LabReport { Name = "intercept", Seed = seed, Tables = { table } };
        (string Name, InterceptCheck Check)[] profiles = [("published", new InterceptCheck(Scene.Published)), ("measured", new InterceptCheck(Scene.Measured))];
        for (int i = 0; i < flights; i++)
        {
            progress.Report(i, flights, () => profiles[i % 2].Name);
            profiles[i % 2].Check.Run(new SeededRandom(SeededRandom.Mix(seed, i)));
        }

        foreach ((string name, InterceptCheck check) in profiles)
        {
            int count = (flights + (name == "published" ? 1 : 0)) / 2;
            table.Add(name, count, check.Windows, check.Lost, check.Invented, check.Short, check.WrongFirst, check.Worst, Verdict.Of(check.Holds));
            report.Failed |= !check.Holds;
        }

        report.Notes.Add("Reached: no window lost or invented, who is first is right, and ends are within 1e-6 s. The path is in the game's own steps of 10 ms.");
        return report;
    }
}
