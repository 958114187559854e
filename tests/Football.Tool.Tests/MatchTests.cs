using System.Globalization;
using System.Text;
using System.Text.Json;

namespace FootballPhysics.Tool.Tests;

/// <summary>football fit --match: lines of pieces and a summary, from CSV as trackers write it.</summary>
public sealed class MatchTests
{
    [Fact]
    public void Pieces_are_lines_in_order_of_time_and_a_summary_ends_them()
    {
        FootballCommand done = Match(Track("t,x,y,z"), "--ball", "modern", "--altitude", "100", "--temperature", "12");
        Assert.Equal(0, done.ExitCode);
        JsonElement[] pieces = [.. done.Lines.SkipLast(1)];
        double last = double.NegativeInfinity;
        foreach (JsonElement piece in pieces)
        {
            Assert.Contains(piece.GetProperty("kind").GetString(), (string[])["flight", "impact", "ground", "touch", "lost"]);
            Assert.True(piece.GetProperty("from").GetDouble() >= last);
            last = piece.GetProperty("from").GetDouble();
            Assert.Equal(3, piece.GetProperty("velocity").GetArrayLength());
            Assert.Equal(3, piece.GetProperty("spin").GetArrayLength());
            Assert.Equal(JsonValueKind.Object, piece.GetProperty("deviations").ValueKind);
        }

        JsonElement summary = done.Lines[^1];
        Assert.Equal("summary", summary.GetProperty("kind").GetString());
        Assert.InRange(summary.GetProperty("rms").GetDouble(), 0, 0.02);
        Assert.Equal(2, summary.GetProperty("flights").GetInt32());
        JsonElement fitted = summary.GetProperty("fitted");
        Assert.All((string[])["drag", "groundHeight", "restitution", "friction"], name => Assert.Equal(JsonValueKind.Number, fitted.GetProperty(name).ValueKind));

        // In the terms of robot soccer: friction and a little drag slow the slide, and the ball is a shell.
        JsonElement robot = summary.GetProperty("robotSoccer");
        Assert.InRange(robot.GetProperty("acc_slide").GetDouble() / -9.81, fitted.GetProperty("slidingFriction").GetDouble(), fitted.GetProperty("slidingFriction").GetDouble() + 0.15);
        Assert.InRange(robot.GetProperty("k_switch").GetDouble(), 0.55, 0.6);
        Assert.All((string[])["acc_roll", "damping_xy_first_hop", "damping_xy_other_hops", "damping_z"], name => Assert.Equal(JsonValueKind.Number, robot.GetProperty(name).ValueKind));

        // y up, and z against the file's y: the flight goes along −y of the file.
        JsonElement velocity = pieces.First(piece => piece.GetProperty("kind").GetString() == "flight").GetProperty("velocity");
        Assert.InRange(velocity[0].GetDouble(), 11, 13);
        Assert.InRange(velocity[2].GetDouble(), 4, 6);
    }

    [Theory]
    [InlineData("timestamp,ball_x,ball_y,ball_z_cm", true)]
    [InlineData("T;X;Y;Z", false)]
    public void Columns_are_read_as_trackers_name_them(string header, bool centimetres)
    {
        string[] lines = Track(header).Split('\n');
        for (int i = 1; i < lines.Length; i++)
        {
            string[] cells = lines[i].Split(',');
            cells[3] = centimetres ? (100 * double.Parse(cells[3], CultureInfo.InvariantCulture)).ToString(CultureInfo.InvariantCulture) : cells[3];
            lines[i] = string.Join(header.Contains(';', StringComparison.Ordinal) ? ';' : ',', cells);
        }

        FootballCommand done = Match(string.Join('\n', lines));
        Assert.Equal(0, done.ExitCode);
        Assert.Equal(Match(Track("t,x,y,z")).Lines[^1].GetProperty("flights").GetInt32(), done.Lines[^1].GetProperty("flights").GetInt32());
    }

    [Theory]
    [InlineData("t,x,y\n0,1,2", "TRACK's columns")]
    [InlineData("t,x,y,z\n0,1,2,3", "1 points")]
    [InlineData("t,x,y,z\n0,1,2,kick", "line 2, z is kick")]
    [InlineData("t,x,y,z\n1,1,2,3\n0.5,1,2,3", "2 points")]
    [InlineData("t,x,y,z\nnoon,1,2,3", "line 2, time is noon")]
    public void What_is_no_track_is_refused_by_line(string text, string expected)
    {
        FootballCommand done = Match(text);
        Assert.Equal(1, done.ExitCode);
        Assert.Contains(expected, done.ErrorLine, StringComparison.Ordinal);
        Assert.Equal("", done.Output);
    }

    [Fact]
    public void Options_are_refused_by_what_is_allowed()
    {
        Assert.Contains("wind | drag | crisis | lift | surface | height | none", Match(Track("t,x,y,z"), "--free", "gravity").ErrorLine, StringComparison.Ordinal);
        Assert.Contains("ball.type", Match(Track("t,x,y,z"), "--ball", "square").ErrorLine, StringComparison.Ordinal);
        Assert.Equal(2, FootballCommand.Run("{}", "fit", "-", "--free", "wind").ExitCode);
        Assert.Equal(2, FootballCommand.Run("{}", "fit", "-", "--match", "-").ExitCode);
        Assert.Equal(2, FootballCommand.Run("", "fit").ExitCode);
    }

    [Theory]
    [InlineData("--batch")]
    [InlineData("--jobs", "2")]
    public void What_is_of_batches_is_refused_by_name(params string[] option)
    {
        FootballCommand done = Match(Track("t,x,y,z"), option);
        Assert.Equal((2, ""), (done.ExitCode, done.Output));
        Assert.StartsWith($"football: {option[0]} cannot be combined with --match.", done.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void A_drawing_does_not_take_the_place_of_the_track()
    {
        string file = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName() + ".csv");
        try
        {
            string track = Track("t,x,y,z");
            File.WriteAllText(file, track);
            FootballCommand done = FootballCommand.Run("", "fit", "--match", file, "--plot", file);
            Assert.Equal(1, done.ExitCode);
            Assert.Matches("^football: --plot \".*\" is also the file of the input. Pass another file.$", done.ErrorLine);
            Assert.Equal(track, File.ReadAllText(file));
        }
        finally
        {
            File.Delete(file);
        }
    }

    [Fact]
    public void Only_what_is_free_has_a_deviation()
    {
        JsonElement deviations = Match(Track("t,x,y,z"), "--free", "wind,height").Lines[^1].GetProperty("deviations");
        Assert.Equal(["groundHeight", "wind"], deviations.EnumerateObject().Select(item => item.Name).Order());
    }

    [Fact]
    public void Slides_and_rolls_are_told_with_their_friction()
    {
        // Passes along the ground, one every three seconds; each slides and then rolls.
        FootballCommand done = Match(Passes(), "--set", "ground.surface=matchTurf", "--ball", "modern", "--free", "surface,height");
        Assert.Equal(0, done.ExitCode);
        JsonElement[] windows = [.. done.Lines.SkipLast(1).Where(piece => piece.GetProperty("kind").GetString() == "ground").SelectMany(piece => piece.GetProperty("windows").EnumerateArray())];
        JsonElement summary = done.Lines[^1];
        Assert.Equal(summary.GetProperty("slides").GetInt32(), windows.Count(window => window.GetProperty("motion").GetString() == "sliding"));
        Assert.Equal(summary.GetProperty("rolls").GetInt32(), windows.Count(window => window.GetProperty("motion").GetString() == "rolling"));
        Assert.Equal(["deviation", "from", "motion", "points", "resistance", "speed", "to"], windows[0].EnumerateObject().Select(item => item.Name).Order());
        JsonElement fitted = summary.GetProperty("fitted");
        JsonElement deviations = summary.GetProperty("deviations");
        foreach ((string name, double truth) in (ReadOnlySpan<(string, double)>)[("slidingFriction", 0.4), ("rollingFriction", 0.06), ("rollingFrictionBySpeed", 0.002)])
        {
            double deviation = deviations.GetProperty(name).GetDouble();
            Assert.InRange(deviation, 1e-4, 0.06);
            Assert.InRange(fitted.GetProperty(name).GetDouble(), truth - (3 * deviation), truth + (3 * deviation));
        }

        JsonElement rolling = summary.GetProperty("rolling");
        Assert.Equal(0.06 + (0.002 * rolling.GetProperty("speed").GetDouble()), rolling.GetProperty("resistance").GetDouble(), 3 * rolling.GetProperty("deviation").GetDouble());
        Assert.Contains("slides and rolls", done.Error, StringComparison.Ordinal);
        Assert.Equal(JsonValueKind.Null, Match(Track("t,x,y,z")).Lines[^1].GetProperty("rolling").ValueKind);
    }

    [Fact]
    public void The_fit_is_drawn()
    {
        string file = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName() + ".svg");
        try
        {
            Assert.Equal(0, Match(Track("t,x,y,z"), "--plot", file).ExitCode);
            string drawing = File.ReadAllText(file);
            Assert.Contains("From above", drawing, StringComparison.Ordinal);
            Assert.Contains("Distances by flight", drawing, StringComparison.Ordinal);
        }
        finally
        {
            File.Delete(file);
        }
    }

    private static FootballCommand Match(string track, params string[] options) => FootballCommand.Run(track, ["fit", "--match", "-", .. options]);

    /// <summary>A kick with a bounce, at 50 Hz, to a tenth of a millimetre.</summary>
    private static string Track(string header)
    {
        var simulator = new Simulator(new Scene { Ball = BallProperties.Modern, Ground = Ground.Of(SurfaceMaterial.MatchTurf) });
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(12, 7, 5), new Vector3d(0, 20, 0));
        var text = new StringBuilder(header);
        for (int i = 0; i < 110; i++)
        {
            text.Append(CultureInfo.InvariantCulture, $"\n{i * 0.02:0.####},{ball.Position.X:0.####},{-ball.Position.Z:0.####},{ball.Position.Y:0.####}");
            log.Clear();
            simulator.Step(ref ball, 0.02, log);
        }

        return text.ToString();
    }

    private static string Passes()
    {
        var simulator = new Simulator(new Scene
        {
            Ball = BallProperties.Modern,
            Ground = Ground.Of(SurfaceMaterial.MatchTurf with { SlidingFriction = 0.4, RollingResistance = 0.06, RollingResistancePerSpeed = 0.002 }),
        });
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), Vector3d.Zero, Vector3d.Zero);
        var text = new StringBuilder("t,x,y,z");
        for (int i = 0; i < 900; i++)
        {
            if (i % 150 == 0)
            {
                double way = i % 300 == 0 ? 1 : -1;
                simulator.Kick(ref ball, new Vector3d(way * (7 + (0.004 * i)), 0, 2 * way), Vector3d.Zero);
            }

            text.Append(CultureInfo.InvariantCulture, $"\n{i * 0.02:0.####},{ball.Position.X:0.###},{-ball.Position.Z:0.###},{ball.Position.Y:0.###}");
            log.Clear();
            simulator.Step(ref ball, 0.02, log);
        }

        return text.ToString();
    }
}
