using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Ends a piece of a slide or a roll at the border between two materials of the ground.</summary>
internal static class SurfaceBorder
{
    /// <summary>Limits a piece to half the width of the narrowest patch, so that it cannot step over a patch, s.</summary>
    public static double LongestPiece(Collider carrier, double speed, double h)
    {
        double most = 0.5 * carrier.LeastWidth;
        return speed * h > most ? most / speed : h;
    }

    /// <summary>Shortens a piece that ends on another patch than it started on, so that it ends just beyond the border.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
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

        // Bisect the length of the piece, because the patch index has no slope.
        double low = 0;
        double high = sweep.Length;
        var beyond = new Beyond<TSweep>(in sweep, carrier, patch);
        Roots.Bisect(ref beyond, ref low, ref high, EventLocator.MostSteps);
        sweep = beyond.Sweep;
        sweep.Step(high);
    }

    /// <summary>True once the ball is on another patch.</summary>
    private struct Beyond<TSweep> : ICondition
        where TSweep : struct, ISweep
    {
        /// <summary>The piece, with its count of evaluations.</summary>
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
