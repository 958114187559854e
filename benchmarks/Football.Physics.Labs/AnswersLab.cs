using System.CommandLine;

namespace FootballPhysics.Labs;

/// <summary>football lab answers: checks that simulated kicks are found again, that hits hit, that verdicts hold, and that look-aheads report all events.</summary>
internal static class AnswersLab
{
    /// <summary>The largest share of known kicks that may not be found again: in still air, and in wind.</summary>
    private const double StillShare = 0.001;
    private const double WindyShare = 0.005;
    private const double Windy = 20;
    private const int MostExamples = 12;
    private const int FewExamples = 8;

    /// <summary>The number of kicks simulated per chance, and the largest allowed error of the chance, as a share.</summary>
    private const int KicksPerRequest = 20;
    private const double LargestChanceError = 0.02;

    private static readonly (double Wind, int Balls)[] s_conditions = [(0, 1), (0, KnownKick.Balls.Length), (Windy, 1), (Windy, KnownKick.Balls.Length)];

    private static readonly (string Name, Action<LabRun, int, int> Ask)[] s_questions =
        [("known", Known), ("ground", Ground), ("batches", Batches), ("lookahead", LookAheads), ("verdicts", Verdicts), ("arrivals", Arrivals), ("slopes", Slopes), ("surfaces", Surfaces), ("frame", Frame)];

    public static Lab Create()
    {
        var lab = new Lab(
            "answers",
            "Correctness of searches: known kicks are found, hits hit, verdicts agree with a dense scan, look-aheads miss no event.",
            ["football lab answers --only lookahead --seed 7 --count 100"]);
        Option<long> count = lab.Whole("--count", "Kicks, requests and look-aheads of each kind.", 1, 1_000_000, 2000);
        Option<string?> only = lab.Only("QUESTION", "Run one question", s_questions.Select(one => one.Name));
        return lab.Plays(run =>
        {
            foreach ((string name, Action<LabRun, int, int> ask) in s_questions.Where(one => run.Get(only) is not { } wanted || one.Name == wanted))
            {
                run.Progress.Report(() => name);
                ask(run, unchecked((int)run.Seed), run.Int(count));
            }
        });
    }

    private static void Known(LabRun run, int seed, int count)
    {
        LabTable table = run.Table(
            "Known kicks (5 to 35 m/s, up to 85°, spins, heights; 1 mm), and how many of them are not found again",
            ["wind up to, m/s", "balls", .. KnownKickCounts.Columns, "verdict"]);
        foreach ((double wind, int balls) in s_conditions)
        {
            LabCounts known = KnownKickCounts.Of(seed, count, wind, balls);
            double share = wind > 0 ? WindyShare : StillShare;
            bool reached = new[] { "low arc", "high arc", "at their time", "no slower one" }.All(column => known[column] <= share * known["kicks"])
                && known["two points below 45°"] <= share * known["below 45°"] && known["false hits"] == 0;
            table.Judge(reached, [wind, balls, .. known.Cells(KnownKickCounts.Columns)]);
            run.Notes.AddRange(known.Examples.Where(example => !example.StartsWith("two points, steep", StringComparison.Ordinal)).Take(MostExamples));
        }
    }

    private static void Ground(LabRun run, int seed, int count)
    {
        LabTable table = run.Table(
            "Passes along the ground (3 to 28 m/s, spins; 1 cm), and how many of them are not found again",
            ["wind up to, m/s", "balls", .. GroundPassCounts.Columns, "verdict"]);
        foreach ((double wind, int balls) in s_conditions)
        {
            LabCounts passes = GroundPassCounts.Of(seed, count, wind, balls);
            double most = (wind > 0 ? WindyShare : StillShare) * passes["passes"];
            bool reached = new[] { "found", "at their time", "no slower one" }.All(column => passes[column] <= most) && passes["false hits"] == 0;
            table.Judge(reached, [wind, balls, .. passes.Cells(GroundPassCounts.Columns)]);
            run.Notes.AddRange(passes.Examples.Take(MostExamples));
        }
    }

    private static void Batches(LabRun run, int seed, int count)
    {
        LabTable table = run.Table(
            "Many aims at once, five balls (15 to 35 m/s, up to 60°; 1 mm), and how many of their hits miss",
            ["wind up to, m/s", "kind", .. BatchHitCounts.Columns, "verdict"]);
        foreach ((double wind, bool drives) in ((double, bool)[])[(0, true), (0, false), (Windy, true), (Windy, false)])
        {
            LabCounts batch = BatchHitCounts.Of(seed, 4 * count, wind, drives);
            table.Judge(batch["false hits"] == 0, [wind, drives ? "low drives with backspin" : "any", .. batch.Cells(BatchHitCounts.Columns)]);
        }
    }

    private static void Arrivals(LabRun run, int seed, int count)
    {
        LabTable table = run.Table("Kicks that are to arrive with a speed (no faster than 35 m/s; 0.1 m/s)", ["targets", .. ArrivalCounts.Columns, "verdict"]);
        foreach (ArrivalCounts.Kind kind in Enum.GetValues<ArrivalCounts.Kind>())
        {
            LabCounts arrivals = ArrivalCounts.Of(seed, count, kind);
            bool reached = arrivals["hits at another speed"] == 0 && arrivals["not found again"] <= StillShare * arrivals["known kicks"];
            string name = kind switch { ArrivalCounts.Kind.Air => "in the air", ArrivalCounts.Kind.Volley => "low, of volleys", _ => "on the ground" };
            table.Judge(reached, [name, .. arrivals.Cells(ArrivalCounts.Columns)]);
            run.Notes.AddRange(arrivals.Examples.Take(FewExamples));
        }
    }

    private static void Slopes(LabRun run, int seed, int count)
    {
        LabTable table = run.Table("Aims on slopes of up to 5 % (1 cm), and how many of their hits miss", ["ground", .. SlopeCounts.Columns, "verdict"]);
        foreach (bool isUneven in new[] { false, true })
        {
            LabCounts slopes = SlopeCounts.Of(seed, count, 0.05, isUneven);
            table.Judge(slopes["false hits"] == 0, [isUneven ? "long waves" : "a slope", .. slopes.Cells(SlopeCounts.Columns)]);
            run.Notes.AddRange(slopes.Examples.Take(FewExamples));
        }
    }

    private static void Surfaces(LabRun run, int seed, int count)
    {
        LabTable table = run.Table(
            "Known kicks on level ground, slopes and hills (1 cm; a quarter lands at its target, a quarter rolls), and how many are not found again",
            ["ground", "wind up to, m/s", .. SurfaceKickCounts.Columns, "verdict"]);
        foreach (SurfaceCondition condition in SurfaceCondition.All)
        {
            LabCounts kicks = SurfaceKickCounts.Of(seed, count, condition);
            table.Judge(SurfaceKickCounts.Holds(kicks, condition), [condition.Name, condition.Wind, .. kicks.Cells(SurfaceKickCounts.Columns)]);
            run.Notes.AddRange(kicks.Examples.Take(MostExamples));
        }

        Decisions(run, seed, count);
    }

    /// <summary>Targets that a dense scan puts at least 5 % of their distance beyond the reach: most are called out of reach.</summary>
    private static void Decisions(LabRun run, int seed, int count)
    {
        LabCounts far = FarTargetCounts.Of(seed, Math.Max(1, count / 4));
        run.Table("Targets at least 5 % beyond the reach (level ground, still air)", [.. FarTargetCounts.Columns, "verdict"])
            .Judge(far["out of reach"] >= 0.9 * far["targets"] && far["hits"] == 0, [.. far.Cells(FarTargetCounts.Columns)]);
        run.Notes.AddRange(far.Examples.Take(FewExamples));
    }

    private static void Frame(LabRun run, int seed, int count)
    {
        // At the default count this is 40 000 kicks, so the standard error is at most a quarter of a percentage point.
        int kicks = KicksPerRequest * count;
        LabTable table = run.Table("Chances of a goal near the frame, %", "aside, m", "height, m", "spread, °", "kicks", "played", "by derivatives", "by flights", "verdict");
        foreach ((double Aside, double Height, double Degrees) item in FrameChances.Cases)
        {
            (GoalChanceResult derived, GoalChanceResult flown, double played) = FrameChances.Of(item, seed, kicks);
            double room = LargestChanceError + (3.0 * Math.Sqrt(0.25 / kicks) * (kicks < 40_000 ? 1 : 0));
            bool reached = Math.Abs(derived.Scores - played) <= room && Math.Abs(flown.Scores - played) <= room;
            table.Judge(reached, item.Aside, item.Height, item.Degrees, kicks, 100 * played, 100 * derived.Scores, 100 * flown.Scores);
        }
    }

    private static void LookAheads(LabRun run, int seed, int count)
    {
        LabCounts ahead = LookAheadCounts.Of(seed, count);
        bool reached = new[] { "not found", "ended before passing", "wrongly complete or not", "diverged" }.All(column => ahead[column] == 0);
        run.Table("Look-aheads, five balls, winds up to 20 m/s", [.. LookAheadCounts.Columns, "verdict"]).Judge(reached, [.. ahead.Cells(LookAheadCounts.Columns)]);
        run.Notes.AddRange(ahead.Examples.Take(MostExamples));
    }

    private static void Verdicts(LabRun run, int seed, int count)
    {
        Scene Windy20(int index) => KnownKick.Scene(new Random((seed * 1000) + index), index % KnownKick.Balls.Length, Windy);
        LabCounts verdicts = AimVerdicts.Of(run, "Random requests in winds up to 20 m/s, five balls, held against a dense scan", Windy20, count, 1);
        run.Failed |= !AimVerdicts.Answers(verdicts);
    }
}

/// <summary>Compares the chance of a goal near the frame with simulated random kicks.</summary>
internal static class FrameChances
{
    private const double Away = 15;
    private const double Speed = 24;
    private const int PerTask = 500;

    private static readonly Goal s_goal = new() { Center = new Vector3d(0, 0, -Away), Facing = new Vector3d(0, 0, 1) };

    /// <summary>The targets of the kicks: next to the posts, under the bar, at a corner; and their spread, degrees.</summary>
    public static (double Aside, double Height, double Degrees)[] Cases { get; } =
        [(3.58, 1.1, 0.3), (3.64, 1.1, 0.3), (-3.6, 2, 0.3), (3.7, 0.5, 0.8), (0, 2.4, 0.3), (1, 2.5, 0.8), (3.5, 2.3, 0.3), (-3.5, 2.3, 0.8)];

    /// <summary>Computes one case: by derivatives, by flights, and by full simulation.</summary>
    public static (GoalChanceResult Derived, GoalChanceResult Flown, double Played) Of((double Aside, double Height, double Degrees) item, int seed, int kicks)
    {
        var from = new Vector3d(0, 0.11, 0);
        AimResult aim = new Aimer().Find(new AimRequest { From = from, Target = new Vector3d(item.Aside, item.Height, -Away), Speed = Speed });
        var spread = new KickSpread { SpeedPercent = 1, ElevationDegrees = item.Degrees, AzimuthDegrees = item.Degrees };
        var chance = new GoalChance();
        var simulator = new Simulator(new Scene { Goals = [s_goal] });
        int goals = 0;
        Parallel.For(0, (kicks + PerTask - 1) / PerTask, task =>
        {
            var random = new Random((seed * 100_003) + task);
            var log = new StepLog();
            int own = 0;
            for (int i = 0; i < Math.Min(PerTask, kicks - (task * PerTask)); i++)
            {
                (Vector3d velocity, Vector3d spin) = spread.Draw(random, aim.Velocity, aim.Spin);
                BallState ball = simulator.Launch(from, velocity, spin);
                log.Clear();
                simulator.Run(ref ball, 0.01, 2.5, StopAt.Time, log);
                own += log.Events.Count(BallEventKind.Goal);
            }

            Interlocked.Add(ref goals, own);
        });
        return (chance.Find(from, aim.Velocity, aim.Spin, spread, s_goal), chance.FindByFlights(from, aim.Velocity, aim.Spin, spread, s_goal, null, kicks, seed), (double)goals / kicks);
    }
}
