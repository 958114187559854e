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

/// <summary>A random shot at a goal, or past it, from within 25 m: in flight, bouncing or along the ground, at the frame, and off a keeper.</summary>
/// <param name="Goal">The goal.</param>
/// <param name="Simulator">The simulator of its scene.</param>
/// <param name="TimeStep">The time step, s.</param>
/// <param name="Start">The ball at the kick.</param>
internal sealed record GoalShot(Goal Goal, Simulator Simulator, double TimeStep, BallState Start)
{
    private const double Farthest = 25;

    /// <summary>Draws a shot.</summary>
    public static GoalShot Draw(SeededRandom random)
    {
        Vector3d facing = random.Heading();
        Vector3d right = Vector3d.Cross(facing, Vector3d.Up);
        var goal = new Goal
        {
            Center = new Vector3d(random.Uniform(-40, 40), 0, random.Uniform(-40, 40)),
            Facing = facing,
            Width = random.Chance(0.7) ? 7.32 : random.Uniform(2, 8),
            Height = random.Chance(0.7) ? 2.44 : random.Uniform(1.5, 3),
            PostRadius = random.Chance(0.7) ? 0.06 : random.Uniform(0.02, 0.1),
            HasNet = random.Chance(0.85),
            Surface = SurfaceMaterial.GoalFrame,
        };
        Vector3d Place(double aside, double height, double before) => goal.Center + (aside * right) + new Vector3d(0, height, 0) + (before * facing);

        // Half of the shots have a keeper near the line.
        double stands = random.Uniform(-0.5, 0.5) * goal.Width;
        double ahead = random.Uniform(0, 1.5);
        Obstacle[] people = random.Chance(0.5) ? [] :
        [
            new Obstacle { Name = "keeper", Shape = new CapsuleShape(Place(stands, 0.25, ahead), Place(stands, 1.6, ahead), 0.25), Surface = SurfaceMaterial.PublishedGoalFrame },
        ];
        Scene scene = random.Chance(0.8) ? Scene.Default : Scene.Published;
        var simulator = new Simulator(
            scene with { Goals = [goal], Obstacles = people }, new SolverSettings { Integrator = random.Chance(0.5) ? Integrator.Rk2 : Integrator.Rk4 });
        double timeStep = random.Any(1.0 / 60, 0.01, 1.0 / 30, 0.04);

        // The start is before the line, or level with it outside the posts. The target is the opening, the frame, or past it, at any height.
        double angle = random.Uniform(-92, 92) * Math.PI / 180;
        double distance = random.Uniform(0.3, Farthest);
        bool low = random.Chance(0.4);
        double high = low ? 0.11 : random.Uniform(0.11, 3.5);
        Vector3d from = Place(distance * Math.Sin(angle), high, distance * Math.Cos(angle));
        while (goal.Frame(ForceSet.Measured).Concat(people).Any(thing => thing.Shape.At(from).Distance < 0.12))
        {
            // Do not start inside an object.
            distance += 0.3;
            from = Place(distance * Math.Sin(angle), high, distance * Math.Cos(angle));
        }

        double side = random.Uniform(-1, 1);
        double aside = random.Chance(0.4) ? Math.Sign(side) * ((0.5 * goal.Width) + random.Uniform(-0.5, 0.2)) : side * ((0.5 * goal.Width) + 1);
        double height = random.Chance(0.25) ? goal.Height + random.Uniform(-0.4, 0.2) : random.Chance(0.3) ? 0.11 : random.Uniform(0.11, goal.Height + 0.5);
        Vector3d way = Place(aside, height, 0) - from;
        double speed = random.Chance(0.25) ? random.Uniform(1, 9) : random.Uniform(9, 38);

        // Some shots compensate for the drop by gravity on their path.
        double lift = random.Chance(0.7) ? 0.5 * 9.81 * way.Length / speed : 0;
        Vector3d velocity = (speed * (way / way.Length)) + new Vector3d(0, low && height < 0.2 ? 0 : Math.Min(lift, 12), 0);
        return new GoalShot(goal, simulator, timeStep, simulator.Launch(from, velocity, random.Chance(0.3) ? Vector3d.Zero : random.Uniform(0, 70) * random.Direction()));
    }
}
