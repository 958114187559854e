using System.Text.Json;
using System.Xml.Linq;
using FootballPhysics.Tool.Gallery;

namespace FootballPhysics.Tool.Tests;

/// <summary>football kick: a shot without a file, for a person and for a program.</summary>
public sealed class KickTests
{
    private static readonly string[] s_kick = ["kick", "--speed", "27", "--elevation", "12", "--azimuth", "5", "--top-spin", "-10", "--side-spin", "60"];

    [Fact]
    public void Redirected_it_is_what_simulate_says_of_the_same_launch()
    {
        JsonElement kick = FootballCommand.Run("", s_kick).Result;
        (double up, double flat) = Math.SinCos(12 * Math.PI / 180);
        (double left, double along) = Math.SinCos(5 * Math.PI / 180);
        var velocity = new Vector3d(-27 * flat * left, 27 * up, -27 * flat * along);
        Vector3d spin = KickVectors.Spin(velocity, -10, 60);
        JsonElement played = FootballCommand.Play(FormattableString.Invariant(
            $"{{\"launch\":{{\"position\":[0,0,0],\"velocity\":[{velocity.X:R},{velocity.Y:R},{velocity.Z:R}],\"spin\":[{spin.X:R},{spin.Y:R},{spin.Z:R}]}},\"stop\":{{\"at\":\"rest\",\"time\":120}}}}"));
        Assert.Equal(played.EnumerateObject().Select(member => member.Name), kick.EnumerateObject().Select(member => member.Name));
        Assert.Equal(played.GetProperty("bounces").GetInt32(), kick.GetProperty("bounces").GetInt32());
        Assert.Equal("stopped", kick.GetProperty("final").GetProperty("state").GetString());
        for (int i = 0; i < 3; i++)
        {
            Assert.Equal(played.GetProperty("final").GetProperty("position")[i].GetDouble(), kick.GetProperty("final").GetProperty("position")[i].GetDouble(), 1e-6);
        }
    }

    [Fact]
    public void In_a_terminal_it_is_a_table_and_two_sketches_that_fit_into_80_columns()
    {
        FootballCommand done = FootballCommand.InTerminal("", s_kick);
        Assert.Equal(0, done.ExitCode);
        Assert.Contains("carry m", done.Output);
        Assert.Contains("impact", done.Output);
        Assert.Contains("rest", done.Output);
        Assert.Contains("m along, height up", done.Output);
        Assert.Contains("m along, left up", done.Output);
        Assert.DoesNotContain("\"final\"", done.Output);
        Assert.All(done.Output.Split('\n'), line => Assert.InRange(line.Length, 0, 80));
    }

    [Fact]
    public void In_a_terminal_simulate_and_aim_are_tables_too_and_json_where_it_is_asked_for()
    {
        string scenario = $"{{{FootballCommand.Launch}}}";
        Assert.Contains("m along, height up", FootballCommand.InTerminal(scenario, "simulate", "-").Output);
        Assert.Equal(FootballCommand.Simulate(scenario).Output, FootballCommand.InTerminal(scenario, "simulate", "-", "--json").Output);
        Assert.Equal(FootballCommand.Run("", s_kick).Output, FootballCommand.InTerminal("", [.. s_kick, "--json"]).Output);
        const string Aim = "{\"aim\":{\"from\":[0,0.11,0],\"target\":[20,1.5,3],\"speed\":25}}";
        Assert.Contains("outOfReach", FootballCommand.InTerminal(Aim, "aim", "-", "--set", "aim.speed=5").Output);
        Assert.Equal(FootballCommand.Run(Aim, "aim", "-").Output, FootballCommand.InTerminal(Aim, "aim", "-", "--json").Output);
    }

    [Fact]
    public void It_is_drawn_to_the_file_named()
    {
        string file = Path.Combine(AppContext.BaseDirectory, "kick-test.svg");
        Assert.Equal(0, FootballCommand.Run("", [.. s_kick, "--svg", file]).ExitCode);
        var drawing = XDocument.Load(file);
        Assert.Contains(drawing.Descendants(), text => text.Value == "From the side");
        Assert.Contains(drawing.Descendants(), text => text.Value.StartsWith("27 m/s, 12° up", StringComparison.Ordinal));
    }

    [Fact]
    public void Every_number_and_every_field_counts()
    {
        string plain = FootballCommand.Run("", s_kick).Output;
        for (int i = 1; i < s_kick.Length; i += 2)
        {
            string[] other = [.. s_kick];
            other[i + 1] = "3";
            Assert.NotEqual(plain, FootballCommand.Run("", other).Output);
        }

        Assert.NotEqual(plain, FootballCommand.Run("", [.. s_kick, "--set", "air.wind=[3,0,0]"]).Output);
        Assert.True(FootballCommand.Run("", [.. s_kick, "--set", "samples=true"]).Result.TryGetProperty("samples", out _));
    }

    [Theory]
    [InlineData(2, "--speed is 1001; allowed: 0 … 1000 m/s.", "--speed", "1001")]
    [InlineData(2, "--speed is fast; allowed: 0 … 1000 m/s.", "--speed", "fast")]
    [InlineData(2, "--speed is NaN; allowed: 0 … 1000 m/s.", "--speed", "NaN")]
    [InlineData(2, "--elevation is 91; allowed: -90 … 90 degrees.", "--elevation", "91")]
    [InlineData(1, "air.wind[1] is \"x\"; allowed: a finite number", "--set", "air.wind=[1,\"x\",0]")]
    [InlineData(1, "ball.mass is 0; allowed: 0.001 … 100.", "--set", "ball.mass=0")]
    [InlineData(1, "--svg \"\" cannot be written. Pass a file that can be written.", "--svg", "")]
    public void What_is_wrong_is_refused(int exitCode, string message, params string[] args)
    {
        FootballCommand done = FootballCommand.Run("", ["kick", .. args]);
        Assert.Equal((exitCode, ""), (done.ExitCode, done.Output));
        Assert.StartsWith("football: " + message, done.Error);
    }

    [Fact]
    public void A_sketch_joins_its_points_from_corner_to_corner()
    {
        string[] rows = new Sketch(10, 3).Draw("height", [0, 5, 10], [0, 2.5, 5]).Split('\n');
        Assert.All(Enumerable.Range(0, 10), column => Assert.Contains(rows[..3], row => row[9 + column] != ' '));
        Assert.NotEqual(' ', rows[2][9]);
        Assert.NotEqual(' ', rows[0][18]);
    }
}
