using System.Globalization;
using FootballPhysics.Prediction;
using FootballPhysics.Tracks;

namespace FootballPhysics.Golden;

/// <summary>The bits of a filter that every machine and every language must reproduce: positions, positions without height, and pixels of two cameras.</summary>
/// <remarks>tests/Native/follow.c and tests/Python/test_filter.py make the same streams by the same arithmetic; tests/Native/follow.txt contains the lines.</remarks>
public static class GoldenFollow
{
    private const int Points = 400;
    private const int Block = 100;
    private const double Interval = 0.02;
    private const double Noise = 0.02;
    private const int Rows = 11;
    private const double Every = 0.1;

    private static readonly int[] s_kicks = [40, 170, 300];
    private static readonly Vector3d[] s_velocities = [new(18, 9, 3), new(-12, 5, 4), new(6, 0.5, -14)];
    private static readonly Vector3d[] s_spins = [new(10, 20, -15), new(0, 30, 0), new(-20, 0, 10)];

    /// <summary>Two cameras, along −z and along −x: 3 × 4 matrices, row by row.</summary>
    private static readonly double[][] s_cameras =
    [
        [1500, 0, -960, 38400, 0, -1500, -540, 36600, 0, 0, -1, 40],
        [-960, 0, -1500, 38400, -540, -1500, 0, 36600, -1, 0, 0, 40],
    ];

    /// <summary>A line for each hundred points of each stream, and one for its path ahead and its saved bytes.</summary>
    public static IEnumerable<string> Lines()
    {
        foreach (string kind in (string[])["position", "plan", "pixel"])
        {
            var filter = new BallFilter(Scene.Default);
            TrackCamera[] cameras = [.. s_cameras.Select(matrix => new TrackCamera(matrix))];
            Vector3d[] points = Stream();
            ulong hash = 0;
            int held = -1;
            for (int i = 0; i < Points; i++)
            {
                if (i is >= 220 and < 235)
                {
                    // Hidden.
                }
                else if (i % 29 == 28)
                {
                    held = i;
                }
                else
                {
                    hash = Deliver(filter, cameras, kind, points, i, hash);
                    hash = held >= 0 ? Deliver(filter, cameras, kind, points, held, hash) : hash;
                    held = -1;
                }

                if (i % Block == Block - 1)
                {
                    yield return Line(kind, (i + 1).ToString(CultureInfo.InvariantCulture), hash);
                }
            }

            yield return Line(kind, "ahead", Ahead(filter));
            yield return Line(kind, "saved", Saved(filter.Save()));
        }
    }

    /// <summary>The noisy positions of a ball that rests, and is kicked three times.</summary>
    private static Vector3d[] Stream()
    {
        var simulator = new Simulator(Scene.Default);
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(1, 0, 2), Vector3d.Zero, Vector3d.Zero);
        ulong seed = 7;
        var points = new Vector3d[Points];
        for (int i = 0; i < Points; i++)
        {
            int kick = Array.IndexOf(s_kicks, i);
            if (kick >= 0)
            {
                simulator.Kick(ref ball, s_velocities[kick], s_spins[kick]);
            }

            double x = Normal(ref seed);
            double y = Normal(ref seed);
            double z = Normal(ref seed);
            points[i] = new Vector3d(ball.Position.X + (Noise * x), ball.Position.Y + (Noise * y), ball.Position.Z + (Noise * z));
            if (i % 37 == 36)
            {
                points[i] = new Vector3d(points[i].X + 3, points[i].Y, points[i].Z);
            }

            log.Clear();
            simulator.Step(ref ball, Interval, log);
        }

        return points;
    }

    private static ulong Deliver(BallFilter filter, TrackCamera[] cameras, string kind, Vector3d[] points, int at, ulong hash)
    {
        double time = at * Interval;
        Vector3d p = points[at];
        switch (kind)
        {
            case "position":
                filter.Update(time, p);
                return Mix(hash, filter.Estimate);
            case "plan":
                filter.Update(time, p.X, p.Z);
                return Mix(hash, filter.Estimate);
            default:
                for (int i = 0; i < cameras.Length; i++)
                {
                    double[] m = s_cameras[i];
                    double a = (m[0] * p.X) + (m[1] * p.Y) + (m[2] * p.Z) + m[3];
                    double b = (m[4] * p.X) + (m[5] * p.Y) + (m[6] * p.Z) + m[7];
                    double w = (m[8] * p.X) + (m[9] * p.Y) + (m[10] * p.Z) + m[11];
                    filter.Update(time, cameras[i], a / w, b / w);
                    hash = Mix(hash, filter.Estimate);
                }

                return hash;
        }
    }

    /// <summary>The words of an fp_estimate.</summary>
    private static ulong Mix(ulong hash, BallEstimate estimate)
    {
        BallState state = estimate.State;
        hash = Mix(hash, state.Time);
        foreach (Vector3d vector in (Vector3d[])[state.Position, state.Velocity, state.Spin, new Vector3d(estimate.PositionDeviation, estimate.VelocityDeviation, estimate.SpinDeviation)])
        {
            hash = Mix(Mix(Mix(hash, vector.X), vector.Y), vector.Z);
        }

        for (int i = 0; i < BallEstimate.Components * BallEstimate.Components; i++)
        {
            hash = Mix(hash, estimate.Covariance(i / BallEstimate.Components, i % BallEstimate.Components));
        }

        hash = Mix(Mix(Mix(hash, estimate.KickTime), estimate.KickDeviation), estimate.KickProbability);
        hash = Mix(hash, (uint)state.Motion | (estimate.HasKick ? 1UL << 32 : 0));
        return Mix(hash, (estimate.IsOutlier ? 1UL : 0) | (estimate.IsHeld ? 1UL << 32 : 0));
    }

    private static ulong Ahead(BallFilter filter)
    {
        var path = new Trajectory();
        filter.LookAhead((Rows - 1) * Every, path);
        ulong hash = 0;
        for (int i = 0; i < Rows; i++)
        {
            double time = Math.Min(path.EndTime, path.StartTime + (i * Every));
            Vector3d position = path.PositionAt(time);
            hash = Mix(Mix(Mix(Mix(Mix(hash, time), position.X), position.Y), position.Z), filter.DeviationAt(time));
        }

        return hash;
    }

    private static ulong Saved(byte[] bytes)
    {
        ulong hash = (ulong)bytes.Length;
        foreach (byte one in bytes)
        {
            hash = Mix(hash, (ulong)one);
        }

        return hash;
    }

    private static string Line(string kind, string part, ulong hash) => string.Create(CultureInfo.InvariantCulture, $"{kind} {part} {hash:x16}");

    /// <summary>Nearly a normal distribution, by additions only, which have the same bits in every language.</summary>
    private static double Normal(ref ulong seed)
    {
        double sum = -6;
        for (int i = 0; i < 12; i++)
        {
            sum += Draw(ref seed);
        }

        return sum;
    }

    private static double Draw(ref ulong seed)
    {
        unchecked
        {
            seed += 0x9E3779B97F4A7C15;
            ulong z = (seed ^ (seed >> 30)) * 0xBF58476D1CE4E5B9;
            z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
            return ((z ^ (z >> 31)) >> 11) * (1.0 / 9007199254740992.0);
        }
    }

    private static ulong Mix(ulong hash, double number) => Mix(hash, BitConverter.DoubleToUInt64Bits(number));

    private static ulong Mix(ulong hash, ulong word)
    {
        unchecked
        {
            hash = (hash ^ word) * 0x9E3779B97F4A7C15;
            return hash ^ (hash >> 29);
        }
    }
}
