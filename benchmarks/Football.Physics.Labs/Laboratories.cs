using System.CommandLine;
using Football.Physics.Labs.BankShots;
using Football.Physics.Labs.Derivatives;
using Football.Physics.Labs.Goals;
using Football.Physics.Labs.Intercept;
using Football.Physics.Labs.Matches;
using Football.Physics.Labs.Obstacles;
using Football.Physics.Labs.People;
using Football.Physics.Labs.Play;
using Football.Physics.Labs.Queries;
using Football.Physics.Labs.Scenes;
using Football.Physics.Labs.Stress;
using Football.Physics.Labs.Zones;
using Football.Tool.Commands;

namespace Football.Physics.Labs;

/// <summary>football lab: the experiments that measure the library.</summary>
internal static class Laboratories
{
    public static Command Create(Terminal terminal) => new ExampleCommand(
        "lab",
        "Experiments: accuracy, run time against error, stability under stress, aiming. \"The thesis\" is the one that the library began with, whose laws are the published profile (docs/profiles.md); its tables and tests are named by their numbers.",
        "football lab",
        "football lab vacuum --seed 7 --csv vacuum.csv --plot vacuum.svg")
    {
        VacuumLab.Create(terminal),
        ConsistencyLab.Create(terminal),
        CostLab.Create(terminal),
        PrecisionLab.Create(terminal),
        StabilityLab.Create(terminal),
        AimLab.Create(terminal),
        AnswersLab.Create(terminal),
        FuzzLab.Create(terminal),
        BallsLab.Create(terminal),
        RigsLab.Create(terminal),
        KicksLab.Create(terminal),
        SweepLab.Create(terminal),
        InterceptLab.Create(terminal),
        DerivativesLab.Create(terminal),
        BankShotLab.Create(terminal),
        ScatterLab.Create(terminal),
        FitLab.Create(terminal),
        ObstaclesLab.Create(terminal),
        GoalsLab.Create(terminal),
        MatchesLab.Create(terminal),
        PeopleLab.Create(terminal),
        PlayLab.Create(terminal),
        ScenesLab.Create(terminal),
        StressLab.Create(terminal),
        ZonesLab.Create(terminal),
    };
}
