namespace FootballPhysics.Labs.Play;

/// <summary>Counts the pieces of simulated minutes that a fit finds, and the share of true values within its uncertainty.</summary>
internal sealed class SyntheticCheck
{
    /// <summary>Shorter flights are not counted, s.</summary>
    private const double Shortest = 0.3;

    /// <summary>A flight is found if the overlap of both intervals exceeds this share of their union. A flight begins up to a frame before its first point.</summary>
    private const double Overlap = 0.8;
    private const double Frame = SyntheticMatch.Interval;

    /// <summary>A hop that rises by no more than this many standard deviations of a point cannot be distinguished from rolling.</summary>
    private const double RiseShare = 5;

    /// <summary>An event is found if its time is within this error, s.</summary>
    private const double EventError = 0.05;

    /// <summary>Six numbers are in a joint 95 % box if each is within this many standard deviations.</summary>
    private const double Box = 2.631;

    private const double One = 1.96;

    /// <summary>Pairs of counts: flights and those found, impacts, launches and those within the uncertainty, numbers of the track's fit and those within 1.96 standard deviations.</summary>
    public LabCounts Counts { get; } = new();

    public double Squares { get; private set; }

    public void Run(SyntheticMatch match)
    {
        MatchFitResult fit = new MatchFit(SyntheticMatch.Known).Find([.. match.Seen], new MatchFitRequest { Crisis = false });
        Squares += fit.Rms * fit.Rms;
        CountFlights(match, fit);
        CountNumbers(match, fit);
    }

    private void CountFlights(SyntheticMatch match, MatchFitResult fit)
    {
        MatchPiece[] flights = [.. fit.Pieces.Where(piece => piece.Kind == MatchPieceKind.Flight)];
        double from = 0;
        foreach ((double time, bool impact) in match.Events.Append((match.Truth[^1].Time, false)))
        {
            double first = from;
            from = time;

            // Require a flight that is airborne and visible throughout: a gap or a seam splits it in two.
            bool flies = time - first >= Shortest && match.Truth.Where(ball => ball.Time > first + 1e-9 && ball.Time < time - 1e-9).All(ball => ball.Motion == MotionState.Airborne);
            bool isSeen = !match.Gaps.Exists(gap => gap.From < time && gap.To > first) && !Array.Exists(match.Seams, seam => seam > first && seam < time);
            double rise = match.Truth.Where(ball => ball.Time > first && ball.Time < time).Select(ball => ball.Position.Y).DefaultIfEmpty().Max()
                - Math.Max(match.Truth.Last(ball => ball.Time <= first + 1e-9).Position.Y, match.Truth.Last(ball => ball.Time <= time + 1e-9).Position.Y);
            bool isDistinct = !impact || rise > RiseShare * match.Noise;
            if (!flies || !isSeen || !isDistinct)
            {
                continue;
            }

            Counts.Add("flights");
            MatchPiece? found = Array.Find(flights, piece => Math.Min(piece.EndTime + Frame, time) - Math.Max(piece.StartTime - Frame, first) > Overlap * (Math.Max(piece.EndTime, time) - Math.Min(piece.StartTime, first)));
            Counts.AddIf(found is not null, "flights found");
            if (impact && time < match.Truth[^1].Time)
            {
                Counts.Add("impacts");
                Counts.AddIf(fit.Pieces.Any(piece => piece.Kind == MatchPieceKind.Impact && Math.Abs(piece.StartTime - time) < EventError), "impacts found");
            }

            if (found is not null)
            {
                (Vector3d velocity, Vector3d spin) = TruthAt(match, found.StartTime, first);
                Counts.Add("launches");
                Counts.AddIf(IsWithin(velocity - found.Velocity, found.VelocityDeviation) && IsWithin(spin - found.Spin, found.SpinDeviation), "launches within");
            }
        }
    }

    /// <summary>Returns the true velocity and spin at the start of a found flight. If the fit starts a frame too early, the truth is extrapolated to that time.</summary>
    private static (Vector3d Velocity, Vector3d Spin) TruthAt(SyntheticMatch match, double time, double first)
    {
        int at = match.Truth.FindIndex(ball => ball.Time > Math.Max(time - 1e-6, first));
        BallState next = match.Truth[at];
        BallState second = match.Truth[Math.Min(match.Truth.Count - 1, at + 1)];
        Vector3d acceleration = (second.Velocity - next.Velocity) / SyntheticMatch.Interval;
        return (next.Velocity - ((next.Time - time) * acceleration), next.Spin);
    }

    private void CountNumbers(SyntheticMatch match, MatchFitResult fit)
    {
        for (int i = 0; i < fit.Names.Count; i++)
        {
            double? truth = fit.Names[i] switch
            {
                "wind.x" => match.Wind.X,
                "wind.z" => match.Wind.Z,
                "drag" => match.Drag,
                _ => null,
            };
            if (truth is { } number)
            {
                Counts.Add("numbers");
                Counts.AddIf(Math.Abs(fit.Value(i) - number) <= One * fit.StandardError(i), "numbers within");
            }
        }
    }

    private static bool IsWithin(Vector3d off, Vector3d deviation) =>
        Math.Abs(off.X) <= Box * deviation.X && Math.Abs(off.Y) <= Box * deviation.Y && Math.Abs(off.Z) <= Box * deviation.Z;
}
