using System.Globalization;
using Football.Tool.Commands;
using Spectre.Console;

namespace Football.Tool.Fit;

/// <summary>The fit of a match as tables for a person.</summary>
internal static class MatchTable
{
    public static void Print(MatchFitResult fit, Terminal terminal)
    {
        Table pieces = new Table().Border(TableBorder.Simple).AddColumns("", "from, s", "to, s", "points", "rms, cm", "worst, cm", "speed, m/s", "spin, rad/s", "of an impact: e, kept");
        foreach (MatchPiece piece in fit.Pieces)
        {
            bool flies = piece.Kind == MatchPieceKind.Flight;
            pieces.AddRow(
                MatchWriter.Word(piece.Kind), Text(piece.From, "0.00"), Text(piece.To, "0.00"), piece.Points.ToString(CultureInfo.InvariantCulture),
                flies ? Text(100 * piece.Rms, "0.0") : "", flies ? Text(100 * piece.Worst, "0.0") : "", Text(piece.Velocity.Length, "0.0"), flies ? Text(piece.Spin.Length, "0") : "",
                piece.Kind == MatchPieceKind.Impact ? $"{(piece.Restitution is { } e ? Text(e, "0.00") : "–")}, {Text(piece.Kept, "0.00")}" : "");
        }

        terminal.PersonConsole.Write(pieces);
        Table numbers = new Table().Border(TableBorder.Simple).AddColumns("of the whole track", "value", "±");
        for (int i = 0; i < fit.Names.Count; i++)
        {
            numbers.AddRow(Cell.Of(fit.Names[i]), Text(fit.Value(i), "0.000"), Text(fit.Deviation(i), "0.000"));
        }

        terminal.PersonConsole.Write(numbers);
    }

    /// <summary>The summary as one line.</summary>
    public static string Summary(MatchFitResult fit) => FormattableString.Invariant(
        $"{fit.Flights} flights, rms {100 * fit.Rms:0.00} cm; {100 * fit.Covered:0.0} % of what is above 0.5 m in them; {fit.Impacts} impacts; noise {1000 * fit.Noise:0.0} mm. Good for {MatchWriter.GoodFor(fit)}.");

    private static string Text(double number, string format) => number.ToString(format, CultureInfo.InvariantCulture);
}
