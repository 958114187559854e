using System.CommandLine;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Obstacles;

/// <summary>football lab obstacles: the cost and accuracy of hits, compared with the method of a rigid-body engine.</summary>
internal static class ObstaclesLab
{
    private const int Shots = 2000;

    private static readonly double[] s_speeds = [10, 20, 40, 60, 100];
    private static readonly double[] s_steps = [1.0 / 120, 1.0 / 60, 1.0 / 30];

    public static Command Create(Terminal terminal)
    {
        var lab = new Lab(
            "obstacles",
            "Obstacles compared with a rigid-body engine: cost by their number, shots that tunnel through a post, and the error of a rebound.",
            ["football lab obstacles --quick"]);
        Option<bool> quick = lab.Quick();
        return lab.Command(terminal, run => Run(run, run.Get(quick)));
    }

    private static void Run(LabRun run, bool quick)
    {
        int shots = quick ? Shots / 20 : Shots;
        run.Progress.Report(0, 3, () => "cost");
        ObstacleCost.Measure(run, quick);
        run.Progress.Report(1, 3, () => "a post");
        LabTable passing = run.Table(
            $"{shots} shots at a post of 6 cm radius: passed through, and how far off the direction of the rebound is, mean and worst, degrees",
            "speed, m/s", "step, ms", "engine: passed", "engine: mean", "engine: worst", "here: passed", "here: mean", "here: worst", "verdict");
        foreach (double speed in s_speeds)
        {
            foreach (double step in s_steps)
            {
                PostShots engine = PostShots.ByEngine(run.Random(13), shots, speed, step);
                PostShots here = PostShots.Here(run.Random(13), shots, speed, step);
                bool holds = here.Passed == 0 && here.Worst < 1e-5;
                run.Failed |= !holds;
                passing.Add(speed, 1e3 * step, $"{100.0 * engine.Passed / shots:0.0} %", engine.Mean, engine.Worst, $"{100.0 * here.Passed / shots:0.0} %", here.Mean, here.Worst, holds ? "holds" : "FAILED");
            }
        }

        run.Progress.Report(2, 3, () => "drops");
        LabTable drops = run.Table("Drops from 0.5 to 1.5 m on a board of restitution 0.6: the restitution that comes out, √(height after/height before)", "step, ms", "engine: least", "engine: greatest", "here: least", "here: greatest", "verdict");
        foreach (RigidBodyRebound engine in RigidBodyEngineReport.Measure().Rebounds)
        {
            (double least, double greatest) = BoardDrops.Measure(engine.TimeStep, quick ? 20 : 200);
            bool holds = least > 0.6 - 1e-9 && greatest < 0.6 + 1e-9;
            run.Failed |= !holds;
            drops.Add(1e3 * engine.TimeStep, engine.Least, engine.Greatest, least, greatest, holds ? "holds" : "FAILED");
        }

        run.Notes.Add("The engine's method: symplectic Euler; it finds contacts at the ball's position at the end of a frame, and pushes out and resolves them there. The test is in vacuum, without friction, so that only the time and position of the contact matter.");
    }
}
