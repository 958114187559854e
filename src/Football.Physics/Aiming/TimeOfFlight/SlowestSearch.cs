namespace Football.Physics;

/// <summary>The slowest kick that hits a target: the least speed over the time, or the kick on the bounds.</summary>
internal sealed class SlowestSearch
{
    private const int MostSteps = 16;

    private readonly AimContext _context;
    private readonly SpeedOverTime _speeds;
    private readonly LeastSpeed _least;
    private readonly TimedHits _hits;
    private readonly SlowestNewton _newton;
    private readonly CurveSearch _curves;

    public SlowestSearch(AimContext context, CurveSearch curves)
    {
        _context = context;
        _speeds = new SpeedOverTime(context.TimedFlight);
        _least = new LeastSpeed(_speeds);
        _hits = new TimedHits(context);
        _newton = new SlowestNewton(context.TimedFlight, _hits);
        _curves = curves;
    }

    /// <summary>The slowest kick that hits the target, in flight or along the ground.</summary>
    /// <param name="request">What it is to do; its speed is the fastest allowed.</param>
    /// <param name="solution">The kick.</param>
    /// <returns>Whether there is one, measured.</returns>
    public bool Find(AimRequest request, out AimSolution solution)
    {
        _context.TimedFlight.Set(request, request.TopSpin, request.SideSpin);
        bool flies = _newton.Find(_context.Upward, out solution) || Find(_context.TimedFlight, request.Speed, out solution);
        if (_context.TimedFlight.IsRuledByAir && _curves.Slowest(request, out AimSolution other) && (!flies || other.Speed < solution.Speed))
        {
            solution = other;
            flies = true;
        }

        _context.TimedRoll.Set(request, request.TopSpin, request.SideSpin);
        if (_context.TimedRoll.CanHit && Find(_context.TimedRoll, flies ? solution.Speed : request.Speed, out AimSolution rolling))
        {
            solution = rolling;
            return true;
        }

        return flies;
    }

    private bool Find(TimedProblem problem, double fastest, out AimSolution solution)
    {
        solution = default;
        solution.Speed = fastest;
        _speeds.Begin(problem, fastest, _context.Upward);
        _speeds.Shorten(fastest);
        _speeds.Lengthen(fastest);
        return SlowestOfRow(problem, ref solution) | (_speeds.Cross(solution.Speed) && SlowestOfRow(problem, ref solution));
    }

    private bool SlowestOfRow(TimedProblem problem, ref AimSolution solution)
    {
        bool found = false;

        // Either slower than its neighbours, or on the bounds.
        for (int i = 0; i < _speeds.Count; i++)
        {
            if (_speeds.IsBottom(i) && (MayKeep(problem, i, i - 1) || MayKeep(problem, i, i + 1)))
            {
                i = _least.WithWaves(_least.At(i, enough: -1));
                found |= Take(problem, _speeds[i], ref solution);
            }
        }

        for (int i = 1; i < _speeds.Count; i++)
        {
            if (_speeds[i - 1].Found && _speeds[i].Found && Math.Min(_speeds[i - 1].Speed, _speeds[i].Speed) < solution.Speed)
            {
                found |= AtBounds(problem, _speeds[i - 1], _speeds[i], ref solution);
            }
        }

        for (int i = 0; i < _speeds.Count && !found; i++)
        {
            found = Take(problem, _speeds[i], ref solution);
        }

        return found;
    }

    /// <summary>Whether a kick of the row or one next to it keeps to the bounds, or may between them.</summary>
    private bool MayKeep(TimedProblem problem, int at, int next)
    {
        bool known = next >= 0 && next < _speeds.Count && _speeds[next].Found;
        return Keeps(problem, at) || (known && (Keeps(problem, next) || problem.PassesBounds(_speeds[at], _speeds[next], out _)));
    }

    private bool Keeps(TimedProblem problem, int at) => problem.Violation(_speeds[at]) <= TimedHits.OffBounds;

    /// <summary>Takes a kick for the slowest, if it is slower than that and hits.</summary>
    private bool Take(TimedProblem problem, in TimedKick kick, ref AimSolution slowest)
    {
        if (!TimedHits.IsAllowed(problem, in kick, slowest.Speed) || !_hits.IsHit(problem, in kick, Math.Min(kick.Speed, slowest.Speed), out AimSolution hit))
        {
            return false;
        }

        slowest = hit;
        return true;
    }

    /// <summary>The kicks on the bounds between two of which one lies within them, or that lie on either side of them.</summary>
    private bool AtBounds(TimedProblem problem, in TimedKick one, in TimedKick other, ref AimSolution slowest)
    {
        double atOne = problem.Violation(in one);
        double atOther = problem.Violation(in other);
        if (atOne > TimedHits.OffBounds && atOther > TimedHits.OffBounds)
        {
            return Within(problem, one, other, out TimedKick within)
                && (Take(problem, in within, ref slowest) | AtBounds(problem, in one, in within, ref slowest) | AtBounds(problem, in within, in other, ref slowest));
        }

        if (atOne > TimedHits.OffBounds == atOther > TimedHits.OffBounds)
        {
            return false;
        }

        var violation = new ViolationOverTime(_speeds, in one, in other);
        TimedHits.Illinois(ref violation, one.Time, atOne, other.Time, atOther);
        return Take(problem, violation.Last, ref slowest);
    }

    /// <summary>A kick within the bounds, between two that lie on either side of them.</summary>
    private bool Within(TimedProblem problem, TimedKick one, TimedKick other, out TimedKick within)
    {
        within = default;
        for (int k = 0; k < MostSteps; k++)
        {
            if (!problem.PassesBounds(in one, in other, out double time))
            {
                return false;
            }

            within = (Math.Abs(time - one.Time) < Math.Abs(time - other.Time) ? one : other).At(time);
            if (!problem.Solve(ref within))
            {
                return false;
            }

            if (problem.Violation(in within) <= TimedHits.OffBounds)
            {
                return true;
            }

            if (problem.PassesBounds(in one, in within, out _))
            {
                other = within;
            }
            else
            {
                one = within;
            }
        }

        return false;
    }

    /// <summary>By how much kicks violate their bounds, over their time.</summary>
    private struct ViolationOverTime : IFunction
    {
        private readonly SpeedOverTime _speeds;
        private TimedKick _one;
        private TimedKick _other;
        private readonly bool _oneViolates;

        public ViolationOverTime(SpeedOverTime speeds, in TimedKick one, in TimedKick other)
        {
            _speeds = speeds;
            _one = one;
            _other = other;
            _oneViolates = speeds.Problem.Violation(in one) > 0;
            Last = _oneViolates ? other : one;
            Ends = true;
        }

        /// <summary>The last kick within the bounds.</summary>
        public TimedKick Last { get; private set; }

        public bool Ends { get; private set; }

        public bool Evaluate(double x, out double value)
        {
            TimedKick kick = (Math.Abs(x - _one.Time) < Math.Abs(x - _other.Time) ? _one : _other).At(x);
            if (!_speeds.Problem.Solve(ref kick))
            {
                value = double.NaN;
                return true;
            }

            value = _speeds.Problem.Violation(in kick);
            Last = value <= TimedHits.OffBounds ? kick : Last;
            if (value > 0 == _oneViolates)
            {
                _one = kick;
            }
            else
            {
                _other = kick;
            }

            return Math.Abs(value) <= TimedHits.OffBounds;
        }
    }
}
