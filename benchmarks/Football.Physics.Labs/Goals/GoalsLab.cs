namespace FootballPhysics.Labs.Goals;

/// <summary>football lab goals: checks that every goal is reported, and nothing else.</summary>
internal static class GoalsLab
{
    /// <summary>The rows of the table, and whether they must be 0.</summary>
    private static readonly (string Row, bool IsFault)[] s_rows =
    [
        (GoalCount.Shots, false), (GoalCount.Reported, false), (GoalCount.Rebounds, false), (GoalCount.Carried, false), (GoalCount.LieIn, false), (GoalCount.LieInUnreported, true),
        (GoalCount.Missed, true), (GoalCount.Wrong, true), (GoalCount.Undecided, false), (GoalCount.Cut, true),
    ];

    public static Lab Create() => new Lab(
        "goals",
        "Random shots within 25 m of a goal, with rebounds: the goal event, compared with an independent check of the path.",
        ["football lab goals", "football lab goals --shots 200 --seed 7"]).Plays(Lab.Number("--shots", "Number of shots.", 1, 100_000_000, 300), Run);

    private static void Run(LabRun run, int shots)
    {
        var goals = new GoalCount();
        int first = -1;
        run.Each(shots, "shot", (random, i) => first = !goals.Add(random) && first < 0 ? i : first);
        goals.Counts.AddTo(run.Table("Goals", "of the shots", "count", "verdict"), s_rows);
        run.Failed = first >= 0;
        if (first >= 0)
        {
            run.Notes.Add(FormattableString.Invariant($"First wrong result: shot {first}."));
        }
    }
}

/// <summary>Counts shots that come to rest in a goal, and reported goals.</summary>
internal sealed class GoalCount
{
    /// <summary>The largest allowed difference between the time of an event and the time found on the sampled path, s.</summary>
    private const double Closeness = 1e-6;

    /// <summary>The time for which a shot is followed, s.</summary>
    private const double Longest = 12;

    private readonly Trajectory _path = new(1 << 16);

    public const string Shots = "shots";
    public const string Reported = "reported goals";

    /// <summary>The goals after a hit of the frame or the keeper, and those of a ball that slid or rolled over the line.</summary>
    public const string Rebounds = "after a post, a bar or a keeper";
    public const string Carried = "along the ground over the line";

    public const string LieIn = "came to rest in a net";
    public const string LieInUnreported = "came to rest in a net, not reported";
    public const string Missed = "over the line by the sampled path, not reported";
    public const string Wrong = "reported, and not by the sampled path, at another time, or twice";

    /// <summary>The shots that passed the mouth within a micrometre of post or bar, or turned back within a micrometre of the line.</summary>
    public const string Undecided = "within a micrometre of post or bar, not judged";

    /// <summary>The shots not followed to the end: the path had more pieces than the buffer holds.</summary>
    public const string Cut = "cut short";

    /// <summary>The counts by these names.</summary>
    public LabCounts Counts { get; } = new();

    /// <summary>Simulates a shot. Returns true if events and sampled path agree.</summary>
    public bool Add(SeededRandom random)
    {
        GoalShot shot = GoalShot.Draw(random);
        BallState start = shot.Start;
        shot.Simulator.LookAhead(in start, new LookAheadRequest { Duration = Longest, TimeStep = shot.TimeStep }, _path);
        var watch = new GoalWatch(shot.Goal, shot.Simulator.Scene.Ball.Radius);
        watch.Follow(_path);
        bool decided = !watch.IsUndecided;
        Counts.Add(Shots);
        Counts.AddIf(!_path.IsComplete, Cut);
        Counts.AddIf(!decided, Undecided);
        BallEvent[] events = _path.Events.Span.ToArray();
        BallEvent[] reported = [.. events.Where(item => item.Kind == BallEventKind.Goal)];
        bool lies = shot.Goal.HasNet && _path.Final.Motion == MotionState.Rest && watch.LiesIn(_path.Final.Position);
        Counts.AddIf(lies, LieIn);
        Counts.AddIf(lies && reported.Length == 0, LieInUnreported);
        if (reported.Length > 0)
        {
            Counts.Add(Reported);
            Counts.AddIf(events.Any(item => item.Kind == BallEventKind.Impact && item.ColliderIndex > 0 && item.Time <= reported[0].Time), Rebounds);
            Counts.AddIf(MotionAt(reported[0].Time) is MotionState.Sliding or MotionState.Rolling, Carried);
        }

        bool missed = reported.Length == 0 && watch.Time < double.PositiveInfinity;
        bool wrong = reported.Length > 1 || (reported.Length == 1 && !(Math.Abs(reported[0].Time - watch.Time) <= Closeness));
        Counts.AddIf(missed && decided, Missed);
        Counts.AddIf(wrong && decided, Wrong);
        return !decided || !(missed || wrong || (lies && reported.Length == 0));
    }

    private MotionState MotionAt(double time)
    {
        foreach (ref readonly PathSegment piece in _path.Pieces)
        {
            if (piece.EndTime >= time)
            {
                return piece.Motion;
            }
        }

        return _path.Final.Motion;
    }
}
