using System.Globalization;
using System.Text.Json;
using FootballPhysics.Scenarios;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Labs.Following;

/// <summary>The true motion at a row of a track.</summary>
internal readonly record struct TrueMotion(Vector3d Position, Vector3d Velocity, Vector3d Spin);

/// <summary>A kick of a track.</summary>
internal readonly record struct TrueKick(double Time, Vector3d Position, Vector3d Before, Vector3d Velocity, Vector3d Spin);

/// <summary>A row of a track: the measured position, and the truth.</summary>
internal readonly record struct FollowRow(double Time, Vector3d Measured, TrueMotion Truth, bool IsOutlier, bool IsRepeated);

/// <summary>A track with its truth.</summary>
internal sealed class FollowTrack
{
    private const double Noon = 1000;

    public required Scene Scene { get; init; }

    public required double Rate { get; init; }

    public required double Noise { get; init; }

    public List<FollowRow> Rows { get; } = [];

    public List<TrueKick> Kicks { get; } = [];

    /// <summary>The scene of <see cref="TruthBall"/>.</summary>
    public static Scene TruthScene { get; } = new() { Ball = BallProperties.Modern, Ground = Ground.Of(SurfaceMaterial.MatchTurf) };

    /// <summary>Simulates a track: starts in flight, rolling or at rest; one to four kicks, gaps, wrong and repeated points.</summary>
    public static FollowTrack Simulate(SeededRandom random, double rate, double noise)
    {
        var track = new FollowTrack { Scene = TruthScene, Rate = rate, Noise = noise };
        var ball = new TruthBall();
        double start = Noon * random.Next();
        double length = random.Uniform(6, 8);
        Vector3d place = (random.Uniform(0, 30) * random.Heading()) + (TruthBall.Radius * Vector3d.Up);
        switch (random.Below(3))
        {
            case 0:
                ball.Launch(start, place + (random.Uniform(0.5, 4) * Vector3d.Up), random.Velocity(5, 20, -10, 50), SpinOf(random));
                break;
            case 1:
                Vector3d along = random.Uniform(1, 6) * random.Heading();
                ball.Launch(start, place, along, new Vector3d(along.Z / TruthBall.Radius, 0, -along.X / TruthBall.Radius));
                break;
            default:
                ball.Launch(start, place, Vector3d.Zero, Vector3d.Zero);
                break;
        }

        double kick = start + random.Uniform(0.7, 2);
        double gap = start + random.Uniform(1, length);
        double gapLength = random.Uniform(0.1, 0.5);
        double interval = 1 / rate;
        for (double time = start; time < start + length; time += interval)
        {
            if (time > kick)
            {
                ball.Run(kick);
                track.Kick(ball, random);
                kick = time + random.Uniform(1, 4);
            }

            ball.Run(time);
            if (time > gap && time < gap + gapLength)
            {
                continue;
            }

            bool outlier = random.Chance(0.02) && time > start;
            Vector3d error = outlier ? random.Uniform(1, 5) * random.Direction() : new Vector3d(noise * Normal(random), noise * Normal(random), noise * Normal(random));
            var row = new FollowRow(time, ball.Position + error, new TrueMotion(ball.Position, ball.Velocity, ball.Spin), outlier, false);
            track.Rows.Add(row);
            if (random.Chance(0.01))
            {
                track.Rows.Add(row with { IsRepeated = true });
            }
        }

        return track;
    }

    /// <summary>Reads a track and its truth.</summary>
    public static FollowTrack Read(string csv)
    {
        using JsonDocument truth = JsonDocument.Parse(File.ReadAllText(Path.ChangeExtension(csv, ".json")));
        JsonElement root = truth.RootElement;
        JsonElement rows = root.GetProperty("rows");
        var scene = SceneInput.Scene(new InputFields(root.GetProperty("scene")).Root);
        var track = new FollowTrack { Scene = scene, Rate = root.GetProperty("rate").GetDouble(), Noise = root.GetProperty("noise").GetDouble() };
        HashSet<int> outliers = [.. rows.GetProperty("outlier").EnumerateArray().Select(at => at.GetInt32())];
        HashSet<int> repeated = [.. rows.GetProperty("repeated").EnumerateArray().Select(at => at.GetInt32())];
        string[] lines = File.ReadAllLines(csv);
        for (int i = 0; i < lines.Length - 1; i++)
        {
            double[] cells = [.. lines[i + 1].Split(',').Select(cell => double.Parse(cell, CultureInfo.InvariantCulture))];
            var motion = new TrueMotion(Vector(rows.GetProperty("position")[i]), Vector(rows.GetProperty("velocity")[i]), Vector(rows.GetProperty("spin")[i]));
            track.Rows.Add(new FollowRow(cells[0], new Vector3d(cells[1], cells[3], -cells[2]), motion, outliers.Contains(i), repeated.Contains(i)));
        }

        foreach (JsonElement kick in root.GetProperty("kicks").EnumerateArray())
        {
            track.Kicks.Add(new TrueKick(
                kick.GetProperty("time").GetDouble(), Vector(kick.GetProperty("position")), Vector(kick.GetProperty("velocityBefore")),
                Vector(kick.GetProperty("velocity")), Vector(kick.GetProperty("spin"))));
        }

        return track;
    }

    private static Vector3d Vector(JsonElement array) => new(array[0].GetDouble(), array[1].GetDouble(), array[2].GetDouble());

    private static Vector3d SpinOf(SeededRandom random) => random.Uniform(0, 60) * random.Direction();

    private static double Normal(SeededRandom random) =>
        Math.Sqrt(-2 * Math.Log(1 - random.Next())) * Math.Cos(2 * Math.PI * random.Next());

    private void Kick(TruthBall ball, SeededRandom random)
    {
        Vector3d before = ball.Velocity;
        bool low = random.Chance(0.25);
        Vector3d velocity = random.Velocity(5, 35, low ? 0 : 2, low ? 0 : 40);
        ball.Launch(ball.Time, ball.Position, velocity, SpinOf(random));
        Kicks.Add(new TrueKick(ball.Time, ball.Position, before, velocity, ball.Spin));
    }
}
