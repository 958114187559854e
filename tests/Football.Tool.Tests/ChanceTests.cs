using System.Text.Json;
using FootballPhysics.Batch;

namespace FootballPhysics.Tool.Tests;

/// <summary>football chance, and the columns of a sweep: the numbers of GoalChance, bit by bit.</summary>
public sealed class ChanceTests
{
    private const string Goal = "\"goals\": [{\"center\": [0, 0, -20], \"facing\": [0, 0, 1]}]";
    private const string Chance = "\"chance\": {\"keeper\": {\"position\": [0, 0, -19.5], \"heights\": [0, 2.7], \"reach\": 1}, \"spread\": {\"azimuthDegrees\": 4, \"elevationDegrees\": 2}, \"kicks\": 800, \"seed\": 5}";

    private static GoalChanceResult Expected(Vector3d velocity, Vector3d spin)
    {
        var goal = new Goal { Center = new Vector3d(0, 0, -20), Facing = new Vector3d(0, 0, 1) };
        return new GoalChance(Scene.Default with { Goals = [goal] }).Find(new GoalChanceRequest
        {
            Position = new Vector3d(0, 0.11, 0),
            Velocity = velocity,
            Spin = spin,
            Goal = goal,
            Keeper = new Player { Position = new Vector3d(0, 0, -19.5), MinimumHeight = 0, MaximumHeight = 2.7, Reach = 1 },
            Spread = new KickSpread { AzimuthDegrees = 4, ElevationDegrees = 2 },
            Kicks = 800,
            Seed = 5,
            AlwaysSimulate = true,
        });
    }

    [Theory]
    [InlineData(2, 4, -24)]
    [InlineData(3.4, 4.2, -24)]
    public void The_command_prints_the_numbers_of_the_library(double x, double y, double z)
    {
        var velocity = new Vector3d(x, y, z);
        FootballCommand done = FootballCommand.Run(FormattableString.Invariant($"{{{Goal}, {Chance}, \"launch\": {{\"position\": [0, 0.11, 0], \"velocity\": [{x}, {y}, {z}]}}}}"), "chance", "-");
        Assert.Equal("", done.Error);
        GoalChanceResult expected = Expected(velocity, Vector3d.Zero);
        double Of(string name) => done.Result.GetProperty(name).GetDouble();
        Assert.Equal(expected.Scores, Of("goal"));
        Assert.Equal(expected.Covered, Of("save"));
        Assert.Equal(expected.Post, Of("post"));
        Assert.Equal(expected.Wide, Of("wide"));
        Assert.Equal(800, Of("kicks"));
        Assert.Equal(expected.StandardError, done.Result.GetProperty("errors").GetProperty("goal").GetDouble());
        Assert.Equal(1, Of("goal") + Of("save") + Of("post") + Of("wide"), 1e-12);
        Assert.True(Of("wide") > 0 && Of("goal") > 0);
    }

    [Fact]
    public void A_row_of_a_sweep_has_the_chance_of_its_own_kick()
    {
        FootballCommand done = FootballCommand.Run(
            $"{{{Goal}, {Chance}, \"launch\": {{\"position\": [0, 0.11, 0], \"speed\": [22, 28], \"azimuth\": [-8, 8], \"elevation\": [5, 12]}}, \"row\": {{\"columns\": [\"launch.velocity\", \"launch.spin\", \"chance.goal\", \"chance.save\", \"chance.post\", \"chance.wide\", \"chance.goalError\", \"chance.kicks\"]}}}}",
            "sweep", "-", "--count", "6");
        Assert.Equal("", done.Error);
        foreach (JsonElement row in done.Lines)
        {
            Vector3d Vector(string name) => new(row.GetProperty(name)[0].GetDouble(), row.GetProperty(name)[1].GetDouble(), row.GetProperty(name)[2].GetDouble());
            GoalChanceResult expected = Expected(Vector("launch.velocity"), Vector("launch.spin"));
            Assert.Equal(expected.Scores, row.GetProperty("chance.goal").GetDouble());
            Assert.Equal(expected.Covered, row.GetProperty("chance.save").GetDouble());
            Assert.Equal(expected.Post, row.GetProperty("chance.post").GetDouble());
            Assert.Equal(expected.StandardError, row.GetProperty("chance.goalError").GetDouble());
            Assert.Equal(800, row.GetProperty("chance.kicks").GetInt32());
        }

        Assert.True(done.Lines.Select(row => row.GetProperty("chance.goal").GetDouble()).Distinct().Count() > 2);
    }

    [Theory]
    [InlineData("{\"launch\": {\"position\": [0, 0.11, 0], \"velocity\": [2, 4, -24]}, \"chance\": {}}", "goal is 0; allowed: none, because the scene has no goals")]
    [InlineData("{" + Goal + ", \"launch\": {\"position\": [0, 0.11, 0], \"velocity\": [2, 4, -24]}, \"chance\": {\"kiks\": 3}}", "kiks is unknown")]
    public void A_wrong_request_names_its_field(string input, string words) => Assert.Contains(words, FootballCommand.Run(input, "chance", "-").ErrorLine);

    [Fact]
    public void A_wrong_word_of_an_option_is_refused_in_one_line() =>
        Assert.Contains("--format is xlsx; allowed: ndjson | csv | npy | parquet.", FootballCommand.Run("{}", "sweep", "-", "--format", "xlsx").Error);
}
