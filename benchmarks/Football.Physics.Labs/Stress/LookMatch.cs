using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Stress;

/// <summary>Simulates one match twice: alone, and with paths, aims, interceptions and a kept prediction between its ticks.</summary>
internal sealed class LookMatch(long seed, long index)
{
    private const double Tick = 1 / 60.0;

    /// <summary>The number of ticks between two aims, and between two interceptions.</summary>
    private const int PerAim = 24;
    private const int PerInterception = 6;

    private readonly SeededRandom _looks = new(SeededRandom.Mix(seed, index + 1_000_003));
    private readonly Interception _interception = new();

    public long Ticks { get; private set; }

    public long Paths { get; private set; }

    public long Aims { get; private set; }

    public long Hits { get; private set; }

    public long Interceptions { get; private set; }

    public long Saves { get; private set; }

    public long Updates { get; private set; }

    public long Recomputed { get; private set; }

    /// <summary>The number of ticks with different hashes or events.</summary>
    public long Differ { get; private set; }

    /// <summary>The first of these ticks.</summary>
    public string FirstAt { get; private set; } = "";

    /// <summary>True if a step or a query threw.</summary>
    public bool Throws { get; private set; }

    /// <summary>Simulates both matches.</summary>
    public void Play(double seconds)
    {
        try
        {
            Compare(seconds);
        }
        catch (Exception e) when (e is not OutOfMemoryException)
        {
            Throws = true;
            FirstAt = FormattableString.Invariant($"match {index}, tick {Ticks}: {e.GetType().Name}: {e.Message} {e.StackTrace?.Split('\n')[0].Trim()}");
        }
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
            Ticks++;
            bool same = Snapshot.Hash(plain.Balls) == Snapshot.Hash(looked.Balls) && log.Events.Count == lookedLog.Events.Count;
            Differ += same ? 0 : 1;
            if (!same && FirstAt.Length == 0)
            {
                int ball = Enumerable.Range(0, plain.Balls.Length).FirstOrDefault(k => !Snapshot.Same(in plain.Balls[k], in looked.Balls[k]), 0);
                StateDifference? field = Snapshot.Difference(in plain.Balls[ball], in looked.Balls[ball]);
                FirstAt = FormattableString.Invariant($"match {index}, {plain.Time} s, ball {ball} of {plain.Balls.Length}, {(plain.IsGroup ? "group" : "alone")}: {field}");
            }
        }

        Recomputed = cache.Recomputations;
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
        Paths += paths.Length;
        int ball = _looks.Below(arena.Balls.Length);
        if (arena.Balls.Length == 1)
        {
            Updates++;
            cache.Update(in arena.Balls[0]);
        }

        if (Ticks % PerInterception == 0)
        {
            Vector3d at = arena.Balls[ball].Position.Horizontal;
            Player[] runners = [.. Enumerable.Range(0, 3).Select(_ => new Player { Position = at + (_looks.Uniform(0.5, 8) * _looks.Heading()), Velocity = _looks.Uniform(0, 6) * _looks.Heading() })];
            _interception.Find(paths[ball], runners);
            _interception.FindFirst(paths[ball], runners, out _);
            Interceptions++;
            Goal goal = arena.Scene.Goals[_looks.Below(arena.Scene.Goals.Count)];
            var keeper = new Player { Position = goal.Center, Reach = 1, MaximumHeight = 2.7 };
            _interception.FindSave(paths[ball], in keeper, goal);
            Saves++;
        }

        if (Ticks % PerAim == 0)
        {
            Goal goal = arena.Scene.Goals[_looks.Below(arena.Scene.Goals.Count)];
            var request = new AimRequest
            {
                From = arena.Balls[ball].Position,
                Target = goal.Center + new Vector3d(_looks.Uniform(-0.4, 0.4) * goal.Width, _looks.Uniform(0.2, 0.9) * goal.Height, 0),
                Speed = _looks.Uniform(8, 32),
            };
            Hits += aimer.Find(request).HitsTarget ? 1 : 0;
            Aims++;
        }
    }
}
