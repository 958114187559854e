namespace FootballPhysics.Tool.Tests;

/// <summary>--set puts a value in every scenario before anything is checked.</summary>
public sealed class OverrideTests
{
    private const string L = FootballCommand.Launch;

    [Theory]
    [InlineData("solver.timeStep=0.04", "\"solver\":{\"timeStep\":0.04}")]
    [InlineData("gravity=5", "\"gravity\":5")]
    [InlineData("forces.drag=none", "\"forces\":{\"drag\":\"none\"}")]
    [InlineData("forces.drag=\"none\"", "\"forces\":{\"drag\":\"none\"}")]
    [InlineData("stop={\"at\":\"rest\",\"time\":5}", "\"stop\":{\"at\":\"rest\",\"time\":5}")]
    [InlineData("air.wind=[1, 0, 2]", "\"air\":{\"wind\":[1,0,2]}")]
    public void It_is_as_if_it_had_been_written(string set, string written) =>
        Assert.Equal(FootballCommand.Play($"{{{L},{written}}}").GetRawText(), FootballCommand.Play($"{{{L}}}", "--set", set).GetRawText());

    [Fact]
    public void It_takes_the_place_of_what_is_refused() =>
        Assert.Equal(
            FootballCommand.Play($"{{{L}}}").GetRawText(),
            FootballCommand.Play($"{{{L},\"ball\":{{\"mass\":-3,\"radius\":0.11}}}}", "--set", "ball.mass=0.43").GetRawText());

    [Fact]
    public void It_can_give_what_is_required() =>
        Assert.Equal(
            FootballCommand.Play($"{{{L}}}").GetRawText(),
            FootballCommand.Play("{}", "--set", "launch.position=[0,1,0]", "--set", "launch.velocity=[1,0,0]").GetRawText());

    [Theory]
    [InlineData("launch.velocity.0=5", "[5,0,0]")]
    [InlineData("launch.velocity[2]=-5", "[1,0,-5]")]
    public void An_element_of_an_array_is_replaced(string set, string velocity) =>
        Assert.Equal(FootballCommand.Play($"{{{L}}}", "--set", $"launch.velocity={velocity}").GetRawText(), FootballCommand.Play($"{{{L}}}", "--set", set).GetRawText());

    [Fact]
    public void The_last_of_two_counts() =>
        Assert.Equal(
            FootballCommand.Play($"{{{L}}}", "--set", "gravity=3").GetRawText(),
            FootballCommand.Play($"{{{L}}}", "--set", "gravity=bad", "--set", "gravity=3").GetRawText());

    [Theory]
    [InlineData("solver.timeStp=0.04", "solver.timeStp is unknown (given 0.04)", "did you mean solver.timeStep?")]
    [InlineData("solver.timeStep=0", "solver.timeStep is 0", "above 0")]
    [InlineData("solver.timeStep=NaN", "solver.timeStep is \"NaN\"", "above 0")]
    [InlineData("solver.timeStep=", "solver.timeStep is \"\"", "above 0")]
    [InlineData("solver=5", "solver is 5", "an object")]
    [InlineData("wind=[0,0,0]", "wind is unknown", "did you mean air.wind?")]
    [InlineData("a..b=1", "a is unknown", "allowed at the top")]
    [InlineData("solver.timeStep=0.04,", "solver.timeStep is \"0.04,\"", "above 0")]
    [InlineData("solver.timeStep={},", "solver.timeStep is \"{},\"", "above 0")]
    [InlineData("launch.velocity.0=fast", "launch.velocity[0] is \"fast\"", "a finite number")]
    [InlineData("launch.velocity.3=5", "--set launch.velocity.3 is no place: launch.velocity has no 3", "an element from 0 to 2")]
    [InlineData("launch.velocity.x=5", "--set launch.velocity.x is no place: launch.velocity has no x", "an element from 0 to 2")]
    [InlineData("launch.velocity.0.1=5", "--set launch.velocity.0.1 is no place: launch.velocity.0 has no 1", "a member of an object, or an element of an array")]
    [InlineData("launch.spin.0=5", "--set launch.spin.0 is no place: launch.spin has no 0", "an element of an array that is there")]
    public void It_is_checked_like_any_other(string set, string begins, string contains)
    {
        FootballCommand refused = FootballCommand.Simulate($"{{{L}}}", "--set", set);
        Assert.Equal(1, refused.ExitCode);
        Assert.StartsWith("football: " + begins, refused.ErrorLine);
        Assert.Contains(contains, refused.ErrorLine);
    }

    [Fact]
    public void It_holds_for_every_line_of_a_batch_wrapped_or_not()
    {
        FootballCommand done = FootballCommand.Simulate($"{{{L}}}\n{{\"name\":\"b\",\"scenario\":{{{L}}}}}\n", "--batch", "--set", "stop.time=0.1");
        Assert.Equal([0.1, 0.1], done.Lines.Select(line => line.GetProperty("final").GetProperty("time").GetDouble()));
    }
}
