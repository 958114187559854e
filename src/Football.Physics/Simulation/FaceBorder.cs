using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Ends a piece of a slide or a roll at the edge of a flat face, such as a face of a box.</summary>
/// <remarks>Beyond the edge, another tile may support the ball.</remarks>
internal static class FaceBorder
{
    /// <summary>Shortens a piece that ends beyond the edge of its face, so that it ends just beyond the edge.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="carrier">The carrier of the ball.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void EndBeyond<TSweep>(ref TSweep sweep, in BallState s, Collider carrier)
        where TSweep : struct, ISweep
    {
        double end = carrier.FaceMargin(sweep.Position, s.Time + sweep.Length);
        double start = carrier.FaceMargin(s.Position, s.Time);
        if (!(end < 0))
        {
            return;
        }

        // Along the piece, the margin is almost linear.
        double length = sweep.Length;
        var margin = new Margin<TSweep>(in sweep, carrier, s.Time);
        double x = start > ContactTolerances.LeastBeyondEdge ? Roots.Illinois(ref margin, 0, start, length, end, ContactTolerances.EventWidth * length, EventLocator.MostSteps) : 0;
        sweep = margin.Sweep;
        sweep.Step(Math.Min(length, x + Math.Max(ContactTolerances.Beyond * length, ContactTolerances.LeastBeyondEdge / Math.Max(ContactTolerances.SlowestAtEdge, sweep.Velocity.Length))));
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
            return Math.Abs(value) < ContactTolerances.LeastBeyondEdge;
        }
    }
}
