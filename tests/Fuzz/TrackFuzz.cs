using System.Globalization;
using System.Text;
using FootballPhysics.Labs.Fuzz;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Fit;
using FootballPhysics.Tool.Fit.Reading;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Fuzz;

/// <summary>Tracks as text: rejected with a sentence, or finite points in order of time.</summary>
internal sealed class TrackFuzz : FuzzTarget
{
    private const double Farthest = 1e5;
    private const int Points = 12;

    public override string Name => "tracks";

    public override string Text(byte[] input) => Encoding.UTF8.GetString(input);

    /// <summary>A throw in one of the layouts; a mutation changes a few characters.</summary>
    public override byte[] Make(SeededRandom random, int mutations)
    {
        double rate = random.Any(25.0, 50, 100);
        int layout = random.Below(8);
        double metre = layout is 2 or 7 ? 100 : 1;
        List<double[]> rows = [.. Enumerable.Range(0, Points).Select(i => i / rate).Select(t => (double[])[t, metre * 12 * t, metre * 3 * t, metre * (1 + (6 * t) - (4.905 * t * t))])];
        string Line(string separator, IEnumerable<string> cells) => string.Join(separator, cells);
        string Number(double number) => Math.Round(number, 4).ToString(CultureInfo.InvariantCulture);
        string text = layout switch
        {
            0 => "t,x,y,z\n" + Line("\n", rows.Select(row => Line(",", row.Select(Number)))),
            1 => Line("\n", rows.Select(row => Line(";", row.Select(number => Number(number).Replace('.', ','))))),
            2 => "time\tteam\tobject\tx [cm]\ty [cm]\tz [cm]\r\n" + Line("\r\n", rows.Select(row => Line("\t", [Number(row[0]), "home", "ball", Number(row[1]), Number(row[2]), Number(row[3])]))),
            3 => "period,timestamp,ball_x,ball_y,ball_z\n" + Line("\n", rows.Select(row => Line(",", ["1", $"00:00:{row[0]:00.00}", Number(row[1]), Number(row[2]), Number(row[3])]))),
            4 => "{\"data\": [" + Line(",", rows.Select(row => $"{{\"t\": {Number(row[0])}, \"x\": {Number(row[1])}, \"y\": {Number(row[2])}, \"z\": {Number(row[3])}}}")) + "]}",
            5 => Line("\n", rows.Select((row, i) => $"{{\"frameIdx\": {i}, \"gameClock\": {Number(row[0])}, \"period\": 1, \"ball\": {{\"xyz\": [{Number(row[1])}, {Number(row[2])}, {Number(row[3])}]}}}}")),
            7 => Line("\n", rows.Select((row, i) => FormattableString.Invariant($"{i}:4,1,1,0,0,1.5;:{row[1]:0},{row[2]:0},{row[3]:0},12,H,Alive;:"))),
            _ => "<PutDataRequest><Positions><FrameSet TeamId=\"BALL\" PersonId=\"DFL-OBJ-0000XT\">"
                + string.Concat(rows.Select((row, i) => $"<Frame N=\"{i}\" T=\"2021-05-09T15:30:{row[0]:00.000}+02:00\" X=\"{Number(row[1])}\" Y=\"{Number(row[2])}\" Z=\"{Number(row[3])}\" />"))
                + "</FrameSet></Positions></PutDataRequest>",
        };
        return FuzzBytes.Changed(random, Encoding.UTF8.GetBytes(text), mutations / 2);
    }

    /// <summary>Reads a track without options, then with those that a file of frame numbers needs.</summary>
    public override bool Try(byte[] input) => Try(input, new TrackFormat()) & Try(input, new TrackFormat { Rate = 25, Unit = "cm", IsYDown = true, Pitch = (105, 68) });

    private static bool Try(byte[] input, TrackFormat format)
    {
        TrackPoint[] points;
        try
        {
            points = TrackReader.Read(new MemoryStream(input), remark => Must(Sentences.Is(remark), $"a remark is not one line: {remark}"), format);
        }
        catch (RefusedException refusal)
        {
            Must(Sentences.Is(refusal.Message), $"a refusal is not one sentence: {refusal.Message}");
            return true;
        }

        Must(points.Length >= 8, "a track has too few points");
        for (int i = 0; i < points.Length; i++)
        {
            Vector3d place = points[i].Position;
            Must(double.IsFinite(points[i].Time) && Math.Abs(place.X) <= Farthest && Math.Abs(place.Y) <= Farthest && Math.Abs(place.Z) <= Farthest, "a point is nowhere");
            Must(i == 0 || points[i].Time >= points[i - 1].Time, "points are out of order");
        }

        return false;
    }
}
