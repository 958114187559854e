using System.CommandLine;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs;

/// <summary>football lab answers: checks that simulated kicks are found again, that hits hit, that verdicts hold, and that look-aheads report all events.</summary>
internal static class AnswersLab
{
    /// <summary>The largest share of known kicks that may not be found again: in still air, and in wind.</summary>
    private const double StillShare = 0.001;
    private const double WindyShare = 0.005;
    private const double Windy = 20;
    private const int MostExamples = 12;

    /// <summary>The number of kicks simulated per chance, and the largest allowed error of the chance, as a share.</summary>
    private const int KicksPerRequest = 20;
    private const double LargestChanceError = 0.02;

    private static readonly (double Wind, int Balls)[] s_conditions = [(0, 1), (0, KnownKick.Balls.Length), (Windy, 1), (Windy, KnownKick.Balls.Length)];

    private static readonly (string Name, Action<LabReport, int, int, Progress> Count)[] s_questions =
        [("known", Known), ("ground", Ground), ("batches", Batches), ("lookahead", LookAheads), ("verdicts", Verdicts), ("arrivals", Arrivals), ("slopes", Slopes), ("frame", Frame)];

    public static Command Create(Terminal terminal)
    {
        Option<long> count = Arguments.Whole("--count", "Kicks, requests and look-aheads of each kind.", 1, 1_000_000, 2000);
        var only = new Option<string?>("--only") { HelpName = "QUESTION", Description = $"Run one question: {string.Join(", ", s_questions.Select(one => one.Name))}." };
        only.AcceptOnlyFromAmong([.. s_questions.Select(one => one.Name)]);
        return LabOptions.Create(
            "answers",
            "Correctness of searches: known kicks are found, hits hit, verdicts agree with a dense scan, look-aheads miss no event.",
            ["football lab answers --only lookahead --seed 7 --count 100"],
            terminal,
            (parsed, seed, progress) => Run(unchecked((int)seed), (int)parsed.GetValue(count), parsed.GetValue(only), progress),
            count,
            only);
    }

    private static LabReport Run(int seed, int count, string? only, Progress progress)
    {
        var report = new LabReport { Name = "answers", Seed = seed };
        foreach ((string name, Action<LabReport, int, int, Progress> ask) in s_questions.Where(one => only is null || one.Name == only))
        {
            ask(report, seed, count, progress);
        }

        return report;
    }

    private static void Known(LabReport report, int seed, int count, Progress progress)
    {
        var table = new LabTable(
            "Known kicks (5 to 35 m/s, up to 85°, spins, heights; 1 mm), and how many of them are not found again",
            ["wind up to, m/s", "balls", .. KnownKickCounts.Columns, "verdict"]);
        report.Tables.Add(table);
        foreach ((double wind, int balls) in s_conditions)
        {
            progress.Report(() => "known kicks");
            LabCounts known = KnownKickCounts.Of(seed, count, wind, balls);
            double share = wind > 0 ? WindyShare : StillShare;
            bool reached = new[] { "low arc", "high arc", "at their time", "no slower one" }.All(column => known[column] <= share * known["kicks"])
                && known["two points below 45°"] <= share * known["below 45°"] && known["false hits"] == 0;
            table.Add([wind, balls, .. known.Cells(KnownKickCounts.Columns), Verdict.Of(reached)]);
            Judge(report, reached, known.Examples.Where(example => !example.StartsWith("two points, steep", StringComparison.Ordinal)));
        }
    }

    private static void Ground(LabReport report, int seed, int count, Progress progress)
    {
        var table = new LabTable(
            "Passes along the ground (3 to 28 m/s, spins; 1 cm), and how many of them are not found again",
            ["wind up to, m/s", "balls", .. GroundPassCounts.Columns, "verdict"]);
        report.Tables.Add(table);
        foreach ((double wind, int balls) in s_conditions)
        {
            progress.Report(() => "passes along the ground");
            LabCounts passes = GroundPassCounts.Of(seed, count, wind, balls);
            double most = (wind > 0 ? WindyShare : StillShare) * passes["passes"];
            bool reached = new[] { "found", "at their time", "no slower one" }.All(column => passes[column] <= most) && passes["false hits"] == 0;
            table.Add([wind, balls, .. passes.Cells(GroundPassCounts.Columns), Verdict.Of(reached)]);
            Judge(report, reached, passes.Examples);
        }
    }

    private static void Batches(LabReport report, int seed, int count, Progress progress)
    {
        var table = new LabTable(
            "Many aims at once, five balls (15 to 35 m/s, up to 60°; 1 mm), and how many of their hits miss",
            ["wind up to, m/s", "kind", .. BatchHitCounts.Columns, "verdict"]);
        report.Tables.Add(table);
        foreach ((double wind, bool drives) in ((double, bool)[])[(0, true), (0, false), (Windy, true), (Windy, false)])
        {
            progress.Report(() => "many aims at once");
            LabCounts batch = BatchHitCounts.Of(seed, 4 * count, wind, drives);
            bool reached = batch["false hits"] == 0;
            table.Add([wind, drives ? "low drives with backspin" : "any", .. batch.Cells(BatchHitCounts.Columns), Verdict.Of(reached)]);
            Judge(report, reached, []);
        }
    }

    private static void Arrivals(LabReport report, int seed, int count, Progress progress)
    {
        var table = new LabTable("Kicks that are to arrive with a speed (no faster than 35 m/s; 0.1 m/s)", ["targets", .. ArrivalCounts.Columns, "verdict"]);
        report.Tables.Add(table);
        foreach (ArrivalCounts.Kind kind in Enum.GetValues<ArrivalCounts.Kind>())
        {
            progress.Report(() => "arrivals");
            LabCounts arrivals = ArrivalCounts.Of(seed, count, kind);
            bool reached = arrivals["hits at another speed"] == 0 && arrivals["not converged"] <= StillShare * arrivals["requests"]
                && arrivals["not found again"] <= StillShare * arrivals["known kicks"];
            string name = kind switch { ArrivalCounts.Kind.Air => "in the air", ArrivalCounts.Kind.Volley => "low, of volleys", _ => "on the ground" };
            table.Add([name, .. arrivals.Cells(ArrivalCounts.Columns), Verdict.Of(reached)]);
            Judge(report, reached, arrivals.Examples.Take(8));
        }
    }

    private static void Slopes(LabReport report, int seed, int count, Progress progress)
    {
        var table = new LabTable("Aims on slopes of up to 5 % (1 cm), and how many of their hits miss", ["ground", .. SlopeCounts.Columns, "verdict"]);
        report.Tables.Add(table);
        foreach (bool isUneven in new[] { false, true })
        {
            progress.Report(() => "slopes");
            LabCounts slopes = SlopeCounts.Of(seed, count, 0.05, isUneven);
            bool reached = slopes["false hits"] == 0;
            table.Add([isUneven ? "long waves" : "a slope", .. slopes.Cells(SlopeCounts.Columns), Verdict.Of(reached)]);
            Judge(report, reached, slopes.Examples.Take(8));
        }
    }

    private static void Frame(LabReport report, int seed, int count, Progress progress)
    {
        // At the default count this is 40 000 kicks, so the standard error is at most a quarter of a percentage point.
        int kicks = KicksPerRequest * count;
        var table = new LabTable("Chances of a goal near the frame, %", "aside, m", "height, m", "spread, °", "kicks", "played", "by derivatives", "by flights", "verdict");
        report.Tables.Add(table);
        foreach ((double Aside, double Height, double Degrees) item in FrameChances.Cases)
        {
            progress.Report(() => "chances near the frame");
            (GoalChanceResult derived, GoalChanceResult flown, double played) = FrameChances.Of(item, seed, kicks);
            double room = LargestChanceError + (3.0 * Math.Sqrt(0.25 / kicks) * (kicks < 40_000 ? 1 : 0));
            bool reached = Math.Abs(derived.Scores - played) <= room && Math.Abs(flown.Scores - played) <= room;
            table.Add(item.Aside, item.Height, item.Degrees, kicks, 100 * played, 100 * derived.Scores, 100 * flown.Scores, Verdict.Of(reached));
            Judge(report, reached, []);
        }
    }

    private static void LookAheads(LabReport report, int seed, int count, Progress progress)
    {
        progress.Report(() => "look-aheads");
        LabCounts ahead = LookAheadCounts.Of(seed, count);
        bool reached = new[] { "not found", "ended before passing", "wrongly complete or not", "diverged" }.All(column => ahead[column] == 0);
        var table = new LabTable("Look-aheads, five balls, winds up to 20 m/s", [.. LookAheadCounts.Columns, "verdict"]);
        table.Add([.. ahead.Cells(LookAheadCounts.Columns), Verdict.Of(reached)]);
        report.Tables.Add(table);
        Judge(report, reached, ahead.Examples);
    }

    private static void Verdicts(LabReport report, int seed, int count, Progress progress)
    {
        Scene Windy20(int index) => KnownKick.Scene(new Random((seed * 1000) + index), index % KnownKick.Balls.Length, Windy);
        var verdicts = AimVerdicts.Of(Windy20, seed, count, 1, done => progress.Report(done, count, () => "verdicts"));
        report.Tables.Add(verdicts.Table("Random requests in winds up to 20 m/s, five balls, held against a dense scan"));
        Judge(report, verdicts.Answers, verdicts.Examples);
    }

    private static void Judge(LabReport report, bool reached, IEnumerable<string> examples)
    {
        report.Failed |= !reached;
        report.Notes.AddRange(examples.Take(MostExamples));
    }
}
