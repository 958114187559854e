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
    public static Command Create(Terminal terminal) => new ExampleCommand(
        "lab",
        "Run accuracy and stability experiments (needs a checkout)",
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
        BodiesLab.Create(terminal),
        RigsLab.Create(terminal),
        KicksLab.Create(terminal),
        SweepLab.Create(terminal),
        InterceptLab.Create(terminal),
        DerivativesLab.Create(terminal),
        BankShotLab.Create(terminal),
        ScatterLab.Create(terminal),
        FitLab.Create(terminal),
        CameraLab.Create(terminal),
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
