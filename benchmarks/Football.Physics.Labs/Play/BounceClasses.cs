namespace FootballPhysics.Labs.Play;

/// <summary>The bounces of a match by the ball's speed along the ground: medians as measured, and as a surface returns the same balls.</summary>
internal static class BounceClasses
{
    /// <summary>Classes of the speed along the ground before an impact, m/s.</summary>
    private static readonly (double From, double To)[] Classes = [(0, 6), (6, 10), (10, 100)];

    /// <summary>Slower balls hop in the grass and do not count, m/s.</summary>
    private const double LeastApproach = 1.2;

    /// <summary>Returns the medians of the bounces of each non-empty class: first as measured, then by each surface.</summary>
    /// <param name="fit">The match.</param>
    /// <param name="grounds">The surfaces.</param>
    public static IEnumerable<BounceRow> Of(MatchFitResult fit, IReadOnlyList<(string Name, Ground Ground)> grounds)
    {
        foreach ((double from, double to) in Classes)
        {
            MatchPiece[] all = [.. fit.Pieces.Where(piece => piece.Kind == MatchPieceKind.Impact && piece.Restitution is not null && -piece.VelocityBefore.Y > LeastApproach && In(piece, from, to))];
            if (all.Length == 0)
            {
                continue;
            }

            Bounce[] seen = [.. all.Select(piece => new Bounce(piece.Restitution!.Value, piece.SpeedRetained, Friction(piece.VelocityBefore, piece.Velocity)))];
            yield return Row(from, to, null, seen, seen);
            foreach ((string name, Ground ground) in grounds)
            {
                var simulator = new Simulator(fit.Scene with { Ground = ground with { Height = 0 }, Forces = new ForceSet() });
                yield return Row(from, to, name, seen, [.. all.Select(piece => Made(simulator, piece, SpinOf(simulator, fit.Pieces, piece)))]);
            }
        }
    }

    public static double Median(IEnumerable<double> numbers)
    {
        double[] sorted = [.. numbers.Order()];
        return sorted.Length % 2 == 1 ? sorted[sorted.Length / 2] : 0.5 * (sorted[(sorted.Length / 2) - 1] + sorted[sorted.Length / 2]);
    }

    private static BounceRow Row(double from, double to, string? surface, Bounce[] seen, Bounce[] made) => new(
        to < 100 ? FormattableString.Invariant($"{from:0}–{to:0} m/s") : FormattableString.Invariant($"over {from:0} m/s"), surface, seen.Length,
        Medians(made), Medians(made.Zip(seen, (one, other) => new Bounce(one.Restitution - other.Restitution, one.Kept - other.Kept, one.Friction - other.Friction))));

    private static Bounce Medians(IEnumerable<Bounce> all) =>
        new(Median(all.Select(bounce => bounce.Restitution)), Median(all.Select(bounce => bounce.Kept)), Median(all.Select(bounce => bounce.Friction)));

    private static bool In(MatchPiece piece, double from, double to)
    {
        double along = Math.Sqrt(Square(piece.VelocityBefore));
        return along >= from && along < to;
    }

    private static double Square(Vector3d v) => (v.X * v.X) + (v.Z * v.Z);

    /// <summary>
    /// Returns the spin before an impact, which is that of the flight. After another impact the short flight hardly determines it. The spin is then computed
    /// from slip on the same surface by its law, at the measured velocity, Δω = n × Δv / r. A ball that gripped rolls.
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

    private static BallEvent Impact(Simulator simulator, MatchPiece piece, Vector3d spin) =>
        simulator.FirstImpact(new Vector3d(0, simulator.ContactHeight, 0), piece.VelocityBefore, spin, 0.002, 1);

    private static Bounce Made(Simulator simulator, MatchPiece piece, Vector3d spin)
    {
        Vector3d after = Impact(simulator, piece, spin).Velocity;
        Vector3d before = piece.VelocityBefore;
        double square = Square(before);
        return new Bounce(after.Y / -before.Y, square > 0 ? ((before.X * after.X) + (before.Z * after.Z)) / square : 1, Friction(before, after));
    }

    /// <summary>Returns the tangential impulse over the normal impulse.</summary>
    private static double Friction(Vector3d before, Vector3d after) => Math.Sqrt(Square(after - before)) / Math.Max(1e-9, after.Y - before.Y);
}

/// <summary>The results of a bounce: the restitution, the share of the tangential speed that remains, and the tangential impulse over the normal one.</summary>
/// <param name="Restitution">The normal speed after the bounce over that before.</param>
/// <param name="Kept">The tangential speed after the bounce over that before.</param>
/// <param name="Friction">The tangential impulse over the normal one.</param>
internal readonly record struct Bounce(double Restitution, double Kept, double Friction);

/// <summary>Medians of a class of bounces.</summary>
/// <param name="Class">The class, in words.</param>
/// <param name="Surface">The surface; null for the bounces as measured.</param>
/// <param name="Impacts">The number of bounces.</param>
/// <param name="Median">Medians.</param>
/// <param name="Off">The medians of the differences from the measurement, bounce by bounce.</param>
internal sealed record BounceRow(string Class, string? Surface, int Impacts, Bounce Median, Bounce Off);
