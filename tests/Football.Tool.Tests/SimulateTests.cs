using System.Text.Json;

namespace FootballPhysics.Tool.Tests;

/// <summary>One scenario in, one result out.</summary>
public sealed class SimulateTests
{
    private const string L = FootballCommand.Launch;

    private const string AllMeasured = """
        {"profile": "measured",
         "ball": {"type": "modern", "mass": 0.43, "radius": 0.11, "inertiaFactor": 0.6666666666666666, "knuckleForce": 1.2, "seamSeed": 1, "reverseLift": 0},
         "air": {"density": 1.2, "kinematicViscosity": 1.5e-5, "wind": [0, 0, 0]},
         "gravity": 9.81,
         "forces": {"buoyancy": true, "drag": "empirical", "magnus": "empirical", "spinDecay": "empirical", "coefficients": "measured",
                    "dragCoefficient": 0.25, "magnusCoefficient": 0.25, "spinDecayCoefficient": 0.0, "knuckleSeed": null},
         "ground": {"surface": "matchTurf", "normalRestitution": 0.67, "restitutionSpeed": 20, "restitutionRise": 0.45, "tangentialRestitution": [-0.15, -0.15], "spinRestitution": 1,
                    "impactFriction": 0.42, "slidingFriction": 0.45, "rollingFriction": 0.064, "rollingFrictionBySpeed": 0.003, "spinDamping": 0,
                    "drillingLength": 0.02, "minimumBounceSpeed": 0.2, "restEnergy": 1e-4, "height": 0, "aerodynamics": "full"},
         "launch": {"position": [0, 0.11, 0], "velocity": [22, 9, 0], "spin": [0, 0, 0], "orientation": [0, 0, 0, 1]},
         "solver": {"integrator": "rk4", "timeStep": 0.01, "collisionTiming": "exact", "collisionTolerance": 1e-6, "rollingTransition": "exact"},
         "stop": {"at": "impact", "time": 20},
         "samples": false}
        """;

    private const string AllPublished = """
        {"profile": "published",
         "ball": {"mass": 0.43, "radius": 0.11, "inertiaFactor": 0.6666666666666666},
         "air": {"density": 1.2, "kinematicViscosity": 1.5e-5, "wind": [0, 0, 0]},
         "gravity": 9.81,
         "forces": {"buoyancy": true, "drag": "empirical", "magnus": "empirical", "spinDecay": "empirical", "coefficients": "published",
                    "dragCoefficient": 0.25, "magnusCoefficient": 0.25, "spinDecayCoefficient": 0.0},
         "ground": {"normalRestitution": 0.6, "tangentialRestitution": [0.5, 0.5], "spinRestitution": 0.8, "slidingFriction": 0.5,
                    "rollingFriction": 0.05, "spinDamping": 0.002, "minimumBounceSpeed": 0.2, "restEnergy": 1e-4, "height": 0,
                    "aerodynamics": "horizontal"},
         "launch": {"position": [0, 0.11, 0], "velocity": [22, 9, 0], "spin": [0, 0, 0], "orientation": [0, 0, 0, 1]},
         "solver": {"integrator": "rk4", "timeStep": 0.01, "collisionTiming": "exact", "collisionTolerance": 1e-6, "rollingTransition": "exact"},
         "stop": {"at": "impact", "time": 20},
         "samples": false}
        """;

    [Theory]
    [InlineData("measured", "")]
    [InlineData("measured", ",\"ball\":{},\"air\":{},\"forces\":{},\"ground\":{},\"solver\":{},\"stop\":{}")]
    [InlineData("published", "")]
    [InlineData("published", ",\"ball\":{},\"air\":{},\"forces\":{},\"ground\":{},\"solver\":{},\"stop\":{}")]
    public void Every_member_but_the_launch_has_the_default_of_its_profile(string profile, string more)
    {
        string named = profile == "measured" ? "" : $",\"profile\":\"{profile}\"";
        string plain = $"{{\"launch\":{{\"position\":[0,0.11,0],\"velocity\":[22,9,0]}}{more}{named}}}";
        foreach (string to in (string[])["impact", "rest"])
        {
            JsonElement whole = FootballCommand.Play(profile == "measured" ? AllMeasured : AllPublished, "--set", $"stop.at={to}");
            JsonElement bare = FootballCommand.Play(plain, "--set", $"stop.at={to}");
            Assert.Equal(whole.GetRawText(), bare.GetRawText());
        }
    }

    [Theory]
    [InlineData("solver.integrator=euler")]
    [InlineData("solver.integrator=semiImplicitEuler")]
    [InlineData("solver.integrator=rk2")]
    [InlineData("solver.timeStep=0.02")]
    [InlineData("solver.collisionTiming=bisection")]
    [InlineData("ball.mass=0.4")]
    [InlineData("ball.radius=0.1")]
    [InlineData("ball.inertiaFactor=0.4")]
    [InlineData("air.density=1")]
    [InlineData("air.kinematicViscosity=2e-5")]
    [InlineData("air.wind=[1,0,1]")]
    [InlineData("gravity=9.8")]
    [InlineData("forces.buoyancy=false")]
    [InlineData("forces.drag=none")]
    [InlineData("forces.drag=constant")]
    [InlineData("forces.magnus=none")]
    [InlineData("forces.magnus=constant")]
    [InlineData("forces.spinDecay=none")]
    [InlineData("forces.coefficients=regularised")]
    [InlineData("ground.normalRestitution=0.5")]
    [InlineData("ground.tangentialRestitution=[0.4,0.5]")]
    [InlineData("ground.tangentialRestitution=[0.5,0.4]")]
    [InlineData("ground.spinRestitution=0.7")]
    [InlineData("ground.slidingFriction=0.4")]
    [InlineData("ground.rollingFriction=0.04")]
    [InlineData("ground.spinDamping=0.001")]
    [InlineData("ground.minimumBounceSpeed=0.5")]
    [InlineData("ground.restEnergy=1e-3")]
    [InlineData("ground.height=0.01")]
    [InlineData("ground.aerodynamics=none")]
    [InlineData("launch.position=[0,1,1]")]
    [InlineData("launch.velocity=[22,9,2]")]
    [InlineData("launch.spin=[1,20,3]")]
    [InlineData("launch.orientation=[1,0,0,1]")]
    [InlineData("stop.at=impact")]
    [InlineData("stop.at=time")]
    [InlineData("stop.time=3")]
    [InlineData("samples=true")]
    public void Every_member_counts(string set)
    {
        string scenario = "{\"launch\":{\"position\":[0,0.11,0],\"velocity\":[12,5,1],\"spin\":[3,120,-40]},\"stop\":{\"at\":\"rest\"}}";
        Assert.NotEqual(FootballCommand.Play(scenario).GetRawText(), FootballCommand.Play(scenario, "--set", set).GetRawText());
    }

    [Theory]
    [InlineData("forces.drag=constant", "forces.dragCoefficient=0.3")]
    [InlineData("forces.magnus=constant", "forces.magnusCoefficient=-0.2")]
    [InlineData("forces.spinDecay=constant", "forces.spinDecayCoefficient=1e-4")]
    [InlineData("solver.collisionTiming=bisection", "solver.collisionTolerance=1e-3")]
    public void A_member_of_a_choice_counts(string choice, string set)
    {
        string scenario = "{\"launch\":{\"position\":[0,0.11,0],\"velocity\":[12,5,1],\"spin\":[3,30,-40]}}";
        string before = FootballCommand.Play(scenario, "--set", choice).GetRawText();
        Assert.NotEqual(before, FootballCommand.Play(scenario, "--set", choice, "--set", set).GetRawText());
    }

    [Fact]
    public void The_rolling_transition_counts()
    {
        string scenario = "{\"launch\":{\"position\":[0,0.11,0],\"velocity\":[12,0,1],\"spin\":[3,30,-10]},\"stop\":{\"at\":\"rest\"}}";
        Assert.NotEqual(
            FootballCommand.Play(scenario).GetRawText(),
            FootballCommand.Play(scenario, "--set", "solver.rollingTransition=heuristic").GetRawText());
    }

    [Fact]
    public void The_name_is_that_of_the_wrapper()
    {
        Assert.Equal(JsonValueKind.Null, FootballCommand.Play($"{{{L}}}").GetProperty("name").ValueKind);
        Assert.Equal("one", FootballCommand.Play($"{{\"name\":\"one\",\"scenario\":{{{L}}},\"expected\":{{\"x\":[1]}},\"x\":1}}").GetProperty("name").GetString());
        Assert.Equal("é\n\"", FootballCommand.Play($"{{\"scenario\":{{{L}}},\"name\":\"é\\n\\\"\"}}").GetProperty("name").GetString());
        Assert.Equal(JsonValueKind.Null, FootballCommand.Play($"{{\"scenario\":{{{L}}}}}").GetProperty("name").ValueKind);
        Assert.Equal(JsonValueKind.Null, FootballCommand.Play($"{{\"name\":null,\"scenario\":{{{L}}}}}").GetProperty("name").ValueKind);
    }

    [Fact]
    public void A_run_that_stops_at_an_impact_ends_just_after_its_impulse()
    {
        JsonElement result = FootballCommand.Play($"{{{L}}}");
        JsonElement final = result.GetProperty("final");
        JsonElement impact = Assert.Single(result.GetProperty("events").EnumerateArray());
        Assert.Equal("impact", impact.GetProperty("kind").GetString());
        Assert.Equal("airborne", final.GetProperty("state").GetString());
        foreach (string member in (string[])["time", "position", "velocity", "spin"])
        {
            Assert.Equal(impact.GetProperty(member).GetRawText(), final.GetProperty(member).GetRawText());
        }

        double approach = -impact.GetProperty("velocityBefore")[1].GetDouble();
        double restitution = 0.67 * Math.Sqrt((1 + (36.0 / 400)) / (1 + (approach * approach / 400)));
        JsonElement before = impact.GetProperty("velocityBefore");
        double steep = 2.8 * approach;
        double oblique = Math.Pow(((before[0].GetDouble() * before[0].GetDouble()) + (before[2].GetDouble() * before[2].GetDouble())) / (steep * steep), 2);
        restitution += 0.45 * (1 - restitution) * oblique / (1 + oblique);
        Assert.Equal(restitution * approach, final.GetProperty("velocity")[1].GetDouble(), 1e-12);
        Assert.Equal(1, result.GetProperty("bounces").GetInt32());
        Assert.Equal(1.0, result.GetProperty("apex").GetDouble());
    }

    [Fact]
    public void A_run_that_stops_at_an_impact_after_which_the_ball_stays_down_keeps_the_impulses_own_upward_speed()
    {
        JsonElement final = FootballCommand.Play($"{{{L}}}", "--set", "ground.minimumBounceSpeed=10").GetProperty("final");
        Assert.Equal("sliding", final.GetProperty("state").GetString());
        Assert.InRange(final.GetProperty("velocity")[1].GetDouble(), 2, 3);
    }

    [Fact]
    public void At_rest_velocity_and_spin_are_the_last_before_it()
    {
        foreach (string set in (string[])["stop={\"at\":\"rest\"}", "stop={\"at\":\"time\",\"time\":30}"])
        {
            JsonElement result = FootballCommand.Play($"{{{L}}}", "--set", set);
            JsonElement final = result.GetProperty("final");
            JsonElement rest = result.GetProperty("events").EnumerateArray().Last();
            Assert.Equal("rest", rest.GetProperty("kind").GetString());
            Assert.Equal("stopped", final.GetProperty("state").GetString());
            Assert.Equal(rest.GetProperty("velocity").GetRawText(), final.GetProperty("velocity").GetRawText());
            Assert.Equal(rest.GetProperty("spin").GetRawText(), final.GetProperty("spin").GetRawText());
            Assert.True(rest.GetProperty("velocity")[0].GetDouble() > 0);
        }
    }

    [Fact]
    public void Values_before_belong_to_impacts_only()
    {
        JsonElement result = FootballCommand.Play($"{{{L}}}", "--set", "stop.at=rest");
        var kinds = new HashSet<string>();
        foreach (JsonElement item in result.GetProperty("events").EnumerateArray())
        {
            string kind = item.GetProperty("kind").GetString()!;
            kinds.Add(kind);
            Assert.Equal(kind == "impact", item.TryGetProperty("velocityBefore", out _));
            Assert.Equal(kind == "impact", item.TryGetProperty("spinBefore", out _));
        }

        Assert.Contains("roll", kinds);
        Assert.Equal(result.GetProperty("bounces").GetInt32(), result.GetProperty("events").EnumerateArray().Count(item => item.GetProperty("kind").GetString() == "impact"));
    }

    [Fact]
    public void The_time_bounds_every_run_and_shortens_the_last_step()
    {
        foreach (string at in (string[])["impact", "rest", "time"])
        {
            JsonElement result = FootballCommand.Play($"{{{L}}}", "--set", $"stop.at={at}", "--set", "stop.time=0.255");
            Assert.Equal(0.1, FootballCommand.Play($"{{{L}}}", "--set", $"stop.at={at}", "--set", "stop.time=0.1").GetProperty("final").GetProperty("time").GetDouble());
            Assert.Equal(0.255, result.GetProperty("final").GetProperty("time").GetDouble());
            Assert.Equal(26, result.GetProperty("steps").GetInt32());
            Assert.Empty(result.GetProperty("events").EnumerateArray());
        }
    }

    [Fact]
    public void Samples_are_one_a_step_from_the_launch_to_the_final_state()
    {
        JsonElement result = FootballCommand.Play($"{{{L}}}", "--set", "samples=true", "--set", "solver.timeStep=0.1", "--set", "launch.spin=[1,2,3]");
        List<JsonElement> samples = [.. result.GetProperty("samples").EnumerateArray()];
        Assert.Equal([0, 0.1, 0.2, 0.3, 0.4], samples.Take(5).Select(sample => Math.Round(sample.GetProperty("time").GetDouble(), 9)));
        Assert.Equal(6, samples.Count);
        Assert.Equal("[0,1,0]", samples[0].GetProperty("position").GetRawText());
        Assert.Equal("[1,0,0]", samples[0].GetProperty("velocity").GetRawText());
        Assert.Equal("[0,0,0,1]", samples[0].GetProperty("orientation").GetRawText());
        Assert.Equal(result.GetProperty("final").GetRawText(), samples[^1].GetRawText());
        Assert.False(FootballCommand.Play($"{{{L}}}").TryGetProperty("samples", out _));
    }

    [Fact]
    public void A_result_put_in_again_goes_on_where_it_was()
    {
        // Numbers survive the way through text to the last bit: stopping half way and going on gives what one run gives.
        const string Vacuum = "\"forces\":{\"buoyancy\":false,\"drag\":\"none\",\"magnus\":\"none\",\"spinDecay\":\"none\"},\"stop\":{\"at\":\"time\",\"time\":0.25},\"solver\":{\"timeStep\":0.25}";
        JsonElement first = FootballCommand.Play($"{{\"launch\":{{\"position\":[0.1,3.3,-0.7],\"velocity\":[1.1,0.3,1e-7],\"spin\":[0.1,0.2,0.3]}},{Vacuum}}}").GetProperty("final");
        string again = $"{{\"launch\":{{\"position\":{first.GetProperty("position")},\"velocity\":{first.GetProperty("velocity")},\"spin\":{first.GetProperty("spin")}}},{Vacuum}}}";
        JsonElement launch = FootballCommand.Play(again, "--set", "samples=true").GetProperty("samples")[0];
        Assert.Equal(first.GetProperty("position").GetRawText(), launch.GetProperty("position").GetRawText());
        Assert.Equal(first.GetProperty("velocity").GetRawText(), launch.GetProperty("velocity").GetRawText());
    }

    [Fact]
    public void An_orientation_of_any_size_is_normalised()
    {
        foreach (string orientation in (string[])["[0,3,0,4]", "[0,3e200,0,4e200]", "[0,3e-200,0,4e-200]"])
        {
            JsonElement launch = FootballCommand.Play($"{{{L}}}", "--set", $"launch.orientation={orientation}", "--set", "samples=true").GetProperty("samples")[0];
            Assert.Equal(0.6, launch.GetProperty("orientation")[1].GetDouble(), 1e-15);
            Assert.Equal(0.8, launch.GetProperty("orientation")[3].GetDouble(), 1e-15);
        }
    }

    [Fact]
    public void A_byte_order_mark_and_line_ends_do_not_matter() =>
        Assert.Equal(FootballCommand.Play($"{{{L}}}").GetRawText(), FootballCommand.Play($"\uFEFF\r\n{{\r\n{L}\r\n}}\r\n").GetRawText());

    /// <summary>A writer may send the mark of the byte order by itself, and what follows later.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    [InlineData(4)]
    public void A_byte_order_mark_that_comes_alone_is_not_the_end(int piece)
    {
        using var stream = new InPieces([0xEF, 0xBB, 0xBF, .. "{\"a\": 1}\n{\"a\": 2}\n"u8], piece);
        var lines = new Scenarios.Input.LineReader(stream);
        Assert.NotNull(lines.ReadLine());
        Assert.NotNull(lines.ReadLine());
        Assert.Null(lines.ReadLine());
    }

    /// <summary>The derivatives are of the run, also where that has moved what it met.</summary>
    [Fact]
    public void Derivatives_are_of_a_scene_that_nothing_has_moved()
    {
        string Light(double mass) => FootballCommand.Play(
            """{"launch":{"position":[0,0.11,0],"velocity":[0,0,-20]},"obstacles":[{"shape":"sphere","center":[0,0.11,-5],"radius":0.1,"mass":MASS}],"derivatives":true,"stop":{"at":"impact"}}"""
            .Replace("MASS", mass.ToString(System.Globalization.CultureInfo.InvariantCulture), StringComparison.Ordinal))
            .GetProperty("derivatives").GetRawText();
        Assert.Equal(Light(1e6), Light(0.5));
    }

    [Fact]
    public void Zones_are_told_by_kind_and_name()
    {
        JsonElement[] events = [.. FootballCommand.Play(
            """
            {"profile": "published", "gravity": 0, "forces": {"buoyancy": false, "drag": "none", "magnus": "none", "spinDecay": "none"},
             "launch": {"position": [0, 5, 0], "velocity": [0, 0, -10]}, "stop": {"at": "time", "time": 1},
             "zones": [{"name": "area", "shape": "box", "center": [0, 5, -4], "halfSize": [3, 3, 1], "of": "centre"},
                       {"shape": "plane", "point": [0, 0, -8], "normal": [0, 0, 1]}]}
            """).GetProperty("events").EnumerateArray()];
        Assert.Equal(
            ["enterZone area 0.300000", "exitZone area 0.500000", "enterZone zone 1 0.789000"],
            events.Select(item => FormattableString.Invariant(
                $"{item.GetProperty("kind").GetString()} {item.GetProperty("surface").GetString()} {item.GetProperty("time").GetDouble():F6}")));
    }

    [Theory]
    [InlineData("""{"shape": "sphere", "center": [0, 0, 0], "radius": 1, "of": "center"}""", "zones[0].of is \"center\"; allowed: ball | centre")]
    [InlineData("""{"shape": "cube"}""", "zones[0].shape is \"cube\"; allowed: plane | sphere | capsule | box")]
    [InlineData("""{"shape": "sphere", "center": [0, 0, 0], "radius": 0}""", "zones[0].radius is 0; allowed: above 0")]
    [InlineData("""{"name": "a", "shape": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}, {"name": "a", "shape": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]}""", "zones[1].name is \"a\"; allowed: a name that no other zone has")]
    public void A_wrong_zone_is_refused_in_one_line(string zones, string expected)
    {
        FootballCommand done = FootballCommand.Simulate($$"""{"launch": {"position": [0, 1, 0], "velocity": [0, 0, -5]}, "zones": [{{zones}}]}""".ReplaceLineEndings(""));
        Assert.Equal(1, done.ExitCode);
        Assert.Contains(expected, done.ErrorLine, StringComparison.Ordinal);
    }

    /// <summary>The one ball flies through the wall, the other does not.</summary>
    [Fact]
    public void Layers_and_what_a_ball_ignores_are_read()
    {
        JsonElement[] balls = [.. FootballCommand.Play(
            """
            {"balls": [{"launch": {"position": [0, 0.11, 0], "velocity": [0, 2, -12]}},
                       {"ball": {"ignores": [3, 7]}, "launch": {"position": [1, 0.11, 0], "velocity": [0, 2, -12]}}],
             "obstacles": [{"shape": "box", "center": [0, 1, -4], "halfSize": [3, 3, 0.1], "layer": 3}], "stop": {"at": "rest"}}
            """).GetProperty("balls").EnumerateArray()];
        Assert.Equal([false, true], balls.Select(ball => ball.GetProperty("final").GetProperty("position")[2].GetDouble() < -4));
    }

    [Theory]
    [InlineData("\"ball\": {\"ignores\": [3, 32]}", "ball.ignores is [3, 32]; allowed: a list of layers, whole numbers 0 … 31")]
    [InlineData("\"ball\": {\"ignores\": 3}", "ball.ignores is 3; allowed: a list of layers")]
    [InlineData("\"obstacles\": [{\"shape\": \"sphere\", \"center\": [9, 0, 0], \"radius\": 1, \"layer\": 32}]", "obstacles[0].layer is 32; allowed: 0 … 31")]
    [InlineData("\"zones\": [{\"shape\": \"sphere\", \"center\": [9, 0, 0], \"radius\": 1, \"layer\": 1.5}]", "zones[0].layer is 1.5; allowed: a whole number")]
    public void A_wrong_layer_is_refused_in_one_line(string member, string expected)
    {
        FootballCommand done = FootballCommand.Simulate($$"""{"launch": {"position": [0, 1, 0], "velocity": [0, 0, -5]}, {{member}}}""");
        Assert.Equal(1, done.ExitCode);
        Assert.Contains(expected, done.ErrorLine, StringComparison.Ordinal);
    }

    /// <summary>A ball at rest lies on the height of its node; the control values of the same numbers are lower.</summary>
    [Fact]
    public void Heights_are_those_of_the_nodes_or_control_values()
    {
        string Ground(string members) => $$$"""{"ground": {"heights": {"origin": [-5, -5], "spacing": 5, {{{members}}}}}, "launch": {"position": [0, 0, 0], "velocity": [0, 0, 0]}, "stop": {"at": "time", "time": 30}}""";
        double Height(string member) =>
            FootballCommand.Play(Ground($"\"{member}\": [[0, 0, 0], [0, -0.9, 0], [0, 0, 0]]")).GetProperty("final").GetProperty("position")[1].GetDouble();
        double radius = BallProperties.Modern.Radius;
        Assert.Equal(-0.9 + radius, Height("nodes"), 1e-9);
        Assert.Equal((-0.9 * 4 / 9) + radius, Height("values"), 1e-9);
        foreach ((string members, string expected) in new[]
        {
            ("\"nodes\": [[0]], \"values\": [[0]]", "ground.heights.nodes is [[0]]; allowed: nodes or values, not both"),
            ("\"nodes\": [[0], [0, 1]]", "ground.heights.nodes is "),
            ("\"nodes\": [[0, 2e6]]", "ground.heights.nodes[0][1] is 2e6; allowed: "),
            ("\"nodes\": [[0, 0], [0, 9], [0, 0]]", "ground.heights (its steepest slope, "),
        })
        {
            FootballCommand done = FootballCommand.Simulate(Ground(members));
            Assert.Equal(1, done.ExitCode);
            Assert.Contains(expected, done.ErrorLine, StringComparison.Ordinal);
        }
    }

    [Fact]
    public void Gravity_is_a_number_or_a_vector_that_does_not_point_up()
    {
        string Play(string gravity) => FootballCommand.Play($$$"""{"gravity": {{{gravity}}}, "launch": {"position": [0, 1, 0], "velocity": [0, 2, -5]}}""").GetRawText();
        Assert.Equal(Play("3.7"), Play("[0, -3.7, 0]"));
        Assert.NotEqual(Play("3.7"), Play("[0, -9.81, 0]"));
        Assert.NotEqual(Play("3.7"), Play("[1, -3.7, 0]"));
        foreach (string wrong in new[] { "[0, 9.81, 0]", "[0, -9.81]" })
        {
            FootballCommand done = FootballCommand.Simulate($$$"""{"gravity": {{{wrong}}}, "launch": {"position": [0, 1, 0], "velocity": [0, 2, -5]}}""");
            Assert.Equal(1, done.ExitCode);
            Assert.Contains($"gravity is {wrong}; allowed: ", done.ErrorLine, StringComparison.Ordinal);
        }
    }

    /// <summary>What a bumper adds is in the event.</summary>
    [Fact]
    public void A_bumper_tells_the_energy_that_it_adds()
    {
        JsonElement hit = FootballCommand.Play(
            """
            {"gravity": 0, "forces": {"buoyancy": false, "drag": "none", "magnus": "none", "spinDecay": "none"}, "launch": {"position": [0, 1, 0], "velocity": [0, 0, -4]},
             "obstacles": [{"shape": "sphere", "center": [0, 1, -3], "radius": 1, "surface": {"minimumExitSpeed": 10, "normalRestitution": 1.5}}], "stop": {"at": "impact"}}
            """).GetProperty("events")[0];
        Assert.Equal(10, hit.GetProperty("velocity")[2].GetDouble(), 9);
        Assert.Equal(0.5 * 0.43 * (100 - 16), hit.GetProperty("addedEnergy").GetDouble(), 9);
    }

    private sealed class InPieces(byte[] all, int piece) : MemoryStream(all)
    {
        public override int Read(Span<byte> buffer) => base.Read(buffer[..Math.Min(buffer.Length, piece)]);
    }
}
