using System.Text.Json;

namespace FootballPhysics.Tool.Tests.Sweep;

/// <summary>football sweep: what a row can say is what the other commands say of the same shot.</summary>
public sealed class SweepRowsTests
{
    private const string Goal = """
        "goals": [{"center": [0, 0, -20], "facing": [0, 0, 1], "net": true}],
        "obstacles": [{"name": "keeper", "shape": "capsule", "from": [0, 0.3, -19.5], "to": [0, 1.7, -19.5], "radius": 0.4}]
        """;

    [Theory]
    [InlineData("rest")]
    [InlineData("impact")]
    [InlineData("time")]
    public void Ends_events_and_samples_are_those_of_simulate(string stop)
    {
        string rest = $"{{{Goal}, \"stop\": {{\"at\": \"{stop}\", \"time\": 6}}, \"solver\": {{\"integrator\": \"rk4\", \"timeStep\": 0.01}}";
        IReadOnlyList<JsonElement> rows = Rows(
            rest + """, "row": {"events": 3, "samples": [0.1, 0.35], "hits": ["keeper", "back net"], "columns": ["launch.velocity", "launch.spin", "end", "time", "position", "outcome", "hits", "events.count", "events.kind", "events.surface", "events.time", "samples.position"]}, "launch": {"speed": [24, 30], "elevation": [8, 16], "azimuth": [-8, 8]}}""",
            12);
        foreach (JsonElement row in rows)
        {
            string scenario = $"{rest}, \"samples\": true, \"launch\": {{\"position\": [0,0,0], \"velocity\": {row.GetProperty("launch.velocity")}, \"spin\": {row.GetProperty("launch.spin")}}}}}";
            JsonElement played = FootballCommand.Play(scenario);
            JsonElement final = played.GetProperty("final");
            Assert.Equal(final.GetProperty("time").GetDouble(), row.GetProperty("time").GetDouble(), 1e-9);
            AssertNear(final.GetProperty("position"), row.GetProperty("position"), 1e-9);
            JsonElement[] events = [.. played.GetProperty("events").EnumerateArray()];
            Assert.Equal(events.Length, row.GetProperty("events.count").GetInt32());
            for (int k = 0; k < 3; k++)
            {
                bool has = k < events.Length;
                Assert.Equal(has ? events[k].GetProperty("kind").GetString() : "none", row.GetProperty("events.kind")[k].GetString());
                Assert.Equal(has && events[k].TryGetProperty("surface", out JsonElement surface) ? surface.GetString() : "none", row.GetProperty("events.surface")[k].GetString());
                Assert.Equal(has ? events[k].GetProperty("time").GetDouble() : double.NaN, row.GetProperty("events.time")[k] is { ValueKind: JsonValueKind.Number } time ? time.GetDouble() : double.NaN);
            }

            bool Met(JsonElement[] happened, string kind, string? what = null) => happened.Any(e => e.GetProperty("kind").GetString() == kind && (what is null || e.GetProperty("surface").GetString() == what));
            Assert.Equal(Met(events, "impact", "keeper"), row.GetProperty("hits")[0].GetInt32() > 0);

            // The outcome is that of the flight to rest.
            JsonElement[] whole = [.. FootballCommand.Play(scenario, "--set", "stop.at=rest", "--set", "stop.time=60").GetProperty("events").EnumerateArray()];
            Assert.Equal(Met(whole, "goal"), row.GetProperty("outcome").GetString() == "goal");
            Assert.Equal(Met(whole, "impact", "keeper") && !Met(whole, "goal"), row.GetProperty("outcome").GetString() == "save");
            AssertNear(played.GetProperty("samples")[10].GetProperty("position"), row.GetProperty("samples.position")[0], 1e-9);
        }

        Assert.True(stop != "rest" || rows.Select(row => row.GetProperty("outcome").GetString()).Distinct().Count() > 1);
    }

    [Fact]
    public void What_comes_after_the_end_is_none()
    {
        JsonElement row = Rows("""{"launch": {"speed": 20, "elevation": 10}, "row": {"samples": [0.1, 19], "events": 2}}""", 1)[0];
        Assert.Equal(JsonValueKind.Number, row.GetProperty("samples.position")[0][0].ValueKind);
        Assert.Equal(JsonValueKind.Null, row.GetProperty("samples.position")[1][0].ValueKind);
        Assert.Equal("none", row.GetProperty("events.kind")[1].GetString());
        Assert.Equal(JsonValueKind.Null, row.GetProperty("events.time")[1].ValueKind);
    }

    [Fact]
    public void A_flight_to_a_plane_ends_on_it()
    {
        IReadOnlyList<JsonElement> rows = Rows("""{"launch": {"speed": [20, 30]}, "stop": {"at": "plane", "plane": {"point": [0, 0, -11], "normal": [0, 0, 1]}}}""", 40);
        Assert.All(rows, row => Assert.Equal("plane", row.GetProperty("end").GetString()));
        Assert.All(rows, row => Assert.Equal(-11, row.GetProperty("position")[2].GetDouble(), 1e-9));
    }

    [Theory]
    [InlineData("")]
    [InlineData(", \"through\": [9.15, 2.4, 1.6]")]
    public void Aims_are_those_of_aim(string through)
    {
        string aim = $"\"from\": [0, 0.11, 0], \"target\": [22, 1.5, 3], \"speed\": 27{through}";
        IReadOnlyList<JsonElement> rows = Rows($"{{\"aim\": {{{aim}}}, \"ranges\": {{\"aim.target[1]\": [0.5, 2]}}}}", 8);
        foreach (JsonElement row in rows)
        {
            FootballCommand found = FootballCommand.Run($"{{\"aim\": {{{aim}}}}}", "aim", "-", "--set", FormattableString.Invariant($"aim.target.1={row.GetProperty("aim.target.1").GetDouble():R}"));
            Assert.Equal(found.Result.GetProperty("status").GetString(), row.GetProperty("status").GetString());
            AssertNear(found.Result.GetProperty("velocity"), row.GetProperty("velocity"), 0.01);
        }
    }

    [Theory]
    [InlineData("\"target\": [2, 0.5, -18], \"speed\": 17, \"arc\": \"high\", \"elevation\": {\"max\": 80}")]
    [InlineData("\"target\": [2, 0.5, -18], \"speed\": 25, \"targetVelocity\": [3, 0, 0]")]
    [InlineData("\"target\": [2, 0.5, -18], \"speed\": 30, \"slowest\": true")]
    [InlineData("\"target\": [2, 0.5, -18], \"speed\": 30, \"arrival\": {\"time\": 1.2}")]
    [InlineData("\"target\": [2, 0.5, -18], \"speed\": 30, \"arrival\": {\"speed\": 15}")]
    [InlineData("\"target\": [2, 0.5, -18], \"speed\": 17, \"after\": [\"ground\"], \"tolerance\": 0.001")]
    public void Whatever_an_aim_asks_for_its_row_is_the_answer_of_aim(string asked)
    {
        string aim = $"{{\"aim\": {{\"from\": [0, 0.11, 0], {asked}}}}}";
        JsonElement row = Assert.Single(Rows(aim, 1));
        JsonElement found = FootballCommand.Run(aim, "aim", "-").Result;
        Assert.Equal("hit", found.GetProperty("status").GetString());
        foreach (string name in (string[])["status", "velocity", "spin", "miss", "time", "closest", "iterations", "simulations"])
        {
            Assert.Equal(found.GetProperty(name).GetRawText(), row.GetProperty(name).GetRawText());
        }
    }

    [Fact]
    public void Rows_of_a_scene_among_others_are_those_of_the_scene_alone()
    {
        const string Columns = "\"row\": {\"columns\": [\"index\", \"time\", \"position\", \"apex\"]}";
        IReadOnlyList<JsonElement> mixed = Rows($"{{\"ranges\": {{\"ball.mass\": {{\"grid\": [0.41, 0.45]}}}}, {Columns}}}", 40);
        IReadOnlyList<JsonElement> light = Rows($"{{\"ball\": {{\"mass\": 0.41}}, {Columns}}}", 40);
        IReadOnlyList<JsonElement> heavy = Rows($"{{\"ball\": {{\"mass\": 0.45}}, {Columns}}}", 40);
        Assert.Equal(mixed.Select((_, i) => (i % 2 == 0 ? light : heavy)[i].ToString()), mixed.Select(row => row.ToString()));
    }

    private static IReadOnlyList<JsonElement> Rows(string sweep, int count)
    {
        FootballCommand done = FootballCommand.Run(sweep, "sweep", "-", "--count", $"{count}");
        Assert.Equal(("", 0), (done.Error, done.ExitCode));
        return done.Lines;
    }

    private static void AssertNear(JsonElement expected, JsonElement actual, double tolerance)
    {
        for (int i = 0; i < 3; i++)
        {
            Assert.Equal(expected[i].GetDouble(), actual[i].GetDouble(), tolerance);
        }
    }
}
