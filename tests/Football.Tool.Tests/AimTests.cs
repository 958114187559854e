using System.Globalization;
using System.Text.Json;
using FootballPhysics.Tests.Reference;

namespace FootballPhysics.Tool.Tests;

/// <summary>football aim on the reference cases.</summary>
public sealed class AimTests
{
    private static readonly string s_input = File.ReadAllText(Path.Combine(AppContext.BaseDirectory, "Reference", "aims.ndjson"));
    private static readonly IReadOnlyList<JsonElement> s_cases = [.. ReferenceCase.Lines("aims.ndjson")];

    [Fact]
    public void All_cases_are_there()
    {
        Assert.Equal(41, s_cases.Count);
        Assert.Equal(8, s_cases.Count(HasThrough));
    }

    [Theory]
    [InlineData(0, "blocked")]
    [InlineData(1.5, "hit")]
    public void What_moves_is_where_it_has_come_to_when_the_ball_is_kicked(double kickTime, string status)
    {
        const string Keeper = """{"aim": {"from": [0, 0.11, 0], "target": [0, 1, -15], "speed": 20, "elevation": {"max": 30}}, "obstacles": [{"name": "keeper", "shape": "capsule", "from": [0, 0.3, -8], "to": [0, 5, -8], "radius": 0.3, "velocity": [0.5, 0, 0]}]}""";
        FootballCommand done = FootballCommand.Run(Keeper, "aim", "-", "--set", $"aim.kickTime={kickTime.ToString(CultureInfo.InvariantCulture)}");
        Assert.Equal(status, done.Result.GetProperty("status").GetString());
    }

    /// <summary>A script that keeps what is a hit must not keep a kick that goes through the wall.</summary>
    [Theory]
    [InlineData(-9, "targetOnly")]
    [InlineData(-19.5, "hit")]
    public void A_kick_that_misses_the_point_on_the_way_is_one_of_the_target_only(double z, string status)
    {
        double height = z < -15 ? 1 : 4;
        string scenario = $$$"""{"aim": {"from": [0, 0.11, 0], "through": [0, {{{height}}}, {{{z.ToString(CultureInfo.InvariantCulture)}}}], "target": [0, 1, -20], "speed": 20}}""";
        JsonElement got = FootballCommand.Run(scenario, "aim", "-").Result;
        Assert.Equal(status, Status(got));
        Assert.Equal(status == "hit", got.GetProperty("throughMiss").GetDouble() <= 0.1);
    }

    [Theory]
    [InlineData("1e-3")]
    [InlineData("0.01")]
    public void Direct_hits_what_can_be_reached_within_a_millimetre_and_says_out_of_reach_of_the_rest_and_nothing_else(string tolerance)
    {
        foreach ((JsonElement wanted, JsonElement got) in Aim("direct", "--set", $"aim.tolerance={tolerance}"))
        {
            string name = got.GetProperty("name").GetString()!;
            if (wanted.GetProperty("expected").GetProperty("reachable").GetBoolean())
            {
                Assert.True(Status(got) == "hit", name);
                Assert.True(got.GetProperty("miss").GetDouble() <= 1e-3, name);
                Assert.True(!HasThrough(wanted) || got.GetProperty("throughMiss").GetDouble() <= 1e-2, name);
            }
            else
            {
                Assert.True(Status(got) == "outOfReach", name);
                Assert.True(got.GetProperty("miss").GetDouble() > 1e-3, name);
            }
        }
    }

    [Theory]
    [InlineData("angle", "rk4", "0.01")]
    [InlineData("angle", "rk2", "0.01")]
    [InlineData("bisection", "rk4", "0.01")]
    [InlineData("bisection", "rk2", "0.01")]
    public void The_thesis_methods_hit_single_targets_within_their_centimetre_and_a_little(string method, string integrator, string timeStep)
    {
        foreach ((JsonElement wanted, JsonElement got) in Aim(method, "--set", $"solver.integrator={integrator}", "--set", $"solver.timeStep={timeStep}"))
        {
            string name = got.GetProperty("name").GetString()!;
            if (wanted.GetProperty("expected").GetProperty("reachable").GetBoolean())
            {
                // The thesis' fast error is a few millimetres off the true one.
                Assert.True(got.GetProperty("miss").GetDouble() <= 0.014, $"{name}: {got}");
            }
            else
            {
                Assert.True(Status(got) == "outOfReach", name);
            }
        }
    }

    [Fact]
    public void The_studio_setting_takes_at_most_five_iterations_of_method_a()
    {
        JsonElement[] studio =
        [
            .. Aim("angle", "--set", "solver.integrator=semiImplicitEuler", "--set", $"solver.timeStep={1.0 / 60.0:R}")
                .Where(pair => pair.Wanted.GetProperty("name").GetString()!.Contains("gattini"))
                .Select(pair => pair.Got),
        ];
        Assert.NotEmpty(studio);
        Assert.All(studio, got => Assert.InRange(got.GetProperty("iterations").GetInt32(), 1, 5));
    }

    [Fact]
    public void The_thesis_two_point_method_passes_both_points_and_is_refused_without_one()
    {
        foreach ((JsonElement wanted, JsonElement got) in AimAll("twoPoint"))
        {
            if (HasThrough(wanted))
            {
                Assert.True(got.GetProperty("miss").GetDouble() <= 0.014, got.ToString());
                Assert.True(got.GetProperty("throughMiss").GetDouble() <= 0.1, got.ToString());
            }
            else
            {
                Assert.Equal("aim.through is null; allowed: a point, with method twoPoint.", got.GetProperty("error").GetString());
            }
        }
    }

    [Theory]
    [InlineData("direct")]
    [InlineData("angle")]
    [InlineData("bisection")]
    public void The_kick_has_the_speed_lies_within_the_bounds_and_misses_by_what_it_says(string method)
    {
        foreach ((JsonElement wanted, JsonElement got) in Aim(method))
        {
            JsonElement aim = wanted.GetProperty("scenario").GetProperty("aim");
            double speed = aim.GetProperty("speed").GetDouble();
            Vector3d velocity = ReferenceCase.Vector(got.GetProperty("velocity"));
            Assert.Equal(1, velocity.Length / speed, 1e-9);
            double elevation = Math.Atan2(velocity.Y, velocity.Horizontal.Length);
            Assert.InRange(elevation, (aim.GetProperty("elevation").GetProperty("min").GetDouble() * Math.PI / 180) - 1e-9, (aim.GetProperty("elevation").GetProperty("max").GetDouble() * Math.PI / 180) + 1e-9);
            Vector3d target = ReferenceCase.Vector(aim.GetProperty("target"));
            Assert.Equal(got.GetProperty("miss").GetDouble(), Vector3d.Distance(target, ReferenceCase.Vector(got.GetProperty("closest"))), 1e-9);
            Assert.Equal(Status(got) is "hit" or "targetOnly", got.GetProperty("miss").GetDouble() <= aim.GetProperty("tolerance").GetDouble());
            if (!HasThrough(wanted))
            {
                Assert.Equal(JsonValueKind.Null, got.GetProperty("throughMiss").ValueKind);
                double top = aim.GetProperty("spin").GetProperty("top").GetDouble();
                double side = aim.GetProperty("spin").GetProperty("side").GetDouble();
                Assert.True(Vector3d.Distance(KickVectors.Spin(velocity, top, side), ReferenceCase.Vector(got.GetProperty("spin"))) < 1e-9, got.ToString());
            }
        }
    }

    [Fact]
    public void The_results_are_the_same_for_any_number_of_jobs()
    {
        string Output(string jobs) => FootballCommand.Run(s_input, "aim", "-", "--batch", "--set", "aim.method=direct", "--jobs", jobs).Output;
        Assert.Equal(Output("1"), Output("3"));
    }

    [Fact]
    public void A_star_is_refused_unless_it_is_set()
    {
        FootballCommand refused = FootballCommand.Run(s_input, "aim", "-", "--batch");
        Assert.Equal(1, refused.ExitCode);
        Assert.All(refused.Lines, line => Assert.Equal("aim.method is \"*\"; allowed: direct | angle | bisection | twoPoint.", line.GetProperty("error").GetString()));
    }

    private static IEnumerable<(JsonElement Wanted, JsonElement Got)> Aim(string method, params string[] more)
    {
        foreach ((JsonElement wanted, JsonElement got) in AimAll(method, more))
        {
            Assert.False(got.TryGetProperty("error", out JsonElement error), error.ToString());
            yield return (wanted, got);
        }
    }

    private static IEnumerable<(JsonElement Wanted, JsonElement Got)> AimAll(string method, params string[] more)
    {
        IReadOnlyList<JsonElement> lines = FootballCommand.Run(s_input, ["aim", "-", "--batch", "--set", $"aim.method={method}", .. more]).Lines;
        Assert.Equal(s_cases.Select(Name), lines.Select(Name));
        return s_cases.Zip(lines);
    }

    private static string? Name(JsonElement of) => of.GetProperty("name").GetString();

    private static string? Status(JsonElement of) => of.GetProperty("status").GetString();

    private static bool HasThrough(JsonElement of) => of.GetProperty("scenario").GetProperty("aim").TryGetProperty("through", out _);
}
