namespace FootballPhysics;

/// <summary>
/// Watches the surfaces at which the published drag law jumps. A piece of motion is locked to one branch of the law; where it crosses a
/// surface it ends there, and the branch that leads away from the surface holds from then on (Filippov).
/// </summary>
internal sealed class DragJumpGuard
{
    /// <summary>A rate across a surface is not known to more than this share of the products that it is summed of.</summary>
    private const double Rounding = 1e-14;

    /// <summary>A ball nearer to a surface than this, by its functions, is on it but for rounding, m²/s².</summary>
    private const double OnIt = 1e-6;

    /// <summary>A crossing within this share of a piece is the one that it starts at.</summary>
    private const double AtStart = 1e-6;

    private readonly FlightSystem _flight;

    public DragJumpGuard(Surroundings around, bool locates)
    {
        _flight = new FlightSystem { Around = around };
        Acts = around.Air.Jumps && locates;
    }

    /// <summary>True when pieces end at the jump. Where they do not, each takes the branch that holds at its start.</summary>
    public bool Acts { get; }

    /// <summary>Ends a piece of flight at its first crossing, and says which branch holds from there.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="s">The ball at its start.</param>
    /// <param name="run">The step.</param>
    /// <param name="next">The branch that holds at its end.</param>
    /// <returns>False where the piece must be taken again, from its start, on that branch.</returns>
    public bool EndAtCrossing<TSweep>(ref TSweep sweep, in BallState s, ref StepRun run, out DragBranch next)
        where TSweep : struct, IFlightSweep
    {
        DragBranch branch = s.Branch;
        next = branch;
        double h = sweep.Length;
        DragJump start = sweep.StartJump;
        DragJump startRate = sweep.StartJumpRate;
        DragJump end = sweep.EndJump;

        // No crossing in sight; or the step chatters between the branches and has had its splits.
        if (run.Splits >= StepRun.MaximumSplits || !DragJump.MayCross(branch, in start, in startRate, in end, h))
        {
            return true;
        }

        run.Splits++;
        if (start.Branch != branch)
        {
            // On the surface to rounding. The branch of the step leads away from it only if the end is on that branch too.
            next = Resolve(s.Time, new Motion(s.Position, s.Velocity, s.Spin), in s, ref run);
            if (next != branch)
            {
                return false;
            }
        }

        // Where the interpolant crosses nothing after all, the whole piece stands.
        TSweep whole = sweep;
        if (!JumpLocator.Locate(ref sweep, branch, in start, in startRate, h))
        {
            whole.Evaluations = sweep.Evaluations;
            sweep = whole;
            return true;
        }

        // What holds from the crossing on: the other branch, or a slide along the surface.
        next = Resolve(s.Time + sweep.Length, sweep.EndMotion, in s, ref run);
        return true;
    }

    /// <summary>Ends a piece of flight along a surface where one branch alone leads off it, or where the other surface is met.</summary>
    public DragBranch EndAlongSurface<TIntegrator>(
        ref MotionSweep<FlightSystem, TIntegrator> sweep, double time, in Motion from, ref StepRun run)
        where TIntegrator : struct, IIntegrator
    {
        double h = sweep.Length;
        DragBranch along = sweep.System.Branch;
        if (run.Splits >= StepRun.MaximumSplits)
        {
            return along;
        }

        // The other surface is met: the sliding mode ends where its function reaches zero, by the secant.
        DragJump end = sweep.EndJump;
        double other = along == DragBranch.AlongCriticalSpeed ? end.Spin : end.Speed;
        if (other <= 0)
        {
            double start = along == DragBranch.AlongCriticalSpeed ? sweep.StartJump.Spin : sweep.StartJump.Speed;
            run.Splits++;
            sweep.Step(start > 0 ? h * start / (start - other) : 0);
            return DragBranch.NoSpin;
        }

        // The mode lasts as long as the share of the law with spin is between 0 and 1.
        double share = sweep.System.SpinningShare(time + h, in sweep.Taken.End, out _, out _);
        run.Log.Evaluations += 2;
        if (share is >= 0 and <= 1)
        {
            return along;
        }

        // Beyond that one law alone leads off the surface: from where the share reaches its limit, by the secant.
        double startShare = sweep.System.SpinningShare(time, in from, out _, out _);
        run.Log.Evaluations += 2;
        run.Splits++;
        double limit = share > 1 ? 1 : 0;
        double fraction = startShare is > 0 and < 1 ? (limit - startShare) / (share - startShare) : 0;
        sweep.Step(fraction * h);
        return share > 1 ? DragBranch.Spinning : DragBranch.NoSpin;
    }

    /// <summary>Ends a piece on the ground at its crossing; the other branch holds from there.</summary>
    /// <param name="sweep">The piece.</param>
    /// <param name="branch">The branch that it is locked to; then the one that holds at its end.</param>
    /// <param name="run">The step.</param>
    public void EndAtCrossingOnGround<TSweep>(ref TSweep sweep, ref DragBranch branch, ref StepRun run)
        where TSweep : struct, IFlowSweep
    {
        if (!Acts || run.Splits >= StepRun.MaximumSplits)
        {
            return;
        }

        DragJump start = sweep.StartJump;
        DragJump startRate = sweep.StartJumpRate;
        DragJump end = sweep.EndJump;
        double h = sweep.Length;
        if (!DragJump.MayCross(branch, in start, in startRate, in end, h))
        {
            return;
        }

        // On the ground no sliding mode is followed: from the crossing on the other branch holds. A piece that starts on a surface, but for rounding, has that crossing
        // behind it, and may meet the other surface.
        run.Splits++;
        TSweep whole = sweep;
        if (JumpLocator.Locate(ref sweep, branch, in start, in startRate, h) && (start.Branch == branch || sweep.Length > AtStart * h))
        {
            branch = branch == DragBranch.Spinning ? DragBranch.NoSpin : DragBranch.Spinning;
            return;
        }

        whole.Evaluations = sweep.Evaluations;
        sweep = whole;
        branch = end.Branch;
    }

    /// <summary>
    /// The branch that a piece on a surface is locked to: the one that holds at its start; on a surface of the jump the last one, unless that is not known or leads
    /// along the surface.
    /// </summary>
    public DragBranch OnSurface(DragBranch last, in Motion from)
    {
        if (!_flight.Around.Air.Jumps)
        {
            return last;
        }

        // Only there does the last piece know better; elsewhere a spin that became that of a roll may have left it behind.
        DragJump here = DragJump.At(in from, in _flight.Around.Wind, _flight.Around.Radius);
        bool known = Acts && (last is DragBranch.NoSpin or DragBranch.Spinning) && Math.Abs(here.Least) < OnIt;
        return known ? last : here.Branch;
    }

    /// <summary>Which branch of the drag law holds from a point on its jump on.</summary>
    /// <param name="time">When, s.</param>
    /// <param name="at">The point.</param>
    /// <param name="s">The ball before, with its branch and the nets that it is in.</param>
    /// <param name="run">The step.</param>
    private DragBranch Resolve(double time, in Motion at, in BallState s, ref StepRun run)
    {
        FlightSystem system = _flight;
        system.Nets = s.Nets;
        system.NetSides = s.NetSides;

        // Of the two surfaces the one that the ball is nearer to.
        DragJump here = system.JumpAt(in at);
        DragBranch along = here.NearerToSpeed ? DragBranch.AlongCriticalSpeed : DragBranch.AlongCriticalSpin;
        system.Branch = along;
        double share = system.SpinningShare(time, in at, out MotionRates spinning, out MotionRates noSpin);
        run.Log.Evaluations += 2;
        DragJump inside = system.JumpRate(in at, in spinning);
        DragJump outside = system.JumpRate(in at, in noSpin);
        double a = here.NearerToSpeed ? inside.Speed : inside.Spin;
        double b = here.NearerToSpeed ? outside.Speed : outside.Spin;

        // a: how the law with spin moves across the surface towards its own side; b: how the law without does. A ball whose speed nothing
        // changes (lift alone, no drag, no gravity) moves neither way: rates of rounding are no reason to follow the surface.
        double rounding = Rounding * system.JumpRateScale(in at, in spinning);

        // Filippov: where both laws push back onto the surface, along it; where both lead to one side, the law of that side; else the other than before.
        return a < -rounding && b > rounding && share > 0 && share < 1 ? along
            : a > 0 && b > 0 ? DragBranch.Spinning
            : a < 0 && b < 0 ? DragBranch.NoSpin
            : s.Branch == DragBranch.Spinning ? DragBranch.NoSpin : DragBranch.Spinning;
    }
}
