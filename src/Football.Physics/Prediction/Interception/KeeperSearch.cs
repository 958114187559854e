namespace FootballPhysics.Prediction;

/// <summary>Finds what a goalkeeper can do about a shot.</summary>
internal readonly struct KeeperSearch
{
    /// <summary>Reactions that would do for less than this, s, may be missed.</summary>
    private const double Shortest = 1e-6;

    /// <summary>Halvings of that: it becomes a nanosecond.</summary>
    private const int Halvings = 10;

    /// <summary>So many reactions are asked for at most: a way that stays within nanometres of his reach asks for no end of them.</summary>
    private const int MostTries = 4096;

    private readonly PathSpans _spans;
    private readonly WindowList _found;

    public KeeperSearch(PathSpans spans, WindowList found)
    {
        _spans = spans;
        _found = found;
    }

    /// <summary>Finds it.</summary>
    public KeeperResult Run(Trajectory path, in Player keeper, Goal goal, double now)
    {
        var mouth = new GoalMouth(goal);

        // The shot: where the path comes through the goal's plane from the pitch, and up to when he may meet it.
        bool crosses = path.TryGetCrossing(new Plane3d(mouth.Center, mouth.Out), out PathPoint crossing) && Vector3d.Dot(crossing.Velocity, mouth.Out) < 0;
        _spans.Take(path, path.EndTime);
        double end = crosses ? crossing.Time : _spans.End;
        double begin = Math.Max(now, _spans.Start);
        bool saves = Meets(in keeper, now, begin, end);
        InterceptWindow first = saves ? _found.Items[0] : default;

        // What he covers: the part of the line within his circle when the ball gets there
        var motion = new RunnerMotion(in keeper, now);
        motion.MiddleAt(end, out double x, out double z);
        var middle = new Vector3d(x, 0, z);
        double off = mouth.BeforeMouth(in middle);
        mouth.Place(in middle, out double aside, out _);
        double radius = motion.RadiusAt(end);
        double half = radius > Math.Abs(off) ? Math.Sqrt((radius * radius) - (off * off)) : double.NegativeInfinity;

        // And where the ball comes: aside and height, by which it is on target or not.
        mouth.Place(crossing.Position, out double ballAside, out double height);
        return new KeeperResult
        {
            Crosses = crosses,
            Crossing = crosses ? crossing : default,
            LateralOffset = crosses ? ballAside : 0,
            IsOnTarget = crosses && mouth.IsOpen(ballAside, height),
            ReachLeft = Math.Max(-0.5 * goal.Width, aside - half),
            ReachRight = Math.Min(0.5 * goal.Width, aside + half),
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

    /// <summary>
    /// The latest reaction with which he still meets the ball. Who runs on may come closer by it, so that a later one can do where an earlier one does not; but
    /// another reaction by Δ changes how far the ball is beyond him by no more than (v + |v₀|) Δ. So where he would not meet it with so much more reach either, a whole interval of reactions is
    /// out; else it is halved, the later half first.
    /// </summary>
    private double Latest(in Player keeper, double now, double begin, double end)
    {
        double low = keeper.Reaction;
        double high = Math.Max(low, end - now);

        // Even one who only goes on as he does until the ball is there meets it.
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

    /// <summary>The latest reaction of an interval with whose end he does not meet the ball; NaN where there is none.</summary>
    private double Latest(in Player keeper, double now, double begin, double end, double low, double high, double rate, double shortest, ref int tries)
    {
        // With the reaction in the middle and so much more reach as half the interval is worth he would meet the ball, if any in it does.
        double half = 0.5 * (high - low);
        if (++tries > MostTries || !Meets(keeper.Reacting(low + half, rate * half), now, begin, end))
        {
            return double.NaN;
        }

        // Short enough: by its earlier end, and where that does, to the nanosecond.
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

        // The later half first: the first that is found is the latest of all.
        double later = Latest(in keeper, now, begin, end, low + half, high, rate, shortest, ref tries);
        return later >= low ? later : Latest(in keeper, now, begin, end, low, low + half, rate, shortest, ref tries);
    }

    /// <summary>With this reaction he does not meet the ball any more.</summary>
    private readonly struct TooLate : ICondition
    {
        private readonly KeeperSearch _search;
        private readonly Player _keeper;
        private readonly double _now;
        private readonly double _begin;
        private readonly double _end;

        public TooLate(KeeperSearch search, Player keeper, double now, double begin, double end)
        {
            _search = search;
            _keeper = keeper;
            _now = now;
            _begin = begin;
            _end = end;
        }

        public bool Evaluate(double x, out bool holds)
        {
            holds = !_search.Meets(_keeper.Reacting(x), _now, _begin, _end);
            return false;
        }
    }
}
