using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Fit;
using FootballPhysics.Tool.Fit.Reading;

namespace FootballPhysics.Tool.Tests.Tracks;

/// <summary>Three tracks, each written in more than a hundred ways: every one is read correctly or refused with advice.</summary>
public sealed class TrackWayTests(ITestOutputHelper output)
{
    /// <summary>A position as read is within this of the true one, m: the last digit of the coarsest way, centimetres.</summary>
    private const double Near = 0.009;

    /// <summary>Times are within half a millisecond, s: the last digit of the coarsest way.</summary>
    private const double Soon = 6e-4;

    private static readonly Scene s_scene = Scene.Default with { Ball = BallProperties.Tunnel };

    [Fact]
    public void Every_way_is_read_correctly_or_refused_with_advice()
    {
        var counts = new Dictionary<string, int> { ["correct"] = 0, ["refused with advice"] = 0, ["wrong"] = 0 };
        List<string> wrong = [];
        foreach (TrackWay way in TrackWay.All)
        {
            string[] verdicts = [.. OwnTrack.All.Select(track => Verdict(way, track))];
            output.WriteLine($"{way.Name,-48} {string.Join(" | ", verdicts)}");
            foreach (string verdict in verdicts)
            {
                string kind = verdict.Split(':')[0];
                counts[kind]++;
                wrong.AddRange(kind == "wrong" ? [$"{way.Name}: {verdict}"] : []);
            }
        }

        output.WriteLine(string.Join(", ", counts.Select(count => $"{count.Key} {count.Value}")));
        Assert.Empty(wrong);
        Assert.True(counts["correct"] + counts["refused with advice"] >= 200);
        Assert.True(counts["correct"] >= 280, $"{counts["correct"]}");
    }

    [Fact]
    public void A_good_track_in_metres_is_not_taken_for_another_unit()
    {
        foreach (OwnTrack track in OwnTrack.All)
        {
            TrackReading reading = TrackReader.Reading(new MemoryStream(TrackWay.All[0].Write(track)), _ => { });
            MatchFitResult fit = new MatchFit(s_scene).Find(reading.Points);
            output.WriteLine($"{track.Name}: {fit.Flights} flights, rms {100 * fit.Rms:0.00} cm, noise {1000 * fit.Noise:0.0} mm");
            Assert.True(reading.IsGuessed);
            Assert.True(fit.Flights >= 3);
            UnitRivals.Check(s_scene, new MatchFitRequest(), reading, fit, _ => { });
        }
    }

    private static string Verdict(TrackWay way, OwnTrack track)
    {
        TrackFormat? format = way.Format is { Rate: not null } rated ? rated with { Rate = track.Rate } : way.Format;
        TrackReading reading;
        try
        {
            reading = TrackReader.Reading(new MemoryStream(way.Write(track)), _ => { }, format);
        }
        catch (RefusedException refusal)
        {
            return Refused(refusal);
        }

        string? off = Off(reading.Points, track);
        if (off is null)
        {
            return "correct";
        }

        // Read as something else: the fit must notice.
        try
        {
            MatchFitResult fit = new MatchFit(s_scene).Find(reading.Points);
            UnitRivals.Check(s_scene, new MatchFitRequest(), reading, fit, _ => { });
        }
        catch (RefusedException refusal)
        {
            return Refused(refusal);
        }

        return "wrong: " + off;
    }

    /// <summary>A refusal has to say what to do.</summary>
    private static string Refused(RefusedException refusal)
    {
        string[] advice = ["Give --", "give --", "--columns", "Write ", "Put ", "Close ", "Keep ", "Unpack ", "State ", "Rename ", "allowed: ", "Check --"];
        return (advice.Any(word => refusal.Message.Contains(word, StringComparison.Ordinal)) ? "refused with advice: " : "wrong: no advice: ") + refusal.Message;
    }

    /// <summary>What is wrong with the points; null if nothing is.</summary>
    internal static string? Off(TrackPoint[] read, OwnTrack track)
    {
        // Points that are hidden may be missing; every other one is there, once or in equal copies.
        TrackPoint[] points = [.. read.DistinctBy(point => point.Time)];
        double start = points[0].Time;
        int at = 0;
        foreach ((double t, double x, double y, double z) in track.Points)
        {
            double time = at < points.Length ? points[at].Time - start : double.PositiveInfinity;
            if (Math.Abs(time - t) > Soon)
            {
                if (TrackWay.IsHidden(t))
                {
                    continue;
                }

                return FormattableString.Invariant($"time {time} at {t}");
            }

            var place = new Vector3d(x, z, -y);
            Vector3d shift = points[0].Position - new Vector3d(track.Points[0].X, track.Points[0].Z, -track.Points[0].Y);
            double miss = Vector3d.Distance(points[at].Position - shift, place);
            if (miss > 2 * Near)
            {
                return FormattableString.Invariant($"{miss:0.000} m off at {t:0.00} s");
            }

            at++;
        }

        return at == points.Length ? null : $"{points.Length - at} points too many";
    }
}
