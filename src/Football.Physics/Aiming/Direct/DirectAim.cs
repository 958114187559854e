namespace FootballPhysics.Aiming;

/// <summary>
/// The library's own solver for one target: Newton's method on the crossing of the target's plane, which mostly takes one flight. Where
/// that fails, leaves the bounds or meets the ground, the closest approach over all elevations gives the hit, or the verdict that there is none.
/// </summary>
internal sealed class DirectAim
{
    /// <summary>Error of the solver's own steps, m: a closer miss counts as none, even where a request asks for more.</summary>
    private const double StepError = 1e-4;

    /// <summary>Share of the target's distance below which a miss is a close one, and the slope above which a target is steep.</summary>
    private const double CloseMiss = 0.001;
    private const double Steep = 1.2;

    /// <summary>Share of its speed within which a slowest roll is known.</summary>
    private const double RollWidth = 1e-4;

    private readonly PlaneProblem _problem;
    private readonly PlaneNewton _newton;
    private readonly AimContext _context;
    private readonly ClosestKick _closest;
    private readonly GeneralAim _general;

    public DirectAim(AimContext context, GeneralAim general)
    {
        _context = context;
        _general = general;
        _problem = new PlaneProblem(context);
        _newton = new PlaneNewton(_problem);
        _closest = new ClosestKick(context);
    }

    public AimSolution Find(AimRequest request) => Find(request, request.Speed, request.Arc, request.TopSpin, request.SideSpin);

    /// <summary>Finds a kick with a speed, on an arc and with spins other than the request's.</summary>
    public AimSolution Find(AimRequest request, double speed, AimArc arc, double top, double side)
    {
        // 1. Newton's method on the plane's crossing: mostly the answer, after one flight. 2. Where ways bend, the steeper kick may be there first.
        // 3. In wind, and for a moving target: by the time of flight, which costs a quarter of the flights that 4, a scan over all directions,
        // would take for the same hits. 5. Over the elevations: the hit, or the bound below which no kick comes. 6. Where those tell too little, by
        // the time of flight: without that known kicks in still air are lost on both arcs. 7. What is closest is the verdict.
        // (football lab answers --only known --count 300, and --only verdicts)
        _problem.Set(request, speed, top, side);
        ref readonly TargetFrame frame = ref _problem.Frame;
        bool separates = _context.Turns(request.TargetVelocity);
        if (arc == AimArc.Low && Newton(out AimSolution solution))
        {
            if (!separates || !IsBent(in frame))
            {
                return solution;
            }

            // Where ways bend the steep kick may be there first: the low arc is the one that is.
            Approach steeper = _closest.Find(_problem, AimArc.High);
            return steeper.Miss <= _problem.Tolerance && steeper.Time < solution.Time ? Solution(in steeper, AimStatus.Hit) : solution;
        }

        // No flight is left for a search: straight at the target, so that the answer is a kick at all.
        if (_context.IsSpent)
        {
            return new AimSolution
            {
                Status = AimStatus.NotConverged,
                Kick = frame.Turned(_problem.Spins, frame.Target - frame.From, _problem.Bounds),
                Forward = frame.Forward,
                Speed = speed,
                Miss = frame.Distance,
            };
        }

        // Where elevation and azimuth do not separate, by the time of flight; else by the elevation.
        if (!separates && frame.Distance >= 1e-6 && _general.WithSpeed(request, speed, arc, top, side, out AimSolution hit))
        {
            return hit;
        }

        Approach found = _closest.Find(_problem, arc);
        bool hits = found.Miss <= _problem.Tolerance;
        if (!hits && IsDoubtful(in frame, found.Miss)
            && (separates ? _general.WithSpeed(request, speed, arc, top, side, out hit) : _general.From(request, speed, found.Kick, found.Time, out hit)))
        {
            return hit;
        }

        if (separates && hits && IsBent(in frame))
        {
            Approach other = _closest.Find(_problem, arc == AimArc.Low ? AimArc.High : AimArc.Low);
            bool isBetter = other.Miss <= _problem.Tolerance && (arc == AimArc.Low ? other.Time < found.Time : other.Time > found.Time);
            found = isBetter ? other : found;
        }

        // Straight above or below only the elevation matters; at the ball there is no direction at all.
        return Solution(
            in found,
            found.Miss <= request.Tolerance ? AimStatus.Hit
                : frame.IsDegenerate ? AimStatus.Degenerate
                : found.Miss < StepError || _context.IsSpent ? AimStatus.NotConverged
                : AimStatus.OutOfReach);
    }

    /// <summary>The slowest kick along the ground: one that is a little slower stops short.</summary>
    public bool SlowestRoll(AimRequest request, double fastest, out AimSolution solution)
    {
        solution = default;
        double low = 0;
        double high = fastest;
        for (double speed = fastest; high - low > RollWidth * high && !_context.IsSpent; speed = 0.5 * (low + high))
        {
            // A bisection from the fastest on: where even that stops short there is none.
            bool hits = Rolls(request, speed, out _);
            if (!hits && speed == fastest)
            {
                return false;
            }

            (low, high) = hits ? (low, speed) : (speed, high);
        }

        // A little faster, so that it does not stop there but passes.
        return Rolls(request, Math.Min((1.0 + RollWidth) * high, fastest), out solution);
    }

    private bool Rolls(AimRequest request, double speed, out AimSolution solution)
    {
        _problem.Set(request, speed, request.TopSpin, request.SideSpin);
        Approach roll = _closest.Roll(_problem);
        solution = Solution(in roll, AimStatus.Hit);
        return roll.Miss <= _problem.Tolerance;
    }

    private AimSolution Solution(in Approach found, AimStatus status) => new()
    {
        Status = status,
        Kick = found.Kick,
        Forward = _problem.Frame.Forward,
        Speed = _problem.Speed,
        Miss = found.Miss,
        Time = found.Time,
    };

    /// <summary>The kick on the low arc by Newton's method.</summary>
    private bool Newton(out AimSolution solution)
    {
        solution = default;
        if (!(_problem.Frame.Distance >= 1e-6) || !_newton.Solve() || !_problem.StaysClear(_newton.X, _newton.R))
        {
            return false;
        }

        solution = new AimSolution
        {
            Status = AimStatus.Hit,
            Kick = _problem.KickOf(_newton.X),
            Forward = _problem.Frame.Forward,
            Speed = _problem.Speed,
            Miss = _newton.Miss,
            Arc = AimArc.Low,
            Time = _newton.Time,
        };
        return true;
    }

    /// <summary>True when elevations tell too little of a miss: a close one, or ways that bend.</summary>
    private bool IsDoubtful(in TargetFrame frame, double miss) =>
        miss < CloseMiss * frame.Distance || IsBent(in frame);

    /// <summary>True when the steeper of two kicks may be the faster: at a steep target, or in an air that bends ways into loops.</summary>
    private bool IsBent(in TargetFrame frame) =>
        frame.Target.Y - frame.From.Y > Steep * frame.Distance || _context.IsRuledByAir(_problem.Speed, _problem.Spins.SpinRate);
}
