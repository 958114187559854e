using System.CommandLine;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Intercept;

/// <summary>football lab intercept: compares windows of random runners on random flights with a dense scan.</summary>
internal static class InterceptLab
{
    public static Command Create(Terminal terminal)
    {
        var lab = new Lab(
            "intercept",
            "Interception by random runners on random flights, compared with a scan in steps of 0.1 ms.",
            ["football lab intercept", "football lab intercept --flights 40 --seed 7"]);
        Option<long> flights = lab.Whole("--flights", "Number of flights, alternating between the profiles.", 2, 10_000_000, 100);
        return lab.Command(terminal, run => Run(run, run.Int(flights)));
    }

    private static void Run(LabRun run, int flights)
    {
        LabTable table = run.Table(
            "Windows of meeting, against a scan in steps of 0.1 ms", ["profile", "flights", .. InterceptCheck.Columns, "worst end, s", "verdict"]);
        (string Name, InterceptCheck Check)[] profiles = [("published", new InterceptCheck(Scene.Published)), ("measured", new InterceptCheck(Scene.Measured))];
        run.Each(flights, "flight", (random, i) => profiles[i % 2].Check.Run(random));
        foreach ((string name, InterceptCheck check) in profiles)
        {
            int count = (flights + (name == "published" ? 1 : 0)) / 2;
            table.Judge(check.Holds, [name, count, .. check.Counts.Cells(InterceptCheck.Columns), check.Worst]);
        }

        run.Notes.Add("Reached: no window lost or invented, who is first is right, and ends are within 1e-6 s. The path is in the game's own steps of 10 ms.");
    }
}
