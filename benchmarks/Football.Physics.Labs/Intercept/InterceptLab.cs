namespace FootballPhysics.Labs.Intercept;

/// <summary>football lab intercept: compares windows of random runners on random flights with a dense scan.</summary>
internal static class InterceptLab
{
    public static Lab Create() => new Lab(
        "intercept",
        "Interception by random runners on random flights, compared with a scan in steps of 0.1 ms.",
        ["football lab intercept", "football lab intercept --flights 40 --seed 7"]).Plays(Lab.Number("--flights", "Number of flights, alternating between the profiles.", 2, 10_000_000, 100), Run);

    private static void Run(LabRun run, int flights)
    {
        LabTable table = run.Table(
            "Windows of meeting, against a scan in steps of 0.1 ms", ["profile", "flights", .. InterceptCheck.Columns, "worst end, s", "verdict"]);
        (string Name, InterceptCheck Check)[] profiles = [("published", new InterceptCheck(Scene.Published)), ("measured", new InterceptCheck(Scene.Measured))];
        run.Each(flights, "flight", (random, i) => profiles[i % 2].Check.Run(random));
        foreach ((string name, InterceptCheck check) in profiles)
        {
            int count = (flights + (name == "published" ? 1 : 0)) / 2;
            table.Judge(check.Holds, [name, count, .. check.Counts.Cells(InterceptCheck.Columns), check.Worst]);
        }

        run.Notes.Add("Reached: no window lost or invented, who is first is right, and ends are within 1e-6 s. The path is in the game's own steps of 10 ms.");
    }
}

/// <summary>Compares the windows of random runners on random flights with a dense scan.</summary>
internal sealed class InterceptCheck(Scene scene)
{
    private const double TimeStep = 0.01;
    private const int RunnersOfAFlight = 2;

    private readonly Simulator _simulator = new(scene);
    private readonly Trajectory _path = new(2048);
    private readonly Interception _interception = new();

    /// <summary>
    /// The windows; those of the scan that were not found; those that were found although the runner does not reach the ball in their middle; windows and
    /// gaps that are correct but too short for the scan; and the flights for which the first runner differs from the scan's.
    /// </summary>
    public static readonly string[] Columns = ["windows", "lost", "invented", "too short for the scan", "wrong first"];

    public LabCounts Counts { get; } = new();

    /// <summary>The largest error of the start or end of a window, s.</summary>
    public double Worst { get; private set; }

    public bool Holds => Counts["lost"] + Counts["invented"] + Counts["wrong first"] == 0 && Worst <= 1e-6;

    /// <summary>Draws a flight and its runners, and compares their windows with the scan.</summary>
    public void Run(SeededRandom random)
    {
        Vector3d velocity = random.Velocity(4, 33, -2, 55);
        Vector3d spin = random.Uniform(0, 60) * random.Direction();
        BallState ball = _simulator.Launch(new Vector3d(0, random.Chance(0.7) ? 0.11 : random.Uniform(0.11, 2), 0), velocity, spin);
        var request = new LookAheadRequest { Duration = random.Uniform(1.5, 4), TimeStep = TimeStep, StopAt = StopAt.Time };
        _simulator.LookAhead(in ball, request, _path);
        Compare([.. Enumerable.Range(0, RunnersOfAFlight).Select(_ => Draw(random))]);
    }

    private Player Draw(SeededRandom random)
    {
        // Near a random point of the path, so that windows begin and end in every manner.
        Vector3d place = _path.PositionAt(random.Uniform(_path.StartTime, _path.EndTime));
        double high = random.Any(0.2, 0.6, 1.2, 2.3, 2.7) * random.Uniform(0.9, 1.1);
        return new Player
        {
            Position = (place + (random.Log(0.05, 15) * random.Heading())).Horizontal,
            Velocity = random.Uniform(0, 6) * random.Heading(),
            Reaction = random.Uniform(0, 0.5),
            Acceleration = random.Uniform(2, 9),
            Speed = random.Uniform(3, 10),
            Reach = random.Uniform(0, 1.5),
            MinimumHeight = random.Chance(0.8) ? 0 : random.Uniform(0, high),
            MaximumHeight = high,
        };
    }

    private void Compare(Player[] runners)
    {
        var scan = new MeetingScan(_path);
        _interception.Find(_path, runners);
        int first = -1;
        double earliest = double.PositiveInfinity;
        for (int i = 0; i < runners.Length; i++)
        {
            List<(double From, double To)> wanted = scan.Windows(runners[i]);
            List<(double From, double To)> found = Found(i, runners[i], scan, wanted);
            Counts.Add("windows", found.Count);

            // The first window that is right, even if it is too short for the scan.
            ReadOnlySpan<InterceptWindow> own = _interception.WindowsOf(i);
            double begins = Math.Min(wanted.Count > 0 ? wanted[0].From : double.PositiveInfinity, own.Length > 0 ? own[0].From : double.PositiveInfinity);
            if (begins < earliest)
            {
                first = i;
                earliest = begins;
            }

            if (found.Count != wanted.Count)
            {
                Counts.Add("lost", Math.Max(0, wanted.Count - found.Count));
                Counts.Add("invented", Math.Max(0, found.Count - wanted.Count));
                continue;
            }

            foreach (((double From, double To) a, (double From, double To) b) in wanted.Zip(found))
            {
                Worst = Math.Max(Worst, Math.Max(Math.Abs(a.From - b.From), Math.Abs(a.To - b.To)));
            }
        }

        Counts.AddIf(first != _interception.First, "wrong first");
    }

    /// <summary>Returns the windows without windows and gaps that are too short for the scan. Those are checked in their middle: the runner reaches the ball there, or does not.</summary>
    private List<(double From, double To)> Found(int index, Player runner, MeetingScan scan, List<(double From, double To)> wanted)
    {
        const double Seen = 2.1e-4;
        var found = new List<(double From, double To)>();
        foreach (InterceptWindow window in _interception.WindowsOf(index))
        {
            if (!scan.Meets(runner, 0.5 * (window.From + window.To)))
            {
                Counts.Add("invented");
                continue;
            }

            if (found.Count > 0 && window.From - found[^1].To < Seen
                && wanted.Any(item => item.From < found[^1].To && item.To > window.From) && !scan.Meets(runner, 0.5 * (window.From + found[^1].To)))
            {
                Counts.Add("too short for the scan");
                found[^1] = (found[^1].From, window.To);
            }
            else if (window.To - window.From < Seen && !wanted.Any(item => item.From <= window.To && item.To >= window.From))
            {
                Counts.Add("too short for the scan");
            }
            else
            {
                found.Add((window.From, window.To));
            }
        }

        return found;
    }
}

/// <summary>Finds when a runner can reach a ball by sampling: the reference for the search with bounds.</summary>
internal sealed class MeetingScan(Trajectory path)
{
    private const double Step = 1e-4;
    private const double Closeness = 1e-10;

    private readonly Vector3d[] _places =
        [.. Enumerable.Range(0, (int)Math.Ceiling((path.EndTime - path.StartTime) / Step) + 1).Select(i => path.PositionAt(TimeOf(path, i)))];

    /// <summary>Returns the windows, with ends to 0.1 ns. Windows shorter than a step of the scan are found only by chance.</summary>
    public List<(double From, double To)> Windows(Player runner)
    {
        var windows = new List<(double From, double To)>();
        bool inside = false;
        double from = 0;
        for (int i = 0; i < _places.Length; i++)
        {
            bool meets = Meets(runner, TimeOf(path, i), _places[i]);
            if (meets == inside)
            {
                continue;
            }

            double change = i == 0 ? TimeOf(path, 0) : LabMath.Bisect(TimeOf(path, i - 1), TimeOf(path, i), time => Meets(runner, time) == meets, Closeness);
            inside = meets;
            if (meets)
            {
                from = change;
            }
            else
            {
                windows.Add((from, change));
            }
        }

        if (inside)
        {
            windows.Add((from, path.EndTime));
        }

        return windows;
    }

    /// <summary>True if the runner reaches the ball at a time, by the literal definition.</summary>
    public bool Meets(Player runner, double time) => Meets(runner, time, path.PositionAt(time));

    private static bool Meets(Player runner, double time, Vector3d ball)
    {
        double since = time - runner.Reaction;
        double s = Math.Max(0, since);
        Vector3d place = runner.Position + (Math.Min(time, runner.Reaction) * runner.Velocity);
        double ramp = runner.Speed / runner.Acceleration;
        double run = s <= ramp ? 0.5 * runner.Acceleration * s * s : runner.Speed * (s - (0.5 * ramp));
        return (ball - place).Horizontal.Length <= run + runner.Reach && ball.Y >= runner.MinimumHeight - 1e-9 && ball.Y <= runner.MaximumHeight + 1e-9;
    }

    private static double TimeOf(Trajectory path, int i) => Math.Min(path.StartTime + (i * Step), path.EndTime);
}
