using System.Globalization;
using System.Text;

// The path behind each golden hash, so that the effect of a change can be stated in metres.

namespace FootballPhysics.Golden;

public static class GoldenTrace
{
    private const double Interval = 0.1;

    // Null while no program writes the paths: the hashes alone need no memory.
    private static List<Vector3d>? s_points;

    /// <summary>The golden lines, each followed by the positions of its balls every 0.1 s, in m. Other lines give results instead: the ends of a batch, or the velocities of aims.</summary>
    public static IEnumerable<string> Lines()
    {
        s_points = new List<Vector3d>();
        foreach (string line in GoldenShots.Lines())
        {
            var text = new StringBuilder(line);
            foreach (Vector3d point in s_points)
            {
                text.Append(' ').Append(Exact(point.X)).Append(' ').Append(Exact(point.Y)).Append(' ').Append(Exact(point.Z));
            }

            s_points.Clear();
            yield return text.ToString();
        }

        s_points = null;
    }

    /// <summary>Adds a point to the path of the current line.</summary>
    internal static void Add(Vector3d point)
    {
        s_points?.Add(point);
    }

    /// <summary>Adds the positions of all balls of a runner after every 0.1 s.</summary>
    internal static void Add(FixedStepRunner runner)
    {
        int ticks = Math.Max(1, (int)((Interval / runner.TimeStep) + 0.5));
        if (s_points is not null && runner.Tick % ticks == 0)
        {
            int balls = runner.Group?.Count ?? 1;
            for (int i = 0; i < balls; i++)
            {
                Add(runner.StateOf(i).Position);
            }
        }
    }

    private static string Exact(double number)
    {
        return number.ToString("R", CultureInfo.InvariantCulture);
    }
}
