using FootballPhysics.Scenarios.Input;
using Spectre.Console;

namespace FootballPhysics.Tool.Commands;

/// <summary>A cell of a table: what came from a file is shown as it is, neither marked up nor obeyed by the terminal.</summary>
internal static class Cell
{
    /// <summary>A cell with a text.</summary>
    public static string Of(string text) => Markup.Escape(Quote.Short(text, int.MaxValue - 1));
}
