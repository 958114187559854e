using System.Globalization;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace FootballPhysics.Tool.Tests.Sweep;

/// <summary>The outcome of a row is that of its flight to rest, whatever ends the recorded flight; or it is missing.</summary>
public sealed class SweepOutcomeTests
{
    private const int Rows = 60;
    private const double Longest = 60;

    private const string Solver = "\"solver\": {\"integrator\": \"rk4\", \"timeStep\": 0.01}";
    private const string Goal = "\"goals\": [{\"center\": [0, 0, -16], \"facing\": [0, 0, 1]}]";
    private const string NetGoal = "\"goals\": [{\"center\": [0, 0, -16], \"facing\": [0, 0, 1], \"net\": true}]";
    private const string SmallGoals = "\"goals\": [{\"center\": [0, 0, -12], \"facing\": [0, 0, 1], \"width\": 3, \"height\": 2}, {\"center\": [-8, 0, -9], \"facing\": [1, 0, 0], \"width\": 5, \"height\": 2}]";
    private const string Keeper = "\"obstacles\": [{\"name\": \"keeper\", \"shape\": \"capsule\", \"from\": [0, 0.3, -15.5], \"to\": [0, 1.7, -15.5], \"radius\": 0.4, \"velocity\": [1.5, 0, 0]}]";
    private const string Wall = "\"obstacles\": [{\"name\": \"wall\", \"shape\": \"box\", \"center\": [0, 0.9, -9.15], \"halfSize\": [1, 0.9, 0.2]}, {\"name\": \"board\", \"shape\": \"box\", \"center\": [0, 1, -20], \"halfSize\": [30, 1, 0.1]}]";
    private const string Launch = "\"launch\": {\"position\": [0, 0.11, 0], \"speed\": [9, 30], \"elevation\": [0, 22], \"azimuth\": [-16, 16], \"sideSpin\": [-40, 40]}";
    private const string Wind = "\"ranges\": {\"air.wind[0]\": {\"list\": [-12, 0, 12]}}";
    private const string Slippery = "\"ground\": {\"slidingFriction\": 0, \"rollingFriction\": 0, \"spinDamping\": 0}, \"air\": {\"density\": 0}";

    /// <summary>Scenes of sweeps, each with a stop.</summary>
    public static TheoryData<string, string> Sweeps()
    {
        string[] stops =
        [
            "\"at\": \"impact\"", "\"at\": \"plane\", \"plane\": {\"point\": [0, 0, -16], \"normal\": [0, 0, 1]}", "\"at\": \"time\", \"time\": 0.7", "\"at\": \"rest\"", "\"at\": \"rest\", \"time\": 1.1",
        ];
        string[] scenes = [$"{Goal}, {Keeper}", $"{NetGoal}, {Wall}, {Wind}", $"{SmallGoals}, {Wall}", $"{Goal}, {Slippery}"];
        var sweeps = new TheoryData<string, string>();
        foreach (string scene in scenes)
        {
            foreach (string stop in stops)
            {
                sweeps.Add(scene, stop);
            }
        }

        return sweeps;
    }

    [Theory]
    [MemberData(nameof(Sweeps))]
    public void An_outcome_is_that_of_the_flight_to_rest(string scene, string stop)
    {
        string shot = $"{scene}, {Solver}";
        string sweep = $"{{{shot}, {Launch}, \"stop\": {{{stop}}}, \"row\": {{\"columns\": [\"outcome\", \"launch.velocity\", \"launch.spin\"{(scene.Contains(Wind) ? ", \"air.wind.0\"" : "")}]}}}}";
        FootballCommand done = FootballCommand.Run(sweep, "sweep", "-", "--count", $"{Rows}", "--seed", "3");
        Assert.True(done.ExitCode == 0, done.Error);
        string?[] told = [.. done.Lines.Select(row => row.GetProperty("outcome").GetString())];
        string?[] truth = FlownToRest(shot, done.Lines);
        Assert.DoesNotContain(told.Zip(truth), row => row.First is not null && row.First != row.Second);

        // A row is missing only if the flight to rest does not decide it either, and the summary counts these rows.
        int missing = told.Count(outcome => outcome is null);
        Assert.Equal(truth.Count(outcome => outcome is null), missing);
        Assert.Equal(missing == 0 ? "" : $"The outcome of {missing} of {Rows} rows is unknown ({missing}: the ball still moves at the end of the longest flight).", done.Error.Trim());
        Assert.True(missing <= Rows / 20, $"{missing} of {Rows}");
        TestContext.Current.TestOutputHelper?.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{missing} of {Rows} rows are null, {told.Count(outcome => outcome == "goal")} goals"));
    }

    [Theory]
    [InlineData("csv", "")]
    [InlineData("ndjson", "null")]
    public void A_ball_that_bounces_for_ever_has_no_outcome(string format, string none)
    {
        string box = string.Join(", ", new[] { (0, -19.0, 9.0, 0.1), (0, 5.0, 9.0, 0.1), (-9, -7.0, 0.1, 12.0), (9, -7.0, 0.1, 12.0) }.Select((wall, i) => string.Create(
            CultureInfo.InvariantCulture, $"{{\"name\": \"side {i}\", \"shape\": \"box\", \"center\": [{wall.Item1}, 20, {wall.Item2}], \"halfSize\": [{wall.Item3}, 20, {wall.Item4}], \"surface\": {{\"normalRestitution\": 1, \"slidingFriction\": 0}}}}")));
        string sweep = $"{{{SmallGoals}, {Slippery}, \"obstacles\": [{box}], \"launch\": {{\"position\": [0, 0.11, 0], \"speed\": 12, \"elevation\": 0, \"azimuth\": {{\"list\": [80, 100]}}}}, \"row\": {{\"columns\": [\"index\", \"outcome\"]}}}}";
        FootballCommand done = FootballCommand.Run(sweep, "sweep", "-", "--count", "4", "--format", format);
        Assert.True(done.ExitCode == 0, done.Error);
        Assert.Equal("The outcome of 4 of 4 rows is unknown (4: the ball still moves at the end of the longest flight).", done.Error.Trim());
        string[] lines = [.. done.Output.Split('\n', StringSplitOptions.RemoveEmptyEntries).TakeLast(4)];
        Assert.All(lines, line => Assert.EndsWith(format == "csv" ? "," + none : $":{none}}}", line));
    }

    [Theory]
    [InlineData("impact")]
    [InlineData("time")]
    public void The_other_columns_are_the_same_with_the_outcome_and_without(string stop)
    {
        string Sweep(string columns) =>
            $"{{{NetGoal}, {Wall}, {Launch}, \"stop\": {{\"at\": \"{stop}\", \"time\": 0.8}}, \"row\": {{\"events\": 2, \"samples\": [0.3, 2], \"hits\": [\"wall\"], \"columns\": [{columns}]}}}}";
        const string Others = "\"end\", \"time\", \"position\", \"velocityAfter\", \"apex\", \"bounces\", \"hits\", \"events.count\", \"events.time\", \"samples.position\"";
        string without = FootballCommand.Run(Sweep(Others), "sweep", "-", "--count", "200").Output;
        string[] with = FootballCommand.Run(Sweep(Others + ", \"outcome\""), "sweep", "-", "--count", "200").Output.Split('\n');
        Assert.Equal(without, string.Join('\n', with.Select(line => System.Text.RegularExpressions.Regex.Replace(line, ",\"outcome\":[^}]*", ""))));
    }

    private static string?[] FlownToRest(string scene, IReadOnlyList<JsonElement> rows)
    {
        string batch = string.Join('\n', rows.Select(row =>
        {
            JsonNode shot = JsonNode.Parse($"{{{scene}, \"stop\": {{\"at\": \"rest\", \"time\": {Longest}}}, \"launch\": {{\"position\": [0, 0.11, 0], \"velocity\": {row.GetProperty("launch.velocity")}, \"spin\": {row.GetProperty("launch.spin")}}}}}")!;
            shot.AsObject().Remove("ranges");
            if (row.TryGetProperty("air.wind.0", out JsonElement wind))
            {
                shot["air"] = JsonNode.Parse($"{{\"wind\": [{wind}, 0, 0]}}");
            }

            return shot.ToJsonString();
        }));
        FootballCommand flown = FootballCommand.Simulate(batch, "--batch");
        Assert.True(flown.ExitCode == 0, flown.Error);
        return [.. flown.Lines.Select(Outcome)];
    }

    /// <summary>The goals are within 20 m of the origin, and nothing brings a ball back from so far.</summary>
    private static bool IsOut(JsonElement position) => Math.Sqrt(Math.Pow(position[0].GetDouble(), 2) + Math.Pow(position[2].GetDouble(), 2)) > 120;

    private static string? Outcome(JsonElement flight)
    {
        JsonElement[] events = [.. flight.GetProperty("events").EnumerateArray()];
        bool Has(string kind, params string[] surfaces) =>
            events.Any(e => e.GetProperty("kind").GetString() == kind && (surfaces.Length == 0 || surfaces.Any(surface => e.GetProperty("surface").GetString()!.Contains(surface))));
        return Has("goal") ? "goal"
            : !Has("rest") && !(IsOut(flight.GetProperty("final").GetProperty("position"))) ? null
            : Has("impact", "keeper", "wall", "board") ? "save"
            : Has("impact", "post", "bar") ? "post" : "miss";
    }
}
