namespace FootballPhysics;

/// <summary>Ends a piece of a slide or a roll where the ground turns into something else.</summary>
internal static class SurfaceBorder
{
    /// <summary>Halvings of a piece: down to the last bits of its length.</summary>
    private const int MostHalvings = 60;

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

        // Bisection of the piece's length: which surface is under the ball has no slope to follow.
        double low = 0;
        double high = sweep.Length;
        var beyond = new Beyond<TSweep>(in sweep, carrier, patch);
        Roots.Bisect(ref beyond, ref low, ref high, MostHalvings);
        sweep = beyond.Sweep;
        sweep.Step(high);
    }

    /// <summary>The ball is on another surface.</summary>
    private struct Beyond<TSweep> : ICondition
        where TSweep : struct, ISweep
    {
        /// <summary>The piece, with what it has evaluated.</summary>
        public TSweep Sweep;

        private readonly Collider _carrier;
        private readonly int _patch;

        public Beyond(in TSweep sweep, Collider carrier, int patch)
        {
            Sweep = sweep;
            _carrier = carrier;
            _patch = patch;
        }

        public bool Evaluate(double x, out bool holds)
        {
            Sweep.Step(x);
            holds = _carrier.PatchAt(Sweep.Position) != _patch;
            return false;
        }
    }
}
