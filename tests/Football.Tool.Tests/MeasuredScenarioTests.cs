using System.Text.Json;

namespace FootballPhysics.Tool.Tests;

/// <summary>What a scenario of the measured profile can say, and what it is refused for.</summary>
public sealed class MeasuredScenarioTests
{
    private const string L = FootballCommand.Launch;

    [Theory]
    [InlineData("\"ball\":{\"type\":\"jabulani\"}")]
    [InlineData("\"ball\":{\"type\":\"generic\",\"mass\":0.45,\"knuckleForce\":2}")]
    [InlineData("\"ball\":{\"type\":\"beachBall\",\"reverseLift\":0.1}")]
    [InlineData("\"air\":{\"weather\":{\"temperature\":-5,\"humidity\":0.8}}")]
    [InlineData("\"air\":{\"weather\":{\"altitude\":2240},\"wind\":[3,0,1]}")]
    [InlineData("\"air\":{\"wind\":{\"speed\":8,\"direction\":[1,-2]}}")]
    [InlineData("\"air\":{\"wind\":{\"speed\":8,\"direction\":[1,-2],\"referenceHeight\":5,\"roughness\":0.1,\"gusts\":{\"seed\":7,\"intensity\":0.3,\"length\":60}}}")]
    [InlineData("\"forces\":{\"knuckleSeed\":1063967332764},\"launch\":{\"position\":[0,0.11,0],\"velocity\":[25,8,0]}")]
    public void Each_part_changes_where_the_ball_lands(string part)
    {
        string launch = part.Contains("launch", StringComparison.Ordinal) ? part[part.IndexOf("\"launch\"", StringComparison.Ordinal)..] : L;
        string plain = $"{{{launch}}}";
        string changed = part.Contains("launch", StringComparison.Ordinal) ? $"{{{part}}}" : $"{{{launch},{part}}}";
        Assert.NotEqual(Landing(plain), Landing(changed));
    }

    [Fact]
    public void The_profile_is_measured_by_default_with_the_modern_ball_on_match_turf()
    {
        Assert.Equal(Landing($"{{{L}}}"), Landing($"{{{L},\"profile\":\"measured\"}}"));
        Assert.NotEqual(Landing($"{{{L}}}"), Landing($"{{{L},\"profile\":\"published\"}}"));
        Assert.Equal(Landing($"{{{L},\"profile\":\"measured\"}}"), Landing($"{{{L},\"profile\":\"measured\",\"ball\":{{\"type\":\"modern\"}},\"ground\":{{\"surface\":\"matchTurf\"}},\"forces\":{{\"knuckleSeed\":null}}}}"));
    }

    /// <summary>With a seed, orientation and seams decide the path; without one, nothing depends on them.</summary>
    [Fact]
    public void Seams_and_orientation_act_with_a_seed_alone()
    {
        const string Flat = "\"launch\":{\"position\":[0,0.11,0],\"velocity\":[25,8,0]";
        const string Turned = Flat + ",\"orientation\":[1,0,0,1]}";
        const string Seed = ",\"forces\":{\"knuckleSeed\":3}";
        const string Seams = ",\"ball\":{\"seamSeed\":77}";
        Assert.NotEqual(Landing($"{{{Flat}}}{Seed}}}"), Landing($"{{{Turned}{Seed}}}"));
        Assert.NotEqual(Landing($"{{{Turned}{Seed}}}"), Landing($"{{{Turned}{Seed}{Seams}}}"));
        Assert.Equal(Landing($"{{{Flat}}}}}"), Landing($"{{{Turned}}}"));
        Assert.Equal(Landing($"{{{Turned}}}"), Landing($"{{{Turned}{Seams}}}"));
        JsonElement impact = FootballCommand.Play($"{{{Turned}{Seed}}}").GetProperty("events")[0];
        Assert.All(
            ["normalImpulse", "tangentialImpulse", "slipBefore", "slipAfter", "contactTime", "compression", "peakForce", "energyLost"],
            name => Assert.True(impact.GetProperty(name).GetDouble() > 0));
        Assert.False(impact.GetProperty("grips").GetBoolean());
    }

    [Theory]
    [InlineData("measured")]
    [InlineData("published")]
    public void Without_ground_a_ball_falls_from_where_it_is_and_a_kick_begins_at_the_origin(string profile)
    {
        string[] options = ["--profile", profile, "--set", "ground.surface=none", "--set", "air.density=0", "--set", "gravity=9.81"];
        JsonElement fallen = FootballCommand.Play("{\"launch\":{\"position\":[0,0,0],\"velocity\":[0,0,0]},\"stop\":{\"at\":\"time\",\"time\":1}}", options).GetProperty("final");
        Assert.Equal(-4.905, fallen.GetProperty("position")[1].GetDouble(), 1e-9);
        Assert.Equal("airborne", fallen.GetProperty("state").GetString());
        JsonElement kicked = FootballCommand.Run("", ["kick", "--speed", "10", "--elevation", "0", .. options, "--set", "stop.time=1", "--set", "samples=true"]).Result;
        Assert.Equal("[0,0,0]", kicked.GetProperty("samples")[0].GetProperty("position").GetRawText());
        Assert.Equal(-4.905, kicked.GetProperty("final").GetProperty("position")[1].GetDouble(), 1e-9);
        Assert.Equal(0, kicked.GetProperty("events").GetArrayLength());
    }

    /// <summary>A gravity vector that is not straight down, and dials, reach the scene.</summary>
    [Fact]
    public void Gravity_may_be_a_vector_and_dials_change_the_ball()
    {
        const string Fall = "\"launch\":{\"position\":[0,9,0],\"velocity\":[0,0,0]},\"stop\":{\"at\":\"time\",\"time\":1},\"air\":{\"density\":0}";
        JsonElement fallen = FootballCommand.Play($"{{{Fall},\"gravity\":[2,-9,1]}}").GetProperty("final").GetProperty("position");
        Assert.Equal([1, 4.5, 0.5], fallen.EnumerateArray().Select(number => Math.Round(number.GetDouble(), 9)));
        double soft = FootballCommand.Play($"{{{Fall},\"ground\":{{\"surface\":\"concrete\",\"height\":8}},\"dials\":{{\"pressure\":0.6}}}}").GetProperty("final").GetProperty("position")[1].GetDouble();
        double hard = FootballCommand.Play($"{{{Fall},\"ground\":{{\"surface\":\"concrete\",\"height\":8}}}}").GetProperty("final").GetProperty("position")[1].GetDouble();
        Assert.True(soft < hard - 0.005, $"{soft} {hard}");
    }

    [Theory]
    [InlineData("\"gravity\":[0,1,0]", "gravity is [0,1,0]; allowed: a number, or [x, y, z] with y at most 0")]
    [InlineData("\"gravity\":[2000,-1,0]", "gravity[0] is 2000; allowed: -1000 … 1000")]
    [InlineData("\"dials\":{\"pressure\":2}", "dials.pressure is 2; allowed: 0.6 … 1.1")]
    [InlineData("\"profile\":\"thesis\"", "profile is \"thesis\"; allowed: measured | published")]
    [InlineData("\"ball\":{\"type\":\"beach\"}", "ball.type is \"beach\"; allowed: modern | generic | tango12 | teamgeist | jabulani | brazuca | telstar18 | flight2020 | alRihla | fussballliebe | trionda | youthFootball | futsal | beachBall | medicineBall")]
    [InlineData("\"ball\":{\"seamSeed\":1.5}", "ball.seamSeed is 1.5; allowed: a whole number")]
    [InlineData("\"ball\":{\"knuckleForce\":-1}", "ball.knuckleForce is -1; allowed: 0 … 100")]
    [InlineData("\"ground\":{\"surface\":\"none\",\"height\":2}", "ground.height is 2; allowed: a surface other than none")]
    [InlineData("\"ground\":{\"surface\":\"none\",\"normal\":[0,1,1]}", "ground.normal is [0,1,1]; allowed: a surface other than none")]
    [InlineData("\"air\":{\"weather\":{\"temperature\":99}}", "air.weather.temperature is 99; allowed: -60 … 60")]
    [InlineData("\"air\":{\"weather\":{\"humidity\":\"wet\"}}", "air.weather.humidity is \"wet\"; allowed: 0 … 1")]
    [InlineData("\"air\":{\"weather\":{\"altitude\":20000}}", "air.weather.altitude is 20000; allowed: -500 … 11000")]
    [InlineData("\"air\":{\"weather\":{\"pressure\":1013}}", "air.weather.pressure is 1013; allowed: 10000 … 120000")]
    [InlineData("\"air\":{\"weather\":{\"pressure\":90000,\"altitude\":10}}", "air.weather.pressure is 90000; allowed: pressure or altitude, not both")]
    [InlineData("\"air\":{\"weather\":{},\"density\":1.1}", "air.density is 1.1; allowed: density or weather, not both")]
    [InlineData("\"air\":{\"wind\":{\"direction\":[1,0]}}", "air.wind.speed is missing; allowed: a finite number")]
    [InlineData("\"air\":{\"wind\":{\"speed\":3}}", "air.wind.direction is missing; allowed: [x, z], 2 finite numbers")]
    [InlineData("\"air\":{\"wind\":{\"speed\":300,\"direction\":[1,0]}}", "air.wind.speed is 300; allowed: 0 … 200")]
    [InlineData("\"air\":{\"wind\":{\"speed\":3,\"direction\":[0,0]}}", "air.wind.direction is [0,0]; allowed: [x, z], 2 finite numbers, not both 0")]
    [InlineData("\"air\":{\"wind\":{\"speed\":3,\"direction\":[1,0],\"roughness\":0}}", "air.wind.roughness is 0; allowed: 0.0001 … 2")]
    [InlineData("\"air\":{\"wind\":{\"speed\":3,\"direction\":[1,0],\"gusts\":{\"length\":0}}}", "air.wind.gusts.length is 0; allowed: 1 … 1000")]
    [InlineData("\"air\":{\"wind\":{\"speed\":3,\"direction\":[1,0],\"gusts\":{\"seed\":1.5}}}", "air.wind.gusts.seed is 1.5; allowed: a whole number")]
    [InlineData("\"forces\":{\"knuckleSeed\":1.5}", "forces.knuckleSeed is 1.5; allowed: a whole number")]
    [InlineData("\"air\":{\"wind\":{\"speed\":3,\"direction\":[1,0],\"knots\":1}}", "air.wind.knots is unknown (given 1); allowed in air.wind: speed | direction | referenceHeight | roughness | gusts")]
    public void What_is_not_allowed_is_refused_by_name(string part, string message)
    {
        FootballCommand refused = FootballCommand.Simulate($"{{{L},{part}}}");
        Assert.Equal(1, refused.ExitCode);
        Assert.StartsWith("football: " + message, refused.ErrorLine);
    }

    [Fact]
    public void The_published_profile_has_one_ball()
    {
        FootballCommand refused = FootballCommand.Simulate($"{{{L},\"ball\":{{\"type\":\"generic\"}}}}", "--profile", "published");
        Assert.Equal(1, refused.ExitCode);
        Assert.StartsWith("football: ball.type is unknown (given \"generic\"); allowed in ball: mass | radius | inertiaFactor", refused.ErrorLine);
    }

    [Fact]
    public void The_option_is_short_for_the_field_and_a_field_set_later_counts()
    {
        string published = FootballCommand.Simulate($"{{{L},\"profile\":\"published\"}}").Output;
        Assert.Equal(published, FootballCommand.Simulate($"{{{L}}}", "--profile", "published").Output);
        Assert.Equal(published, FootballCommand.Simulate($"{{{L},\"profile\":\"measured\"}}", "--profile", "published").Output);
        Assert.Equal(FootballCommand.Simulate($"{{{L}}}").Output, FootballCommand.Simulate($"{{{L}}}", "--profile", "published", "--set", "profile=measured").Output);
        FootballCommand refused = FootballCommand.Simulate($"{{{L}}}", "--profile", "thesis");
        Assert.Equal(2, refused.ExitCode);
        Assert.Contains("--profile is thesis; allowed: measured | published.", refused.Error);
    }

    [Theory]
    [InlineData("aim", "{\"aim\":{\"from\":[0,0.11,0],\"target\":[20,1.5,3],\"speed\":25}}")]
    [InlineData("intercept", "{\"launch\":{\"position\":[0,0.11,0],\"velocity\":[8,7,-24]},\"stop\":{\"at\":\"time\",\"time\":3},\"runners\":[{\"name\":\"nine\",\"position\":[10,0,-30]}]}")]
    [InlineData("fit", "{\"track\":[{\"time\":0,\"position\":[0,0.11,0]},{\"time\":0.2,\"position\":[0.6,1.31,-4.2]},{\"time\":0.4,\"position\":[1.2,2.12,-8.1]},{\"time\":0.6,\"position\":[1.8,2.57,-11.8]}]}")]
    [InlineData("sweep", "{\"launch\":{\"speed\":[20,25],\"elevation\":12}}")]
    public void Every_command_has_the_measured_profile_and_the_published_one_a_word_away(string command, string input)
    {
        string plain = FootballCommand.Run(input, command, "-").Output;
        Assert.NotEqual("", plain);
        Assert.Equal(plain, FootballCommand.Run(input, command, "-", "--profile", "measured").Output);
        string published = FootballCommand.Run(input, command, "-", "--profile", "published").Output;
        Assert.NotEqual(plain, published);
        Assert.Equal(published, FootballCommand.Run(input, command, "-", "--set", "profile=published").Output);
    }

    private static string Landing(string scenario)
    {
        FootballCommand done = FootballCommand.Simulate(scenario);
        Assert.True(done.ExitCode == 0, done.Error);
        return done.Lines[0].GetProperty("final").GetProperty("position").GetRawText();
    }
}
