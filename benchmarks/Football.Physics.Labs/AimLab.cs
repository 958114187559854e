using System.CommandLine;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs;

/// <summary>football lab aim: runs the thesis' experiments with predictors, and the library's own solver on the same requests.</summary>
internal static class AimLab
{
    private const int Requests = 10_000;
    private const int ScanEvery = 4;

    public static Command Create(Terminal terminal)
    {
        var lab = new Lab(
            "aim",
            "Aims of the original thesis (tests 4.1.3, 4.2.3 and 4.3.2), and 10 000 random requests compared with a dense scan. The CSV lists every kick.",
            ["football lab aim --quick --csv kicks.csv", "football lab aim --profiles --quick"],
            isDrawn: true);
        Option<bool> quick = lab.Quick();
        Option<bool> full = lab.Flag("--full", "Compare every random request that was not hit with the dense scan, not one in four.");
        Option<bool> profiles = lab.Flag("--profiles", "Only the random requests, in both profiles, with weather, wind by height and gusts.");
        return lab.Command(terminal, run =>
        {
            int count = run.Get(quick) ? Requests / 20 : Requests;
            if (run.Get(profiles))
            {
                ProfileAims.Run(run, count);
                return;
            }

            new AimExperiments(run, run.Get(quick)).Run();
            run.Progress.Report(() => "random requests");
            int seed = unchecked((int)run.Seed);
            LabCounts verdicts = AimVerdicts.Of(
                run, "Random requests (5 to 40 m/s, spins, winds, laws, 1 to 70 m, heights, elevation bounds; 1 mm), direct, held against a dense scan",
                index => AimAnything.Scene(seed, index), count, run.Get(full) ? 1 : ScanEvery);
            run.Failed |= !AimVerdicts.Hold(verdicts);
        });
    }
}
