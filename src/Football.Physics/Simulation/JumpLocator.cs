using FootballPhysics.Integration;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>A sweep that also tracks the surfaces at which the drag law jumps.</summary>
internal interface IFlowSweep : ISweep
{
    /// <summary>The surface functions at the start.</summary>
    DragJump StartJump { get; }

    /// <summary>The rates of the surface functions at the start.</summary>
    DragJump StartJumpRate { get; }

    /// <summary>The surface functions at the end.</summary>
    DragJump EndJump { get; }

    /// <summary>Returns the rates of the surface functions at the end; one evaluation.</summary>
    DragJump EndJumpRate();
}

/// <summary>Ends a step where it crosses the jump in the drag law.</summary>
internal static class JumpLocator
{
    /// <summary>The longest correction, as a fraction of the step. A longer one means a grazing crossing: the interpolated time is kept.</summary>
    private const double Longest = 0.25;

    /// <summary>Shortens a step, locked to one branch, to its first crossing.</summary>
    /// <returns>False if the step does not cross a surface.</returns>
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

        // Refine the interpolated time by Newton's method on the step itself.
        EventLocator.Locate(ref sweep, new Crossing<TSweep>(bySpeed, Longest * h), fraction * h);
        return true;
    }

    /// <summary>The event function of the crossed surface.</summary>
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

            // Choose the sign so that the function is positive before the crossing, from either side; the correction is Newton's −f/f'.
            value = rate > 0 ? -function : function;
            correction = -function / rate;
            if (!(Math.Abs(correction) < _longest))
            {
                return true;
            }

            // The remainder is small enough to move the end without repeating the step.
            bool isClose = Math.Abs(correction) <= EventLocator.Negligible;
            if (isClose && tau + correction > 0)
            {
                sweep.Nudge(correction);
            }

            return isClose;
        }
    }
}
