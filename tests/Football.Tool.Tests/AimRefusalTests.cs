using System.Text.Json;

namespace FootballPhysics.Tool.Tests;

/// <summary>football aim: defaults, and what is refused with one clear line.</summary>
public sealed class AimRefusalTests
{
    private const string Least = "{\"aim\":{\"from\":[0,0.11,0],\"target\":[20,1.5,3],\"speed\":25}}";

    private const string Full = """
        {"aim": {"method": "direct", "from": [0, 0.11, 0], "target": [20, 1.5, 3], "through": null,
                 "speed": 25, "spin": {"top": 0, "side": 0}, "elevation": {"min": 0, "max": 45},
                 "maxSpin": {"top": 40, "side": 40}, "tolerance": 0.01, "throughTolerance": 0.1, "maxIterations": 60},
         "gravity": 9.81, "solver": {"integrator": "rk4", "timeStep": 0.01}, "stop": {"at": "impact", "time": 20}, "samples": false}
        """;

    [Fact]
    public void What_is_left_out_has_its_default() => Assert.Equal(Find(Full).GetRawText(), Find(Least).GetRawText());

    [Fact]
    public void A_bare_scenario_has_no_name_and_the_fields_are_those_of_the_contract() => Assert.Equal(
        ["name", "status", "velocity", "spin", "miss", "throughMiss", "time", "closest", "iterations", "simulations", "arc", "rolls"],
        Find(Least).EnumerateObject().Select(member => member.Name));

    [Fact]
    public void The_solver_is_that_of_the_thesis_methods()
    {
        string Angle(string step) => Find(Least, "--set", "aim.method=angle", "--set", $"solver.timeStep={step}", "--set", "solver.integrator=rk2").GetRawText();
        Assert.NotEqual(Angle("0.04"), Angle("0.01"));
        Assert.Equal(Find(Least).GetRawText(), Find(Least, "--set", "solver.timeStep=0.04", "--set", "solver.integrator=euler").GetRawText());
        Assert.Equal(Find(Least).GetRawText(), Find(Least, "--set", "solver.timeStep=1e-9").GetRawText());
    }

    [Theory]
    [InlineData("aim.method=*", "aim.method is \"*\"; allowed: direct | angle | bisection | twoPoint.")]
    [InlineData("aim.method=Direct", "aim.method is \"Direct\"; allowed: direct | angle | bisection | twoPoint.")]
    [InlineData("aim.method=twoPoint", "aim.through is null; allowed: a point, with method twoPoint.")]
    [InlineData("aim.through=5", "aim.through is 5; allowed: [x, y, z], 3 finite numbers.")]
    [InlineData("aim.through=[1,2]", "aim.through is [1,2]; allowed: [x, y, z], 3 finite numbers.")]
    [InlineData("aim.from=[0,2e6,0]", "aim.from is [0,2e6,0]; allowed: finite components within ±1000000 m.")]
    [InlineData("aim.target=null", "aim.target is null; allowed: ")]
    [InlineData("aim.speed=0", "aim.speed is 0; allowed: above 0, at most 1000.")]
    [InlineData("aim.speed=1001", "aim.speed is 1001; allowed: ")]
    [InlineData("aim.speed=NaN", "aim.speed is \"NaN\"; allowed: ")]
    [InlineData("aim.spin.top=10001", "aim.spin.top is 10001; allowed: -10000 … 10000.")]
    [InlineData("aim.spin={\"top\":8000,\"side\":-8000}", "aim.spin is {\"top\":8000,\"side\":-8000}; allowed: finite components, size at most 10000 rad/s.")]
    [InlineData("aim.spin=5", "aim.spin is 5; allowed: an object {top, side, free}.")]
    [InlineData("aim.spin.back=5", "aim.spin.back is unknown")]
    [InlineData("aim.maxSpin.side=-1", "aim.maxSpin.side is -1; allowed: 0 … 10000.")]
    [InlineData("aim.elevation.min=-91", "aim.elevation.min is -91; allowed: -90 … 90.")]
    [InlineData("aim.elevation.max=91", "aim.elevation.max is 91; allowed: 0 … 90.")]
    [InlineData("aim.elevation.min=50", "aim.elevation.max is 45; allowed: 50 … 90.")]
    [InlineData("aim.tolerance=0", "aim.tolerance is 0; allowed: a finite number above 0.")]
    [InlineData("aim.throughTolerance=-1", "aim.throughTolerance is -1; allowed: a finite number above 0.")]
    [InlineData("aim.maxIterations=0", "aim.maxIterations is 0; allowed: a finite number, 1 or more.")]
    [InlineData("aim.maxIterations=2.5", "aim.maxIterations is 2.5; allowed: a whole number")]
    [InlineData("launch={}", "launch is unknown")]
    [InlineData("aim.sped=5", "aim.sped is unknown")]
    [InlineData("gravity=-1", "gravity is -1; allowed: 0 … 1000.")]
    public void What_is_wrong_is_named_with_what_is_allowed(string set, string message)
    {
        FootballCommand refused = FootballCommand.Run(Least, "aim", "-", "--set", set);
        Assert.Equal((1, ""), (refused.ExitCode, refused.Output));
        Assert.StartsWith("football: " + message, refused.ErrorLine);
    }

    [Theory]
    [InlineData("from")]
    [InlineData("target")]
    [InlineData("speed")]
    public void What_is_required_is_missed(string field)
    {
        string without = Least.Replace($"\"{field}\"", "\"through\"").Replace("\"through\":25", "\"tolerance\":25");
        FootballCommand refused = FootballCommand.Run(without, "aim", "-");
        Assert.Equal(1, refused.ExitCode);
        Assert.StartsWith($"football: aim.{field} is missing; allowed: ", refused.ErrorLine);
    }

    [Fact]
    public void A_step_too_short_for_the_thesis_methods_is_refused_only_for_them() => Assert.StartsWith(
        "football: solver.timeStep is 1e-6; allowed: ",
        FootballCommand.Run(Least, "aim", "-", "--set", "aim.method=angle", "--set", "solver.timeStep=1e-6").ErrorLine);

    private static JsonElement Find(string scenario, params string[] args)
    {
        FootballCommand done = FootballCommand.Run(scenario, ["aim", "-", .. args]);
        Assert.Equal(("", 0), (done.Error, done.ExitCode));
        return done.Result;
    }
}
