using System.Text.Json;

namespace FootballPhysics.Tool.Tests;

/// <summary>football sweep: rows that depend on the seed and their index only.</summary>
public sealed class SweepTests
{
    [Theory]
    [InlineData(10, 3)]
    [InlineData(9001, 2)]
    [InlineData(5, 8)]
    public void Shards_merge_to_the_same_bytes(int count, int shards)
    {
        string all = Sweep("--count", $"{count}", "--seed", "7", "--jobs", "1");
        string merged = string.Concat(Enumerable.Range(1, shards)
            .Select(i => Sweep("--count", $"{count}", "--seed", "7", "--shard", $"{i}/{shards}", "--jobs", $"{i}")));
        Assert.Equal(all, merged);
        Assert.Equal(count, all.Count(c => c == '\n'));
    }

    [Fact]
    public void Shards_of_a_table_have_one_header()
    {
        string all = Sweep("--count", "10", "--format", "csv");
        Assert.Equal(all, string.Concat(Enumerable.Range(1, 3).Select(i => Sweep("--count", "10", "--format", "csv", "--shard", $"{i}/3"))));
        Assert.Equal(11, all.Count(c => c == '\n'));
    }

    [Fact]
    public void A_longer_sweep_begins_with_the_shorter_one()
    {
        Assert.StartsWith(Sweep("--count", "20"), Sweep("--count", "50"), StringComparison.Ordinal);
        Assert.NotEqual(Sweep("--count", "20"), Sweep("--count", "20", "--seed", "2"));
    }

    [Fact]
    public void A_row_is_the_shot_that_simulate_plays()
    {
        IReadOnlyList<JsonElement> rows = FootballCommand.Run("", "sweep", "--count", "25", "--set", "air.wind=[3,0,1]", "--set", "solver.timeStep=0.01").Lines;
        Assert.Equal(25, rows.Count);
        foreach (JsonElement row in rows)
        {
            double elevation = row.GetProperty("elevation").GetDouble() * Math.PI / 180;
            double azimuth = row.GetProperty("azimuth").GetDouble() * Math.PI / 180;
            double speed = row.GetProperty("speed").GetDouble();
            var d = new Vector3d(-Math.Sin(azimuth), 0, -Math.Cos(azimuth));
            Vector3d v = speed * ((Math.Cos(elevation) * d) + new Vector3d(0, Math.Sin(elevation), 0));
            Vector3d w = KickVectors.Spin(d, row.GetProperty("topSpin").GetDouble(), row.GetProperty("sideSpin").GetDouble());
            JsonElement played = FootballCommand.Play(FormattableString.Invariant(
                $"{{\"air\":{{\"wind\":[3,0,1]}},\"launch\":{{\"position\":[0,0,0],\"velocity\":[{v.X:R},{v.Y:R},{v.Z:R}],\"spin\":[{w.X:R},{w.Y:R},{w.Z:R}]}}}}"));
            JsonElement impact = played.GetProperty("events")[0];
            Assert.Equal(impact.GetProperty("time").GetDouble(), row.GetProperty("time").GetDouble(), 1e-4);
            Assert.Equal(played.GetProperty("apex").GetDouble(), row.GetProperty("apex").GetDouble(), 1e-4);
            for (int i = 0; i < 3; i++)
            {
                Assert.Equal(impact.GetProperty("position")[i].GetDouble(), row.GetProperty("position")[i].GetDouble(), 1e-3);
            }
        }
    }

    [Fact]
    public void Ranges_and_numbers_are_kept()
    {
        IReadOnlyList<JsonElement> rows = FootballCommand.Run("{\"launch\":{\"speed\":[20,21],\"elevation\":12,\"topSpin\":0}}", "sweep", "-", "--count", "50").Lines;
        Assert.Equal(50, rows.Count);
        Assert.True(rows.Max(row => row.GetProperty("speed").GetDouble()) - rows.Min(row => row.GetProperty("speed").GetDouble()) > 0.5);
        foreach (JsonElement row in rows)
        {
            Assert.InRange(row.GetProperty("speed").GetDouble(), 20, 21);
            Assert.Equal(12, row.GetProperty("elevation").GetDouble());
            Assert.Equal(0, row.GetProperty("topSpin").GetDouble());
        }
    }

    [Theory]
    [InlineData("{\"launch\":{\"speed\":[21,20]}}", "launch.speed is [21,20]; allowed: 0 … 1000 m/s, or a range of such: [low, high] | ")]
    [InlineData("{\"launch\":{\"speed\":-1}}", "launch.speed is -1; allowed: 0 … 1000 m/s, or a range of such: [low, high] | ")]
    [InlineData("{\"launch\":{\"sped\":1}}", "launch.sped is unknown")]
    [InlineData("{\"solver\":{\"integrator\":\"euler\"}}", "solver.integrator is \"euler\"; allowed: rk2 | rk4.")]
    [InlineData("{\"solver\":{\"timeStep\":2}}", "solver.timeStep is 2; allowed: 1E-05 … 1.")]
    [InlineData("{\"stop\":{\"time\":601}}", "stop.time is 601; allowed: above 0, at most 600.")]
    [InlineData("{\"launch\":{\"position\":[0,2e6,0]}}", "launch.position is [0,2e6,0]; allowed: finite components within ±1000000 m.")]
    [InlineData("{\"ball\":{\"mass\":-1}}", "ball.mass is -1; allowed: 0.001 … 100.")]
    [InlineData("", "the input is empty; allowed: a JSON object")]
    [InlineData("{\"ranges\":{\"ball.mass\":[-1,2]}}", "ball.mass is -1; allowed: 0.001 … 100.")]
    [InlineData("{\"ranges\":{\"ball.mass\":[2,1]}}", "ranges.ball.mass is [2,1]; allowed: a number, a word, true | false, or [low, high] | ")]
    [InlineData("{\"ranges\":{\"ball.mass\":{\"list\":[0.4,\"heavy\"]}}}", "ball.mass is \"heavy\"; allowed: ")]
    [InlineData("{\"ranges\":{\"ball.mas\":[1,2]}}", "ball.mas is unknown")]
    [InlineData("{\"ranges\":{\"launch.speed\":{\"normal\":[25,-1]}}}", "ranges.launch.speed is {\"normal\":[25,-1]}; allowed: 0 … 1000 m/s, or a range")]
    [InlineData("{\"ranges\":{\"launch.speed\":{\"normal\":[25,1],\"within\":[90,99]}}}", "ranges.launch.speed is {")]
    [InlineData("{\"ranges\":{\"launch.position.1\":{\"grid\":{\"from\":0,\"to\":1}}}}", "ranges.launch.position.1 is {")]
    [InlineData("{\"ranges\":{\"obstacles[0].center[0]\":[0,1]}}", "ranges.obstacles[0].center[0] is ")]
    [InlineData("{\"ranges\":{\"a\":{\"grid\":{\"from\":0,\"to\":1,\"count\":1000000}},\"b\":{\"grid\":{\"from\":0,\"to\":1,\"count\":1000000}},\"launch.speed\":{\"grid\":{\"from\":0,\"to\":1,\"count\":10000}}}}", "a is unknown")]
    [InlineData("{\"launch\":{\"speed\":20,\"velocity\":[1,2,3]}}", "launch.speed is 20; allowed: speed or velocity, not both.")]
    [InlineData("{\"launch\":{\"spin\":[1,2,3]}}", "launch.velocity is missing")]
    [InlineData("{\"stop\":{\"at\":\"plane\"}}", "stop.plane.point is missing")]
    [InlineData("{\"row\":{\"columns\":[\"tim\"]}}", "row.columns is tim; allowed: index | speed | ")]
    [InlineData("{\"row\":{\"samples\":[0.2,0.1]}}", "row.samples is [0.2,0.1]; allowed: a list of finite numbers from 0 on, each above the one before.")]
    [InlineData("{\"row\":{\"hits\":[\"keeper\"]}}", "row.hits is keeper; allowed: ground.")]
    [InlineData("{\"row\":{\"event\":1}}", "row.event is unknown")]
    public void What_is_wrong_is_refused(string input, string message)
    {
        var done = FootballCommand.Run(input, "sweep", "-");
        Assert.Equal(1, done.ExitCode);
        Assert.Equal("", done.Output);
        Assert.StartsWith("football: " + message, done.ErrorLine);
    }

    [Theory]
    [InlineData("--count", "0")]
    [InlineData("--count", "many")]
    [InlineData("--shard", "0/3")]
    [InlineData("--shard", "4/3")]
    [InlineData("--shard", "1")]
    [InlineData("--jobs", "0")]
    [InlineData("--seed", "-1")]
    [InlineData("--set", "nonsense")]
    public void Wrong_usage_ends_with_2(params string[] args)
    {
        var done = FootballCommand.Run("", ["sweep", .. args]);
        Assert.Equal(2, done.ExitCode);
        Assert.StartsWith($"football: {args[0]} is {args[1]}; allowed: ", done.Error);
    }

    private static string Sweep(params string[] args)
    {
        var done = FootballCommand.Run("", ["sweep", .. args]);
        Assert.Equal("", done.Error);
        Assert.Equal(0, done.ExitCode);
        return done.Output;
    }
}
