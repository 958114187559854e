using System.CommandLine;
using Football.Physics.Headless.Lab;

namespace Football.Physics.Headless.Commands;

/// <summary>football lab: the thesis' experiments.</summary>
internal static class LabCommand
{
    public static Command Create(Terminal terminal) => new("lab", "Experiments, the thesis' own and more: accuracy, run time against error, stability under stress, aiming.")
    {
        VacuumLab.Create(terminal),
        ConsistencyLab.Create(terminal),
        CostLab.Create(terminal),
        PrecisionLab.Create(terminal),
        StabilityLab.Create(terminal),
        AimLab.Create(terminal),
    };
}
