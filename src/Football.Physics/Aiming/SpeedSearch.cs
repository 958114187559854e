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

    public SpeedSearch(DirectAim direct) => _direct = direct;

    /// <summary>The slowest kick: where the largest height at the target's distance, which grows with the speed, is zero.</summary>
    public AimAnswer Slowest(AimRequest request)
    {
        double high = request.Speed;
        double highest = _direct.Certificate(request, high);
        if (!(highest >= 0))
        {
            return _direct.Find(request, high, request.Arc);
        }

        // The certificate is nearly linear in the square of the speed. Nothing is known of a ball that is not kicked.
        var reach = new CertificateOverSpeed(_direct, request);
        double squared = high * high;
        Roots.Illinois(ref reach, 0, double.NaN, squared, highest, SpeedWidth * squared, MostSpeeds);
        high = reach.Slowest;

        // A hair above the limit, where both arcs meet; more where the limit is known less well, as near the drag law's jump.
        AimAnswer slowest = default;
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
    public AimAnswer AtTime(AimRequest request, double time)
    {
        AimAnswer fastest = _direct.Find(request);
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

        AimAnswer slowest = Slowest(request);
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
    private AimAnswer HighArc(AimRequest request, double time)
    {
        AimAnswer best = _direct.Find(request, request.Speed, AimArc.High);
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
    private static AimAnswer OnTime(AimAnswer answer, double time)
    {
        if (answer.Status == AimStatus.Hit && Math.Abs(answer.Time - time) > LargestDelay)
        {
            answer.Status = AimStatus.NotConverged;
        }

        return answer;
    }

    /// <summary>The certificate of reach over the square of the speed.</summary>
    private struct CertificateOverSpeed : IFunction
    {
        private readonly DirectAim _direct;
        private readonly AimRequest _request;

        public CertificateOverSpeed(DirectAim direct, AimRequest request)
        {
            _direct = direct;
            _request = request;
            Slowest = request.Speed;
        }

        /// <summary>The slowest speed so far that reaches the target.</summary>
        public double Slowest { get; private set; }

        public bool Evaluate(double x, out double value)
        {
            double speed = Math.Sqrt(x);
            value = _direct.Certificate(_request, speed);
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

        public DelayOverSpeed(DirectAim direct, AimRequest request, double time, in AimAnswer slowest)
        {
            _direct = direct;
            _request = request;
            _time = time;
            _most = slowest.Time - time;
            Last = slowest;
        }

        /// <summary>The last kick that hit.</summary>
        public AimAnswer Last { get; private set; }

        public bool Evaluate(double x, out double value)
        {
            AimAnswer answer = _direct.Find(_request, x, _request.Arc);
            value = _most;
            if (answer.Status != AimStatus.Hit)
            {
                return false;
            }

            Last = answer;
            value = answer.Time - _time;
            return Math.Abs(value) < TimeWidth;
        }
    }

    /// <summary>Whether a kick on the high arc comes late, or too late by a bit.</summary>
    private struct LateOnHighArc : ICondition
    {
        private readonly DirectAim _direct;
        private readonly AimRequest _request;
        private readonly double _time;

        public LateOnHighArc(DirectAim direct, AimRequest request, double time, in AimAnswer fastest)
        {
            _direct = direct;
            _request = request;
            _time = time;
            Last = fastest;
        }

        /// <summary>The last kick that hit and was late.</summary>
        public AimAnswer Last { get; private set; }

        public bool Evaluate(double x, out bool holds)
        {
            AimAnswer answer = _direct.Find(_request, x, AimArc.High);
            holds = answer.Status == AimStatus.Hit && answer.Time >= _time;
            Last = holds ? answer : Last;
            return Math.Abs(Last.Time - _time) < TimeWidth;
        }
    }
}
