using System.Text.Json;

namespace FootballPhysics.Labs.Tests;

/// <summary>The laboratory of obstacles.</summary>
public sealed class ObstaclesLabTests
{
    [Fact]
    public void Nothing_is_passed_through_and_every_rebound_is_exact_where_a_rigid_body_engine_is_neither()
    {
        FootballCommand done = FootballCommand.Run("", "lab", "obstacles", "--quick");
        Assert.Equal(0, done.ExitCode);
        JsonElement[] tables = [.. done.Result.GetProperty("tables").EnumerateArray()];
        JsonElement[] Rows(int table) => [.. tables[table].GetProperty("rows").EnumerateArray()];
        Assert.Equal([0, 1, 10, 100, 1000], Rows(0).Select(row => row.GetProperty("posts").GetInt32()));
        Assert.All(Rows(1), row => Assert.Equal("0.0 %", row.GetProperty("here: passed").GetString()));
        Assert.All(Rows(1), row => Assert.Equal("holds", row.GetProperty("verdict").GetString()));
        Assert.All(Rows(2), row => Assert.Equal("holds", row.GetProperty("verdict").GetString()));
        Assert.Contains(Rows(1), row => row.GetProperty("engine: passed").GetString() != "0.0 %");
        Assert.Contains(Rows(2), row => Math.Abs(row.GetProperty("engine: least").GetDouble() - 0.6) > 0.05);
    }

    [Fact]
    public void Scenes_with_things_are_a_part_of_the_laboratory_of_stability()
    {
        FootballCommand done = FootballCommand.Run("", "lab", "stability", "--things", "--scenes", "12");
        Assert.Equal(0, done.ExitCode);
        Assert.Equal(6, done.Result.GetProperty("tables")[0].GetProperty("rows").GetArrayLength());
    }
}
