using System.Globalization;
using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Tool.Tests;

/// <summary>The chart writer.</summary>
public sealed class DrawingTests
{
    private static readonly XNamespace Svg = "http://www.w3.org/2000/svg";

    [Fact]
    public void Ticks_are_round_and_within_the_axis()
    {
        Assert.Equal([0, 20, 40, 60], Ticks.Linear(-3, 71, 5).Select(tick => Math.Round(tick, 9)));
        Assert.Equal([-0.1, -0.05, 0, 0.05, 0.1], Ticks.Linear(-0.11, 0.12, 5).Select(tick => Math.Round(tick, 9)));
        Assert.Equal([1e-6, 1e-3, 1], Ticks.Logarithmic(1e-6, 1, 2).Select(tick => Math.Round(tick, 9)));
        Assert.Equal([0.5, 1, 2, 5, 10], Ticks.Logarithmic(0.4, 12, 8).Select(tick => Math.Round(tick, 9)));
        Assert.Equal(["0", "0.05", "1e-9", "2.5e7", "-12"], ((double[])[-0.0, 0.05, 1e-9, 2.5e7, -12]).Select(Ticks.Label));
    }

    [Fact]
    public void A_line_goes_where_its_points_are()
    {
        var chart = new Chart(new Axis("x") { Min = 0, Max = 10 }, new Axis("y") { Min = 0, Max = 1 }) { Width = 568, PlotHeight = 100 };
        chart.Items.Add(new PolylineItem([new(0, 0), new(5, 1), new(10, 0.5)]));
        Assert.Equal("0,100 250,0 500,50", chart.Draw().Descendants(Svg + "polyline").Single().Attribute("points")!.Value);
    }

    [Fact]
    public void A_logarithmic_axis_gives_ratios_equal_room_and_leaves_out_what_has_no_place()
    {
        var chart = new Chart(new Axis("x") { Min = 1, Max = 100, Scale = AxisScale.Logarithmic }, new Axis("y") { Min = 1e-4, Max = 1, Scale = AxisScale.Logarithmic })
        {
            Width = 568,
            PlotHeight = 100,
        };
        chart.Items.Add(new PolylineItem([new(1, 1e-4), new(10, 1e-2), new(20, 0), new(-1, 1), new(100, 1)]));
        Assert.Equal("0,100 250,50 500,0", chart.Draw().Descendants(Svg + "polyline").Single().Attribute("points")!.Value);
    }

    [Fact]
    public void Equal_scales_never_distort()
    {
        foreach ((double width, double height) in ((double, double)[])[(60, 3), (3, 60), (10, 10)])
        {
            var chart = new Chart(new Axis("x"), new Axis("y")) { EqualScales = true, PlotHeight = 90 };
            chart.Items.Add(new PolygonItem([[new(0, 0), new(width, 0), new(width, height), new(0, height)]]));
            double[][] corners = [.. chart.Draw().Descendants(Svg + "polygon").Single().Attribute("points")!.Value.Split(' ').Select(Numbers)];
            double ratio = (corners[1][0] - corners[0][0]) / (corners[1][1] - corners[2][1]);
            Assert.Equal(width / height, ratio, 0.01 * width / height);
        }

        static double[] Numbers(string point) => [.. point.Split(',').Select(part => double.Parse(part, CultureInfo.InvariantCulture))];
    }

    [Fact]
    public void A_histogram_counts_every_value_once()
    {
        var bars = BarsItem.Histogram([0, 0.1, 1, 1.9, 2, 4], 4, Palette.Blue);
        Assert.Equal(new Bounds(0, 4, 0, 2), bars.Bounds);
        var chart = new Chart(new Axis("x"), new Axis("count") { Min = 0 });
        chart.Items.Add(bars);
        Assert.Equal(4, chart.Draw().Descendants(Svg + "rect").Count(rect => rect.Attribute("fill-opacity") is not null));
    }

    [Fact]
    public void The_legend_names_each_label_once()
    {
        var chart = new Chart(new Axis("x"), new Axis("y")) { Title = "t" };
        chart.Items.Add(new PolylineItem([new(0, 0), new(1, 1)]) { Label = "line" });
        chart.Items.Add(new PolylineItem([new(1, 1), new(2, 2)]) { Label = "line" });
        chart.Items.Add(new ScatterItem([new(1, 1)]) { Label = "dots", Mark = Mark.Diamond });
        List<string> texts = [.. chart.Draw().Descendants(Svg + "text").Select(text => text.Value)];
        Assert.Single(texts, "line");
        Assert.Single(texts, "dots");
    }
}
