namespace FootballPhysics.Aiming;

/// <content>The kick that arrives with a given speed.</content>
public sealed partial class Aimer
{
    /// <summary>Rounds of the search for the speed of the kick, or its time, after which the arrival is known to a micrometre a second.</summary>
    private const int ArrivalRounds = 40;
    private const double ArrivalStep = 0.02;
    private const double ArrivalCloseness = 1e-9;

    /// <summary>An arrival that is further off than this, m/s, is not the one that was asked for.</summary>
    internal const double LargestArrivalError = 0.01;

    private readonly StepLog _arrivalLog = new() { IgnoresZones = true };
    private ArrivalTimes? _arrivals;

    /// <summary>Finds the kick that is at a target with a given speed.</summary>
    /// <remarks>A target on the ground is reached along the ground where a kick along it has that speed there, and else in flight: then the speed is that before the ball touches the ground.</remarks>
    /// <param name="request">What the kick is to do; its speed is the fastest allowed. Without a point on the way.</param>
    /// <param name="speed">How fast the ball is to be at the target, m/s; above 0, at most 1000.</param>
    /// <returns>The kick, with its speed in its velocity; out of reach where no kick that gets there has that speed there.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or a point on the way is given.</exception>
    public AimResult FindAtSpeed(AimRequest request, double speed)
    {
        Begin(request);
        RefuseThrough(request);
        Check.Within("aim.arrival.speed", speed, 0, Limits.Speed, exclusiveLow: true);

        // Along the ground the faster kick arrives faster. In flight the arrival changes smoothly with the time that the ball takes, and with nothing else: the speed
        // of the kick has two arcs.
        if (_context.Shooting.CanRoll(request) && Rolling(request, speed, out AimResult roll))
        {
            return roll;
        }

        _arrivals ??= new ArrivalTimes(this);
        return _arrivals.Find(request, speed);
    }

    /// <summary>The kick that flies to the target in a time, measured, and its speed there.</summary>
    /// <param name="request">The request.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="isBetween">Whether the time is between two that have a kick: then this has one too, and finer steps find it.</param>
    /// <param name="kick">The kick.</param>
    /// <param name="arrival">Its speed, m/s.</param>
    /// <returns>Whether there is one that meets nothing before.</returns>
    internal bool TryArrival(AimRequest request, double time, bool isBetween, out AimSolution kick, out double arrival)
    {
        _context.Begin(request.MaximumIterations);
        bool hits = TryArrival(request, time, out kick, out arrival, out bool isEarly);
        if (isEarly)
        {
            // Within the tolerance, but the ball comes down before it is due: a closer kick does not.
            _context.Begin(request.MaximumIterations);
            _general.IsTimely = true;
            hits = TryArrival(request, time, out kick, out arrival, out _);
            _general.IsTimely = false;
        }

        if (!hits && isBetween)
        {
            // It grazes the drag law's jump.
            _context.Begin(request.MaximumIterations);
            _context.Steps = AimSteps.Short;
            hits = TryArrival(request, time, out kick, out arrival, out _);
            _context.Steps = AimSteps.Long;
        }

        return hits;
    }

    private bool TryArrival(AimRequest request, double time, out AimSolution kick, out double arrival, out bool isEarly)
    {
        kick = _general.FlightAtTime(request, time);
        kick.Vectors(out Vector3d velocity, out Vector3d spin);
        MeasuredMiss measured = _context.Miss.Measure(request, in velocity, in spin, time);
        arrival = SpeedAt(request, in velocity, in spin, time, rolls: false);
        isEarly = measured.Distance <= request.Tolerance && !(time - measured.Time <= LargestDelay);
        return measured.Distance <= request.Tolerance && !isEarly;
    }

    /// <summary>How long the slowest flight to the target takes, s; or what comes closest to one.</summary>
    internal double SlowestTime(AimRequest request)
    {
        _context.Begin(request.MaximumIterations);
        _general.Slowest(request, out AimSolution slowest);
        return slowest.Time > 0 ? slowest.Time : 1.0;
    }

    /// <summary>Reports a kick of a search for an arrival; one that turns out to arrive otherwise did not converge.</summary>
    internal AimResult ReportArrival(AimRequest request, in AimSolution kick, double speed)
    {
        AimResult result = Report(request, in kick, measure: true);
        bool isOff = result.Status == AimStatus.Hit
            && !(Math.Abs(SpeedAt(request, result.Velocity, result.Spin, result.Time, result.Rolls) - speed) <= LargestArrivalError);
        return isOff ? Failed(in result, AimStatus.NotConverged) : result;
    }

    /// <summary>A kick that hits nothing for a request: what the fastest does, as the verdict of a search for an arrival.</summary>
    internal AimResult NoArrival(AimRequest request)
    {
        AimResult fastest = Find(request);
        return fastest.HitsTarget ? Failed(in fastest, AimStatus.OutOfReach) : fastest;
    }

    /// <summary>The kick along the ground that is at the target with a speed.</summary>
    private bool Rolling(AimRequest request, double speed, out AimResult best)
    {
        AimRequest along = request with { MinimumElevationDegrees = 0, MaximumElevationDegrees = 0 };
        best = Find(along);
        AimResult slow = FindSlowest(along);
        if (best.Status != AimStatus.Hit || slow.Status != AimStatus.Hit)
        {
            return false;
        }

        double low = slow.Speed;
        double high = request.Speed;
        double atLow = ArrivalOf(along, in slow) - speed;
        double atHigh = ArrivalOf(along, in best) - speed;
        if (!(atLow <= 0 && atHigh >= 0))
        {
            return false;
        }

        for (int i = 0; i < ArrivalRounds && high - low > ArrivalCloseness; i++)
        {
            // The secant, kept off both ends so that the bracket shrinks from both.
            double share = Math.Min(0.9, Math.Max(0.1, atLow / (atLow - atHigh)));
            double middle = low + (share * (high - low));
            best = Find(along with { Speed = middle });
            if (best.Status != AimStatus.Hit)
            {
                return false;
            }

            double off = ArrivalOf(along, in best) - speed;
            if (Math.Abs(off) < ArrivalCloseness)
            {
                break;
            }

            // The bracket keeps its signs: too slow below, too fast above.
            (low, atLow, high, atHigh) = off < 0 ? (middle, off, high, atHigh) : (low, atLow, middle, off);
        }

        return Math.Abs(ArrivalOf(along, in best) - speed) <= LargestArrivalError;
    }

    private double ArrivalOf(AimRequest request, in AimResult kick) => SpeedAt(request, kick.Velocity, kick.Spin, kick.Time, kick.Rolls);

    /// <summary>How fast a kick is after a time, m/s; of one that flies before it touches anything then.</summary>
    private double SpeedAt(AimRequest request, in Vector3d velocity, in Vector3d spin, double time, bool rolls)
    {
        Simulator simulator = Context.Game;
        BallState state = simulator.LaunchAt(request.From, velocity, spin, request.KickTime);
        _arrivalLog.Clear();
        bool touches = simulator.RunChecked(ref state, ArrivalStep, Math.Max(time, 1e-9), rolls ? StopAt.Time : StopAt.Impact, _arrivalLog, null);
        return (touches ? _arrivalLog.Events[_arrivalLog.Events.Count - 1].VelocityBefore : state.Velocity).Length;
    }

    internal static AimResult Failed(in AimResult kick, AimStatus status) => new(
        status, kick.Velocity, kick.Spin, new MeasuredMiss(kick.Miss, kick.WaypointMiss, kick.Time, kick.Closest), kick.Arc, kick.Rolls, kick.Iterations, kick.Simulations, kick.BlockedBy);
}
