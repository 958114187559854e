using System.Globalization;
using System.Text;
using System.Text.Json;
using FootballPhysics.Tool.Tests.Tracks;

namespace FootballPhysics.Tool.Tests;

/// <summary>football follow: a line of JSON per point, at once, from a file or a pipe.</summary>
public sealed class FollowTests
{
    private static readonly string[] s_metres = ["--unit", "m", "--up", "z", "--noise", "0.05", "--ahead", "0.5"];

    /// <summary>A track that nothing of the product computes: three kicks, bounces and rolls, at 50 Hz.</summary>
    private static OwnTrack Kicks => OwnTrack.All[1];

    [Fact]
    public void Each_line_of_a_pipe_is_answered_before_the_next_is_read()
    {
        string[] lines = Lines(Kicks);
        using var output = new CountingStream();
        using var input = new LineStream(lines, () => output.FlushedLines);
        FootballCommand done = FootballCommand.Run(input, output, redirected: true, ["follow", "-", .. s_metres]);
        Assert.Equal(0, done.ExitCode);
        Assert.Equal(lines.Length - 1, output.FlushedLines);

        // The header has no answer; the k-th point is read when k − 1 points are answered.
        Assert.Equal([0, .. Enumerable.Range(0, lines.Length)], input.Answered);
    }

    [Fact]
    public void Kicks_motion_and_the_path_ahead_are_those_of_the_track()
    {
        OwnTrack track = Simulated();
        (double T, double X, double Y, double Z)[] points = track.Points;
        JsonElement[] found = [.. FootballCommand.Run(string.Join('\n', Lines(track)), "follow", "-", "--noise", "0.01", "--ahead", "0.5").Lines];
        Assert.Equal(points.Length, found.Length);
        var kicks = new List<double>();
        var off = new List<double>();
        for (int i = 0; i < found.Length; i++)
        {
            JsonElement line = found[i];
            Assert.Equal(points[i].T, line.GetProperty("time").GetDouble(), 1e-9);
            Assert.Equal(points[i].T + 0.5, line.GetProperty("ahead").GetProperty("time").GetDouble(), 1e-9);
            Assert.Contains(line.GetProperty("state").GetString(), (string[])["airborne", "sliding", "rolling", "stopped"]);

            // A ball at rest has a position that is not exactly known, and no motion.
            Assert.True(line.GetProperty("deviation").GetProperty("position").GetDouble() > 0);
            Assert.All((string[])["velocity", "spin"], name => Assert.True(line.GetProperty("deviation").GetProperty(name).GetDouble() >= 0));
            if (line.GetProperty("kick") is { ValueKind: JsonValueKind.Object } kick)
            {
                double time = kick.GetProperty("time").GetDouble();
                Assert.InRange(kick.GetProperty("probability").GetDouble(), 0.999, 1);
                if (kicks.Count == 0 || time > kicks[^1] + 0.2)
                {
                    kicks.Add(time);
                }
            }

            // The library's y is up, and its z points against the file's y.
            Assert.Equal(points[i].Z, line.GetProperty("position")[1].GetDouble(), 0.5);
            Assert.Equal(-points[i].Y, line.GetProperty("position")[2].GetDouble(), 0.5);
            bool isFree = track.Kicks.All(each => each.Time < points[i].T - 0.2 || each.Time > points[i].T + 0.52);
            if (isFree && i > 20 && i + 25 < points.Length)
            {
                off.Add(Math.Abs(points[i + 25].X - line.GetProperty("ahead").GetProperty("position")[0].GetDouble()));
            }
        }

        Assert.Equal(track.Kicks.Count, kicks.Count);
        Assert.All(kicks.Zip(track.Kicks), pair => Assert.Equal(pair.Second.Time, pair.First, 0.04));

        // Half a second ahead: the median is within half a metre.
        Assert.InRange(off.Order().ElementAt(off.Count / 2), 0, 0.5);
    }

    [Fact]
    public void A_file_gives_the_lines_of_a_pipe()
    {
        string text = string.Join('\n', Lines(Kicks));
        string file = Path.Combine(AppContext.BaseDirectory, "follow-test.csv");
        File.WriteAllText(file, text);
        Assert.Equal(FootballCommand.Run(text, ["follow", "-", .. s_metres]).Output, FootballCommand.Run("", ["follow", file, .. s_metres]).Output);
    }

    [Fact]
    public void Frames_units_and_gaps_are_read_as_stated()
    {
        string[] lines = Lines(Kicks)[..60];
        string[] seconds = [.. FootballCommand.Run(string.Join('\n', lines), ["follow", "-", .. s_metres]).Output.Split('\n')];
        string[] frames = [.. lines.Select((line, i) => i == 0 ? "frame;x_cm;y_cm;z_cm" : string.Join(';', Cells(line, i)))];
        frames[20] = "19;;;";
        FootballCommand done = FootballCommand.Run(string.Join('\n', frames), "follow", "-", "--rate", "50", "--noise", "0.05", "--ahead", "0.5");
        Assert.Equal(0, done.ExitCode);
        JsonElement[] found = [.. done.Lines];

        // The empty line is a gap: no answer, and the next point follows.
        Assert.Equal(58, found.Length);
        Assert.Equal(18 / 50.0, found[18].GetProperty("time").GetDouble(), 1e-9);
        Assert.Equal(20 / 50.0, found[19].GetProperty("time").GetDouble(), 1e-9);
        JsonElement same = JsonDocument.Parse(seconds[18]).RootElement;
        Assert.Equal(same.GetProperty("position")[0].GetDouble(), found[18].GetProperty("position")[0].GetDouble(), 1e-6);

        static IEnumerable<string> Cells(string line, int number)
        {
            string[] cells = line.Split(',');
            return cells[1..].Select(cell => (100 * double.Parse(cell, CultureInfo.InvariantCulture)).ToString("R", CultureInfo.InvariantCulture)).Prepend((number - 1).ToString(CultureInfo.InvariantCulture));
        }
    }

    [Theory]
    [InlineData("t,x,y,z\n0,1,2,0.2\n0.02,1,2,high", 1, "line 3, z is high")]
    [InlineData("t,x,y,z\nnoon,1,2,0.2", 0, "line 2, time is noon")]
    [InlineData("t,x,y,z\n0,1,2,0.2\n\n# a remark\n0.02,1,left,0.2", 1, "line 5, y is left")]
    [InlineData("t,x,y,z\n9,1,2,0.2\n9.02,1,2,0.2\n1,1,2,0.2", 2, "line 4, time is 1; allowed: at least 6")]
    [InlineData("t,x,y,z\n0,1,2,0.2\n1e12,1,2,0.2", 1, "line 3, time is 1000000000000")]
    [InlineData("t,x,y,z\n0,1,2,0.2\n0.02,5000,2,0.2", 1, "line 3, x is 5000; allowed: within 1 km")]
    [InlineData("frame,x,y,z\n0,1,2,0.2", 0, "--rate")]
    [InlineData("t,x,y\n0,1,2", 0, "TRACK's first line")]
    public void A_bad_line_is_named_after_the_answers_to_the_lines_before_it(string text, int answers, string expected)
    {
        FootballCommand done = FootballCommand.Run(text, "follow", "-");
        Assert.Equal(1, done.ExitCode);
        Assert.Contains(expected, done.Error.Split('\n', StringSplitOptions.RemoveEmptyEntries)[^1], StringComparison.Ordinal);
        Assert.Equal(answers, done.Lines.Count);
    }

    [Theory]
    [InlineData("--ahead", "0", "--ahead")]
    [InlineData("--ahead", "61", "--ahead")]
    [InlineData("--noise", "-1", "Noise")]
    [InlineData("--kicks-per-second", "0", "KicksPerSecond")]
    [InlineData("--unit", "parsec", "--unit")]
    public void A_bad_option_is_named_before_a_point_is_read(string option, string value, string expected)
    {
        FootballCommand done = FootballCommand.Run("t,x,y,z\n0,1,2,0.2", "follow", "-", option, value);
        Assert.Equal(1, done.ExitCode);
        Assert.Contains(expected, done.ErrorLine, StringComparison.OrdinalIgnoreCase);
        Assert.Equal("", done.Output);
    }

    /// <summary>A ball of the default scene: at rest, kicked three times, with a noise of 1 cm.</summary>
    private static OwnTrack Simulated()
    {
        var random = new Random(3);
        var simulator = new Simulator();
        BallState ball = simulator.Launch(new Vector3d(1, simulator.ContactHeight, 2), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        (double Time, Vector3d Velocity)[] kicks = [(0.5, new Vector3d(18, 9, 3)), (2, new Vector3d(-12, 5, 4)), (3.6, new Vector3d(6, 0, -14))];
        var points = new List<(double, double, double, double)>();
        for (int i = 0; i < 260; i++)
        {
            double time = i / 50.0;
            int kick = Array.FindIndex(kicks, each => Math.Abs(each.Time - time) < 1e-9);
            if (kick >= 0)
            {
                simulator.Kick(ref ball, kicks[kick].Velocity, new Vector3d(10, 20, -15));
            }

            points.Add((time, ball.Position.X + Noise(), -ball.Position.Z + Noise(), ball.Position.Y + Noise()));
            simulator.Run(ref ball, 0.02, 0.02, StopAt.Time, log);
        }

        return new OwnTrack("simulated", 50, [.. points]) { Kicks = kicks };

        double Noise() => 0.01 * Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
    }

    private static string[] Lines(OwnTrack track) =>
        ["t,x,y,z", .. track.Points.Select(point => FormattableString.Invariant($"{point.T:R},{point.X:F4},{point.Y:F4},{point.Z:F4}"))];

    /// <summary>A pipe whose writer waits after each line, and notes how many lines were answered until the next one is read.</summary>
    private sealed class LineStream(string[] lines, Func<int> answered) : MemoryStream
    {
        private int _next;

        public List<int> Answered { get; } = [];

        public override bool CanSeek => false;

        public override int Read(byte[] buffer, int offset, int count) => Read(buffer.AsSpan(offset, count));

        public override int Read(Span<byte> buffer)
        {
            Answered.Add(answered());
            if (_next == lines.Length)
            {
                return 0;
            }

            return Encoding.UTF8.GetBytes(lines[_next++] + "\n", buffer);
        }
    }

    /// <summary>Counts the lines that were flushed.</summary>
    private sealed class CountingStream : MemoryStream
    {
        public int FlushedLines { get; private set; }

        public override void Flush() => FlushedLines = GetBuffer().AsSpan(0, (int)Length).Count((byte)'\n');
    }
}
