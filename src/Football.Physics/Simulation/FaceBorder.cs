namespace FootballPhysics;

/// <summary>Ends a piece of a slide or a roll where the flat face under the ball ends: at the edge of a box, where another tile may carry the ball on.</summary>
internal static class FaceBorder
{
    /// <summary>The piece ends so far beyond the edge, as a share of its length, and at least this far, m: the next one finds the ball beyond it.</summary>
    private const double Beyond = 1e-9;
    private const double LeastBeyond = 1e-12;

    /// <summary>A ball that is slower than this, m/s, is taken for so fast.</summary>
    private const double Slowest = 1e-6;

    /// <summary>The edge is known to this, as a share of the piece.</summary>
    private const double Width = 1e-13;

    private const int MostSteps = 60;

    /// <summary>Shortens a piece that ends beyond the edge of the face that it began on, to just beyond the edge.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="carrier">What carries the ball.</param>
    public static void EndBeyond<TSweep>(ref TSweep sweep, in BallState s, Collider carrier)
        where TSweep : struct, ISweep
    {
        double end = carrier.FaceMargin(sweep.Position, s.Time + sweep.Length);
        double start = carrier.FaceMargin(s.Position, s.Time);
        if (!(end < 0))
        {
            return;
        }

        // The margin is all but linear along the piece.
        double length = sweep.Length;
        var margin = new Margin<TSweep>(in sweep, carrier, s.Time);
        double x = start > LeastBeyond ? Roots.Illinois(ref margin, 0, start, length, end, Width * length, MostSteps) : 0;
        sweep = margin.Sweep;
        sweep.Step(Math.Min(length, x + Math.Max(Beyond * length, LeastBeyond / Math.Max(Slowest, sweep.Velocity.Length))));
    }

    /// <summary>How far the ball is inside the border of the face.</summary>
    private struct Margin<TSweep>(in TSweep sweep, Collider carrier, double time) : IFunction
        where TSweep : struct, ISweep
    {
        /// <summary>The piece, with what it has evaluated.</summary>
        public TSweep Sweep = sweep;

        public bool Evaluate(double x, out double value)
        {
            Sweep.Step(x);
            value = carrier.FaceMargin(Sweep.Position, time + x);
            return Math.Abs(value) < LeastBeyond;
        }
    }
}
