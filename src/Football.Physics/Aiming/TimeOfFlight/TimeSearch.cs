namespace Football.Physics;

/// <summary>Searches over the time that a kick takes: the kick of a given speed on either arc, and the one for a given time.</summary>
internal sealed class TimeSearch
{
    /// <summary>Share of its time by which a kick takes longer than one next to it.</summary>
    private const double LittleLater = 0.003;

    private readonly AimContext _context;
    private readonly SpeedOverTime _speeds;
    private readonly LeastSpeed _least;
    private readonly TimedHits _hits;
    private readonly CurveSearch _curves;

    public TimeSearch(AimContext context, CurveSearch curves)
    {
        _context = context;
        _speeds = new SpeedOverTime(context.TimedFlight);
        _least = new LeastSpeed(_speeds);
        _hits = new TimedHits(context);
        _curves = curves;
    }

    /// <summary>The kick that a request asks for, in flight or along the ground; false where there is none.</summary>
    public bool WithSpeed(AimRequest request, out AimSolution solution) =>
        WithSpeed(request, request.Speed, request.Arc, request.TopSpin, request.SideSpin, out solution);

    /// <summary>The kick of a speed that hits the target, in flight or along the ground.</summary>
    /// <param name="request">What it is to do.</param>
    /// <param name="speed">Its speed, m/s.</param>
    /// <param name="arc">Which of two, if there are two within the bounds.</param>
    /// <param name="top">Its topspin, rad/s.</param>
    /// <param name="side">Its sidespin, rad/s.</param>
    /// <param name="solution">The kick.</param>
    /// <returns>Whether there is one, measured.</returns>
    public bool WithSpeed(AimRequest request, double speed, AimArc arc, double top, double side, out AimSolution solution)
    {
        _context.TimedFlight.Set(request, top, side);
        if (WithSpeed(_context.TimedFlight, speed, arc, out solution))
        {
            return true;
        }

        _context.TimedRoll.Set(request, top, side);
        return _context.TimedRoll.CanHit && WithSpeed(_context.TimedRoll, speed, arc, out solution);
    }

    /// <summary>The kick that is at the target at a time, in flight or along the ground.</summary>
    /// <param name="request">What it is to do; its speed is the fastest allowed.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="solution">The kick; where there is none within the bounds, what the bounds allow of the one that would be there.</param>
    /// <returns>False where no kick is known that comes near.</returns>
    public bool AtTime(AimRequest request, double time, out AimSolution solution)
    {
        TimedFlight flight = _context.TimedFlight;
        flight.Set(request, request.TopSpin, request.SideSpin);
        if (AtTime(flight, time, out TimedKick kick))
        {
            solution = TimedHits.Solution(flight, in kick, Math.Min(kick.Speed, request.Speed), AimStatus.Hit);
            return true;
        }

        TimedRoll roll = _context.TimedRoll;
        roll.Set(request, request.TopSpin, request.SideSpin);
        if (roll.CanHit && AtTime(roll, time, out TimedKick rolling))
        {
            solution = TimedHits.Solution(roll, in rolling, Math.Min(rolling.Speed, request.Speed), AimStatus.Hit);
            return true;
        }

        bool known = kick.Found || double.IsPositiveInfinity(kick.Speed);
        if ((!known || flight.IsRuledByAir || !_context.Scene.Air.IsStill) && _curves.AtTime(request, time, out solution))
        {
            return true;
        }

        solution = TimedHits.Solution(flight, in kick, Math.Min(kick.Velocity.Length, request.Speed), AimStatus.OutOfReach);
        return known;
    }

    /// <summary>On which arc a kick that hits a target is: whether one that takes longer is slower or faster.</summary>
    public AimArc ArcOf(AimRequest request, in AimSolution hit)
    {
        TimedFlight problem = _context.TimedFlight;
        problem.Set(request, hit.Kick.Top, hit.Kick.Side);
        TimedKick kick = problem.Guess(hit.Time);
        hit.Vectors(out kick.Velocity, out _);
        TimedKick later = kick;
        later.Time = hit.Time * (1.0 + LittleLater);
        return problem.Solve(ref kick) && problem.Solve(ref later) && later.Speed > kick.Speed ? AimArc.High : AimArc.Low;
    }

    private bool WithSpeed(TimedProblem problem, double speed, AimArc arc, out AimSolution solution)
    {
        bool low = arc == AimArc.Low;
        _speeds.Begin(problem, speed, _context.Upward);
        Spread(low, speed);
        if (HitBetween(speed, low, out solution))
        {
            return true;
        }

        Spread(!low, speed);
        return HitBetween(speed, low, out solution) || (Deepen(speed) && HitBetween(speed, low, out solution));
    }

    /// <summary>The kick for a time; false where there is none within the bounds.</summary>
    private bool AtTime(TimedProblem problem, double time, out TimedKick kick)
    {
        kick = problem.Guess(time);
        bool known = problem.Solve(ref kick);
        if (TimedHits.IsAllowed(problem, in kick, problem.Request.Speed))
        {
            return true;
        }

        // Far from the model there may be another.
        for (int start = 1; start <= TimedProblem.OtherStarts && (!known || problem.IsRuledByAir); start++)
        {
            TimedKick other = problem.Guess(time, start);
            bool found = problem.Solve(ref other);
            if (TimedHits.IsAllowed(problem, in other, problem.Request.Speed))
            {
                kick = other;
                return true;
            }

            kick = known ? kick : other;
            known |= found;
        }

        if (kick.Found && problem.Across(in kick, out TimedKick across) && problem.Solve(ref across) && TimedHits.IsAllowed(problem, in across, problem.Request.Speed))
        {
            kick = across;
            return true;
        }

        return false;
    }

    private void Spread(bool shorter, double fastest)
    {
        if (shorter)
        {
            _speeds.Shorten(fastest);
        }
        else
        {
            _speeds.Lengthen(fastest);
        }
    }

    /// <summary>A kick with a speed between two of the row, of which one is slower and one is faster.</summary>
    private bool HitBetween(double speed, bool lowFirst, out AimSolution solution)
    {
        for (int k = 1; k < _speeds.Count; k++)
        {
            int i = lowFirst ? k : _speeds.Count - k;
            TimedKick one = _speeds[i - 1];
            TimedKick other = _speeds[i];
            if (!(one.Speed > speed != other.Speed > speed) || double.IsNaN(one.Speed) || double.IsNaN(other.Speed))
            {
                continue;
            }

            var excess = new ExcessSpeed(_speeds, speed, in one, in other);
            TimedHits.Illinois(ref excess, one.Time, Finite(one.Speed - speed), other.Time, Finite(other.Speed - speed));
            if (excess.Hits && _hits.IsHit(_speeds.Problem, excess.Last, speed, out solution))
            {
                solution.Arc = one.Speed > speed ? AimArc.Low : AimArc.High;
                return true;
            }
        }

        solution = default;
        return false;
    }

    private static double Finite(double speed) => Math.Min(speed, Limits.Speed);

    /// <summary>Looks for a slower kick beside each that is slower than its neighbours.</summary>
    /// <returns>Whether one is slow enough.</returns>
    private bool Deepen(double speed)
    {
        for (int i = 1; i < _speeds.Count - 1; i++)
        {
            if (_speeds.IsBottom(i) && _speeds[i].Speed > speed)
            {
                int least = _least.At(i, enough: speed);
                if (_speeds[least].Speed <= speed || TimedHits.IsNearly(_speeds.Problem, _speeds[least], speed))
                {
                    return true;
                }
            }
        }

        return false;
    }

    /// <summary>How much faster than a speed kicks must be, over their time.</summary>
    private struct ExcessSpeed : IFunction
    {
        private readonly SpeedOverTime _speeds;
        private readonly double _speed;
        private TimedKick _one;
        private TimedKick _other;

        public ExcessSpeed(SpeedOverTime speeds, double speed, in TimedKick one, in TimedKick other)
        {
            _speeds = speeds;
            _speed = speed;
            _one = one;
            _other = other;
            Last = default;
            Hits = false;
        }

        public TimedKick Last { get; private set; }

        public bool Hits { get; private set; }

        public bool Evaluate(double x, out double value)
        {
            bool nearOne = _one.Found && (!_other.Found || Math.Abs(x - _one.Time) < Math.Abs(x - _other.Time));
            TimedKick kick = (nearOne ? _one : _other).At(x);
            if (!_speeds.Problem.Solve(ref kick) && !double.IsPositiveInfinity(kick.Speed))
            {
                value = double.NaN;
                return true;
            }

            Last = kick;
            value = Finite(kick.Speed - _speed);
            if (kick.Speed > _speed == _one.Speed > _speed)
            {
                _one = kick;
            }
            else
            {
                _other = kick;
            }

            Hits = Math.Abs(value) * kick.Time <= 0.1 * _speeds.Problem.Tolerance;
            return Hits;
        }
    }
}
