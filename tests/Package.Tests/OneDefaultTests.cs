using System.Globalization;
using System.Reflection;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using FootballPhysics.Scenarios;
using FootballPhysics.Tool.Tests;
using GodotPreset = FootballPhysics.GodotAddon.FootballPreset;
using UnityPreset = FootballPhysics.Unity.FootballPreset;

namespace FootballPhysics.Package.Tests;

/// <summary>C#, the command line, a scenario and a fresh preset of either engine play one shot to the same bits, and call balls and grounds by the same names. C (one_default.c), Python (test_balls.py) and the page (PlayTests) compare with the same table.</summary>
public sealed partial class OneDefaultTests
{
    private const double TimeStep = 0.01;

    private static readonly string[] s_kick = ["kick", "--speed", "27", "--elevation", "15", "--azimuth", "-16.7", "--top-spin", "-10", "--side-spin", "60", "--set", "samples=true"];

    [Theory]
    [InlineData("measured")]
    [InlineData("published")]
    public void A_shot_from_foot_to_rest_is_the_same_bits_in_every_way(string profile)
    {
        bool isDefault = profile == "measured";
        string[] word = isDefault ? [] : ["--profile", profile];
        JsonElement kick = FootballCommand.Run("", [.. s_kick, .. word]).Result;
        JsonElement first = kick.GetProperty("samples")[0];
        string launch = $"{{\"position\":[0,0,0],\"velocity\":{first.GetProperty("velocity")},\"spin\":{first.GetProperty("spin")}}}";
        string named = isDefault ? "" : $"\"profile\":\"{profile}\",";
        JsonElement scenario = FootballCommand.Play($"{{{named}\"launch\":{launch},\"stop\":{{\"at\":\"rest\",\"time\":120}},\"samples\":true}}");
        UnityPreset unity = isDefault ? new() : new() { profile = UnityPreset.ProfileChoice.Published };
        GodotPreset godot = isDefault ? new() : new() { Profile = GodotPreset.ProfileChoice.Published };
        (string Way, Simulator Simulator)[] ways =
        [
            ("C#", isDefault ? new Simulator() : new Simulator(Scene.Published)),
            ("a ball", isDefault ? new Ball().Simulator : new Ball(Scene.Published).Simulator),
            ("Unity", unity.Compile()),
            ("Godot", godot.Compile()),
        ];
        foreach ((string way, Simulator simulator) in ways)
        {
            BallState state = simulator.Launch(Vector3d.Zero, Vector(first, "velocity"), Vector(first, "spin"));
            Same($"{way}, kick", kick, simulator, state);
            Same($"{way}, scenario", scenario, simulator, state);
        }
    }

    /// <summary>The kick of this class as a table of bits, which C, Python and the page compare with their own.</summary>
    [Fact]
    public void The_kick_of_the_default_is_the_one_in_the_table()
    {
        KickVectors.FromAngles(27, 15, -16.7, -10, 60, out Vector3d velocity, out Vector3d spin);
        var ball = new Ball();
        ball.Launch(Vector3d.Zero, velocity, spin);
        var rows = new StringBuilder("time,x,y,z,vx,vy,vz,wx,wy,wz\n");
        for (bool goes = true; goes; ball.Step(TimeStep))
        {
            BallState state = ball.State;
            double[] row = [state.Time, .. Parts(state.Position), .. Parts(state.Velocity), .. Parts(state.Spin)];
            rows.AppendJoin(',', row.Select(number => number.ToString("R", CultureInfo.InvariantCulture))).Append('\n');
            goes = state.Motion != MotionState.Rest;
        }

        Repository.AssertCurrent("tests/Golden/one-default.csv", rows.ToString());
    }

    [Fact]
    public void A_fresh_preset_is_the_scene_that_a_ball_without_one_has()
    {
        Assert.Equal(Scene.Default, new UnityPreset().Compile().Scene);
        Assert.Equal(Scene.Default, new GodotPreset().Compile().Scene);
        Assert.Equal(Scene.Published, new UnityPreset { profile = UnityPreset.ProfileChoice.Published }.Compile().Scene);
        Assert.Equal(Scene.Published, new GodotPreset { Profile = GodotPreset.ProfileChoice.Published }.Compile().Scene);
        Assert.Equal(new Simulator().Settings, new UnityPreset().Compile().Settings);
        Assert.Equal(new Simulator().Settings, new GodotPreset().Compile().Settings);
    }

    /// <summary>Whatever a slider of an inspector allows makes a scene; a large ball is not lighter than a twentieth of its air.</summary>
    [Fact]
    public void The_ends_of_every_slider_are_in_range()
    {
        int sliders = 0;
        foreach (FieldInfo field in typeof(UnityPreset).GetFields().Where(field => field.FieldType == typeof(float)))
        {
            UnityEngine.RangeAttribute range = field.GetCustomAttribute<UnityEngine.RangeAttribute>()!;
            foreach (float end in new[] { range.min, range.max })
            {
                var preset = new UnityPreset { ball = UnityPreset.BallChoice.Custom, customMass = 20, ground = UnityPreset.GroundChoice.Custom };
                field.SetValue(preset, end);
                preset.Compile();
                sliders++;
            }
        }

        foreach (PropertyInfo property in typeof(GodotPreset).GetProperties().Where(property => property.PropertyType == typeof(float)))
        {
            string[] range = property.GetCustomAttribute<Godot.ExportAttribute>()!.HintString.Split(',');
            foreach (string end in range[..2])
            {
                var preset = new GodotPreset { Ball = GodotPreset.BallChoice.Custom, CustomMass = 20, Surface = GodotPreset.GroundChoice.Custom };
                property.SetValue(preset, float.Parse(end, CultureInfo.InvariantCulture));
                preset.Compile();
                sliders++;
            }
        }

        Assert.Equal(60, sliders);
    }

    [Fact]
    public void Every_ground_has_one_name_everywhere()
    {
        // Saved presets hold numbers: what came later stands at the end of the engines' lists.
        string[] grounds = [.. Enum.GetNames<UnityPreset.GroundChoice>().Where(name => name is not ("OfProfile" or "Custom"))];
        Assert.Equal(Enum.GetNames<UnityPreset.GroundChoice>(), Enum.GetNames<GodotPreset.GroundChoice>());
        foreach (string name in grounds)
        {
            string word = JsonNamingPolicy.CamelCase.ConvertName(name);
            Ground ground = Ground.Presets[word];
            Simulator unity = new UnityPreset { ground = Enum.Parse<UnityPreset.GroundChoice>(name) }.Compile();
            Assert.Equal(ground, unity.Scene.Ground);
            Assert.Equal(ground, new GodotPreset { Surface = Enum.Parse<GodotPreset.GroundChoice>(name) }.Compile().Scene.Ground);
            JsonElement played = FootballCommand.Run("", [.. s_kick, "--set", "ground.surface=" + word]).Result;
            JsonElement first = played.GetProperty("samples")[0];
            Same(name, played, unity, unity.Launch(Vector3d.Zero, Vector(first, "velocity"), Vector(first, "spin")));
        }
    }

    [Fact]
    public void Every_ball_has_one_name_everywhere()
    {
        Assert.Equal(Enum.GetNames<UnityPreset.BallChoice>(), Enum.GetNames<GodotPreset.BallChoice>());
        Assert.Equal(
            BallProperties.Presets.Keys.Order(),
            Enum.GetNames<UnityPreset.BallChoice>().Where(name => name != "Custom").Select(JsonNamingPolicy.CamelCase.ConvertName).Order());
        foreach ((string word, BallProperties ball) in BallProperties.Presets)
        {
            Simulator unity = new UnityPreset { ball = Enum.Parse<UnityPreset.BallChoice>(word, ignoreCase: true) }.Compile();
            Assert.Equal(ball, unity.Scene.Ball);
            Assert.Equal(ball, new GodotPreset { Ball = Enum.Parse<GodotPreset.BallChoice>(word, ignoreCase: true) }.Compile().Scene.Ball);
            JsonElement played = FootballCommand.Run("", [.. s_kick, "--set", "ball.type=" + word]).Result;
            JsonElement first = played.GetProperty("samples")[0];
            Same(word, played, unity, unity.Launch(Vector3d.Zero, Vector(first, "velocity"), Vector(first, "spin")));
        }
    }

    /// <summary>Every preset of a type is in its list, under its name.</summary>
    [Fact]
    public void Every_preset_is_in_the_list_of_its_type()
    {
        Assert.Equal(Presets(typeof(SurfaceMaterial)).Order(), SurfaceMaterial.Presets.Keys.Order());
        Assert.Equal(Presets(typeof(BallProperties)).Select(name => name == "tunnel" ? "generic" : name).Order(), BallProperties.Presets.Keys.Order());
        Assert.Equal(SurfaceMaterial.Presets.Keys.Append("none").Order(), Ground.Presets.Keys.Order());
    }

    [Theory]
    [InlineData("measured")]
    [InlineData("published")]
    public void The_frame_of_a_goal_and_a_plain_obstacle_are_the_profile_s(string profile)
    {
        Scene scene = profile == "measured" ? Scene.Default : Scene.Published;
        SurfaceMaterial frame = profile == "measured" ? SurfaceMaterial.GoalFrame : SurfaceMaterial.PublishedGoalFrame;
        var simulator = new Simulator(scene with
        {
            Goals = [new Goal { Center = new Vector3d(0, 0, -11), Facing = new Vector3d(0, 0, 1) }],
            Obstacles = [new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(0, 0, 9), new Vector3d(0, 0, -1)), Surface = frame }],
        });
        const string Things = "\"goals\":[{\"center\":[0,0,-11],\"facing\":[0,0,1]}],\"obstacles\":[{\"name\":\"wall\",\"shape\":\"plane\",\"point\":[0,0,9],\"normal\":[0,0,-1]}]";
        foreach ((string meets, Vector3d from, Vector3d velocity) in new[]
        {
            ("left post", new Vector3d(3.6, 0.8, -5), new Vector3d(0.1, 2, -25)),
            ("wall", new Vector3d(1, 0.8, 0), new Vector3d(1, 2, 25)),
        })
        {
            string launch = $"\"launch\":{{\"position\":[{from.X},{from.Y},{from.Z}],\"velocity\":[{velocity.X},{velocity.Y},{velocity.Z}],\"spin\":[0,3,0]}}";
            JsonElement played = FootballCommand.Play($"{{{launch},{Things},\"stop\":{{\"at\":\"time\",\"time\":3}},\"samples\":true}}", "--profile", profile);
            Assert.Contains(meets, played.GetProperty("events").EnumerateArray().Select(happened => happened.GetProperty("surface").GetString()));
            Same($"{profile}, {meets}", played, simulator, simulator.Launch(from, velocity, new Vector3d(0, 3, 0)));
        }

        Assert.Equal(SurfaceMaterial.GoalFrame, new Obstacle { Shape = new SphereShape(Vector3d.Zero, 1) }.Surface);
    }

    /// <summary>README names the command that kicks as its ten lines do, and it lands where they say.</summary>
    [Fact]
    public void The_README_s_kick_typed_as_a_command_lands_where_its_program_says()
    {
        string readme = Repository.Text("README.md");
        string[] command = KickLine().Match(readme).Groups[1].Value.Split(' ');
        Assert.Equal("kick", command[0]);
        JsonElement landing = FootballCommand.Run("", command).Result.GetProperty("events")[0];
        Vector3d at = Vector(landing, "position");
        Assert.Contains(
            string.Create(CultureInfo.InvariantCulture, $"It lands {-at.Z:F1} m away after {landing.GetProperty("time").GetDouble():F2} s, {at.X:F1} m to the right"),
            readme);
    }

    /// <summary>Every sample of a run is where the simulator steps to, bit by bit.</summary>
    private static void Same(string way, JsonElement played, Simulator simulator, BallState state)
    {
        var log = new StepLog();
        double end = played.GetProperty("final").GetProperty("time").GetDouble();
        JsonElement[] samples = [.. played.GetProperty("samples").EnumerateArray()];
        Assert.True(samples.Length > 100, way);

        // The last step of a run may be a shorter one.
        foreach (JsonElement sample in samples.Where(sample => sample.GetProperty("time").GetDouble() < end - TimeStep))
        {
            string at = $"{way}, {state.Time} s";
            Assert.True(Vector(sample, "position") == state.Position, at);
            Assert.True(Vector(sample, "velocity") == state.Velocity, at);
            Assert.True(Vector(sample, "spin") == state.Spin, at);
            log.Clear();
            simulator.Step(ref state, TimeStep, log);
        }
    }

    private static double[] Parts(Vector3d of) => [of.X, of.Y, of.Z];

    private static Vector3d Vector(JsonElement of, string name)
    {
        JsonElement parts = of.GetProperty(name);
        return new Vector3d(parts[0].GetDouble(), parts[1].GetDouble(), parts[2].GetDouble());
    }

    /// <summary>Names of a type's presets, with a small first letter.</summary>
    private static IEnumerable<string> Presets(Type type) =>
        type.GetProperties(BindingFlags.Public | BindingFlags.Static).Where(property => property.PropertyType == type).Select(property => JsonNamingPolicy.CamelCase.ConvertName(property.Name));

    [GeneratedRegex("`football (kick [^`]*)`")]
    private static partial Regex KickLine();
}
