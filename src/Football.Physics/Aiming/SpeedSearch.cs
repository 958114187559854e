namespace Football.Physics;

/// <summary>Searches over the speed of a kick: the slowest that reaches a target, and the one that is there at a given time.</summary>
internal sealed class SpeedSearch
{
    private const int MostSpeeds = 60;

    /// <summary>How far off its time a kick may be, s.</summary>
    private const double LargestDelay = 1e-4;

    private readonly DirectAim _direct;

    public SpeedSearch(DirectAim direct) => _direct = direct;

    /// <summary>The slowest kick: where the largest height at the target's distance, which grows with the speed, is zero.</summary>
    public AimAnswer Slowest(AimRequest request)
    {
        double high = request.Speed;
        if (!(_direct.Certificate(request, high) >= 0))
        {
            return _direct.Find(request, high, request.Arc);
        }

        // The certificate is nearly linear in the square of the speed: regula falsi on it, bisection now and then.
        double low = 0;
        double lowValue = double.NaN;
        double highValue = double.NaN;
        for (int i = 0; i < MostSpeeds && high - low > 1e-7 * high; i++)
        {
            double speed = 0.5 * (low + high);
            if (i % 3 != 0 && lowValue < 0 && highValue > 0 && low > 0)
            {
                double share = -lowValue / (highValue - lowValue);
                speed = Math.Sqrt((low * low) + (share * ((high * high) - (low * low))));
                double margin = 0.02 * (high - low);
                speed = Math.Min(Math.Max(speed, low + margin), high - margin);
            }

            double value = _direct.Certificate(request, speed);
            if (value >= 0)
            {
                high = speed;
                highValue = value;
            }
            else
            {
                low = speed;
                lowValue = value;
            }
        }

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
        AimAnswer best = slowest;
        double low = slowest.Speed;
        double high = request.Speed;
        double lowError = slowest.Time - time;
        double highError = fastest.Time - time;
        if (slowest.Status != AimStatus.Hit || lowError < 0)
        {
            // The slowest low kick is early already: the high arc takes longer.
            return HighArc(request, time);
        }

        for (int i = 0; i < MostSpeeds && high - low > 1e-10 * high; i++)
        {
            double speed = i % 3 == 2 || i > 20 ? 0.5 * (low + high) : low + ((high - low) * lowError / (lowError - highError));
            AimAnswer answer = _direct.Find(request, speed, request.Arc);
            if (answer.Status != AimStatus.Hit)
            {
                low = speed;
                continue;
            }

            best = answer;
            double error = answer.Time - time;
            if (Math.Abs(error) < 1e-6)
            {
                break;
            }

            if (error > 0)
            {
                low = speed;
                lowError = error;
            }
            else
            {
                high = speed;
                highError = error;
            }
        }

        return OnTime(best, time);
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

        for (int i = 0; i < MostSpeeds && high - low > 1e-10 * high; i++)
        {
            double speed = 0.5 * (low + high);
            AimAnswer answer = _direct.Find(request, speed, AimArc.High);
            if (answer.Status != AimStatus.Hit || answer.Time < time)
            {
                low = speed;
            }
            else
            {
                high = speed;
                best = answer;
            }

            if (Math.Abs(best.Time - time) < 1e-6)
            {
                break;
            }
        }

        return OnTime(best, time);
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
}
