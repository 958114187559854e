using System.CommandLine;

namespace FootballPhysics.Labs.Verdicts;

/// <summary>football lab verdicts: are tracks with a fault called good although an answer is wrong, and clean tracks not called good?</summary>
internal static class VerdictsLab
{
    /// <summary>The minimum duration, in s, and number of points of a flight that is judged.</summary>
    private const double Shortest = 0.35;
    private const int LeastPoints = 10;

    /// <summary>The largest stated deviation of a good velocity, in m/s, and of a good spin, in rad/s.</summary>
    private const double MostVelocity = 1;
    private const double MostSpin = 20;

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

        LabTable rules = run.Table("Rules", "rule", "of", "share, %", "± (1 σ)", "to reach", "verdict");
        Share missed = Share.Of(faulty, t => (t.IsWrong ? 1 : 0, 1));
        Share lost = Share.Of(clean, t => (t.Launches && t.Spins ? 0 : 1, 1));
        rules.Judge(missed.Percent <= 2, "faulty tracks called good although an answer is off by more than 4 deviations", missed.Number, missed.Percent, missed.Error, "at most 2");
        rules.Judge(lost.Percent <= 2, "clean tracks not called good", lost.Number, lost.Percent, lost.Error, "at most 2");
        Cover(rules, "clean tracks", clean);
        Cover(rules, "faulty tracks that are called good", [.. faulty.Where(t => t.Launches)]);
        run.Failed |= !rules.Holds && matches >= 200;
        run.Notes.AddRange(told.Select((t, i) => (t, i)).Where(each => each.t.IsWrong).Select(each => FormattableString.Invariant(
            $"match {each.i}, {each.t.Match.Fault}{(each.t.Match.IsForeign ? ", other drag and bounce" : "")}: {each.t.WorstAnswer} is off by {each.t.Worst:0.0} deviations")));
        run.Notes.Add("An integrator of the laboratory plays the matches: 7 to 12 kicks, wind, 25 or 50 Hz, noise of 2 to 30 mm. In a third of the matches, drag falls linearly between two random speeds, and the bounce is another. Faults: a clock that is 2 to 10 % wrong, a half that is turned, straight lines or held frames in gaps, other drag laws, heights scaled by 2 to 10 %, a wrong rate. Judged are all flights of 0.35 s or longer with 10 points, at their starts, and wind and drag where they have a true value. The shares within deviations count the components that are stated to 1 m/s and 20 rad/s.");
    }

    private static void Cover(LabTable rules, string which, Told[] tracks)
    {
        foreach ((string name, Func<Told, double[]> off) in (ReadOnlySpan<(string, Func<Told, double[]>)>)[("velocity", t => t.Velocity), ("spin", t => t.Spins ? t.Spin : [])])
        {
            Share one = Share.Of(tracks, t => (off(t).Count(z => z <= 1), off(t).Length));
            Share three = Share.Of(tracks, t => (off(t).Count(z => z <= 3), off(t).Length));
            rules.Judge(one.Percent is >= 60 and <= 76, $"{which}: {name} within 1 deviation", one.Number, one.Percent, one.Error, "60 … 76");
            rules.Judge(three.Percent >= 98, $"{which}: {name} within 3 deviations", three.Number, three.Percent, three.Error, "at least 98");
        }
    }

    /// <summary>A share of a number of cases. The error allows for cases of a match that are alike.</summary>
    private readonly record struct Share(int Number, double Percent, double Error)
    {
        public static Share Of(Told[] tracks, Func<Told, (int Part, int Whole)> count)
        {
            (int Part, int Whole)[] counts = [.. tracks.Select(count)];
            int whole = counts.Sum(each => each.Whole);
            double share = (double)counts.Sum(each => each.Part) / whole;
            double squares = counts.Sum(each => (each.Part - (share * each.Whole)) * (each.Part - (share * each.Whole)));
            return new Share(whole, 100 * share, 100 * Math.Sqrt(squares) / whole);
        }
    }

    /// <summary>A match, its verdict, and the errors of its answers in stated deviations.</summary>
    /// <param name="Match">The match.</param>
    /// <param name="Launches">True if the verdict calls the launches good.</param>
    /// <param name="Spins">True if it calls the spins good, and so wind and drag.</param>
    /// <param name="Velocity">The errors of the components of velocities that are stated to 1 m/s.</param>
    /// <param name="Spin">The errors of the components of spins that are stated to 20 rad/s.</param>
    /// <param name="Worst">The largest error of an answer that the verdict calls good, however widely it is stated.</param>
    /// <param name="WorstAnswer">This answer.</param>
    /// <param name="Misfit">The ratio of the residuals to the noise.</param>
    private sealed record Told(VerdictMatch Match, bool Launches, bool Spins, double[] Velocity, double[] Spin, double Worst, string WorstAnswer, double Misfit)
    {
        /// <summary>True if an answer that the verdict calls good is wrong.</summary>
        public bool IsWrong => Worst > Wrong;

        public static Told Of(VerdictMatch match, Scene scene)
        {
            MatchFitResult fit = new MatchFit(scene).Find(match.Track);
            bool launches = fit.GoodFor.HasFlag(MatchAnswers.Launches);
            bool spins = fit.GoodFor.HasFlag(MatchAnswers.Spins);
            List<double> velocity = [];
            List<double> spin = [];
            (double Off, string Name) worst = (0, "");
            foreach (MatchPiece flight in fit.Pieces)
            {
                if (flight.Kind != MatchPieceKind.Flight || flight.Points < LeastPoints || flight.Duration < Shortest || match.Errors(flight) is not { } errors)
                {
                    continue;
                }

                for (int axis = 0; axis < 3; axis++)
                {
                    double ofVelocity = Math.Abs(errors[axis]) / flight.VelocityDeviation.Along(axis);
                    double ofSpin = Math.Abs(errors[3 + axis]) / flight.SpinDeviation.Along(axis);
                    worst = launches ? Worse(worst, ofVelocity, "velocity", flight) : worst;
                    worst = spins ? Worse(worst, ofSpin, "spin", flight) : worst;
                    velocity.AddRange(flight.VelocityDeviation.Along(axis) <= MostVelocity ? [ofVelocity] : []);
                    spin.AddRange(flight.SpinDeviation.Along(axis) <= MostSpin ? [ofSpin] : []);
                }
            }

            worst = fit.GoodFor.HasFlag(MatchAnswers.WindAndDrag) ? OfShared(match, fit, worst) : worst;
            return new Told(match, launches, spins, [.. velocity], [.. spin], worst.Off, worst.Name, fit.Rms / (Math.Sqrt(3) * fit.Noise));
        }

        private static (double Off, string Name) Worse((double Off, string Name) worst, double off, string answer, MatchPiece flight) =>
            off > worst.Off ? (off, FormattableString.Invariant($"the {answer} of the flight at {flight.StartTime:0.00} s")) : worst;

        /// <summary>Returns the largest error, also of the wind, and of the drag if it is the library's. A track that is turned has no single wind.</summary>
        private static (double Off, string Name) OfShared(VerdictMatch match, MatchFitResult fit, (double Off, string Name) worst)
        {
            for (int i = 0; i < fit.Names.Count; i++)
            {
                double? right = fit.Names[i] switch
                {
                    "wind.x" when double.IsInfinity(match.TurnedFrom) => match.Wind.X / match.Clock,
                    "wind.z" when double.IsInfinity(match.TurnedFrom) => match.Wind.Z / match.Clock,
                    "drag" when !match.IsForeign && match.Fault is (TrackFault.None or TrackFault.Lines or TrackFault.Held or TrackFault.Turned) => 1,
                    _ => null,
                };
                double off = right is { } value ? Math.Abs(fit.Value(i) - value) / fit.StandardError(i) : 0;
                worst = off > worst.Off ? (off, fit.Names[i]) : worst;
            }

            return worst;
        }
    }
}
