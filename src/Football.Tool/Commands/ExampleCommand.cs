using System.CommandLine;

namespace FootballPhysics.Tool.Commands;

/// <summary>A command whose help ends with examples.</summary>
/// <param name="name">The name of the command.</param>
/// <param name="description">The purpose, as shown in the list of commands.</param>
/// <param name="examples">The examples, as lines for a shell.</param>
internal sealed class ExampleCommand(string name, string description, params string[] examples) : Command(name, description)
{
    public IReadOnlyList<string> Examples { get; } = examples;

    /// <summary>Additional sentences for the help of the command; null for none.</summary>
    public string? Details { get; set; }
}
