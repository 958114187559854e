using System.CommandLine;
using FootballPhysics.Labs.BankShots;
using FootballPhysics.Labs.Derivatives;
using FootballPhysics.Labs.Goals;
using FootballPhysics.Labs.Intercept;
using FootballPhysics.Labs.Matches;
using FootballPhysics.Labs.Obstacles;
using FootballPhysics.Labs.People;
using FootballPhysics.Labs.Play;
using FootballPhysics.Labs.Queries;
using FootballPhysics.Labs.Scenes;
using FootballPhysics.Labs.Stress;
using FootballPhysics.Labs.Zones;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs;

/// <summary>football lab: the experiments that measure the library.</summary>
internal static class Laboratories
{
    public static Command Create(Terminal terminal)
    {
        var command = new ExampleCommand(
            "lab", "Run accuracy and stability experiments (needs a checkout)", "football lab", "football lab vacuum --seed 7 --csv vacuum.csv --plot vacuum.svg");
        foreach (Lab lab in (Lab[])
        [
            VacuumLab.Create(), ConsistencyLab.Create(), CostLab.Create(), PrecisionLab.Create(), StabilityLab.Create(), AimLab.Create(),
            AnswersLab.Create(), FuzzLab.Create(), BallsLab.Create(), BodiesLab.Create(), RigsLab.Create(), KicksLab.Create(), SweepLab.Create(),
            InterceptLab.Create(), DerivativesLab.Create(), BankShotLab.Create(), ScatterLab.Create(), FitLab.Create(), CameraLab.Create(),
            ObstaclesLab.Create(), GoalsLab.Create(), MatchesLab.Create(), PeopleLab.Create(), PlayLab.Create(), ScenesLab.Create(),
            StressLab.Create(), ZonesLab.Create(),
        ])
        {
            command.Add(lab.Command(terminal));
        }

        return command;
    }
}
