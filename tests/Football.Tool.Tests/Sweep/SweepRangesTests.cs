using System.Text.Json;
using Football.Tool.Sweep.Ranges;

namespace Football.Tool.Tests.Sweep;

/// <summary>football sweep: what is drawn.</summary>
public sealed class SweepRangesTests
{
    [Theory]
    [InlineData(0.5, 0)]
    [InlineData(0.975, 1.959963984540054)]
    [InlineData(0.025, -1.959963984540054)]
    [InlineData(0.9, 1.2815515655446004)]
    [InlineData(1e-9, -5.997807015007686)]
    [InlineData(1e-15, -7.941345326170998)]
    public void Normal_quantiles_are_those_of_the_tables(double share, double quantile) =>
        Assert.Equal(quantile, NormalQuantile.At(share), 1e-13);

    [Fact]
    public void A_field_is_drawn_the_same_whatever_else_is_drawn()
    {
        double[] alone = Numbers("speed", Rows(50));
        Assert.Equal(alone, Numbers("speed", Rows(50, "air.wind[0]=[-5,5]", "launch.elevation=12")));
        Assert.NotEqual(alone, Numbers("elevation", Rows(50)));
    }

    [Fact]
    public void A_normal_has_its_mean_its_deviation_and_its_bounds()
    {
        double[] free = Numbers("speed", Rows(4000, "launch.speed={\"normal\":[25,2]}"));
        double mean = free.Average();
        Assert.Equal(25, mean, 0.15);
        Assert.Equal(2, Math.Sqrt(free.Average(x => (x - mean) * (x - mean))), 0.1);
        double[] bound = Numbers("speed", Rows(4000, "launch.speed={\"normal\":[25,2],\"within\":[26,27]}"));
        Assert.All(bound, x => Assert.InRange(x, 26, 27));

        // The density falls from the lower bound to the upper one.
        Assert.True(bound.Count(x => x < 26.5) > 1.1 * bound.Count(x => x >= 26.5));
    }

    [Fact]
    public void A_list_is_drawn_and_a_grid_comes_in_turn()
    {
        IReadOnlyList<JsonElement> rows = Rows(
            600,
            "ball.mass={\"list\":[0.41,0.43]}",
            "launch.speed={\"grid\":[20,25,30]}",
            "air.wind[2]={\"grid\":{\"from\":-1,\"to\":1,\"count\":3}}");
        double[] masses = Numbers("ball.mass", rows);
        Assert.Equal([0.41, 0.43], masses.Distinct().Order());
        Assert.InRange(masses.Count(mass => mass == 0.41), 250, 350);
        Assert.Equal([20, 20, 20, 25, 25, 25, 30, 30, 30, 20], Numbers("speed", rows).Take(10));
        Assert.Equal([-1, 0, 1, -1, 0, 1, -1, 0, 1, -1], Numbers("air.wind.2", rows).Take(10));
    }

    [Fact]
    public void Words_and_whole_objects_are_values_too()
    {
        IReadOnlyList<JsonElement> rows = Rows(
            60, "profile=measured", "ball.type={\"list\":[\"jabulani\",\"brazuca\"]}", "launch.position={\"list\":[[0,1,0],[3,2,-4]]}");
        Assert.Equal(["brazuca", "jabulani"], rows.Select(row => row.GetProperty("ball.type").GetString()!).Distinct().Order());
        Assert.Equal(["[0,1,0]", "[3,2,-4]"], rows.Select(row => row.GetProperty("launch.position").GetString()!).Distinct().Order());
    }

    [Theory]
    [InlineData("air.wind[0]=[-9,9]")]
    [InlineData("air.wind[0]={\"list\":[-9,0,9]}")]
    public void A_drawn_wind_is_the_wind_that_blows(string wind)
    {
        foreach (JsonElement row in Rows(12, wind, "launch.elevation=[10,40]", "stop.time=3"))
        {
            string set(string name) => FormattableString.Invariant($"{row.GetProperty(name).GetDouble():R}");
            JsonElement played = FootballCommand.Run(
                "", "sweep", "--count", "1", "--set", $"air.wind=[{set("air.wind.0")},0,0]", "--set", $"launch.speed={set("speed")}", "--set", $"launch.elevation={set("elevation")}",
                "--set", $"launch.topSpin={set("topSpin")}", "--set", $"launch.sideSpin={set("sideSpin")}", "--set", "stop.time=3").Result;
            for (int i = 0; i < 3; i++)
            {
                Assert.Equal(played.GetProperty("position")[i].GetDouble(), row.GetProperty("position")[i].GetDouble(), 1e-4);
            }
        }
    }

    [Fact]
    public void A_row_that_cannot_be_is_named()
    {
        FootballCommand done = FootballCommand.Run("", "sweep", "--count", "300", "--range", "ball.mass={\"normal\":[0.43,0.5]}");
        Assert.Equal((1, ""), (done.ExitCode, done.Output));
        Assert.Matches("^football: row [0-9]+: ball.mass is -0.[0-9]+; allowed: 0.001 … 100.$", done.ErrorLine);
    }

    private static IReadOnlyList<JsonElement> Rows(int count, params string[] ranges)
    {
        FootballCommand done = FootballCommand.Run("", ["sweep", "--count", $"{count}", .. ranges.SelectMany(range => (string[])["--range", range])]);
        Assert.Equal(("", 0), (done.Error, done.ExitCode));
        return done.Lines;
    }

    private static double[] Numbers(string column, IReadOnlyList<JsonElement> rows) => [.. rows.Select(row => row.GetProperty(column).GetDouble())];
}
