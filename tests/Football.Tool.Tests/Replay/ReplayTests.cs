using System.Numerics;
using System.Text.Json;
using FootballPhysics.Tool.Replay;
using FootballPhysics.Scenarios;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tool.Tests.Replay;

/// <summary>football replay: the page holds the shots as they were played, and nothing from elsewhere.</summary>
public sealed class ReplayTests
{
    private const string Shot = """
        {"name": "</script><b>post", "scenario": {"launch": {"position": [0, 0.11, 0], "velocity": [3.85, 6, -24], "spin": [30, 40, 0]},
         "goals": [{"center": [0, 0, -22], "facing": [0, 0, 1]}], "stop": {"at": "time", "time": 3},
         "obstacles": [{"name": "keeper", "shape": "box", "center": [1, 1, -21], "halfSize": [0.3, 1, 0.2], "velocity": [1, 0, 0]},
                       {"shape": "sphere", "center": [-3, 0.5, -12], "radius": 0.5}]}}
        """;

    [Fact]
    public void The_page_is_one_file_with_every_shot_in_it()
    {
        string page = Page(Shot, out FootballCommand done);
        Assert.Equal("</script><b>post", done.Result.GetProperty("name").GetString());
        Assert.DoesNotContain("http", page);
        Assert.DoesNotContain("src=", page);
        Assert.DoesNotContain("{{", page);
        Assert.DoesNotContain("</script><b>", page);
        JsonElement picture = Data(page).GetProperty("pictures")[0];
        JsonElement shot = Assert.Single(picture.GetProperty("shots").EnumerateArray());
        Assert.Equal(done.Result.GetProperty("events").GetArrayLength(), shot.GetProperty("events").GetArrayLength());
        string[] names = [.. picture.GetProperty("shapes").EnumerateArray().Select(shape => shape.GetProperty("name").GetString()!)];
        Assert.Empty(((string[])["left post", "right post", "crossbar", "back net", "keeper", "penalty area"]).Except(names));
        Assert.Equal([1, 0, 0], Numbers(picture.GetProperty("shapes").EnumerateArray().Single(shape => shape.GetProperty("name").GetString() == "keeper").GetProperty("velocity")));
    }

    [Fact]
    public void Between_its_keys_a_track_is_the_path_and_the_turning_of_the_ball()
    {
        foreach (string stop in (string[])["time", "rest"])
        {
            var scenario = new Scenario
            {
                Position = new Vector3d(0, 0.11, 0),
                Velocity = new Vector3d(2, 9, -20),
                Spin = new Vector3d(-20, 70, 5),
                StopAt = stop == "rest" ? StopAt.Rest : StopAt.Time,
                Duration = stop == "rest" ? 60 : 2,
                Samples = true,
            };
            Outcome outcome = ScenarioRun.Play(scenario);
            var track = new Track(scenario, outcome);
            Assert.InRange(track.Keys.Count, 10, 0.7 * outcome.Samples!.Count);
            int next = 0;
            foreach (Moment sample in outcome.Samples.Where(sample => sample.Time < track.Keys[^1].Time))
            {
                while (track.Keys[next + 1].Time <= sample.Time)
                {
                    next++;
                }

                (TrackKey a, TrackKey b) = (track.Keys[next], track.Keys[next + 1]);
                Assert.InRange((Track.Between(in a, in b, sample.Time) - sample.Position).Length, 0, 2e-3);
                Quaterniond turned = Quaternion.Slerp(a.Orientation.ToQuaternion(), b.Orientation.ToQuaternion(), (float)((sample.Time - a.Time) / (b.Time - a.Time)));
                Quaterniond q = sample.Orientation;
                Assert.InRange(Math.Abs((turned.X * q.X) + (turned.Y * q.Y) + (turned.Z * q.Z) + (turned.W * q.W)), 0.9985, 1.001);
            }
        }
    }

    [Fact]
    public void An_impact_is_a_key_with_two_velocities()
    {
        var scenario = new Scenario { Position = new Vector3d(0, 2, 0), Velocity = new Vector3d(0, 0, -5), Duration = 1, StopAt = StopAt.Time, Samples = true };
        Outcome outcome = ScenarioRun.Play(scenario);
        BallEvent impact = outcome.Events.First(item => item.Kind == BallEventKind.Impact);
        TrackKey key = new Track(scenario, outcome).Keys.Single(item => item.Time == impact.Time);
        Assert.Equal((impact.VelocityBefore, impact.Velocity, impact.Position), (key.VelocityBefore, key.Velocity, key.Position));
    }

    /// <summary>Two balls of which one hits the other: both move in the picture, and the event of each names the other.</summary>
    [Fact]
    public void Several_balls_of_a_scenario_move_in_one_picture()
    {
        const string Two = """
            {"balls": [{"launch": {"position": [0, 0.11, 0], "velocity": [0, 0, -9]}}, {"launch": {"position": [0.05, 0.11, -3], "velocity": [0, 0, 0]}}], "stop": {"at": "rest"}}
            """;
        string folder = Directory.CreateTempSubdirectory("football-replay-").FullName;
        string page = Path.Combine(folder, "page.html");
        FootballCommand done = FootballCommand.Run(Two, "replay", "-", "-o", page, "--gltf", Path.Combine(folder, "two.gltf"), "--svg", Path.Combine(folder, "two.svg"));
        Assert.Equal(0, done.ExitCode);
        JsonElement[] shots = [.. Data(File.ReadAllText(page)).GetProperty("pictures")[0].GetProperty("shots").EnumerateArray()];
        Assert.Equal(["2 balls: ball 0", "2 balls: ball 1"], shots.Select(shot => shot.GetProperty("name").GetString()));
        for (int i = 0; i < 2; i++)
        {
            Assert.Contains(shots[i].GetProperty("events").EnumerateArray(), item => item.GetProperty("surface").GetString() == $"ball {1 - i}");
            Assert.DoesNotContain(shots[i].GetProperty("events").EnumerateArray(), item => item.GetProperty("surface").GetString() == $"ball {i}");
        }

        // The samples of the answer, by itself and on the line of a batch.
        JsonElement answer = FootballCommand.Run(Two, "simulate", "-", "--set", "samples=true").Result;
        JsonElement[] balls = [.. answer.GetProperty("balls").EnumerateArray()];
        Assert.Equal(2, balls.Length);
        foreach (JsonElement ball in balls)
        {
            JsonElement[] samples = [.. ball.GetProperty("samples").EnumerateArray()];
            Assert.InRange(samples.Length, 100, 2000);
            Assert.Equal(ball.GetProperty("final").GetRawText(), samples[^1].GetRawText());
            Assert.Equal(samples.Length, balls[0].GetProperty("samples").GetArrayLength());
        }

        FootballCommand batch = FootballCommand.Simulate($"{Two}\n{{{FootballCommand.Launch}}}\n{Two}\n", "--batch", "--set", "samples=true");
        Assert.Equal(3, batch.Lines.Count);
        Assert.All(new[] { 0, 2 }, line => Assert.Equal(answer.GetProperty("balls").GetRawText(), batch.Lines[line].GetProperty("balls").GetRawText()));
        Directory.Delete(folder, recursive: true);
    }

    [Fact]
    public void Several_files_share_a_picture_and_what_is_the_same_in_both_stands_once()
    {
        string folder = Directory.CreateTempSubdirectory("football-replay-").FullName;
        string[] files = [Path.Combine(folder, "one.json"), Path.Combine(folder, "two.json")];
        foreach (string file in files)
        {
            File.WriteAllText(file, JsonDocument.Parse(Shot).RootElement.GetProperty("scenario").GetRawText());
        }

        string page = Path.Combine(folder, "page.html");
        FootballCommand done = FootballCommand.Run("", ["replay", .. files, "-o", page, "--set", "stop.time=1"]);
        Assert.Equal(0, done.ExitCode);
        JsonElement picture = Data(File.ReadAllText(page)).GetProperty("pictures")[0];
        Assert.Equal(["one", "two"], picture.GetProperty("shots").EnumerateArray().Select(shot => shot.GetProperty("name").GetString()));
        Assert.Single(picture.GetProperty("shapes").EnumerateArray(), shape => shape.GetProperty("name").GetString() == "crossbar");
        Assert.Single(picture.GetProperty("shapes").EnumerateArray(), shape => shape.GetProperty("name").GetString() == "keeper");
        Directory.Delete(folder, recursive: true);
    }

    [Fact]
    public void Slopes_and_hills_are_drawn_where_they_are()
    {
        var tilted = Ground.PublishedTurf with { Normal = new Vector3d(0.1, 1, 0), Height = 0.5 };
        GroundGrid grid = GroundGrid.Of(tilted, [Vector3d.Zero, new Vector3d(5, 0, 5)])!;
        for (int i = 0; i < grid.Columns * grid.Rows; i++)
        {
            Vector3d at = grid.At(i % grid.Columns, i / grid.Columns);
            Assert.Equal(0.5 - (0.1 * at.X), at.Y, 1e-12);
        }

        Assert.Null(GroundGrid.Of(Ground.None, [Vector3d.Zero]));
    }

    [Fact]
    public void The_picture_of_the_README_is_what_the_command_draws()
    {
        string folder = Directory.CreateTempSubdirectory("football-picture-").FullName;
        string drawn = Path.Combine(folder, "picture.svg");
        FootballCommand done = FootballCommand.Run(RepositoryFiles.Text("docs/free-kick.json"), "replay", "-", "-o", Path.Combine(folder, "page.html"), "--svg", drawn);
        Assert.Equal(0, done.ExitCode);
        string text = File.ReadAllText(drawn);
        Assert.True(text == RepositoryFiles.Text("docs/free-kick.svg"), "Look at the picture, then run tests/regenerate.sh.");
        Assert.Contains("<title>A free kick over the wall</title>", text);
        Assert.Equal(4, text.Split("<animateTransform ").Length - 1);                       // ball and shadow: where, and how large
        Assert.Equal(2, text.Split("attributeName=\"d\"").Length - 1);                        // its panels turn, the back net gives way
        Assert.True(text.Split("<use href=\"#replay-0\"").Length > 2, "the ball goes behind what it passes behind");
        Directory.Delete(folder, recursive: true);
    }

    [Fact]
    public void A_ball_behind_the_eye_is_drawn_when_it_comes_into_sight_or_not_at_all()
    {
        string folder = Directory.CreateTempSubdirectory("football-behind-").FullName;
        string Shot(string name, string launch)
        {
            string file = Path.Combine(folder, name);
            File.WriteAllText(file, $"{{\"launch\":{{{launch}}},\"stop\":{{\"at\":\"time\",\"time\":2}}}}");
            return file;
        }

        string drawn = Path.Combine(folder, "behind.svg");
        FootballCommand done = FootballCommand.Run(
            "", "replay", Shot("ahead.json", "\"position\":[0,0.11,0],\"velocity\":[0,6,-20]"), Shot("passes.json", "\"position\":[1,0.11,17],\"velocity\":[0,6,-20]"),
            Shot("stays.json", "\"position\":[1,0.11,17],\"velocity\":[0,6,5]"), "-o", Path.Combine(folder, "page.html"), "--svg", drawn);
        Assert.Equal(("", 0), (done.Error.Split('\n').FirstOrDefault(line => line.StartsWith("football: ", StringComparison.Ordinal)) ?? "", done.ExitCode));
        var svg = System.Xml.Linq.XDocument.Load(drawn);
        string[] ids = [.. svg.Descendants().Where(element => element.Name.LocalName == "g" && element.Attribute("id") is not null).Select(element => element.Attribute("id")!.Value)];
        Assert.Equal(["replay-0", "replay-1"], ids);

        // Both stories last as long: the second ball is hidden at first, and moves by the same clock.
        string[] clocks = [.. svg.Descendants().Where(element => element.Attribute("type")?.Value == "translate").Select(element => element.Attribute("keyTimes")!.Value).Distinct()];
        Assert.Single(clocks);
        System.Xml.Linq.XElement[] uses = [.. svg.Descendants().Where(element => element.Name.LocalName == "use" && element.Attribute("href")?.Value == "#replay-1")];
        Assert.NotEmpty(uses);
        Assert.All(uses, use => Assert.Equal("hidden", use.Attribute("visibility")!.Value));
        Directory.Delete(folder, recursive: true);
    }

    [Fact]
    public void What_is_wrong_is_refused_before_anything_is_played()
    {
        FootballCommand done = FootballCommand.Run(Shot, "replay", "-", "-o", "");
        Assert.Equal((1, ""), (done.ExitCode, done.Output));
        Assert.Contains("--output \"\" cannot be written. ", done.Error);
        Assert.Contains("launch.position is missing", FootballCommand.Run("{}", "replay", "-", "-o", Path.Combine(AppContext.BaseDirectory, "none.html")).Error);
    }

    private static string Page(string scenario, out FootballCommand done)
    {
        string file = Path.Combine(AppContext.BaseDirectory, $"replay-{Guid.NewGuid():N}.html");
        done = FootballCommand.Run(scenario, "replay", "-", "-o", file);
        Assert.Equal(0, done.ExitCode);
        string page = File.ReadAllText(file);
        File.Delete(file);
        return page;
    }

    private static JsonElement Data(string page)
    {
        const string begin = "id=\"data\">";
        int from = page.IndexOf(begin, StringComparison.Ordinal) + begin.Length;
        return JsonDocument.Parse(page[from..page.IndexOf("</script>", from, StringComparison.Ordinal)]).RootElement;
    }

    private static double[] Numbers(JsonElement array) => [.. array.EnumerateArray().Select(item => item.GetDouble())];
}
