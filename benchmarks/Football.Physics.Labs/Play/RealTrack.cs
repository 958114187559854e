using Football.Scenarios.Input;
using Football.Tool.Fit;

namespace Football.Physics.Labs.Play;

/// <summary>The track of a real match, beside what balls and surfaces of the library would have done.</summary>
internal static class RealTrack
{
    /// <summary>Classes of the speed along the ground before an impact, m/s.</summary>
    private static readonly (double From, double To)[] Classes = [(0, 6), (6, 10), (10, 100)];

    private static readonly (string Name, BallProperties Ball)[] Balls =
    [
        ("generic", BallProperties.Tunnel), ("brazuca", BallProperties.Brazuca), ("trionda", BallProperties.Trionda), ("modern", BallProperties.Modern),
    ];

    private static readonly (string Name, Ground Ground)[] Grounds = [("dryTurf", Ground.Of(SurfaceMaterial.DryTurf)), ("wetTurf", Ground.Of(SurfaceMaterial.WetTurf)), ("matchTurf", Ground.Of(SurfaceMaterial.MatchTurf))];

    public static void Add(string file, double? altitude, LabTable flights, LabTable impacts, LabReport report, Action<string> said)
    {
        TrackPoint[] track;
        try
        {
            using FileStream stream = File.OpenRead(file);
            track = TrackReader.Read(stream, said);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new RefusedException("FILE", Quote.File(file), "a file that can be read");
        }

        Air air = altitude is { } metres ? Weather.AtAltitude(metres, 15, 0.5).ToAir() : new Air();
        string name = Path.GetFileName(file);
        MatchFitResult? last = null;
        foreach ((string ball, BallProperties properties) in Balls)
        {
            foreach (bool fitted in (bool[])[false, true])
            {
                // The ball as it ships, and with its drag fitted
                MatchFitResult fit = new MatchFit(new Scene { Ball = properties, Air = air, Ground = Ground.Of(SurfaceMaterial.MatchTurf) }).Find(track, new MatchFitRequest { Drag = fitted });
                flights.Add(name, ball, fitted ? "drag, wind, height" : "wind, height", fit.Flights, 100 * fit.Rms, 100 * fit.Covered, Value(fit, "drag"), fit.Scene.Ball.DragCurve.CriticalReynolds, Limit(fit, ball, fitted));
                last = fit;
            }
        }

        AddImpacts(name, last!, impacts, report);
        report.Notes.Add($"{name}: good for {MatchWriter.GoodFor(last!)}.");
    }

    private static string Limit(MatchFitResult fit, string ball, bool fitted) =>
        ball != "modern" || fit.Flights < 4 || fit.Noise > 0.005 ? "" : Verdict.Of(fit.Rms <= (fitted ? 0.03 : 0.06));

    private static double Value(MatchFitResult fit, string name)
    {
        int at = fit.Names.ToList().IndexOf(name);
        return at >= 0 ? fit.Value(at) : 1;
    }

    /// <summary>Medians of restitution and of what is kept along the ground, seen and by each surface for the same impacts.</summary>
    private static void AddImpacts(string file, MatchFitResult fit, LabTable table, LabReport report)
    {
        foreach ((double from, double to) in Classes)
        {
            MatchPiece[] all = [.. fit.Pieces.Where(piece => piece.Kind == MatchPieceKind.Impact && piece.Restitution is not null && -piece.VelocityBefore.Y > 1.2 && In(piece, from, to))];
            if (all.Length == 0)
            {
                continue;
            }

            double bounce = Median(all.Select(piece => piece.Restitution!.Value));
            double kept = Median(all.Select(piece => piece.Kept));
            table.Add(file, Text(from, to), "seen", all.Length, bounce, kept, null, null, "");
            foreach ((string name, Ground ground) in Grounds)
            {
                var simulator = new Simulator(fit.Scene with { Ground = ground with { Height = 0 }, Forces = new ForceSet() });
                (double Bounce, double Kept)[] made = [.. all.Select(piece => Bounce(simulator, piece, SpinOf(simulator, fit.Pieces, piece)))];
                double offBounce = Median(made.Zip(all, (shares, piece) => shares.Bounce - piece.Restitution!.Value));
                double offKept = Median(made.Zip(all, (shares, piece) => shares.Kept - piece.Kept));
                bool within = Math.Abs(offBounce) <= 0.05 && Math.Abs(offKept) <= 0.05;
                table.Add(
                    file, Text(from, to), name, all.Length, Median(made.Select(shares => shares.Bounce)), Median(made.Select(shares => shares.Kept)), offBounce, offKept,
                    name == "matchTurf" ? Verdict.Of(within) : "");
            }
        }
    }

    private static bool In(MatchPiece piece, double from, double to)
    {
        double along = Along(piece.VelocityBefore);
        return along >= from && along < to;
    }

    private static double Along(Vector3d v) => Math.Sqrt((v.X * v.X) + (v.Z * v.Z));

    /// <summary>
    /// The spin before an impact: that of the flight; after another impact, of whose short flight little is told, the one with which the same surface lets the ball slip there as far as
    /// its law says, at the velocity that was seen: Δω = n × Δv / r. A ball that gripped rolls.
    /// </summary>
    private static Vector3d SpinOf(Simulator simulator, IReadOnlyList<MatchPiece> pieces, MatchPiece piece)
    {
        int before = pieces.ToList().IndexOf(piece) - 1;
        while (before >= 0 && pieces[before].Kind is MatchPieceKind.Flight or MatchPieceKind.Lost)
        {
            before--;
        }

        if (before < 0 || pieces[before].Kind != MatchPieceKind.Impact)
        {
            return piece.SpinBefore;
        }

        BallEvent impact = Impact(simulator, pieces[before], SpinOf(simulator, pieces, pieces[before]));
        return impact.Spin + (Vector3d.Cross(Vector3d.Up, pieces[before].Velocity - impact.Velocity) / simulator.Scene.Ball.Radius);
    }

    private static BallEvent Impact(Simulator simulator, MatchPiece piece, Vector3d spin)
    {
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(0, simulator.ContactHeight, 0), piece.VelocityBefore, spin);
        simulator.Run(ref ball, 0.002, 1, StopAt.Impact, log);
        return log.Events[0];
    }

    private static (double Bounce, double Kept) Bounce(Simulator simulator, MatchPiece piece, Vector3d spin)
    {
        Vector3d after = Impact(simulator, piece, spin).Velocity;
        Vector3d before = piece.VelocityBefore;
        double square = (before.X * before.X) + (before.Z * before.Z);
        return (after.Y / -before.Y, square > 0 ? ((before.X * after.X) + (before.Z * after.Z)) / square : 1);
    }

    private static string Text(double from, double to) => to < 100 ? FormattableString.Invariant($"{from:0}–{to:0} m/s") : FormattableString.Invariant($"over {from:0} m/s");

    private static double Median(IEnumerable<double> numbers)
    {
        double[] sorted = [.. numbers.Order()];
        return sorted.Length % 2 == 1 ? sorted[sorted.Length / 2] : 0.5 * (sorted[(sorted.Length / 2) - 1] + sorted[sorted.Length / 2]);
    }
}
