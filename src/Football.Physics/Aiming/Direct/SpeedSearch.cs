namespace Football.Physics;

/// <summary>Searches over the speed of a kick: the slowest that reaches a target, and the one that is there at a given time.</summary>
internal sealed class SpeedSearch
{
    private const int MostSpeeds = 60;

    /// <summary>Halvings of all speeds that leave 1e-10 of them.</summary>
    private const int HighArcHalvings = 34;

    /// <summary>How close to its time a kick is found, s.</summary>
    private const double TimeWidth = 1e-6;

    /// <summary>Share of the square of the speed within which the slowest kick is found.</summary>
    private const double SpeedWidth = 2e-7;

    /// <summary>How far off its time a kick may be, s.</summary>
    private const double LargestDelay = 1e-4;

    private readonly DirectAim _direct;
    private readonly ReachBound _reach;

    public SpeedSearch(DirectAim direct, ReachBound reach)
    {
        _direct = direct;
        _reach = reach;
    }

    /// <summary>The slowest kick: where the largest height at the target's distance, which grows with the speed, is zero.</summary>
    public AimSolution Slowest(AimRequest request)
    {
        double high = request.Speed;
        double atHigh = _reach.Of(request, high);
        if (!(atHigh >= 0))
        {
            return _direct.Find(request, high, request.Arc);
        }

        // The bound is nearly linear in the square of the speed. Nothing is known of a ball that is not kicked.
        var reach = new BoundOverSpeed(_reach, request);
        double squared = high * high;
        Roots.Illinois(ref reach, 0, double.NaN, squared, atHigh, SpeedWidth * squared, MostSpeeds);
        high = reach.Slowest;

        // A hair above the limit, where both arcs meet; more where the limit is known less well, as near the drag law's jump.
        AimSolution slowest = default;
        for (double more = 1e-6; more < 0.1; more *= 4)
        {
            double speed = Math.Min(request.Speed, high * (1.0 + more));
            slowest = _direct.Find(request, speed, request.Arc);
            if (slowest.Status == AimStatus.Hit || speed >= request.Speed)
            {
                break;
            }
        }

        return slowest;
    }

    /// <summary>The kick that is at the target at a time: on one arc the flight is the shorter, the faster the kick.</summary>
    public AimSolution AtTime(AimRequest request, double time)
    {
        AimSolution fastest = _direct.Find(request);
        if (fastest.Status != AimStatus.Hit)
        {
            return fastest;
        }

        if (fastest.Time > time)
        {
            // Even the fastest is late. A target in reach, but not by then.
            fastest.Status = AimStatus.OutOfReach;
            return fastest;
        }

        AimSolution slowest = Slowest(request);
        if (slowest.Status != AimStatus.Hit || slowest.Time < time)
        {
            // The slowest low kick is early already: the high arc takes longer.
            return HighArc(request, time);
        }

        var delay = new DelayOverSpeed(_direct, request, time, in slowest);
        Roots.Illinois(
            ref delay, slowest.Speed, slowest.Time - time, request.Speed, fastest.Time - time, 1e-10 * request.Speed, MostSpeeds);
        return OnTime(delay.Last, time);
    }

    /// <summary>The same on the high arc, where a faster kick takes longer.</summary>
    private AimSolution HighArc(AimRequest request, double time)
    {
        AimSolution best = _direct.Find(request, request.Speed, AimArc.High);
        double high = request.Speed;
        double low = 0;
        if (best.Status == AimStatus.Hit && best.Time < time)
        {
            best.Status = AimStatus.OutOfReach;
            return best;
        }

        var late = new LateOnHighArc(_direct, request, time, in best);
        Roots.Bisect(ref late, ref low, ref high, HighArcHalvings);
        return OnTime(late.Last, time);
    }

    /// <summary>Where the time jumps with the speed, as at the drag law's jump, none may be right: a hit at another time is none.</summary>
    private static AimSolution OnTime(AimSolution solution, double time)
    {
        if (solution.Status == AimStatus.Hit && Math.Abs(solution.Time - time) > LargestDelay)
        {
            solution.Status = AimStatus.NotConverged;
        }

        return solution;
    }

    /// <summary>The bound of reach over the square of the speed.</summary>
    private struct BoundOverSpeed : IFunction
    {
        private readonly ReachBound _reach;
        private readonly AimRequest _request;

        public BoundOverSpeed(ReachBound reach, AimRequest request)
        {
            _reach = reach;
            _request = request;
            Slowest = request.Speed;
        }

        /// <summary>The slowest speed so far that reaches the target.</summary>
        public double Slowest { get; private set; }

        public bool Evaluate(double x, out double value)
        {
            double speed = Math.Sqrt(x);
            value = _reach.Of(_request, speed);
            Slowest = value >= 0 && speed < Slowest ? speed : Slowest;
            return false;
        }
    }

    /// <summary>By how much a kick comes late, over its speed. One that does not hit counts as the slowest that does.</summary>
    private struct DelayOverSpeed : IFunction
    {
        private readonly DirectAim _direct;
        private readonly AimRequest _request;
        private readonly double _time;
        private readonly double _most;

        public DelayOverSpeed(DirectAim direct, AimRequest request, double time, in AimSolution slowest)
        {
            _direct = direct;
            _request = request;
            _time = time;
            _most = slowest.Time - time;
            Last = slowest;
        }

        /// <summary>The last kick that hit.</summary>
        public AimSolution Last { get; private set; }

        public bool Evaluate(double x, out double value)
        {
            AimSolution solution = _direct.Find(_request, x, _request.Arc);
            value = _most;
            if (solution.Status != AimStatus.Hit)
            {
                return false;
            }

            Last = solution;
            value = solution.Time - _time;
            return Math.Abs(value) < TimeWidth;
        }
    }

    /// <summary>Whether a kick on the high arc comes late, or too late by a bit.</summary>
    private struct LateOnHighArc : ICondition
    {
        private readonly DirectAim _direct;
        private readonly AimRequest _request;
        private readonly double _time;

        public LateOnHighArc(DirectAim direct, AimRequest request, double time, in AimSolution fastest)
        {
            _direct = direct;
            _request = request;
            _time = time;
            Last = fastest;
        }

        /// <summary>The last kick that hit and was late.</summary>
        public AimSolution Last { get; private set; }

        public bool Evaluate(double x, out bool holds)
        {
            AimSolution solution = _direct.Find(_request, x, AimArc.High);
            holds = solution.Status == AimStatus.Hit && solution.Time >= _time;
            Last = holds ? solution : Last;
            return Math.Abs(Last.Time - _time) < TimeWidth;
        }
    }
}
