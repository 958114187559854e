using FootballPhysics.Scenarios.Input;
using Spectre.Console;

namespace FootballPhysics.Tool.Commands;

/// <summary>Cells of a table. Text from a file is shown literally: it contains no markup, and the terminal executes no control characters.</summary>
internal static class Cell
{
    /// <summary>Returns a cell with a text.</summary>
    public static string Of(string text) => Markup.Escape(Quote.Short(text, int.MaxValue - 1));
}
