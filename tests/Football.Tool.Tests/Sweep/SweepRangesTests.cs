using System.Text.Json;
using FootballPhysics.Tool.Sweep.Ranges;

namespace FootballPhysics.Tool.Tests.Sweep;

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

    [Fact]
    public void Where_a_flight_ends_may_differ_from_row_to_row()
    {
        IReadOnlyList<JsonElement> rows = Rows(8, "stop.at={\"grid\":[\"impact\",\"rest\"]}", "launch.speed={\"list\":[18]}");
        Assert.Equal(["impact", "rest", "impact", "rest"], rows.Take(4).Select(row => row.GetProperty("end").GetString()!));
    }

    [Fact]
    public void How_the_ball_is_turned_at_first_may_differ_from_row_to_row()
    {
        Assert.True(Rows(4, "launch={\"grid\":[{\"speed\":20},{\"speed\":20,\"orientation\":[0,1,0,0]}]}").All(row => row.TryGetProperty("bounces", out _)), "flown one by one, which a turned ball is");
        Assert.False(Rows(4, "solver.timeStep={\"grid\":[0.01,0.02]}")[0].TryGetProperty("bounces", out _), "flown in lanes, each with its own step");
    }

    [Fact]
    public void A_range_of_launches_says_what_their_members_are()
    {
        IReadOnlyList<JsonElement> rows = Rows(4, "launch={\"grid\":[{\"speed\":20,\"elevation\":10},{\"speed\":30,\"elevation\":15}]}");
        Assert.Equal([20, 30, 20, 30], Numbers("speed", rows));
        Assert.Equal([10, 15, 10, 15], Numbers("elevation", rows));
        Assert.Equal(4, Numbers("topSpin", rows).Distinct().Count());
        JsonElement alone = FootballCommand.Run(
            "", "sweep", "--count", "1", "--set", "launch.speed=30", "--set", "launch.elevation=15", "--set", FormattableString.Invariant($"launch.topSpin={Numbers("topSpin", rows)[1]:R}"),
            "--set", FormattableString.Invariant($"launch.sideSpin={Numbers("sideSpin", rows)[1]:R}")).Result;
        Assert.Equal(alone.GetProperty("position")[2].GetDouble(), rows[1].GetProperty("position")[2].GetDouble(), 1e-3);
    }

    [Fact]
    public void Things_are_those_of_the_rows_own_scene()
    {
        const string Keeper = """{"name":"keeper","shape":"box","center":[0,1.2,-19.5],"halfSize":[3.6,1.2,0.2]}""";
        IReadOnlyList<JsonElement> rows = [.. FootballCommand.Run(
            """{"goals":[{"center":[0,0,-20],"facing":[0,0,1]}],"launch":{"speed":25,"elevation":8,"topSpin":0,"sideSpin":0},"row":{"events":2,"hits":["keeper"]},"stop":{"at":"time","time":2}}""",
            "sweep", "-", "--count", "4", "--range", $"obstacles={{\"grid\":[[],[{Keeper}]]}}").Lines];
        Assert.Equal(["goal", "save", "goal", "save"], rows.Select(row => row.GetProperty("outcome").GetString()!));
        Assert.Equal([0, 1, 0, 1], rows.Select(row => Math.Min(1, row.GetProperty("hits")[0].GetInt32())));
        Assert.Equal([false, true, false, true], rows.Select(row => row.GetProperty("events.surface").EnumerateArray().Any(surface => surface.GetString() == "keeper")));
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
