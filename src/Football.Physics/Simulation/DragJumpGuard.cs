using System.Runtime.CompilerServices;
using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.State;

namespace FootballPhysics.Simulation;

/// <summary>Locates the jumps in the published drag law.</summary>
/// <remarks>
/// A piece is locked to one branch of the law and ends when it crosses a surface of the jump. From there, the branch that leads away from
/// the surface is used (Filippov).
/// </remarks>
internal sealed class DragJumpGuard
{
    /// <summary>Relative rounding error of a rate across a surface, as a share of its summands.</summary>
    private const double Rounding = 1e-14;

    /// <summary>A ball is on a surface if the surface's function is below this, m²/s².</summary>
    private const double OnIt = 1e-6;

    /// <summary>A crossing within this share of a piece is identified with the crossing at the start of the piece.</summary>
    private const double AtStart = 1e-6;

    private readonly FlightSystem _flight;

    public DragJumpGuard(Surroundings around, bool locates)
    {
        _flight = new FlightSystem { Around = around };
        Acts = around.Air.Jumps && locates;
    }

    /// <summary>True if pieces end at the jump. If not, each piece uses the branch at its start.</summary>
    public bool Acts { get; }

    /// <summary>Ends a piece of flight at its first crossing, and returns the branch to use from there.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="run">The step.</param>
    /// <param name="next">The branch that holds at its end.</param>
    /// <returns>False if the piece must be repeated from its start on that branch.</returns>
    public bool EndAtCrossing<TSweep>(ref TSweep sweep, in BallState s, ref StepRun run, out DragBranch next)
        where TSweep : struct, IFlightSweep
    {
        DragBranch branch = s.Branch;
        next = branch;
        double h = sweep.Length;
        DragJump start = sweep.StartJump;
        DragJump startRate = sweep.StartJumpRate;
        DragJump end = sweep.EndJump;

        // No crossing is possible, or the step alternates between the branches and has used up its splits.
        if (run.Spent.Splits >= StepRun.MaximumSplits || !DragJump.MayCross(branch, in start, in startRate, in end, h))
        {
            return true;
        }

        run.Spent.Splits++;
        if (start.Branch != branch)
        {
            // The state is on the jump in the drag law, to within rounding: keep the branch only if the motion leads away from the jump.
            next = Resolve(s.Time, new Motion(s.Position, s.Velocity, s.Spin), in s, ref run);
            if (next != branch)
            {
                return false;
            }
        }

        // After the crossing, use the other branch, or slide along the surface. If the interpolant crosses no surface after all, keep the entire piece.
        if (JumpLocator.Locate(ref sweep, branch, in start, in startRate, h))
        {
            next = Resolve(s.Time + sweep.Length, sweep.EndMotion, in s, ref run);
        }

        return true;
    }

    /// <summary>Ends a piece that slides along a surface of the jump when one branch leads off it, or when it reaches the other
    /// surface.</summary>
    public DragBranch EndAlongSurface<TIntegrator>(
        ref MotionSweep<FlightSystem, TIntegrator> sweep, double time, in Motion from, ref StepRun run)
        where TIntegrator : struct, IMotionMethod
    {
        double h = sweep.Length;
        DragBranch along = sweep.System.Branch;
        if (run.Spent.Splits >= StepRun.MaximumSplits)
        {
            return along;
        }

        // The sliding mode ends when the jump's other function (speed or spin) reaches zero: find this time by the secant method.
        DragJump end = sweep.EndJump;
        double other = along == DragBranch.AlongCriticalSpeed ? end.Spin : end.Speed;
        if (other <= 0)
        {
            double start = along == DragBranch.AlongCriticalSpeed ? sweep.StartJump.Spin : sweep.StartJump.Speed;
            run.Spent.Splits++;
            sweep.Step(start > 0 ? h * start / (start - other) : 0);
            return DragBranch.NoSpin;
        }

        // The sliding mode lasts while the spinning branch's share is between 0 and 1.
        double share = sweep.System.SpinningShare(time + h, in sweep.Taken.End, out _, out _);
        run.Log.Evaluations += 2;
        if (share is >= 0 and <= 1)
        {
            return along;
        }

        // Outside this range, one branch leads off the surface: find the time when the share reaches its limit by the secant method.
        double startShare = sweep.System.SpinningShare(time, in from, out _, out _);
        run.Log.Evaluations += 2;
        run.Spent.Splits++;
        double limit = share > 1 ? 1 : 0;
        double fraction = startShare is > 0 and < 1 ? (limit - startShare) / (share - startShare) : 0;
        sweep.Step(fraction * h);
        return share > 1 ? DragBranch.Spinning : DragBranch.NoSpin;
    }

    /// <summary>Ends a piece on the ground at its crossing. From there, the other branch is used.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="branch">The branch of the piece; on return, the branch at its end.</param>
    /// <param name="run">The step.</param>
    public void EndAtCrossingOnGround<TSweep>(ref TSweep sweep, ref DragBranch branch, ref StepRun run)
        where TSweep : struct, IFlowSweep
    {
        if (!Acts || run.Spent.Splits >= StepRun.MaximumSplits)
        {
            return;
        }

        DragJump start = sweep.StartJump;
        DragJump startRate = sweep.StartJumpRate;
        DragJump end = sweep.EndJump;
        if (!DragJump.MayCross(branch, in start, in startRate, in end, sweep.Length))
        {
            return;
        }

        run.Spent.Splits++;
        EndAtCrossingOnGround(ref sweep, ref branch, in start, in startRate, in end);
    }

    [MethodImpl(MethodImplOptions.NoInlining)] // its copy of the sweep would be cleared in every piece
    private static void EndAtCrossingOnGround<TSweep>(ref TSweep sweep, ref DragBranch branch, in DragJump start, in DragJump startRate, in DragJump end)
        where TSweep : struct, IFlowSweep
    {
        // On the ground there is no sliding mode: from the crossing on, use the other branch. A piece that starts on a surface has already passed
        // that crossing, and may reach the other surface.
        TSweep whole = sweep;
        double h = sweep.Length;
        if (JumpLocator.Locate(ref sweep, branch, in start, in startRate, h) && (start.Branch == branch || sweep.Length > AtStart * h))
        {
            branch = branch == DragBranch.Spinning ? DragBranch.NoSpin : DragBranch.Spinning;
            return;
        }

        whole.Evaluations = sweep.Evaluations;
        sweep = whole;
        branch = end.Branch;
    }

    /// <summary>Returns the branch for a piece on a surface: the one that applies at its start.</summary>
    /// <remarks>Exactly on the jump it is the previous branch, unless that is unknown or a sliding mode.</remarks>
    public DragBranch OnSurface(DragBranch last, in Motion from)
    {
        if (!_flight.Around.Air.Jumps)
        {
            return last;
        }

        // Use the previous branch only on the jump. Elsewhere, a change of spin, such as the start of a roll, may have invalidated it.
        DragJump here = DragJump.At(in from, in _flight.Around.Wind, _flight.Around.Radius);
        bool known = Acts && (last is DragBranch.NoSpin or DragBranch.Spinning) && Math.Abs(here.Least) < OnIt;
        return known ? last : here.Branch;
    }

    /// <summary>Returns the branch of the drag law to use from a point on its jump.</summary>
    /// <param name="time">The time, s.</param>
    /// <param name="at">The point.</param>
    /// <param name="s">The ball before, with its branch and its nets.</param>
    /// <param name="run">The step.</param>
    private DragBranch Resolve(double time, in Motion at, in BallState s, ref StepRun run)
    {
        FlightSystem system = _flight;
        system.Nets = s.Nets;
        system.NetSides = s.NetSides;

        // Use the nearer of the two surfaces.
        DragJump here = system.JumpAt(in at);
        DragBranch along = here.NearerToSpeed ? DragBranch.AlongCriticalSpeed : DragBranch.AlongCriticalSpin;
        system.Branch = along;
        double share = system.SpinningShare(time, in at, out MotionRates spinning, out MotionRates noSpin);
        run.Log.Evaluations += 2;
        DragJump inside = system.JumpRate(in at, in spinning);
        DragJump outside = system.JumpRate(in at, in noSpin);
        double a = here.NearerToSpeed ? inside.Speed : inside.Spin;
        double b = here.NearerToSpeed ? outside.Speed : outside.Spin;

        // a and b are the rates at which the ball's state crosses the surface on the spinning and the non-spinning branch. If no force changes the
        // speed (lift alone), both are rounding errors, which must not start a sliding mode.
        double rounding = Rounding * system.JumpRateScale(in at, in spinning);

        // Filippov: slide if both branches lead back to the surface. If both lead to the same side, use the branch of that side; otherwise switch branches.
        return a < -rounding && b > rounding && share > 0 && share < 1 ? along
            : a > 0 && b > 0 ? DragBranch.Spinning
            : a < 0 && b < 0 ? DragBranch.NoSpin
            : s.Branch == DragBranch.Spinning ? DragBranch.NoSpin : DragBranch.Spinning;
    }
}
