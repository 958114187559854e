using System.CommandLine;

namespace FootballPhysics.Tool.Commands;

/// <summary>A command whose help ends with examples.</summary>
/// <param name="name">Its name.</param>
/// <param name="description">Its purpose, as the list of commands shows it.</param>
/// <param name="examples">Lines for a shell.</param>
internal sealed class ExampleCommand(string name, string description, params string[] examples) : Command(name, description)
{
    public IReadOnlyList<string> Examples { get; } = examples;

    /// <summary>Further sentences for the help of the command itself; null if it needs none.</summary>
    public string? Details { get; set; }
}
