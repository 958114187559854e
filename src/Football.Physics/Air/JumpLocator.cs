namespace FootballPhysics;

/// <summary>Ends a step where it crosses the drag law's jump.</summary>
internal static class JumpLocator
{
    /// <summary>A correction longer than this share of the step comes of a surface that is hardly crossed: the interpolant's instant stays.</summary>
    private const double Longest = 0.25;

    /// <summary>Shortens a step, locked to one branch, to its first crossing.</summary>
    /// <returns>False where it does not cross after all.</returns>
    public static bool Locate<TSweep>(ref TSweep sweep, DragBranch branch, in DragJump from, in DragJump fromRate, double h)
        where TSweep : struct, IFlowSweep
    {
        DragJump to = sweep.EndJump;
        DragJump toRate = sweep.EndJumpRate();
        double fraction = DragJump.FirstCrossing(branch, in from, in fromRate, in to, in toRate, h, out bool bySpeed);
        if (fraction > 1)
        {
            return false;
        }

        // From the interpolant to the step itself: Newton.
        EventLocator.Locate(ref sweep, new Crossing<TSweep>(bySpeed, Longest * h), fraction * h);
        return true;
    }

    /// <summary>The law's surface that is crossed.</summary>
    private readonly struct Crossing<TSweep> : IEventFunction<TSweep>
        where TSweep : struct, IFlowSweep
    {
        private readonly bool _bySpeed;
        private readonly double _longest;

        public Crossing(bool bySpeed, double longest)
        {
            _bySpeed = bySpeed;
            _longest = longest;
        }

        public bool Evaluate(ref TSweep sweep, double tau, out double value, out double correction)
        {
            DragJump at = sweep.EndJump;
            DragJump rates = sweep.EndJumpRate();
            double function = _bySpeed ? at.Speed : at.Spin;
            double rate = _bySpeed ? rates.Speed : rates.Spin;

            // Positive before the crossing from whichever side, and Newton's −f/f'.
            value = rate > 0 ? -function : function;
            correction = -function / rate;
            if (!(Math.Abs(correction) < _longest))
            {
                return true;
            }

            // So little is left that the end can be moved, and the step need not be taken again.
            bool isClose = Math.Abs(correction) <= EventLocator.Negligible;
            if (isClose && tau + correction > 0)
            {
                sweep.Nudge(correction);
            }

            return isClose;
        }
    }
}
