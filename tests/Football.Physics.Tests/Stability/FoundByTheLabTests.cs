using Football.Physics.Tests.Headless;

namespace Football.Physics.Tests.Stability;

/// <summary>What the stress matrix has found, by name, so that it stays found.</summary>
public sealed class FoundByTheLabTests
{
    private const string BalloonInADowndraught =
        "{\"launch\":{\"position\":[0,1,0],\"velocity\":[20,5,0],\"spin\":[1,2,3]},\"ball\":{\"mass\":0.01,\"radius\":0.2},\"air\":{\"wind\":[5,-30,3]},\"stop\":{\"at\":\"time\",\"time\":2}}";

    /// <summary>The apex of a straight piece of path was 0/0.</summary>
    [Fact]
    public void A_path_that_does_not_turn_has_a_finite_apex()
    {
        var result = FootballCommand.Play(BalloonInADowndraught, "--set", "solver.integrator=euler");
        Assert.InRange(result.GetProperty("apex").GetDouble(), 1, 2);
    }

    /// <summary>It bounced ever lower and never stayed down: no end of impacts within one step.</summary>
    [Theory]
    [InlineData("euler")]
    [InlineData("semiImplicitEuler")]
    [InlineData("rk2")]
    [InlineData("rk4")]
    public void A_balloon_that_the_wind_presses_to_the_ground_stays_down(string integrator)
    {
        var result = FootballCommand.Play(BalloonInADowndraught, "--set", $"solver.integrator={integrator}");
        Assert.InRange(result.GetProperty("bounces").GetInt32(), 1, 2000);
    }

    /// <summary>The bound for the Magnus force called for 17 million pieces.</summary>
    [Fact]
    public void A_balloon_of_nine_metres_without_drag_needs_few_pieces()
    {
        var result = FootballCommand.Play(
            "{\"launch\":{\"position\":[0,1,0],\"velocity\":[1,0,0],\"spin\":[1,2,3]},\"ball\":{\"mass\":0.4,\"radius\":9.1},\"forces\":{\"drag\":\"none\"}}");
        Assert.InRange(result.GetProperty("steps").GetInt64(), 2000, 200_000);
    }

    /// <summary>Without inertia a ball goes with the wind and rises or sinks at its terminal speed, at once and without end of pieces.</summary>
    [Theory]
    [InlineData("1e-9")]
    [InlineData("1e-30")]
    [InlineData("1e-300")]
    public void A_ball_without_inertia_goes_with_the_wind_at_its_terminal_speed(string mass)
    {
        foreach (string integrator in new[] { "euler", "semiImplicitEuler", "rk2", "rk4" })
        {
            var result = FootballCommand.Play(
                "{\"launch\":{\"position\":[0,1,0],\"velocity\":[20,5,0],\"spin\":[1,2,3]},\"stop\":{\"at\":\"time\",\"time\":2},\"air\":{\"wind\":[3,0,-4]},\"ball\":{\"mass\":"
                + mass + "}}",
                "--set",
                $"solver.integrator={integrator}");
            double[] velocity = [.. result.GetProperty("final").GetProperty("velocity").EnumerateArray().Select(item => item.GetDouble())];

            // ½ ρ C_D A u² = 4/3 π r³ ρ g with C_D 0.5009 at this speed
            Assert.Equal(3, velocity[0], 1e-3);
            Assert.Equal(2.397, velocity[1], 1e-3);
            Assert.Equal(-4, velocity[2], 1e-3);
            Assert.InRange(result.GetProperty("steps").GetInt64(), 200, 200 * 1100);
        }
    }

    [Fact]
    public void A_strong_Magnus_force_without_drag_does_not_feed_a_method_of_low_order()
    {
        foreach (string integrator in new[] { "euler", "semiImplicitEuler", "rk2", "rk4" })
        {
            var result = FootballCommand.Play(
                "{\"launch\":{\"position\":[0,50,0],\"velocity\":[20,5,0],\"spin\":[100,200,300]},\"stop\":{\"at\":\"time\",\"time\":2},"
                + "\"ball\":{\"mass\":0.1,\"radius\":0.2},\"forces\":{\"drag\":\"none\",\"magnus\":\"constant\",\"magnusCoefficient\":20}}",
                "--set",
                $"solver.integrator={integrator}");
            double[] velocity = [.. result.GetProperty("final").GetProperty("velocity").EnumerateArray().Select(item => item.GetDouble())];
            Assert.All(velocity, component => Assert.InRange(component, -40, 40));
        }
    }
}
