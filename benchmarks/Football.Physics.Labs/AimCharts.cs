using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Labs;

/// <summary>Charts of experiments with predictors.</summary>
internal static class AimCharts
{
    private const int Bars = 40;

    /// <summary>Draws a histogram of misses.</summary>
    /// <param name="row">The row to draw.</param>
    /// <param name="all">The rows that share the same axes.</param>
    public static XElement Misses(AimRow row, IEnumerable<AimRow> all)
    {
        static double[] Values(AimRow of) => [.. of.Shots.Where(shot => shot.Miss <= 0.1).Select(shot => 1e3 * shot.Miss)];
        return Histogram(row, "miss, mm", Values(row), Palette.Blue, all.SelectMany(Values));
    }

    /// <summary>Draws a histogram of times, without the slowest hundredth: the machine slowed those down, not the method.</summary>
    /// <param name="row">The row to draw.</param>
    /// <param name="all">The rows that share the same axes.</param>
    public static XElement Times(AimRow row, IEnumerable<AimRow> all)
    {
        static double[] Values(AimRow of) => [.. of.Shots.Select(shot => shot.Microseconds).Order().Take((of.Shots.Count * 99) / 100)];
        return Histogram(row, "time, µs", Values(row), Palette.Orange, all.SelectMany(Values));
    }

    /// <summary>Draws the number of kicks per number of iterations.</summary>
    public static XElement IterationCounts(AimRow row)
    {
        int most = row.Shots.Max(shot => shot.Result.Iterations);
        double[] counts = [.. Enumerable.Range(0, most + 1).Select(i => (double)row.Shots.Count(shot => shot.Result.Iterations == i))];
        var chart = new Chart(new Axis("iterations"), new Axis("kicks") { Min = 0 }) { Title = row.Name, PlotHeight = 130 };
        chart.Items.Add(new BarsItem([.. Enumerable.Range(0, most + 2).Select(i => i - 0.5)], counts) { Colour = Palette.Green });
        return chart.Draw();
    }

    /// <summary>Draws one quantity of every kick over another one, with one series per row.</summary>
    public static XElement Over(
        string title, string xTitle, string yTitle, Func<AimShot, double> x, Func<AimShot, double> y, IEnumerable<AimRow> rows, AxisScale scale = AxisScale.Linear)
    {
        var chart = new Chart(new Axis(xTitle), new Axis(yTitle) { Scale = scale }) { Title = title, PlotHeight = 180 };
        int series = 0;
        foreach (AimRow row in rows)
        {
            chart.Items.Add(new ScatterItem([.. row.Shots.Select(shot => new PlotPoint(x(shot), y(shot)))])
            {
                Label = row.Name,
                Colour = Palette.Series[series],
                Mark = series == 0 ? Mark.Ring : series == 1 ? Mark.Triangle : Mark.Dot,
                Size = 2.2,
            });
            series++;
        }

        return chart.Draw();
    }

    private static XElement Histogram(AimRow row, string axis, double[] values, string colour, IEnumerable<double> all)
    {
        var chart = new Chart(new Axis(axis) { Min = 0, Max = all.DefaultIfEmpty(1).Max() }, new Axis("kicks") { Min = 0 }) { Title = row.Name, PlotHeight = 130 };
        if (values.Length > 0)
        {
            chart.Items.Add(BarsItem.Histogram(values, Bars, colour));
        }

        return chart.Draw();
    }
}
