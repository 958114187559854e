using System.Globalization;
using System.Text;
using FootballPhysics.Tool.Fit;

namespace FootballPhysics.Tool.Tests.Tracks;

/// <summary>Tracks with missing points or rounded times: the noise is estimated to within 30 %, and all launches are found.</summary>
/// <remarks>Every pattern is applied to the three tracks at 25, 50 and 29.97 Hz, with three levels of noise.</remarks>
public sealed class GapTests(ITestOutputHelper output)
{
    /// <summary>A flight begins within this time of its kick, in s; its velocity is within this of the kick's, in m/s, and the ball slows by at most this meanwhile, in m/s².</summary>
    private const double MostLate = 0.25;
    private const double MostMiss = 1;
    private const double MostSlowing = 20;

    private static readonly Scene s_scene = Scene.Default with { Ball = BallProperties.Tunnel };

    /// <summary>The patterns: how many different ones there are, and whether one of them keeps a point, by its index and a random number.</summary>
    private static readonly Dictionary<string, (int Seeds, Func<int, int, double, bool> Keeps)> s_patterns = new()
    {
        ["every third point missing"] = (3, (i, seed, _) => i % 3 != seed),
        ["every second point missing"] = (2, (i, seed, _) => i % 2 != seed),
        ["40 % missing at random"] = (3, (_, _, lot) => lot >= 0.4),
        ["times rounded to 10 ms"] = (1, (_, _, _) => true),
    };

    public static TheoryData<string, double> Rows
    {
        get
        {
            var rows = new TheoryData<string, double>();
            foreach (string pattern in s_patterns.Keys)
            {
                foreach (double noise in new[] { 0.002, 0.005, 0.02 })
                {
                    rows.Add(pattern, noise);
                }
            }

            return rows;
        }
    }

    [Theory]
    [MemberData(nameof(Rows))]
    public void The_noise_of_a_track_with_gaps_is_known_and_its_launches_are_found(string pattern, double noise)
    {
        bool isRounded = pattern.StartsWith("times", StringComparison.Ordinal);
        List<string> wrong = [];
        foreach (OwnTrack track in OwnTrack.WithNoise(noise, noise, noise))
        {
            double least = double.PositiveInfinity;
            double most = 0;
            double latest = 0;
            int found = 0;
            int launches = 0;
            for (int seed = 0; seed < s_patterns[pattern].Seeds; seed++)
            {
                MatchFitResult fit = new MatchFit(s_scene).Find(Gappy(track, pattern, seed, isRounded));
                double ratio = fit.Noise / noise;
                (least, most) = (Math.Min(least, ratio), Math.Max(most, ratio));
                foreach ((double time, Vector3d velocity) in track.Kicks)
                {
                    launches++;
                    bool isFound = IsFound(fit, time, velocity, out double late, out double miss);
                    latest = Math.Max(latest, Math.Abs(late));
                    found += isFound ? 1 : 0;
                    wrong.AddRange(isFound ? [] : [FormattableString.Invariant($"{track.Name}, seed {seed}, kick at {time:0.0} s: {late:0.000} s late, {miss:0.00} m/s off")]);
                }
            }

            output.WriteLine(FormattableString.Invariant($"{pattern,-27} {1000 * noise,2} mm  {track.Name,-8}  noise {least:0.00} to {most:0.00} of the true one, launches {found} of {launches}, at most {latest:0.00} s off"));
            Assert.InRange(least, 0.7, 1.3);
            Assert.InRange(most, 0.7, 1.3);
        }

        Assert.True(wrong.Count == 0, string.Join('\n', wrong));
    }

    /// <summary>The track as a file of CSV with a pattern of missing points, read back.</summary>
    private static TrackPoint[] Gappy(OwnTrack track, string pattern, int seed, bool isRounded)
    {
        var random = new Random(100 + seed);
        var text = new StringBuilder("t,x,y,z\n");
        for (int i = 0; i < track.Points.Length; i++)
        {
            (double t, double x, double y, double z) = track.Points[i];
            if (s_patterns[pattern].Keeps(i, seed, random.NextDouble()))
            {
                text.AppendLine(string.Create(CultureInfo.InvariantCulture, $"{(isRounded ? Math.Round(t, 2) : t):0.#####},{x:0.00000},{y:0.00000},{z:0.00000}"));
            }
        }

        return TrackReader.Reading(new MemoryStream(Encoding.UTF8.GetBytes(text.ToString())), _ => { }).Points;
    }

    /// <summary>A launch is found if a flight begins soon after the kick, with the velocity that the ball still has then.</summary>
    /// <remarks>A flight begins late if only one to three points precede the kick: they and the next ones form a short segment.</remarks>
    private static bool IsFound(MatchFitResult fit, double time, Vector3d velocity, out double late, out double miss)
    {
        MatchPiece nearest = fit.Pieces.Where(piece => piece.Kind == MatchPieceKind.Flight).MinBy(piece => Math.Abs(piece.StartTime - time))!;
        late = nearest.StartTime - time;
        miss = (nearest.Velocity - velocity).Length;
        return Math.Abs(late) < MostLate && miss < MostMiss + (MostSlowing * Math.Abs(late));
    }
}
