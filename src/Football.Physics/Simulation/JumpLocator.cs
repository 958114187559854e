namespace Football.Physics;

/// <summary>Ends a step where it crosses the drag law's jump.</summary>
internal static class JumpLocator
{
    /// <summary>Below this correction, s, a linear one is exact to rounding.</summary>
    private const double Negligible = 1e-6;

    /// <summary>Shortens a step, locked to one branch, to its first crossing.</summary>
    /// <returns>False where it does not cross after all.</returns>
    public static bool Locate<TTrial>(ref TTrial trial, DragBranch branch, in DragJump from, in DragJump fromRate, double h)
        where TTrial : struct, ITrial
    {
        DragJump to = trial.EndJump;
        DragJump toRate = trial.EndJumpRate();
        double fraction = DragJump.FirstCrossing(branch, in from, in fromRate, in to, in toRate, h, out bool bySpeed);
        if (fraction > 1)
        {
            return false;
        }

        // From the interpolant to the step itself: Newton.
        double tau = fraction * h;
        for (int i = 0; i < 4; i++)
        {
            trial.Step(tau);
            DragJump at = trial.EndJump;
            DragJump rate = trial.EndJumpRate();
            double correction = bySpeed ? -at.Speed / rate.Speed : -at.Spin / rate.Spin;
            if (!(Math.Abs(correction) < 0.25 * h))
            {
                break;
            }

            if (Math.Abs(correction) <= Negligible || i == 3)
            {
                if (tau + correction > 0)
                {
                    trial.Nudge(correction);
                }

                break;
            }

            tau = Math.Min(Math.Max(tau + correction, 0), h);
        }

        return true;
    }
}
