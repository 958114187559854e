namespace Football.Physics;

/// <summary>Ends a step where it crosses the drag law's jump.</summary>
internal static class JumpLocator
{
    /// <summary>Below this correction, s, a linear one is exact to rounding.</summary>
    private const double Negligible = 1e-6;

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
        double tau = fraction * h;
        for (int i = 0; i < 4; i++)
        {
            sweep.Step(tau);
            DragJump at = sweep.EndJump;
            DragJump rate = sweep.EndJumpRate();
            double correction = bySpeed ? -at.Speed / rate.Speed : -at.Spin / rate.Spin;
            if (!(Math.Abs(correction) < 0.25 * h))
            {
                break;
            }

            if (Math.Abs(correction) <= Negligible || i == 3)
            {
                if (tau + correction > 0)
                {
                    sweep.Nudge(correction);
                }

                break;
            }

            tau = Math.Min(Math.Max(tau + correction, 0), h);
        }

        return true;
    }
}
