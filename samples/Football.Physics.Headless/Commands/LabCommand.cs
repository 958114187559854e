using System.CommandLine;
using Football.Physics.Headless.Lab;
using Football.Physics.Headless.Lab.BankShots;
using Football.Physics.Headless.Lab.Derivatives;
using Football.Physics.Headless.Lab.Goals;
using Football.Physics.Headless.Lab.Intercept;
using Football.Physics.Headless.Lab.Obstacles;
using Football.Physics.Headless.Lab.People;
using Football.Physics.Headless.Lab.Queries;

namespace Football.Physics.Headless.Commands;

/// <summary>football lab: the thesis' experiments.</summary>
internal static class LabCommand
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
        PeopleLab.Create(terminal),
    };
}
