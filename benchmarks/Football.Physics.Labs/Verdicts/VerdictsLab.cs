using System.CommandLine;

namespace FootballPhysics.Labs.Verdicts;

/// <summary>football lab verdicts: are tracks with a fault called good although an answer is wrong, and clean tracks not called good?</summary>
internal static class VerdictsLab
{
    /// <summary>The minimum duration, in s, and number of points of a flight that is judged.</summary>
    private const double Shortest = 0.35;
    private const int LeastPoints = 10;

    /// <summary>The deviations beyond which a good answer is wrong.</summary>
    private const double Wrong = 4;

    public static Lab Create()
    {
        var lab = new Lab("verdicts", "The verdict and the deviations of match fits, on simulated matches with known faults.", ["football lab verdicts --matches 14"]);
        Option<long> matches = lab.Whole("--matches", "Simulated matches; every second one has a fault.", 1, 1_000_000, 2000);
        Option<long> jobs = lab.Jobs("Threads; default: one per processor. The tables do not depend on it.");
        return lab.Plays(run => Run(run, run.Int(matches), run.Int(jobs)));
    }

    private static void Run(LabRun run, int matches, int jobs)
    {
        var scene = new Scene { Ball = BallProperties.Tunnel };
        var told = new Told[matches];
        int done = 0;
        Parallel.For(0, matches, new ParallelOptions { MaxDegreeOfParallelism = jobs }, i =>
        {
            told[i] = Told.Of(VerdictMatch.Play(run.Random(i), i), scene);
            run.Progress.Report(Interlocked.Increment(ref done), matches, () => "matches");
        });
        Told[] clean = [.. told.Where(t => t.Match.Fault == TrackFault.None)];
        Told[] faulty = [.. told.Where(t => t.Match.Fault != TrackFault.None)];
        LabTable kinds = run.Table("Verdicts", "tracks", "number", "good for launches", "good for spins", "good, but off by more than 4 deviations", "rms/noise, median");
        foreach (IGrouping<(TrackFault, bool), Told> kind in told.GroupBy(t => (t.Match.Fault, t.Match.IsForeign)).OrderBy(kind => kind.Key))
        {
            Told[] all = [.. kind];
            kinds.Add(
                $"{(kind.Key.Item1 == TrackFault.None ? "clean" : kind.Key.Item1)}{(kind.Key.Item2 ? ", other drag and bounce" : "")}", all.Length, all.Count(t => t.Launches), all.Count(t => t.Spins), all.Count(t => t.IsWrong),
                all.Select(t => t.Misfit).Order().ElementAt(all.Length / 2));
        }

        LabTable rules = run.Table("Rules", "rule", "share, %", "to reach", "verdict");
        double missed = Percent(faulty.Count(t => t.IsWrong), faulty.Length);
        double lost = Percent(clean.Count(t => !(t.Launches && t.Spins)), clean.Length);
        rules.Judge(missed <= 2, "faulty tracks called good although an answer is off by more than 4 deviations", missed, "at most 2");
        rules.Judge(lost <= 2, "clean tracks not called good", lost, "at most 2");
        Cover(rules, "clean tracks", clean);
        Cover(rules, "faulty tracks that are called good", [.. faulty.Where(t => t.Launches)]);
        run.Failed |= !rules.Holds && matches >= 200;
        run.Notes.Add("An integrator of the laboratory plays the matches: 7 to 12 kicks, wind, 25 or 50 Hz, noise of 2 to 30 mm. In a third of the matches, drag falls linearly between two random speeds, and the bounce is another. Faults: a clock that is 2 to 10 % wrong, a half that is turned, straight lines or held frames in gaps, other drag laws, heights scaled by 2 to 10 %, a wrong rate. Judged are all flights of 0.35 s or longer with 10 points.");
    }

    private static void Cover(LabTable rules, string which, Told[] tracks)
    {
        double[] velocity = [.. tracks.SelectMany(t => t.Velocity)];
        double[] spin = [.. tracks.Where(t => t.Spins).SelectMany(t => t.Spin)];
        foreach ((string name, double[] off) in (ReadOnlySpan<(string, double[])>)[("velocity", velocity), ("spin", spin)])
        {
            double one = Percent(off.Count(z => z <= 1), off.Length);
            double three = Percent(off.Count(z => z <= 3), off.Length);
            rules.Judge(one is >= 60 and <= 76, $"{which}: {name} within 1 deviation", one, "60 … 76");
            rules.Judge(three >= 98, $"{which}: {name} within 3 deviations", three, "at least 98");
        }
    }

    private static double Percent(int part, int whole) => whole == 0 ? double.NaN : 100.0 * part / whole;

    /// <summary>A match, its verdict, and the errors of its flights in stated deviations.</summary>
    private sealed record Told(VerdictMatch Match, bool Launches, bool Spins, double[] Velocity, double[] Spin, double Misfit)
    {
        /// <summary>True if an answer that the verdict calls good is wrong.</summary>
        public bool IsWrong => (Launches && Velocity.Any(z => z > Wrong)) || (Spins && Spin.Any(z => z > Wrong));

        public static Told Of(VerdictMatch match, Scene scene)
        {
            MatchFitResult fit = new MatchFit(scene).Find(match.Track);
            List<double> velocity = [];
            List<double> spin = [];
            foreach (MatchPiece flight in fit.Pieces)
            {
                if (flight.Kind == MatchPieceKind.Flight && flight.Points >= LeastPoints && flight.Duration >= Shortest && match.Errors(flight) is { } errors)
                {
                    for (int axis = 0; axis < 3; axis++)
                    {
                        velocity.Add(Math.Abs(errors[axis]) / flight.VelocityDeviation.Along(axis));
                        spin.Add(Math.Abs(errors[3 + axis]) / flight.SpinDeviation.Along(axis));
                    }
                }
            }

            bool launches = fit.GoodFor.HasFlag(MatchAnswers.Launches);
            bool spins = fit.GoodFor.HasFlag(MatchAnswers.Spins);
            return new Told(match, launches, spins, [.. velocity], [.. spin], fit.Rms / (Math.Sqrt(3) * fit.Noise));
        }
    }
}
