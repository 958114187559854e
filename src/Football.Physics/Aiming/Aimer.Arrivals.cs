using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <content>Kicks that arrive at a given speed.</content>
public sealed partial class Aimer
{
    private const double ArrivalStep = 0.02;

    /// <summary>The maximum error of the arrival speed, in m/s.</summary>
    internal const double LargestArrivalError = 0.01;

    private readonly StepLog _arrivalLog = new() { IgnoresZones = true };
    private ArrivalTimes? _arrivals;

    /// <summary>Finds the kick that arrives at a target at a given speed.</summary>
    /// <remarks>If the target is on the ground and a kick along the ground can arrive at this speed, that kick is used. Otherwise the kick flies, and the speed
    /// applies just before the ball touches the ground.</remarks>
    /// <param name="request">The request, without a waypoint; its speed is the maximum allowed.</param>
    /// <param name="speed">The speed of the ball at the target, in m/s; above 0, at most 1000.</param>
    /// <returns>The kick; its velocity contains its speed. Out of reach if every kick is slower there; a hit arrives within 0.01 m/s.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or the request has a waypoint.</exception>
    public AimResult FindAtSpeed(AimRequest request, double speed)
    {
        Begin(request);
        RefuseThrough(request);
        Check.Within("aim.arrival.speed", speed, 0, Limits.Speed, exclusiveLow: true);

        // Search over the time, with which the arrival speed changes smoothly. A kick speed can have two flights, and in wind or on a slope two rolls.
        _arrivals ??= new ArrivalTimes(this);
        if (_context.Shooting.CanRoll(request) && FastestRoll(request, speed, out AimSolution roll)
            && _arrivals.Find(request, speed, roll, out AimResult kick) && kick.Status is AimStatus.Hit or AimStatus.Blocked)
        {
            return kick;
        }

        return _arrivals.Find(request, speed, roll: null, out kick) ? kick : NoArrival(request, _arrivals.Closest, speed);
    }

    /// <summary>Finds the kick that flies or rolls to the target in a given time, measures it, and returns its arrival speed.</summary>
    /// <param name="request">The request.</param>
    /// <param name="time">The time, in s.</param>
    /// <param name="rolls">True for a kick along the ground.</param>
    /// <param name="isBetween">True if the time is between two times that have a kick. A kick then exists, and finer steps find it.</param>
    /// <param name="near">The hit at another time, to start from if the closed form is too far off; its time is 0 if there is none.</param>
    /// <param name="kick">The kick.</param>
    /// <param name="arrival">The arrival speed, in m/s.</param>
    /// <returns>True if a kick reaches the target at this time and hits nothing before.</returns>
    internal bool TryArrival(AimRequest request, double time, bool rolls, bool isBetween, in AimSolution near, out AimSolution kick, out double arrival)
    {
        _context.Begin(request.MaximumIterations);
        bool hits = TryArrival(request, time, rolls, in near, out kick, out arrival, out bool isEarly);
        if (isEarly)
        {
            // The kick is within tolerance but arrives too early: solve again for a closer kick, which arrives on time.
            _context.Begin(request.MaximumIterations);
            _general.IsTimely = true;
            hits = TryArrival(request, time, rolls, in near, out kick, out arrival, out _);
            _general.IsTimely = false;
        }

        if (!hits && isBetween)
        {
            // A kick that grazes the jump in the drag law requires short steps: search again.
            _context.Begin(request.MaximumIterations);
            _context.Steps = AimSteps.Short;
            hits = TryArrival(request, time, rolls, in near, out kick, out arrival, out _);
            _context.Steps = AimSteps.Long;
        }

        return hits;
    }

    private bool TryArrival(AimRequest request, double time, bool rolls, in AimSolution near, out AimSolution kick, out double arrival, out bool isEarly)
    {
        kick = _general.AtTime(request, time, rolls, in near);
        kick.Vectors(out Vector3d velocity, out Vector3d spin);
        bool there = IsThere(request, in velocity, in spin, time, out _, out isEarly);
        arrival = SpeedAt(request, in velocity, in spin, time, rolls);
        return there;
    }

    /// <summary>Returns the duration of the slowest flight to the target, in s; if no flight reaches it, that of the closest one.</summary>
    internal double SlowestTime(AimRequest request)
    {
        _context.Begin(request.MaximumIterations);
        _general.Slowest(request, out AimSolution slowest);
        return slowest.Time > 0 ? slowest.Time : 1.0;
    }

    /// <summary>Finds the fastest roll to the target.</summary>
    /// <returns>False if the roll does not reach the target, or no roll can arrive at a speed, in m/s.</returns>
    private bool FastestRoll(AimRequest request, double speed, out AimSolution roll)
    {
        _context.Begin(request.MaximumIterations);
        if (!_direct.Rolls(request, request.Speed, out roll))
        {
            return false;
        }

        // In still air over level ground, no other roll arrives faster.
        roll.Vectors(out Vector3d velocity, out Vector3d spin);
        return !_context.Turns(request.TargetVelocity) || SpeedAt(request, in velocity, in spin, roll.Time, rolls: true) >= speed - LargestArrivalError;
    }

    /// <summary>Reports a kick for an arrival speed; the status is "not converged" if its actual arrival speed differs.</summary>
    internal AimResult ReportArrival(AimRequest request, in AimSolution kick, double speed)
    {
        AimResult result = Report(request, in kick, measure: true);
        bool isOff = result.Status == AimStatus.Hit
            && !(Math.Abs(SpeedAt(request, result.Velocity, result.Spin, result.Time, result.Rolls) - speed) <= LargestArrivalError);
        return isOff ? Failed(in result, AimReason.OtherSpeed) : result;
    }

    /// <summary>Returns the result if no kick was found that arrives at this speed: that of the closest one, or else of the fastest kick.</summary>
    private AimResult NoArrival(AimRequest request, AimSolution? closest, double speed)
    {
        AimResult kick = closest is { } one ? ReportArrival(request, in one, speed) : Find(request);
        bool misses = kick.Status is AimStatus.NotConverged or AimStatus.OutOfReach || (closest is null && kick.HitsTarget);
        AimReason miss = kick.Miss <= request.Tolerance ? AimReason.OtherSpeed : AimReason.NoneFound;
        return misses ? Failed(in kick, new EnergyBound(_context, request).ReasonFor(speed, miss)) : kick;
    }

    /// <summary>Returns the speed of a kick after a time, in m/s; if it touches the ground earlier, the speed just before the contact.</summary>
    private double SpeedAt(AimRequest request, in Vector3d velocity, in Vector3d spin, double time, bool rolls)
    {
        Simulator simulator = Context.Game;
        BallState state = simulator.LaunchAt(request.From, velocity, spin, request.KickTime, AimContext.OrientationOf(simulator, request));
        _arrivalLog.Clear();
        bool touches = simulator.RunChecked(ref state, ArrivalStep, Math.Max(time, 1e-9), rolls ? StopAt.Time : StopAt.Impact, _arrivalLog, null);
        return (touches ? _arrivalLog.Events[_arrivalLog.Events.Count - 1].VelocityBefore : state.Velocity).Length;
    }

    /// <summary>Returns a kick with another reason.</summary>
    internal static AimResult Failed(in AimResult kick, AimReason reason) => new(
        reason, kick.Velocity, kick.Spin, new MeasuredMiss(kick.Miss, kick.WaypointMiss, kick.Time, kick.Closest), kick.Arc, kick.Rolls, kick.Iterations, kick.Simulations, kick.BlockedBy);
}
