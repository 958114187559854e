namespace FootballPhysics;

/// <summary>Ends a piece of a slide or a roll at the edge of a flat face, such as a face of a box.</summary>
/// <remarks>Beyond the edge, another tile may support the ball.</remarks>
internal static class FaceBorder
{
    /// <summary>The piece ends this share of its length beyond the edge, and at least this distance, m.</summary>
    /// <remarks>The next piece then starts beyond the edge.</remarks>
    private const double Beyond = 1e-9;
    private const double LeastBeyond = 1e-12;

    /// <summary>Minimum speed used to convert a distance to a time, m/s.</summary>
    private const double Slowest = 1e-6;

    /// <summary>Tolerance of the edge, as a share of the piece.</summary>
    private const double Width = 1e-13;

    private const int MostSteps = 60;

    /// <summary>Shortens a piece that ends beyond the edge of its face, so that it ends just beyond the edge.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="carrier">The carrier of the ball.</param>
    public static void EndBeyond<TSweep>(ref TSweep sweep, in BallState s, Collider carrier)
        where TSweep : struct, ISweep
    {
        double end = carrier.FaceMargin(sweep.Position, s.Time + sweep.Length);
        double start = carrier.FaceMargin(s.Position, s.Time);
        if (!(end < 0))
        {
            return;
        }

        // The margin is almost linear along the piece.
        double length = sweep.Length;
        var margin = new Margin<TSweep>(in sweep, carrier, s.Time);
        double x = start > LeastBeyond ? Roots.Illinois(ref margin, 0, start, length, end, Width * length, MostSteps) : 0;
        sweep = margin.Sweep;
        sweep.Step(Math.Min(length, x + Math.Max(Beyond * length, LeastBeyond / Math.Max(Slowest, sweep.Velocity.Length))));
    }

    /// <summary>Distance of the ball inside the border of the face.</summary>
    private struct Margin<TSweep>(in TSweep sweep, Collider carrier, double time) : IFunction
        where TSweep : struct, ISweep
    {
        /// <summary>The piece, with its count of evaluations.</summary>
        public TSweep Sweep = sweep;

        public bool Evaluate(double x, out double value)
        {
            Sweep.Step(x);
            value = carrier.FaceMargin(Sweep.Position, time + x);
            return Math.Abs(value) < LeastBeyond;
        }
    }
}
