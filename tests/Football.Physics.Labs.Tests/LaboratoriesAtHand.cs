using System.Runtime.CompilerServices;

namespace FootballPhysics.Labs.Tests;

/// <summary>Gives the command that tests run the laboratories, so that none is started as a process of its own.</summary>
internal static class LaboratoriesAtHand
{
    [ModuleInitializer]
    internal static void Give() => FootballCommand.Laboratories = Laboratories.Create;
}
