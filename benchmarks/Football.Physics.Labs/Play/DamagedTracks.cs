using System.Text;
using FootballPhysics.Yardsticks;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Fit;

namespace FootballPhysics.Labs.Play;

/// <summary>Files of tracks that were damaged: what is read is fitted, what is not is refused with a reason; nothing else.</summary>
internal sealed class DamagedTracks
{
    public int Fitted { get; private set; }

    public int Refused { get; private set; }

    public List<string> Faults { get; } = [];

    /// <summary>Damages a track, reads it and fits it.</summary>
    public void Run(SeededRandom random, SyntheticMatch match)
    {
        byte[] file = Damage(random, match);
        try
        {
            TrackPoint[] track = TrackReader.Read(new MemoryStream(file), _ => { });
            MatchFitResult fit = new MatchFit().Find(track);
            bool isFinite = double.IsFinite(fit.Rms) && fit.Pieces.All(piece => double.IsFinite(piece.Velocity.Length + piece.Spin.Length + piece.Position.Length + piece.Rms))
                && Enumerable.Range(0, fit.Names.Count).All(i => double.IsFinite(fit.Value(i)));
            Fitted++;
            if (!isFinite)
            {
                Faults.Add("a number that is not finite");
            }
        }
        catch (Exception refusal) when (refusal is RefusedException or ArgumentException)
        {
            Refused++;
        }
        catch (Exception fault)
        {
            Faults.Add($"{fault.GetType().Name}: {fault.Message} {fault.StackTrace?.Split('\n')[0].Trim()}");
        }
    }

    private static byte[] Damage(SeededRandom random, SyntheticMatch match)
    {
        // A few seconds of a match, as text; then up to six damages.
        int count = random.Below(250) + 1;
        int from = random.Below(Math.Max(1, match.Seen.Count - count));
        List<string> lines = ["t,x,y,z"];
        lines.AddRange(match.Seen.Skip(from).Take(count).Select(point => FormattableString.Invariant($"{point.Time:0.####},{point.Position.X:0.####},{-point.Position.Z:0.####},{point.Position.Y:0.####}")));
        for (int damages = random.Below(6) + 1; damages > 0; damages--)
        {
            int at = random.Below(lines.Count);
            switch (random.Below(14))
            {
                case 0:
                    lines[at] = "";
                    break;
                case 1:
                    lines[at] = lines[at].Replace('.', random.Any('x', ',', ';', '-'));
                    break;
                case 2:
                    lines[at] += random.Any(",", ",1,2", ",\"", "\0");
                    break;
                case 3:
                    lines.RemoveRange(at, Math.Min(lines.Count - at, random.Below(40) + 1));
                    lines.Add("9999,1,1,1");
                    break;
                case 4:
                    lines.Insert(at, lines[random.Below(lines.Count)]);
                    break;
                case 5:
                    (lines[at], lines[^1]) = (lines[^1], lines[at]);
                    break;
                case 6:
                    lines[at] = random.Any("nan,nan,nan,nan", "1e308,1e308,1e308,1e308", "0,0,0,0", "-1,-1,-1", "inf,1,2,3", ",,,");
                    break;
                case 7:
                    Columns(lines, line => string.Join(',', line.Split(',').Reverse()));
                    break;
                case 8:
                    Columns(lines, line => line.Contains('t', StringComparison.Ordinal) ? line : Scaled(line, random.Any(0.0, 1e-9, 100.0, 1e4, -1.0)));
                    break;
                case 9:
                    lines[0] = random.Any("", "t,x,y", "T;X;Y;Z", "timestamp,ball_x,ball_y,ball_z_cm", "a,b,c,d");
                    break;
                case 10:
                    Columns(lines, line => random.Chance(0.3) ? line[..random.Below(line.Length + 1)] : line);
                    break;
                case 11:
                    Columns(lines, line => line.Contains('t', StringComparison.Ordinal) || random.Chance(0.8) ? line : Jump(line, random));
                    break;
                case 12:
                    lines.RemoveAll(_ => random.Chance(0.5));
                    lines.Add("t,x,y,z");
                    break;
                default:
                    lines[at] = Encoding.Latin1.GetString([.. Encoding.Latin1.GetBytes(lines[at]).Select(b => random.Chance(0.2) ? (byte)random.Below(256) : b)]);
                    break;
            }
        }

        return Encoding.UTF8.GetBytes(string.Join(random.Any("\n", "\r\n", "\r"), lines));
    }

    private static void Columns(List<string> lines, Func<string, string> change)
    {
        for (int i = 0; i < lines.Count; i++)
        {
            lines[i] = change(lines[i]);
        }
    }

    private static string Scaled(string line, double factor)
    {
        string[] cells = line.Split(',');
        return cells.Length == 4 && double.TryParse(cells[0], out _) ? $"{cells[0]},{Times(cells[1], factor)},{Times(cells[2], factor)},{Times(cells[3], factor)}" : line;
    }

    private static string Jump(string line, SeededRandom random)
    {
        string[] cells = line.Split(',');
        return cells.Length == 4 ? FormattableString.Invariant($"{cells[0]},{random.Uniform(-200, 200)},{cells[2]},{random.Uniform(-5, 50)}") : line;
    }

    private static string Times(string cell, double factor) =>
        double.TryParse(cell, System.Globalization.CultureInfo.InvariantCulture, out double number) ? FormattableString.Invariant($"{number * factor}") : cell;
}
