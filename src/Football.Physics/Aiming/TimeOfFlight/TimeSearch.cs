namespace Football.Physics;

/// <summary>Searches over the time that a kick takes: the kick of a given speed on either arc, the slowest, and the one for a given time.</summary>
internal sealed class TimeSearch
{
    /// <summary>Steps towards the least speed, and towards a root.</summary>
    private const int MostSteps = 12;
    private const int MostRootSteps = 16;

    /// <summary>How far apart, as shares of the time, and how many to each side, are looks for waves beside the slowest kick.</summary>
    private const double Wave = 0.04;
    private const int MostWaves = 3;

    /// <summary>Share of its time by which a kick takes longer than one next to it.</summary>
    private const double LittleLater = 0.003;

    /// <summary>How far, rad, a kick may be off its bounds: it is put on them then.</summary>
    private const double OffBounds = 1e-9;

    /// <summary>Share of its time within which the slowest kick is found.</summary>
    private const double TimeWidth = 2e-3;

    private readonly AimContext _context;
    private readonly SpeedOverTime _speeds;

    public TimeSearch(AimContext context)
    {
        _context = context;
        _speeds = new SpeedOverTime(context.TimedFlight);
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

    /// <summary>The slowest kick that hits the target, in flight or along the ground.</summary>
    /// <param name="request">What it is to do; its speed is the fastest allowed.</param>
    /// <param name="solution">The kick.</param>
    /// <returns>Whether there is one, measured.</returns>
    public bool Slowest(AimRequest request, out AimSolution solution)
    {
        _context.TimedFlight.Set(request, request.TopSpin, request.SideSpin);
        bool flies = Slowest(_context.TimedFlight, request.Speed, out solution);
        _context.TimedRoll.Set(request, request.TopSpin, request.SideSpin);
        if (_context.TimedRoll.CanHit && Slowest(_context.TimedRoll, flies ? solution.Speed : request.Speed, out AimSolution rolling))
        {
            solution = rolling;
            return true;
        }

        return flies;
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
            solution = Solution(flight, in kick, Math.Min(kick.Speed, request.Speed), AimStatus.Hit);
            return true;
        }

        TimedRoll roll = _context.TimedRoll;
        roll.Set(request, request.TopSpin, request.SideSpin);
        if (roll.CanHit && AtTime(roll, time, out TimedKick rolling))
        {
            solution = Solution(roll, in rolling, Math.Min(rolling.Speed, request.Speed), AimStatus.Hit);
            return true;
        }

        bool known = kick.Found || double.IsPositiveInfinity(kick.Speed);
        solution = Solution(flight, in kick, Math.Min(kick.Velocity.Length, request.Speed), AimStatus.OutOfReach);
        return known;
    }

    private bool WithSpeed(TimedProblem problem, double speed, AimArc arc, out AimSolution solution)
    {
        bool low = arc == AimArc.Low;
        for (int start = 0; start < Starts(problem); start++)
        {
            _speeds.Begin(problem, speed, _context.Upward, start);
            Spread(low, speed);
            if (HitBetween(speed, low, out solution))
            {
                return true;
            }

            Spread(!low, speed);
            if (HitBetween(speed, low, out solution) || (Deepen(speed) && HitBetween(speed, low, out solution)))
            {
                return true;
            }
        }

        solution = default;
        return false;
    }

    /// <summary>From how many first kicks to search: several where there are several kicks for a time.</summary>
    private static int Starts(TimedProblem problem) => problem.IsRuledByAir ? 1 + TimedProblem.OtherStarts : 1;

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

    /// <summary>The kick for a time; false where there is none within the bounds.</summary>
    private bool AtTime(TimedProblem problem, double time, out TimedKick kick)
    {
        kick = problem.Guess(time);
        bool known = problem.Solve(ref kick);
        if (IsAllowed(problem, in kick, problem.Request.Speed))
        {
            return true;
        }

        // Far from the model there may be another.
        for (int start = 1; start <= TimedProblem.OtherStarts && (!known || problem.IsRuledByAir); start++)
        {
            TimedKick other = problem.Guess(time, start);
            bool found = problem.Solve(ref other);
            if (IsAllowed(problem, in other, problem.Request.Speed))
            {
                kick = other;
                return true;
            }

            kick = known ? kick : other;
            known |= found;
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
            Illinois(ref excess, one.Time, Finite(one.Speed - speed), other.Time, Finite(other.Speed - speed));
            if (excess.Hits && IsHit(_speeds.Problem, excess.Last, speed, out solution))
            {
                solution.Arc = one.Speed > speed ? AimArc.Low : AimArc.High;
                return true;
            }
        }

        solution = default;
        return false;
    }

    private static double Finite(double speed) => Math.Min(speed, Limits.Speed);

    private static void Illinois<TFunction>(ref TFunction function, double low, double atLow, double high, double atHigh)
        where TFunction : struct, IFunction => Roots.Illinois(ref function, low, atLow, high, atHigh, 1e-12 * high, MostRootSteps);

    /// <summary>Looks for a slower kick beside each that is slower than its neighbours.</summary>
    /// <returns>Whether one is slow enough.</returns>
    private bool Deepen(double speed)
    {
        for (int i = 1; i < _speeds.Count - 1; i++)
        {
            if (_speeds[i].Speed <= _speeds[i - 1].Speed && _speeds[i].Speed <= _speeds[i + 1].Speed && _speeds[i].Speed > speed)
            {
                int least = Least(i, enough: speed);
                if (_speeds[least].Speed <= speed || IsNearly(_speeds.Problem, _speeds[least], speed))
                {
                    return true;
                }
            }
        }

        return false;
    }

    /// <summary>The slowest kick around one of the row, by successive parabolas.</summary>
    /// <param name="at">A kick that is no faster than its neighbours.</param>
    /// <param name="enough">A speed that is slow enough, or negative.</param>
    /// <returns>Its place in the row.</returns>
    private int Least(int at, double enough)
    {
        for (int i = 0; i < MostSteps && at > 0 && at < _speeds.Count - 1 && !(_speeds[at].Speed <= enough); i++)
        {
            ref readonly TimedKick a = ref _speeds[at - 1];
            ref readonly TimedKick b = ref _speeds[at];
            ref readonly TimedKick c = ref _speeds[at + 1];
            double left = b.Time - a.Time;
            double right = c.Time - b.Time;
            double move = Vertex(left, right, b.Speed - a.Speed, b.Speed - c.Speed);
            if (!double.IsFinite(move))
            {
                move = left > right ? -0.5 * left : 0.5 * right;
            }
            else if (Math.Max(left, right) < 0.2 * b.Time && Math.Abs(move) < TimeWidth * b.Time)
            {
                // What is left is of second order in the last move.
                return at;
            }

            double least = 0.05 * Math.Max(left, right);
            if (Math.Abs(move) < least)
            {
                move = left > right ? -least : least;
            }

            double time = b.Time + Math.Min(Math.Max(move, -0.9 * left), 0.9 * right);
            double speed = b.Speed;
            int added = _speeds.Add(time);
            if (added < 0)
            {
                return at;
            }

            at = _speeds[added].Speed < speed ? added : added <= at ? at + 1 : at;
            if (double.IsNaN(_speeds[added].Speed))
            {
                return at;
            }
        }

        return at;
    }

    /// <summary>Looks beside the slowest kick: the drag law's jump makes waves there.</summary>
    /// <returns>The place of the slowest in the row.</returns>
    private int Waves(int at)
    {
        double time = _speeds[at].Time;
        for (int i = 1; i <= MostWaves; i++)
        {
            at = Slower(at, _speeds.Add(time * (1.0 + (i * Wave))));
            at = Slower(at, _speeds.Add(time * (1.0 - (i * Wave))));
        }

        return _speeds[at].Time == time ? at : Least(at, enough: -1);
    }

    /// <summary>The slower of a kick of the row and one that was added to it since.</summary>
    private int Slower(int at, int added) =>
        added < 0 ? at : added <= at ? (_speeds[added].Speed < _speeds[at + 1].Speed ? added : at + 1) : _speeds[added].Speed < _speeds[at].Speed ? added : at;

    /// <summary>Where the parabola through three points is least, from the middle one.</summary>
    private static double Vertex(double left, double right, double riseLeft, double riseRight)
    {
        double below = (left * riseRight) + (right * riseLeft);
        return below < 0 ? 0.5 * ((right * right * riseLeft) - (left * left * riseRight)) / below : 0;
    }

    private bool Slowest(TimedProblem problem, double fastest, out AimSolution solution)
    {
        solution = default;
        solution.Speed = fastest;
        bool found = false;
        for (int start = 0; start < Starts(problem); start++)
        {
            _speeds.Begin(problem, fastest, _context.Upward, start);
            _speeds.Shorten(fastest);
            _speeds.Lengthen(fastest);
            found |= SlowestOfRow(problem, ref solution);
        }

        return found;
    }

    private bool SlowestOfRow(TimedProblem problem, ref AimSolution solution)
    {
        bool found = false;

        // Either slower than its neighbours, or on the bounds.
        for (int i = 0; i < _speeds.Count; i++)
        {
            bool bottom = (i == 0 || _speeds[i].Speed <= _speeds[i - 1].Speed) && (i == _speeds.Count - 1 || _speeds[i].Speed <= _speeds[i + 1].Speed);
            if (bottom && (Keeps(problem, i - 1) || Keeps(problem, i) || Keeps(problem, i + 1)))
            {
                i = Waves(Least(i, enough: -1));
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

    /// <summary>Whether a kick of the row keeps to the bounds.</summary>
    private bool Keeps(TimedProblem problem, int at) => at >= 0 && at < _speeds.Count && _speeds[at].Found && problem.Violation(_speeds[at]) <= OffBounds;

    /// <summary>Takes a kick for the slowest, if it is slower than that and hits.</summary>
    private bool Take(TimedProblem problem, in TimedKick kick, ref AimSolution slowest)
    {
        if (!IsAllowed(problem, in kick, slowest.Speed) || !IsHit(problem, in kick, Math.Min(kick.Speed, slowest.Speed), out AimSolution hit))
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
        if (atOne > OffBounds && atOther > OffBounds)
        {
            return Within(problem, one, other, out TimedKick within)
                && (Take(problem, in within, ref slowest) | AtBounds(problem, in one, in within, ref slowest) | AtBounds(problem, in within, in other, ref slowest));
        }

        if (atOne > OffBounds == atOther > OffBounds)
        {
            return false;
        }

        var violation = new ViolationOverTime(_speeds, in one, in other);
        Illinois(ref violation, one.Time, atOne, other.Time, atOther);
        return Take(problem, violation.Last, ref slowest);
    }

    /// <summary>A kick within the bounds, between two that lie on either side of them.</summary>
    private bool Within(TimedProblem problem, TimedKick one, TimedKick other, out TimedKick within)
    {
        within = default;
        for (int k = 0; k < MostRootSteps; k++)
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

            if (problem.Violation(in within) <= OffBounds)
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

    /// <summary>Whether a kick is slow enough, and within its bounds.</summary>
    private static bool IsAllowed(TimedProblem problem, in TimedKick kick, double fastest) =>
        kick.Found && (kick.Speed <= fastest || IsNearly(problem, in kick, fastest)) && problem.Violation(in kick) <= OffBounds;

    /// <summary>Whether a kick that is a little slower than this one hits as well.</summary>
    private static bool IsNearly(TimedProblem problem, in TimedKick kick, double speed) =>
        kick.Found && kick.Miss + (Math.Abs(kick.Speed - speed) * kick.Time) <= problem.Tolerance;

    /// <summary>Whether a kick, put on its bounds, hits, measured.</summary>
    private bool IsHit(TimedProblem problem, in TimedKick kick, double speed, out AimSolution solution)
    {
        solution = Solution(problem, in kick, speed, AimStatus.Hit);
        if (!kick.Found || problem.Violation(in kick) > OffBounds)
        {
            return false;
        }

        solution.Vectors(out Vector3d velocity, out Vector3d spin);
        solution.Miss = _context.Miss.Measure(problem.Request, in velocity, in spin).Distance;
        return solution.Miss <= problem.Request.Tolerance;
    }

    private static AimSolution Solution(TimedProblem problem, in TimedKick kick, double speed, AimStatus status) => new()
    {
        Status = status,
        Kick = problem.KickOf(in kick.Velocity),
        Forward = problem.Frame.Forward,
        Speed = speed,
        Miss = kick.Miss,
        Time = kick.Time,
    };

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
            Last = value <= OffBounds ? kick : Last;
            if (value > 0 == _oneViolates)
            {
                _one = kick;
            }
            else
            {
                _other = kick;
            }

            return Math.Abs(value) <= OffBounds;
        }
    }
}
