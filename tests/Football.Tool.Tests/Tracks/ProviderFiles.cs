using System.Globalization;
using System.Text;
using FootballPhysics.Tool.Fit.Reading;

namespace FootballPhysics.Tool.Tests.Tracks;

/// <summary>
/// Files as providers write them. The layouts are those of kloppy's test files and parsers (kloppy/tests/files, kloppy/infra/serializers/tracking), and of the
/// schema of the Common Data Format 0.2.3. The numbers are those of a track of this test.
/// </summary>
internal static class ProviderFiles
{
    /// <summary>The teams of TRACAB's objects: away, home, officials and others.</summary>
    private static readonly int[] s_teams = [0, 1, 3, 4, -1];

    private static readonly TrackFormat s_rated = new() { Rate = 1 };

    /// <summary>A file, and the words of its refusal; null if it is read.</summary>
    public static IReadOnlyList<(TrackWay Way, string[]? Refusal)> All { get; } = [.. Tracab(), .. TracabJson(), .. Sportec(), .. Lines(), .. Lists(), .. Columns()];

    private static IEnumerable<(TrackWay Way, string[]? Refusal)> Tracab()
    {
        foreach (int objects in (int[])[0, 1, 14, 18, 25, 29, 34])
        {
            yield return Read($"TRACAB, {objects} objects", track => TracabLines(track, _ => objects), s_rated);
        }

        yield return Read("TRACAB, CR LF", track => TracabLines(track, _ => 22).Replace("\n", "\r\n", StringComparison.Ordinal), s_rated);
        yield return Read("TRACAB, blank lines", track => "\n\n" + TracabLines(track, _ => 22).Replace("\n", "\n\n", StringComparison.Ordinal), s_rated);
        yield return Read("TRACAB, set marks", track => TracabLines(track, _ => 25, i => i % 7 == 0 ? ",SetHome" : i % 7 == 3 ? ",SetAway,B1" : ""), s_rated);
        yield return Read("TRACAB, a short first line", track => TracabLines(track, i => i == 0 ? 2 : 27), s_rated);
        yield return Read("TRACAB, a long first line", track => TracabLines(track, i => i == 0 ? 34 : 20), s_rated);
        yield return Read("TRACAB, frames without a ball at the end", track => TracabLines(track, _ => 22) + "99999998:0,1,2,3,4,0.00;:\n99999999:0,1,2,3,4,0.00;::\n", s_rated);
        yield return Refused("TRACAB without a rate", track => TracabLines(track, _ => 29), "--rate");
        yield return Refused("TRACAB with a line of another kind", track => TracabLines(track, _ => 29) + "the end\n", "TRACAB", "the end");
    }

    private static IEnumerable<(TrackWay Way, string[]? Refusal)> TracabJson()
    {
        string Ball(double x, double y, double z) => FormattableString.Invariant($"{{\"BallContactInfo\": \"SetHome\", \"BallOwningTeam\": \"H\", \"BallStatus\": \"Alive\", \"Speed\": 11, \"X\": {100 * x:0}, \"Y\": {100 * y:0}, \"Z\": {100 * z:0}}}");
        string Frames(OwnTrack track, int balls) => "{\"FrameData\": [" + string.Join(",\n", track.Points.Select((p, i) =>
            $"{{\"FrameCount\": {Frame(p, track)}, \"GameRunning\": 1, \"Phase\": 1, \"PlayerPositions\": [{People(i, 22, (k, x, y) => $"{{\"Team\": {k % 2}, \"JerseyNumber\": {k}, \"X\": {100 * x:0}, \"Y\": {100 * y:0}, \"Speed\": 1.5}}", ", ")}], "
            + $"\"BallPosition\": [{string.Join(", ", Enumerable.Range(0, balls).Select(k => k == 0 ? Ball(p.X, p.Y, p.Z) : Ball(55.5, 44, 0)))}]}}")) + "]}";
        yield return Read("TRACAB's JSON, one ball", track => Frames(track, 1), s_rated);
        yield return Read("TRACAB's JSON, four balls", track => Frames(track, 4), s_rated);
        yield return Refused("TRACAB's JSON without a rate", track => Frames(track, 2), "--rate");
    }

    private static IEnumerable<(TrackWay Way, string[]? Refusal)> Sportec()
    {
        yield return Read("DFL, the ball alone", track => Dfl(track, "B"));
        yield return Read("DFL, the ball first", track => Dfl(track, "B12"));
        yield return Read("DFL, the ball last, players with heights", track => Dfl(track, "12B", heights: true));
        yield return Read("DFL, 22 players", track => Dfl(track, "123456B789", heights: true));
        yield return Read("DFL, the ball by its id", track => Dfl(track, "1B2", team: "BALL-1"));
        yield return Refused("DFL without a ball", track => Dfl(track, "12"), "FrameSet firstHalf DFL-CLU-000001 DFL-OBJ-002G01: ", "TeamId is BALL");
        yield return Refused("other XML", _ => "<?xml version=\"1.0\"?><gpx><trk/></gpx>", "only gpx without a FrameSet");
    }

    private static IEnumerable<(TrackWay Way, string[]? Refusal)> Lines()
    {
        string SecondSpectrum(OwnTrack track, Func<(double T, double X, double Y, double Z), string> clocks) => JsonLines(track, (p, i) =>
            $"{{\"period\": 1, \"frameIdx\": {Frame(p, track)}, {clocks(p)}\"homePlayers\": [{People(i, 11, (k, x, y) => FormattableString.Invariant($"{{\"playerId\": \"h{k}\", \"number\": {k}, \"xyz\": [{x:0.00}, {y:0.00}, 0.0], \"speed\": 1}}"), ", ")}], \"awayPlayers\": [], "
            + $"\"ball\": {{\"xyz\": [{N(p.X)}, {N(p.Y)}, {N(p.Z)}], \"speed\": 2.5}}, \"live\": true, \"lastTouch\": \"home\"}}");
        yield return Read("Second Spectrum, gameClock", track => SecondSpectrum(track, p => $"\"gameClock\": {N(p.T)}, "));
        yield return Read("Second Spectrum, gameClock and wallClock", track => SecondSpectrum(track, p => $"\"gameClock\": {N(p.T)}, \"wallClock\": 0, "));
        yield return Read("Second Spectrum, wallClock first", track => SecondSpectrum(track, p => $"\"wallClock\": {N(1000 * p.T)}, \"gameClock\": {N(p.T)}, "));
        yield return Read("Second Spectrum with --rate", track => SecondSpectrum(track, p => $"\"gameClock\": {N(p.T)}, "), s_rated);
        yield return Refused("Second Spectrum without a clock", track => SecondSpectrum(track, _ => ""), "--rate");
        yield return Read("Common Data Format", track => JsonLines(track, (p, i) =>
            $"{{\"frame_id\": {Frame(p, track)}, \"timestamp\": \"{Date(p.T)}Z\", \"period\": \"first_half\", \"match\": {{\"id\": \"m\"}}, \"ball_status\": true, \"teams\": {{\"home\": {{\"id\": \"t\", \"players\": [{People(i, 3, (k, x, y) => FormattableString.Invariant($"{{\"id\": \"{k}\", \"x\": {x:0.0}, \"y\": {y:0.0}}}"), ", ")}]}}, \"away\": {{\"id\": \"u\", \"players\": []}}}}, "
            + $"\"ball\": {{\"x\": {N(p.X)}, \"y\": {N(p.Y)}, \"z\": {N(p.Z)}}}}}"));
        yield return Refused("Common Data Format without heights", track => JsonLines(track, (p, _) => $"{{\"frame_id\": 1, \"timestamp\": \"{Date(p.T)}Z\", \"ball\": {{\"x\": {N(p.X)}, \"y\": {N(p.Y)}}}}}"), "frame_id, timestamp, ball_x, ball_y", "heights");
        yield return Read("PFF", track => JsonLines(track, (p, _) =>
            $"{{\"version\": \"4.1.0\", \"videoTimeMs\": {N(1000 * p.T)}, \"frameNum\": {Frame(p, track)}, \"period\": 1, \"homePlayers\": [{{\"jerseyNum\": \"21\", \"x\": 13.9, \"y\": 19.2, \"z\": 1.1}}], \"balls\": [{{\"visibility\": \"VISIBLE\", \"x\": {N(p.X)}, \"y\": {N(p.Y)}, \"z\": {N(p.Z)}}}]}}"));
        string Ma25(OwnTrack track, bool first) => string.Join('\n', track.Points.Select((p, i) => i == 0 && !first
            ? FormattableString.Invariant($"1598184000000;0,1,1:;:")
            : FormattableString.Invariant($"{1598184000000 + Math.Round(1000 * p.T)};{Math.Round(1000 * p.T)},1,0:{People(i, 22, (k, x, y) => FormattableString.Invariant($"{k % 2},id{k},{k},{x:0.###},{y:0.###};"), "")}:{N(p.X)},{N(p.Y)},{N(p.Z)};"))) + "\n";
        yield return Read("Stats Perform MA25", track => Ma25(track, true));
        yield return Refused("Stats Perform MA25 with a torn line", track => Ma25(track, true) + "1598184", "MA25", "1598184");
    }

    private static IEnumerable<(TrackWay Way, string[]? Refusal)> Lists()
    {
        string HawkEye(OwnTrack track, string samples) => "{\"details\": {\"match\": {\"id\": {\"heId\": \"a\"}}, \"teams\": [{\"name\": \"A\"}, {\"name\": \"B\"}]}, \"samples\": {"
            + $"\"{samples}\": [{string.Join(",\n", track.Points.Select(p => $"{{\"speed\": {{\"mph\": 1, \"mps\": 2}}, \"distance\": {{\"metres\": 0.1, \"feet\": 0.2}}, \"pos\": [{N(p.X)}, {N(p.Y)}, {N(p.Z)}], \"possession\": {{\"teamId\": {{\"heId\": \"a\"}}}}, \"time\": {N(p.T)}, \"bounds\": \"In\", \"play\": \"In\"}}"))}]}}, "
            + "\"units\": {\"length\": \"metre\"}, \"segments\": [{\"segment\": 0}], \"sport\": \"Football\"}";
        yield return Read("Hawk-Eye samples.ball", track => HawkEye(track, "ball"));
        yield return Refused("Hawk-Eye, samples of people", track => HawkEye(track, "people"), "list samples.people: ", "list details.teams: 2 objects", "--records");
        yield return Read("Hawk-Eye, the list by name", track => HawkEye(track, "ball.1".Replace(".1", "s", StringComparison.Ordinal)), new TrackFormat { Records = "samples.balls" });
        yield return Refused("JSON without lists", _ => "{\"home\": \"A\", \"away\": \"B\"}", "no list of objects");
    }

    private static IEnumerable<(TrackWay Way, string[]? Refusal)> Columns()
    {
        string Table(OwnTrack track, string head) => head + "\n" + string.Concat(track.Points.Select(p => $"{N(p.T)};Spieler;1;2;0\n{N(p.T)};Ball;{N(p.X)};{N(p.Y)};{N(p.Z)}\n"));
        yield return Read("German columns, objects by name", track => Table(track, "Uhr;Objekt;Ost;Nord;Höhe"), new TrackFormat { Columns = ["Uhr", "Ost", "Nord", "Höhe"], Object = ("Objekt", "Ball") });
        yield return Read("Japanese columns", track => Table(track, "時刻;物体;東;北;高さ"), new TrackFormat { Columns = ["時刻", "東", "北", "高さ"], Object = ("物体", "Ball") });
        yield return Refused("German columns without their names", track => Table(track, "Uhr;Objekt;Ost;Nord;Höhe"), "Uhr, Objekt, Ost, Nord, Höhe", "--columns");
        yield return Refused("objects that are not named", track => Table(track, "Uhr;Objekt;Ost;Nord;Höhe"), new TrackFormat { Columns = ["Uhr", "Ost", "Nord", "Höhe"] }, "--object");
    }

    private static (TrackWay Way, string[]? Refusal) Read(string name, Func<OwnTrack, string> write, TrackFormat? format = null) => (new TrackWay(name, track => Encoding.UTF8.GetBytes(write(track)), format), null);

    private static (TrackWay Way, string[]? Refusal) Refused(string name, Func<OwnTrack, string> write, params string[] words) => Refused(name, write, null, words);

    private static (TrackWay Way, string[]? Refusal) Refused(string name, Func<OwnTrack, string> write, TrackFormat? format, params string[] words) =>
        (new TrackWay(name, track => Encoding.UTF8.GetBytes(write(track)), format), words);

    private static string TracabLines(OwnTrack track, Func<int, int> objects, Func<int, string>? mark = null) => string.Concat(track.Points.Select((p, i) => string.Create(CultureInfo.InvariantCulture,
        $"{1848508 + Frame(p, track)}:{People(i, objects(i), (k, x, y) => string.Create(CultureInfo.InvariantCulture, $"{s_teams[k % 5]},{k},{k % 30},{100 * x:0},{100 * y:0},1.25;"), "")}:{100 * p.X:0},{100 * p.Y:0},{100 * p.Z:0},12.30,H,Alive{mark?.Invoke(i)};:\n")));

    /// <summary>The sets of players 1 to 9 and of the ball B, in this order.</summary>
    private static string Dfl(OwnTrack track, string sets, bool heights = false, string team = "BALL")
    {
        var text = new StringBuilder("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<PutDataRequest>\n<Positions>\n");
        foreach (char set in sets)
        {
            text.Append(set == 'B' ? $"<FrameSet GameSection=\"firstHalf\" TeamId=\"{team}\" PersonId=\"DFL-OBJ-0000XT\">\n" : $"<FrameSet GameSection=\"firstHalf\" TeamId=\"DFL-CLU-00000{set}\" PersonId=\"DFL-OBJ-002G0{set}\">\n");
            foreach ((double T, double X, double Y, double Z) p in track.Points)
            {
                string z = set == 'B' ? N(p.Z) : "1.2";
                text.Append(CultureInfo.InvariantCulture, $"<Frame N=\"{10000 + Frame(p, track)}\" T=\"{Date(p.T)}+02:00\" X=\"{(set == 'B' ? N(p.X) : "3")}\" Y=\"{(set == 'B' ? N(p.Y) : "4")}\"{(set == 'B' || heights ? $" Z=\"{z}\"" : "")} M=\"1\"/>\n");
            }

            text.Append("</FrameSet>\n");
        }

        return text.Append("</Positions>\n</PutDataRequest>\n").ToString();
    }

    private static string JsonLines(OwnTrack track, Func<(double T, double X, double Y, double Z), int, string> line) => string.Join('\n', track.Points.Select(line)) + "\n";

    private static string People(int frame, int count, Func<int, double, double, string> person, string between) =>
        string.Join(between, Enumerable.Range(1, count).Select(k => person(k, (10 * Math.Sin((3 * k) + (0.02 * frame))) + (2 * k) - 30, 9 * Math.Cos((2 * k) + (0.03 * frame)))));

    private static long Frame((double T, double X, double Y, double Z) point, OwnTrack track) => (long)Math.Round(point.T * track.Rate);

    private static string Date(double t) => new DateTime(2022, 10, 15, 15, 30, 0, DateTimeKind.Utc).AddSeconds(t).ToString("yyyy-MM-ddTHH:mm:ss.ffffff", CultureInfo.InvariantCulture);

    private static string N(double value) => value.ToString("0.######", CultureInfo.InvariantCulture);
}
