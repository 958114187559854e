namespace FootballPhysics.Labs.Stress;

/// <summary>Simulates one match twice: alone, and with paths, aims, interceptions and a kept prediction between its ticks.</summary>
/// <param name="seed">The seed of all matches.</param>
/// <param name="index">The number of the match.</param>
/// <param name="counts">The counts of all matches.</param>
internal sealed class LookMatch(long seed, long index, LabCounts counts)
{
    public static readonly string[] Columns =
        ["ticks", "paths", "aims", "hits", "interceptions", "saves", "cache updates", "recomputed", "ticks that differ", "exceptions"];

    private const double Tick = 1 / 60.0;

    /// <summary>The number of ticks between two aims, and between two interceptions.</summary>
    private const int PerAim = 24;
    private const int PerInterception = 6;

    private readonly SeededRandom _looks = new(SeededRandom.Mix(seed, index + 1_000_003));
    private readonly Interception _interception = new();

    private long _ticks;
    private string _firstAt = "";

    /// <summary>Simulates both matches.</summary>
    /// <returns>The first tick with other hashes or events, or the exception that a step or a query threw; empty if there is neither.</returns>
    public string Play(double seconds)
    {
        try
        {
            Compare(seconds);
        }
        catch (Exception e) when (e is not OutOfMemoryException)
        {
            counts.Add("exceptions");
            _firstAt = FormattableString.Invariant($"match {index}, tick {_ticks}: {e.GetType().Name}: {e.Message} {e.StackTrace?.Split('\n')[0].Trim()}");
        }

        counts.Add("ticks", _ticks);
        return _firstAt;
    }

    private void Compare(double seconds)
    {
        var plain = new Arena(SeededRandom.Mix(seed, index));
        var looked = new Arena(SeededRandom.Mix(seed, index));
        Trajectory[] paths = [.. looked.Balls.Select(_ => new Trajectory(512))];
        var aimer = new Aimer(looked.Simulator);
        var cache = new TrajectoryCache(looked.Simulator, new LookAheadRequest { Duration = 1, TimeStep = Tick });
        var log = new StepLog();
        var lookedLog = new StepLog();
        while (plain.Time < seconds)
        {
            Look(looked, paths, aimer, cache);
            Step(plain, log);
            Step(looked, lookedLog);
            _ticks++;
            bool same = Snapshot.Hash(plain.Balls) == Snapshot.Hash(looked.Balls) && log.Events.Count == lookedLog.Events.Count;
            counts.AddIf(!same, "ticks that differ");
            if (!same && _firstAt.Length == 0)
            {
                int ball = Enumerable.Range(0, plain.Balls.Length).FirstOrDefault(k => !Snapshot.Same(in plain.Balls[k], in looked.Balls[k]), 0);
                StateDifference? field = Snapshot.Difference(in plain.Balls[ball], in looked.Balls[ball]);
                _firstAt = FormattableString.Invariant($"match {index}, {plain.Time} s, ball {ball} of {plain.Balls.Length}, {(plain.IsGroup ? "group" : "alone")}: {field}");
            }
        }

        counts.Add("recomputed", cache.Recomputations);
    }

    private static void Step(Arena arena, StepLog log)
    {
        arena.Put();
        for (int ball = 0; ball < arena.Balls.Length; ball++)
        {
            if (arena.Decide(ball, Tick) is { } kick)
            {
                arena.Kick(ball, kick.Velocity, kick.Spin);
            }
        }

        // Clear the log, because the look-aheads may have run on the kicked balls.
        log.Clear();
        arena.Step(Tick, log);
        arena.Walk(Tick);
    }

    private void Look(Arena arena, Trajectory[] paths, Aimer aimer, TrajectoryCache cache)
    {
        arena.Put();
        arena.LookAhead(_looks.Any(Tick, 0.04, 0.08), paths, _looks.Uniform(0.1, 2));
        counts.Add("paths", paths.Length);
        int ball = _looks.Below(arena.Balls.Length);
        if (arena.Balls.Length == 1)
        {
            counts.Add("cache updates");
            cache.Update(in arena.Balls[0]);
        }

        if (_ticks % PerInterception == 0)
        {
            Vector3d at = arena.Balls[ball].Position.Horizontal;
            Player[] runners = [.. Enumerable.Range(0, 3).Select(_ => new Player { Position = at + (_looks.Uniform(0.5, 8) * _looks.Heading()), Velocity = _looks.Uniform(0, 6) * _looks.Heading() })];
            _interception.Find(paths[ball], runners);
            _interception.FindFirst(paths[ball], runners, out _);
            counts.Add("interceptions");
            Goal goal = arena.Scene.Goals[_looks.Below(arena.Scene.Goals.Count)];
            var keeper = new Player { Position = goal.Center, Reach = 1, MaximumHeight = 2.7 };
            _interception.FindSave(paths[ball], in keeper, goal);
            counts.Add("saves");
        }

        if (_ticks % PerAim == 0)
        {
            Goal goal = arena.Scene.Goals[_looks.Below(arena.Scene.Goals.Count)];
            var request = new AimRequest
            {
                From = arena.Balls[ball].Position,
                Target = goal.Center + new Vector3d(_looks.Uniform(-0.4, 0.4) * goal.Width, _looks.Uniform(0.2, 0.9) * goal.Height, 0),
                Speed = _looks.Uniform(8, 32),
            };
            counts.AddIf(aimer.Find(request).HitsTarget, "hits");
            counts.Add("aims");
        }
    }
}
