namespace Football.Physics;

/// <summary>Ends a piece of a slide or a roll where the ground turns into something else.</summary>
internal static class SurfaceBorder
{
    /// <summary>How far a piece may go, s: half of what is narrowest, so that nothing is stepped over.</summary>
    public static double LongestPiece(Collider carrier, double speed, double h)
    {
        double most = 0.5 * carrier.LeastWidth;
        return speed * h > most ? most / speed : h;
    }

    /// <summary>Shortens a piece that ends on another surface than it began on, to just beyond the border.</summary>
    public static void EndBeyond<TSweep>(ref TSweep sweep, in BallState s, Collider carrier)
        where TSweep : struct, ISweep
    {
        if (double.IsPositiveInfinity(carrier.LeastWidth))
        {
            return;
        }

        int patch = carrier.PatchAt(s.Position);
        if (carrier.PatchAt(sweep.Position) == patch)
        {
            return;
        }

        double low = 0;
        double high = sweep.Length;
        for (double middle = 0.5 * high; middle > low && middle < high; middle = 0.5 * (low + high))
        {
            sweep.Step(middle);
            bool beyond = carrier.PatchAt(sweep.Position) != patch;
            low = beyond ? low : middle;
            high = beyond ? middle : high;
        }

        sweep.Step(high);
    }
}
