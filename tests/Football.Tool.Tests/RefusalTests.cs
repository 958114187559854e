using System.Text;

namespace FootballPhysics.Tool.Tests;

/// <summary>Every input that is not as it should be is refused on one line that names field, value and what is allowed.</summary>
public sealed class RefusalTests
{
    private const string L = FootballCommand.Launch;

    [Theory]
    [InlineData("ball.mass", "-1", "0.001 … 100")]
    [InlineData("ball.mass", "0", "0.001 … 100")]
    [InlineData("ball.mass", "1e999", "0.001 … 100")]
    [InlineData("ball.mass", "\"NaN\"", "0.001 … 100")]
    [InlineData("ball.mass", "\"0.43\"", "0.001 … 100")]
    [InlineData("ball.mass", "null", "0.001 … 100")]
    [InlineData("ball.mass", "[1]", "0.001 … 100")]
    [InlineData("ball.mass", "true", "0.001 … 100")]
    [InlineData("ball.radius", "0", "0.005 … 5")]
    [InlineData("ball.radius", "1000001", "0.005 … 5")]
    [InlineData("ball.inertiaFactor", "1.01", "0.1 … 1")]
    [InlineData("ball", "5", "an object {type, roughness, dragCurve, mass, radius, inertiaFactor, bounce, pressure, knuckleForce, reverseLift, seamSeed, ignores}")]
    [InlineData("air.density", "-0.1", "0 … 100")]
    [InlineData("air.kinematicViscosity", "0", "1E-07 … 0.1")]
    [InlineData("air.wind", "[1000, 1, 0]", "at most 1000 m/s")]
    [InlineData("air.wind", "[1, 2]", "[x, y, z]")]
    [InlineData("gravity", "-9.81", "0 … 1000")]
    [InlineData("forces.buoyancy", "\"yes\"", "true | false")]
    [InlineData("forces.drag", "\"emprical\"", "none | constant | empirical")]
    [InlineData("forces.drag", "\"Empirical\"", "none | constant | empirical")]
    [InlineData("forces.coefficients", "1", "published | regularised")]
    [InlineData("forces.dragCoefficient", "-1", "0 … 10")]
    [InlineData("forces.spinDecayCoefficient", "-1", "0 … 1")]
    [InlineData("ground.normalRestitution", "1.5", "0 … 1")]
    [InlineData("ground.spinRestitution", "-0.1", "0 … 1")]
    [InlineData("ground.tangentialRestitution", "[0.5]", "a number, or [x, z], 2 finite numbers")]
    [InlineData("ground.slidingFriction", "-1", "0 … 10")]
    [InlineData("ground.rollingFriction", "-1", "0 … 10")]
    [InlineData("ground.spinDamping", "-1", "0 … 1")]
    [InlineData("ground.minimumBounceSpeed", "0.0009", "0.001 … 10")]
    [InlineData("ground.restEnergy", "0", "1E-12 … 100")]
    [InlineData("ground.height", "2e6", "-1000000 … 1000000")]
    [InlineData("ground.aerodynamics", "\"all\"", "horizontal | none")]
    [InlineData("solver.integrator", "\"rk5\"", "euler | semiImplicitEuler | rk2 | rk4")]
    [InlineData("solver.timeStep", "0", "above 0")]
    [InlineData("solver.timeStep", "-0.01", "above 0")]
    [InlineData("solver.collisionTiming", "\"\"", "exact | bisection")]
    [InlineData("solver.collisionTolerance", "0", "above 0")]
    [InlineData("solver.rollingTransition", "{}", "exact | heuristic")]
    [InlineData("stop.at", "\"end\"", "time | impact | rest")]
    [InlineData("stop.time", "0", "above 0")]
    [InlineData("samples", "1", "true | false")]
    public void A_value_that_is_not_allowed(string field, string value, string allowed)
    {
        string[] path = field.Split('.');
        string member = path.Length == 1 ? $"\"{field}\":{value}" : $"\"{path[0]}\":{{\"{path[1]}\":{value}}}";
        Refused($"{{{L},{member}}}", $"{field} is {value}; allowed: ", allowed);
    }

    [Theory]
    [InlineData("\"ground\":{\"tangentialRestitution\":[0.5,1.5]}", "ground.tangentialRestitution[1] is 1.5; allowed: -1 … 1.")]
    [InlineData("\"ground\":{\"tangentialRestitution\":[-2,0]}", "ground.tangentialRestitution[0] is -2; allowed: -1 … 1.")]
    [InlineData("\"air\":{\"wind\":[0,\"x\",0]}", "air.wind[1] is \"x\"; allowed: a finite number")]
    [InlineData("\"air\":{\"wind\":[0,0,1e400]}", "air.wind[2] is 1e400; allowed: a finite number")]
    public void An_element_of_an_array_is_named_with_its_index(string member, string begins) => Refused($"{{{L},{member}}}", begins, "allowed");

    [Theory]
    [InlineData("\"position\":[0,1,0]", "launch.velocity is missing; allowed: ", "[x, y, z], 3 finite numbers")]
    [InlineData("\"velocity\":[0,1,0]", "launch.position is missing; allowed: ", "[x, y, z], 3 finite numbers")]
    [InlineData("\"position\":[0,1e7,0],\"velocity\":[1,0,0]", "launch.position is [0,1e7,0]; allowed: ", "within ±1000000 m")]
    [InlineData("\"position\":[0,1,0],\"velocity\":[800,800,0]", "launch.velocity is [800,800,0]; allowed: ", "at most 1000 m/s")]
    [InlineData("\"position\":[0,1,0],\"velocity\":[1,\"x\",0]", "launch.velocity[1] is \"x\"; allowed: a finite number", "[x, y, z]")]
    [InlineData("\"position\":[0,1,0],\"velocity\":[1,NaN,0]", "launch.velocity[1] is NaN, which is not JSON (byte 45); allowed: ", "finite numbers")]
    [InlineData("\"position\":[0,1,0],\"velocity\":[1,0,1e400]", "launch.velocity[2] is 1e400; allowed: a finite number", "[x, y, z]")]
    [InlineData("\"position\":[0,1,0],\"velocity\":[1,0,0],\"spin\":[0,10001,0]", "launch.spin is [0,10001,0]; allowed: ", "10000 rad/s")]
    [InlineData("\"position\":[0,1,0],\"velocity\":[1,0,0],\"orientation\":[0,0,0,0]", "launch.orientation is [0,0,0,0]; allowed: ", "other than zero")]
    public void A_launch_that_is_not_allowed(string members, string begins, string allowed) =>
        Refused($"{{\"launch\":{{{members}}}}}", begins, allowed);

    [Theory]
    [InlineData("\"ball\":{\"mas\":1}", "ball.mas is unknown (given 1)", "did you mean ball.mass?")]
    [InlineData("\"ball\":{\"Mass\":1}", "ball.Mass is unknown (given 1)", "did you mean ball.mass?")]
    [InlineData("\"solvr\":{}", "solvr is unknown (given {})", "did you mean solver?")]
    [InlineData("\"timeStep\":0.1", "timeStep is unknown (given 0.1)", "did you mean solver.timeStep?")]
    [InlineData("\"ground\":{\"tangentialRestitutoin\":0}", "ground.tangentialRestitutoin is unknown", "did you mean ground.tangentialRestitution?")]
    [InlineData("\"ball\":{\"colour\":\"red\"}", "ball.colour is unknown (given \"red\")", "allowed in ball: type | roughness | dragCurve | mass | radius | inertiaFactor | bounce | pressure | knuckleForce | reverseLift | seamSeed | ignores.")]
    [InlineData("\"aim\":{}", "aim is unknown", "allowed at the top: ball | air | gravity")]
    public void An_unknown_field(string member, string begins, string hint) => Refused($"{{{L},{member}}}", begins, hint);

    [Theory]
    [InlineData("", "the input is empty", "a JSON object")]
    [InlineData(" \n ", "the input is empty", "a JSON object")]
    [InlineData("{" + L + "},", "the input is more than one value (a separator at byte 51)", "one JSON object")]
    [InlineData("{" + L + "}:", "the input is more than one value (a separator at byte 51)", "one JSON object")]
    [InlineData("1,", "the input is more than one value (a separator at byte 2)", "one JSON object")]
    [InlineData("\"x\":", "the input is more than one value", "one JSON object")]
    [InlineData("null ,", "the input is more than one value", "one JSON object")]
    [InlineData("{" + L + "/* no */}", "the input is /*, which is not JSON", "no comments")]
    [InlineData("{" + L + ",\"ball\":{\"mass\":-Infinity}}", "ball.mass is -Infinity, which is not JSON", "finite numbers")]
    [InlineData("{" + L + ",\"ball\":{\"mass\":Infinity}}", "ball.mass is Infinity, which is not JSON", "finite numbers")]
    [InlineData("[]", "the input is []", "an object")]
    [InlineData("7", "the input is 7", "an object")]
    [InlineData("hello", "the input is hello, which is not JSON (byte 1)", "strict JSON")]
    [InlineData("{" + L, "the input is cut off after byte 49", "strict JSON")]
    [InlineData("{" + L + ",\"ball\":{\"mass\":0.4", "ball.mass is cut off after byte 68", "strict JSON")]
    [InlineData("{" + L + ",\"ball\":{\"mass\":", "ball.mass is cut off after byte 65", "strict JSON")]
    [InlineData("{" + L + ",\"ball\":{\"mass\":0x1}}", "ball.mass is 0x1, which is not JSON (byte 66)", "strict JSON")]
    [InlineData("{" + L + ",}", "the input is }, which is not JSON (byte 51)", "no trailing commas")]
    [InlineData("{" + L + "} {}", "the input is more than one value", "--batch")]
    [InlineData("{" + L + "," + L + "}", "launch is given twice; allowed: once", "once")]
    [InlineData("{" + L + ",\"ball\":{\"mass\":1,\"mass\":2}}", "ball.mass is given twice; allowed: once", "once")]
    [InlineData("{" + L + ",\"a\\nb\":1}", "a\\u000ab is unknown", "allowed at the top")]
    [InlineData("{" + L + ",\"x\":\"\\ud800\"}", "x is \"\\ud800\", which is not JSON", "strict JSON")]
    [InlineData("{\"name\":5,\"scenario\":{" + L + "}}", "name is 5", "a string")]
    [InlineData("{\"name\":\"x\"}", "scenario is missing", "an object")]
    [InlineData("{\"scenario\":5}", "the scenario is 5", "an object {ball, ")]
    [InlineData("{\"scenario\":{" + L + ",\"ball\":{\"mass\":NaN}}}", "ball.mass is NaN, which is not JSON", "finite numbers")]
    [InlineData("{" + L + ",\"solver\":{\"timeStep\":1e-300}}", "solver.timeStep is 1e-300; allowed: ", "2E-11 or more")]
    [InlineData("{" + L + ",\"samples\":true,\"solver\":{\"timeStep\":1e-9}}", "samples is true with 20000000000 steps", "at most 1000000 steps")]
    public void A_text_that_is_not_what_it_should_be(string input, string begins, string allowed) => Refused(input, begins, allowed);

    [Fact]
    public void Bytes_that_are_not_text()
    {
        byte[] input = [.. Encoding.UTF8.GetBytes("{\"launch\":\""), 0xff, .. Encoding.UTF8.GetBytes("\"}")];
        var refused = FootballCommand.Run(input, "simulate", "-");
        Assert.Equal(1, refused.ExitCode);
        Assert.StartsWith("football: the input is not UTF-8 at byte 12", refused.ErrorLine);
    }

    [Fact]
    public void Depth_without_end() => Refused(new string('[', 100_000), "[0][0][0]", "nested too deep");

    [Fact]
    public void A_value_without_end_is_shortened()
    {
        string line = Refused($"{{{L},\"ball\":{{\"mass\":\"{new string('x', 10_000)}\"}}}}", "ball.mass is \"xxx", "allowed: 0.001 … 100");
        Assert.True(line.Length < 200, line);
    }

    [Theory]
    [InlineData("")]
    [InlineData("nul")]
    [InlineData("\"\\u12")]
    [InlineData("{\"launch\":{\"position\":[0,1,0],\"velocity\":[1,0,0],\"spin\":[1,2,3],\"orientation\":[0,0,0,1]},\"ball\":{\"mass\":0.4},\"forces\":{\"drag\":\"none\",\"buoyancy\":true},\"stop\":{\"time\":0.2}}")]
    public void Any_damage_is_refused_or_played_never_more(string text)
    {
        // Cut everywhere, and every byte replaced by some that matter to JSON.
        byte[] whole = Encoding.UTF8.GetBytes(text);
        for (int i = 0; i < whole.Length; i++)
        {
            Harmless(whole[..i]);
            foreach (byte b in "\0{}[]\",:-9e\\\xff"u8)
            {
                byte[] damaged = [.. whole];
                damaged[i] = b;
                Harmless(damaged);
            }
        }
    }

    private static void Harmless(byte[] input)
    {
        var done = FootballCommand.Run(input, "simulate", "-");
        if (done.ExitCode == 0)
        {
            Assert.Equal("", done.Error);
            Assert.NotNull(done.Result.GetProperty("final").GetProperty("state").GetString());
        }
        else
        {
            Assert.Equal(1, done.ExitCode);
            Assert.Equal("", done.Output);
            Assert.Contains("allowed", done.ErrorLine);
            Assert.DoesNotContain("internal error", done.ErrorLine);
        }
    }

    private static string Refused(string input, string begins, string contains)
    {
        FootballCommand refused = FootballCommand.Simulate(input);
        Assert.Equal(1, refused.ExitCode);
        Assert.Equal("", refused.Output);
        Assert.StartsWith("football: " + begins, refused.ErrorLine);
        Assert.Contains(contains, refused.ErrorLine);
        return refused.ErrorLine;
    }
}
