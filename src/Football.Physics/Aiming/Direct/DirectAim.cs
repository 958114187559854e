using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>The library's solver for one target: Newton's method on the crossing of the target's plane, usually with one flight.</summary>
/// <remarks>
/// If Newton's method fails, leaves the bounds or hits the ground, a search over all elevations finds the closest approach. The closest approach is either a hit, or
/// shows that no kick hits.
/// </remarks>
internal sealed class DirectAim
{
    /// <summary>The error of the solver's own steps, in m; a miss that exceeds the tolerance by less excludes nothing.</summary>
    private const double StepError = 1e-4;

    /// <summary>The miss that counts as close, as a share of the distance, and the slope above which a target is steep.</summary>
    private const double CloseMiss = 0.001;
    private const double Steep = 1.2;

    /// <summary>The relative accuracy of the speed of the slowest roll.</summary>
    private const double RollWidth = 1e-4;

    /// <summary>The number of slower and slower rolls in wind or on a slope, and the difference of their speeds, as a logarithm.</summary>
    private const int SlowerRolls = 16;
    private const double SlowerRoll = 0.2;

    /// <summary>The share of the slowest speed that hits, below which no slower roll is tried.</summary>
    private const double TooSlow = 0.6;

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

    /// <summary>Finds a kick with a speed, an arc and spins that may differ from the request's.</summary>
    public AimSolution Find(AimRequest request, double speed, AimArc arc, double top, double side)
    {
        // 1. Apply Newton's method to the plane crossing. 2. On bent paths, also try the steeper kick, which may arrive first. 3. In wind or for a
        // moving target, search over the time of flight, which finds the same hits as a scan of all directions (4) at a quarter of the cost. 5. Search
        // over the elevation. 6. If the result is inconclusive, search over the time of flight: without this step, known kicks in still air are lost
        // on both arcs. 7. Return the closest kick. (football lab answers --only known --count 300, and --only verdicts)
        _problem.Set(request, speed, top, side);
        ref readonly TargetFrame frame = ref _problem.Frame;
        bool separates = _context.Turns(request.TargetVelocity);
        if (arc == AimArc.Low && Newton(out AimSolution solution))
        {
            if (!separates || !IsBent(in frame))
            {
                return solution;
            }

            // On bent paths, the steep kick may arrive first. The kick that arrives first is the low arc.
            Approach steeper = _closest.Find(_problem, AimArc.High);
            return steeper.Miss <= _problem.HitMiss && steeper.Time < solution.Time ? Solution(in steeper, AimReason.Hit) : solution;
        }

        // If no flights are left, return a kick straight at the target.
        if (_context.IsSpent)
        {
            return new AimSolution
            {
                Reason = AimReason.NoneFound,
                Kick = frame.Turned(_problem.Spins, frame.Target - frame.From, _problem.Bounds),
                Forward = frame.Forward,
                Speed = speed,
                Miss = frame.Distance,
            };
        }

        // If elevation and azimuth are coupled, search over the time of flight; otherwise, search over the elevation.
        if (!separates && frame.Distance >= 1e-6 && _general.WithSpeed(request, speed, arc, top, side, out AimSolution hit))
        {
            return hit;
        }

        if (!separates && _context.Shooting.CanRoll(request) && _general.Roll(request, speed, top, side, isThorough: true, out hit))
        {
            return hit;
        }

        Approach found = _closest.Find(_problem, arc);
        bool hits = found.Miss <= _problem.HitMiss;
        if (!hits && IsDoubtful(in frame, found.Miss)
            && (separates ? _general.WithSpeed(request, speed, arc, top, side, out hit) : _general.From(request, speed, found.Kick, found.Time, out hit)))
        {
            return hit;
        }

        if (separates && hits && IsBent(in frame))
        {
            Approach other = _closest.Find(_problem, arc == AimArc.Low ? AimArc.High : AimArc.Low);
            bool isBetter = other.Miss <= _problem.HitMiss && (arc == AimArc.Low ? other.Time < found.Time : other.Time > found.Time);
            found = isBetter ? other : found;
        }

        // If the target is straight above or below, only the elevation matters. If it is at the ball, there is no direction.
        return Solution(
            in found,
            found.Miss <= request.Tolerance ? AimReason.Hit
                : frame.IsDegenerate ? AimReason.NoDirection
                : hits ? AimReason.NoneFound
                : Excluding(request, in frame, in found));
    }

    /// <summary>Finds the slowest kick along the ground that reaches the target.</summary>
    public bool SlowestRoll(AimRequest request, double fastest, out AimSolution solution)
    {
        // 1. In still air over level ground, a faster roll goes farther. Otherwise wind or slope may take a slow ball to the target but not a fast
        // one, so try slower and slower ones, down to a share of the slowest that hits. 2. Bisect between the slowest that hits and the next one.
        double low = 0;
        double high = double.PositiveInfinity;
        solution = default;
        Narrow(request, fastest, ref low, ref high, ref solution);
        for (int i = 1; i <= SlowerRolls && !_context.Turns(request.TargetVelocity) && !_context.IsHalfSpent; i++)
        {
            double speed = fastest * Elementary.Exp(-SlowerRoll * i);
            if (high <= fastest && speed < TooSlow * high)
            {
                break;
            }

            Narrow(request, speed, ref low, ref high, ref solution);
        }

        while (high <= fastest && high - low > RollWidth * high && !_context.IsSpent)
        {
            Narrow(request, 0.5 * (low + high), ref low, ref high, ref solution);
        }

        // Kick slightly faster, so that the ball passes the target instead of stopping at it.
        if (high <= fastest && Rolls(request, Math.Min((1.0 + RollWidth) * high, fastest), out AimSolution safe))
        {
            solution = safe;
        }

        return high <= fastest;
    }

    /// <summary>Tries a roll, and narrows the range that ends at the slowest roll that hits.</summary>
    private void Narrow(AimRequest request, double speed, ref double low, ref double high, ref AimSolution best)
    {
        if (Rolls(request, speed, out AimSolution roll))
        {
            low = low < speed ? low : 0;
            high = speed;
            best = roll;
        }
        else
        {
            low = Math.Max(low, speed);
        }
    }

    /// <summary>Finds the kick along the ground at a given speed that hits the target.</summary>
    public bool Rolls(AimRequest request, double speed, out AimSolution solution)
    {
        if (!_context.Turns(request.TargetVelocity))
        {
            return _general.Roll(request, speed, request.TopSpin, request.SideSpin, isThorough: speed == request.Speed, out solution);
        }

        _problem.Set(request, speed, request.TopSpin, request.SideSpin);
        Approach roll = _closest.Roll(_problem);
        solution = Solution(in roll, AimReason.Hit);
        return roll.Miss <= _problem.HitMiss;
    }

    private AimSolution Solution(in Approach found, AimReason reason) => new()
    {
        Reason = reason,
        Kick = found.Kick,
        Forward = _problem.Frame.Forward,
        Speed = _problem.Speed,
        Miss = found.Miss,
        Time = found.Time,
    };

    /// <summary>Finds the kick on the low arc by Newton's method.</summary>
    private bool Newton(out AimSolution solution)
    {
        solution = default;
        if (!(_problem.Frame.Distance >= 1e-6) || !_newton.Solve() || !_problem.StaysClear(_newton.X, _newton.R))
        {
            return false;
        }

        solution = new AimSolution
        {
            Reason = AimReason.Hit,
            Kick = _problem.KickOf(_newton.X),
            Forward = _problem.Frame.Forward,
            Speed = _problem.Speed,
            Miss = _newton.Miss,
            Arc = AimArc.Low,
            Time = _newton.Time,
        };
        return true;
    }

    /// <summary>Returns the bound that shows that no kick within the bounds hits: its energy, or the flights over all elevations.</summary>
    private AimReason Excluding(AimRequest request, in TargetFrame frame, in Approach found)
    {
        AimReason reason = new EnergyBound(_context, request).Reason;
        bool isExcluded = reason == AimReason.NoneFound && found.Miss > request.Tolerance + StepError && !IsBent(in frame) && _closest.IsOutOfReach();
        return !isExcluded ? reason : _closest.IsShort ? AimReason.TooShort : AimReason.BetweenBounds;
    }

    /// <summary>True if a miss from the elevation search is inconclusive, because it is close or the paths bend.</summary>
    private bool IsDoubtful(in TargetFrame frame, double miss) =>
        miss < CloseMiss * frame.Distance || IsBent(in frame);

    /// <summary>True if the steeper of two kicks may arrive first: at a steep target, or in air that bends paths into loops.</summary>
    private bool IsBent(in TargetFrame frame) =>
        frame.Target.Y - frame.From.Y > Steep * frame.Distance || _context.IsRuledByAir(_problem.Speed, _problem.Spins.SpinRate);
}
