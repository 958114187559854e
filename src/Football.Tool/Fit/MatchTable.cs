using System.Globalization;
using FootballPhysics.Tool.Commands;
using Spectre.Console;

namespace FootballPhysics.Tool.Fit;

/// <summary>Formats the fit of a match as tables.</summary>
internal static class MatchTable
{
    public static void Print(MatchFitResult fit, Terminal terminal)
    {
        Table pieces = new Table().Border(TableBorder.Simple).AddColumns("", "from, s", "to, s", "points", "rms, cm", "worst, cm", "speed, m/s", "spin, rad/s", "of an impact: e, kept");
        foreach (MatchPiece piece in fit.Pieces)
        {
            bool flies = piece.Kind == MatchPieceKind.Flight;
            pieces.AddRow(
                MatchWriter.Word(piece.Kind), Text(piece.StartTime, "0.00"), Text(piece.EndTime, "0.00"), piece.Points.ToString(CultureInfo.InvariantCulture),
                flies ? Text(100 * piece.Rms, "0.0") : "", flies ? Text(100 * piece.MaximumResidual, "0.0") : "", Text(piece.Velocity.Length, "0.0"), flies ? Text(piece.Spin.Length, "0") : "",
                piece.Kind == MatchPieceKind.Impact ? $"{(piece.Restitution is { } e ? Text(e, "0.00") : "–")}, {Text(piece.SpeedRetained, "0.00")}" : "");
        }

        terminal.PersonConsole.Write(pieces);
        PrintWindows(fit, terminal);
        Table numbers = new Table().Border(TableBorder.Simple).AddColumns("of the whole track", "value", "±");
        for (int i = 0; i < fit.Names.Count; i++)
        {
            numbers.AddRow(Cell.Of(fit.Names[i]), Text(fit.Value(i), "0.000"), Text(fit.StandardError(i), "0.000"));
        }

        terminal.PersonConsole.Write(numbers);
        if (fit.RollingSpeed > 0)
        {
            terminal.Person.WriteLine(FormattableString.Invariant(
                $"Rolling: c₀ + c₁ v is {MatchWriter.RollingResistance(fit):0.000} ± {fit.RollingDeviation:0.000} at {fit.RollingSpeed:0.0} m/s, where it is known best."));
        }

        PrintRobotSoccer(fit, terminal);
    }

    /// <summary>Prints the fitted ball in the terms of robot soccer.</summary>
    private static void PrintRobotSoccer(MatchFitResult fit, Terminal terminal)
    {
        if (RobotSoccerModel.Of(fit.Scene) is { } model)
        {
            terminal.Person.WriteLine(FormattableString.Invariant(
                $"Robot soccer, kicks of 6 m/s: acc_slide {model.SlideAcceleration:0.00} m/s², acc_roll {model.RollAcceleration:0.00} m/s², k_switch {model.SwitchFraction:0.000}; damping_xy {model.FirstHopDamping:0.00}, then {model.OtherHopsDamping:0.00}, damping_z {model.VerticalDamping:0.00}."));
        }
    }

    /// <summary>Prints the windows in which the ball slides or rolls untouched, with their resistance.</summary>
    private static void PrintWindows(MatchFitResult fit, Terminal terminal)
    {
        if (fit.Windows.Count == 0)
        {
            return;
        }

        Table windows = new Table().Border(TableBorder.Simple).AddColumns("on the ground", "from, s", "to, s", "points", "speed, m/s", "resistance", "±");
        foreach (GroundWindow window in fit.Windows)
        {
            windows.AddRow(
                MatchWriter.Word(window.Motion), Text(window.StartTime, "0.00"), Text(window.EndTime, "0.00"), window.Points.ToString(CultureInfo.InvariantCulture),
                Text(window.Speed, "0.0"), Text(window.Resistance, "0.000"), Text(window.StandardError, "0.000"));
        }

        terminal.PersonConsole.Write(windows);
    }

    /// <summary>Returns the summary as one line.</summary>
    public static string Summary(MatchFitResult fit) => FormattableString.Invariant(
        $"{fit.Flights} flights, rms {100 * fit.Rms:0.00} cm; {100 * fit.Covered:0.0} % of what is above 0.5 m in them; {fit.Impacts} impacts, {fit.Windows.Count} slides and rolls; noise {1000 * fit.Noise:0.0} mm. Good for {fit.Explanation}.");

    private static string Text(double number, string format) => number.ToString(format, CultureInfo.InvariantCulture);
}
