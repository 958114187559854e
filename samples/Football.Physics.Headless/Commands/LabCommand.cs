using System.CommandLine;
using Football.Physics.Headless.Lab;

namespace Football.Physics.Headless.Commands;

/// <summary>football lab: the thesis' experiments.</summary>
internal static class LabCommand
{
    public static Command Create(Terminal terminal) => new("lab", "Repeats the thesis' experiments, with tables and plots.")
    {
        StabilityLab.Create(terminal),
        AimLab.Create(terminal),
    };
}
