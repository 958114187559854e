using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Replay;

/// <summary>The path of a ball in as few keys as possible: cubics between the keys stay within a millimetre of every step.</summary>
/// <param name="scenario">The shot.</param>
/// <param name="outcome">Its result, with samples.</param>
internal sealed class Track(Scenario scenario, Outcome outcome)
{
    /// <summary>The maximum distance of a cubic from the path, in m.</summary>
    private const double Tolerance = 1e-3;

    /// <summary>The maximum time between keys, in s, because other numbers are interpolated linearly between keys.</summary>
    private const double Longest = 0.2;

    /// <summary>The maximum rotation between keys, in rad. Beyond half a turn, the direction of the rotation is ambiguous.</summary>
    private const double MostTurn = 2.4;

    /// <summary>The maximum number of keys between two steps. A faster spin is shown too slow.</summary>
    private const int MostBetween = 32;

    public double Radius { get; } = scenario.Scene.Ball.Radius;

    public IReadOnlyList<TrackKey> Keys { get; } = Thinned(Dense(outcome));

    public IReadOnlyList<BallEvent> Events { get; } = outcome.Events;

    /// <summary>Returns the name of the object that the ball hits in an event; null if there is none.</summary>
    public string? SurfaceOf(BallEvent item) => outcome.SurfaceOf(in item);

    /// <summary>Returns the position at a time between two keys, in m.</summary>
    public static Vector3d Between(in TrackKey from, in TrackKey to, double time)
    {
        double h = to.Time - from.Time;
        double s = h > 0 ? (time - from.Time) / h : 0;
        double r = 1 - s;
        return (r * r * (1 + (2 * s)) * from.Position) + (s * s * (1 + (2 * r)) * to.Position)
            + (h * s * r * ((r * from.Velocity) - (s * to.VelocityBefore)));
    }

    /// <summary>Returns a key for every step and event, and additional keys for a fast spin.</summary>
    private static List<TrackKey> Dense(Outcome outcome)
    {
        IReadOnlyList<Moment> samples = outcome.Samples!;
        List<TrackKey> keys = [Key(samples[0])];
        int next = 0;
        foreach (Moment sample in samples.Skip(1))
        {
            for (; next < outcome.Events.Count && outcome.Events[next].Time <= sample.Time; next++)
            {
                BallEvent item = outcome.Events[next];
                TrackKey last = keys[^1];
                Quaterniond turned = Turned(last, item.Time);
                var key = new TrackKey(item.Time, item.Position, item.VelocityBefore, item.Velocity, item.Spin, turned, MotionAfter.Of(item.Kind, last.Motion));
                if (item.Time > last.Time)
                {
                    AddTurning(keys, key);
                }
                else
                {
                    keys[^1] = key with { VelocityBefore = last.VelocityBefore };
                }
            }

            if (sample.Time > keys[^1].Time)
            {
                AddTurning(keys, Key(sample));
            }
        }

        return keys;
    }

    private static TrackKey Key(in Moment at) => new(at.Time, at.Position, at.Velocity, at.Velocity, at.Spin, at.Orientation, at.State);

    /// <summary>Returns the orientation of a ball at a time after a key, from the spin at the key.</summary>
    public static Quaterniond Turned(in TrackKey from, double time) =>
        (Quaterniond.FromRotationVector((time - from.Time) * from.Spin) * from.Orientation).Normalized();

    /// <summary>Adds a key. If the ball turns too far for one key, it adds others before it.</summary>
    private static void AddTurning(List<TrackKey> keys, in TrackKey key)
    {
        TrackKey from = keys[^1];
        double h = key.Time - from.Time;
        int parts = (int)Math.Clamp(Math.Ceiling(from.Spin.Length * h / MostTurn), 1, MostBetween);
        for (int i = 1; i < parts; i++)
        {
            double time = from.Time + (h * i / parts);
            double s = (double)i / parts;
            Vector3d velocity = Vector3d.Lerp(from.Velocity, key.VelocityBefore, s);
            keys.Add(new TrackKey(
                time, Between(in from, in key, time), velocity, velocity, Vector3d.Lerp(from.Spin, key.Spin, s), Turned(in from, time), from.Motion));
        }

        keys.Add(key);
    }

    private static List<TrackKey> Thinned(List<TrackKey> all)
    {
        List<TrackKey> kept = [all[0]];
        int last = 0;
        for (int i = 1; i < all.Count; i++)
        {
            bool ends = i == all.Count - 1 || all[i].VelocityBefore != all[i].Velocity || all[i].Motion != all[last].Motion;
            if (ends || !Stands(all, last, i + 1))
            {
                kept.Add(all[i]);
                last = i;
            }
        }

        return kept;
    }

    /// <summary>True if the keys between two keys can be removed.</summary>
    private static bool Stands(List<TrackKey> all, int from, int to)
    {
        TrackKey a = all[from];
        TrackKey b = all[to];
        if (b.Time - a.Time > Longest || a.Spin.Length * (b.Time - a.Time) > MostTurn || (b.Spin - a.Spin).Length * (b.Time - a.Time) > 0.05)
        {
            return false;
        }

        for (int i = from + 1; i < to; i++)
        {
            if ((Between(in a, in b, all[i].Time) - all[i].Position).Length > Tolerance)
            {
                return false;
            }
        }

        return true;
    }
}
