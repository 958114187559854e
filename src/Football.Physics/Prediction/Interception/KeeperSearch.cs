using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Prediction;

/// <summary>Computes a goalkeeper's response to a shot.</summary>
internal readonly struct KeeperSearch(PathSpans spans, WindowList found)
{
    /// <summary>The shortest interval of successful reactions that is always found, in s.</summary>
    private const double Shortest = 1e-6;

    /// <summary>The number of bisections that shorten that interval to a nanosecond.</summary>
    private const int Halvings = 10;

    /// <summary>The maximum number of reactions tried; a path that stays within nanometres of his reach would need unlimited tries.</summary>
    private const int MostTries = 4096;

    /// <summary>The maximum number of intervals of all tries: on such a path, each try takes many.</summary>
    private const long MostIntervals = 1 << 22;

    private readonly PathSpans _spans = spans;
    private readonly WindowList _found = found;

    /// <summary>Runs the search.</summary>
    public KeeperResult Run(Trajectory path, in Player keeper, Goal goal, double now)
    {
        var mouth = new GoalMouth(goal);

        // The shot crosses the goal plane from the pitch; until then, the keeper can reach the ball.
        bool crosses = path.TryGetCrossing(new Plane3d(mouth.Center, mouth.Out), out PathPoint crossing) && Vector3d.Dot(crossing.Velocity, mouth.Out) < 0;
        _spans.Take(path, path.EndTime);
        double end = crosses ? crossing.Time : _spans.End;
        double begin = Math.Max(now, _spans.Start);
        bool saves = Meets(in keeper, now, begin, end);
        InterceptWindow first = saves ? _found.Items[0] : default;

        // The keeper covers the part of the goal line that is within his circle when the ball arrives.
        new RunnerMotion(in keeper, now).Covers(in mouth, end, out double left, out double right);

        // The lateral offset and height of the crossing decide whether the shot is on target.
        mouth.Place(crossing.Position, out double ballAside, out double height);
        return new KeeperResult
        {
            Crosses = crosses,
            Crossing = crosses ? crossing : default,
            LateralOffset = crosses ? ballAside : 0,
            IsOnTarget = crosses && mouth.IsOpen(ballAside, height),
            ReachLeft = Math.Max(-0.5 * goal.Width, left),
            ReachRight = Math.Min(0.5 * goal.Width, right),
            ReachHeight = Math.Min(goal.Height, keeper.MaximumHeight - goal.Center.Y),
            Saves = saves,
            Save = saves ? new PathPoint(first.From, first.Position, first.Velocity, 0) : default,
            LatestReaction = saves ? Latest(keeper, now, begin, end) : double.NaN,
        };
    }

    private bool Meets(in Player keeper, double now, double begin, double end)
    {
        var motion = new RunnerMotion(in keeper, now);
        _found.Count = 0;
        new WindowSearch(_spans, in motion, 0, firstOnly: true, _found).Run(begin, end);
        return _found.Count > 0;
    }

    /// <summary>Returns the latest reaction time with which he still reaches the ball.</summary>
    /// <remarks>
    /// A player who keeps running may come closer, so a later reaction may succeed where an earlier one fails. But a change of the reaction time by Δ
    /// changes the distance by at most (v + |v₀|) Δ. So if he fails even with that extra reach, the whole interval fails. Otherwise it is halved, and
    /// the later half is searched first.
    /// </remarks>
    private double Latest(in Player keeper, double now, double begin, double end)
    {
        double low = keeper.Reaction;
        double high = Math.Max(low, end - now);
        _found.Intervals = 0;

        // Even the latest possible reaction succeeds: he reaches the ball without reacting at all.
        if (Meets(keeper.Reacting(high), now, begin, end))
        {
            return now + high;
        }

        double rate = keeper.Speed + keeper.Velocity.Horizontal.Length;
        double shortest = Math.Max(Shortest, 1e-14 * high);
        int tries = 0;
        double latest = Latest(in keeper, now, begin, end, low, high, rate, shortest, ref tries);
        return now + (latest >= low ? latest : low);
    }

    /// <summary>Returns the latest successful reaction of an interval whose end fails; NaN if there is none.</summary>
    private double Latest(in Player keeper, double now, double begin, double end, double low, double high, double rate, double shortest, ref int tries)
    {
        // Test the middle with extra reach for half of the interval: if this test fails, every reaction in the interval fails.
        double half = 0.5 * (high - low);
        if (++tries > MostTries || _found.Intervals > MostIntervals || !Meets(keeper.Reacting(low + half, rate * half), now, begin, end))
        {
            return double.NaN;
        }

        // The interval is short enough: test its earlier end, then bisect to a nanosecond.
        if (2.0 * half <= shortest)
        {
            if (!Meets(keeper.Reacting(low), now, begin, end))
            {
                return double.NaN;
            }

            var tooLate = new TooLate(this, keeper, now, begin, end);
            Roots.Bisect(ref tooLate, ref low, ref high, Halvings);
            return low;
        }

        // Search the later half first, so that the first success is the latest.
        double later = Latest(in keeper, now, begin, end, low + half, high, rate, shortest, ref tries);
        return later >= low ? later : Latest(in keeper, now, begin, end, low, low + half, rate, shortest, ref tries);
    }

    /// <summary>True if he no longer reaches the ball with this reaction.</summary>
    private readonly struct TooLate(KeeperSearch search, Player keeper, double now, double begin, double end) : ICondition
    {
        public bool Evaluate(double x, out bool holds)
        {
            holds = !search.Meets(keeper.Reacting(x), now, begin, end);
            return false;
        }
    }
}
