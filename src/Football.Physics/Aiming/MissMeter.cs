namespace FootballPhysics.Aiming;

/// <summary>Measures the miss of a kick before its first impact, in accurate steps.</summary>
/// <param name="context">The data shared by the searches.</param>
/// <param name="simulator">The scene.</param>
internal sealed class MissMeter(AimContext context, Simulator simulator)
{
    private readonly AimContext _context = context;
    private readonly Simulator _simulator = simulator;
    private readonly MeasuredFlight _shot = new(simulator);
    private AimRequest? _measured;
    private Vector3d _measuredVelocity;
    private Vector3d _measuredSpin;
    private double? _measuredTime;
    private MeasuredMiss _miss;

    /// <summary>Returns the name of a blocking object.</summary>
    public string? NameOf(int thing) => _simulator.NameOf(thing);

    /// <summary>Discards the last measurement, because objects in the scene may have moved.</summary>
    public void Forget() => _measured = null;

    /// <summary>Simulates a kick and measures its miss; the last measurement is cached.</summary>
    /// <param name="request">The request.</param>
    /// <param name="velocity">The velocity of the kick, in m/s.</param>
    /// <param name="spin">The spin of the kick, in rad/s.</param>
    /// <param name="time">The time of the measurement, in s after the kick; an earlier impact ends it. Null measures at the closest approach.</param>
    public MeasuredMiss Measure(AimRequest request, in Vector3d velocity, in Vector3d spin, double? time = null)
    {
        // Return the cached result, because the solver and the report measure the same kick.
        if (ReferenceEquals(request, _measured) && velocity == _measuredVelocity && spin == _measuredSpin && time == _measuredTime)
        {
            return _miss;
        }

        (_measured, _measuredVelocity, _measuredSpin, _measuredTime) = (request, velocity, spin, time);
        BallState state = _simulator.LaunchAt(request.From, velocity, spin, request.KickTime, AimContext.OrientationOf(_simulator, request));
        double step = MeasuringStep.Of(_simulator, _context.Upward, velocity.Length, spin.Length, state.Motion);

        // On the scene's clock, the target has moved since time 0.
        Vector3d target = AimContext.Raised(_simulator, request.Target) - (request.KickTime * request.TargetVelocity);

        // Measure the miss at the given time, not at the closest approach.
        if (time is { } end)
        {
            int blocker = _shot.FlyTo(ref state, step, end);
            Vector3d there = target + (state.Time * request.TargetVelocity);
            return _miss = new MeasuredMiss(Vector3d.Distance(state.Position, in there), null, state.Time - request.KickTime, state.Position, blocker);
        }

        Vector3d? through = request.Waypoint is { } way ? AimContext.Raised(_simulator, way) : null;
        _shot.Fly(state, step, AimContext.LongestFlight, in target, request.TargetVelocity, through, []);
        return _miss = new MeasuredMiss(_shot.Miss, _shot.ThroughMiss, _shot.Time, _shot.Position, _shot.Blocker);
    }
}

/// <summary>The measured closest approach of a kick before its first impact.</summary>
/// <param name="Distance">The distance from the target, in m.</param>
/// <param name="ThroughDistance">The distance from the waypoint, in m; null without one.</param>
/// <param name="Time">The time of the closest approach to the target, in s.</param>
/// <param name="Position">The position at this time, in m.</param>
/// <param name="Blocker">The first object except the ground that the ball hits, numbered as in events; <see cref="MeasuredFlight.NoThing"/> if there
/// is none.</param>
internal readonly record struct MeasuredMiss(double Distance, double? ThroughDistance, double Time, Vector3d Position, int Blocker = MeasuredFlight.NoThing);

/// <summary>The step of a flight that measures a miss, with an error far below a millimetre.</summary>
internal static class MeasuringStep
{
    /// <summary>The step of an ordinary flight, in s, of a roll over hills, and of a flight that is dominated by air, has fast spin, or is in a storm.</summary>
    private const double Ordinary = 0.02;
    private const double Uneven = 0.01;
    private const double Fine = 0.005;

    /// <summary>The wind speed of a storm, in m/s.</summary>
    private const double Storm = 25;

    /// <summary>The ratio of drag or lift to gravity above which the air dominates.</summary>
    private const double Ruling = 3;

    /// <summary>Returns the step for a kick, in s.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="upward">The upward acceleration by gravity and buoyancy, in m/s².</param>
    /// <param name="speed">The speed of the kick, in m/s.</param>
    /// <param name="spinRate">The spin of the kick, in rad/s.</param>
    /// <param name="motion">The motion of the ball after the kick.</param>
    public static double Of(Simulator simulator, double upward, double speed, double spinRate, MotionState motion) =>
        IsRuledByAir(simulator, upward, speed, spinRate) || simulator.Scene.Air.Wind.Length > Storm
            || simulator.Scene.Ball.Radius * spinRate > speed ? Fine
            : motion != MotionState.Airborne && IsUneven(simulator) ? Uneven : Ordinary;

    /// <summary>True if the slope of the ground changes along a roll.</summary>
    public static bool IsUneven(Simulator simulator) => simulator.Scene.Ground.Heights is not null;

    /// <summary>True if drag or lift exceeds gravity so much that paths bend into loops, or end in the air.</summary>
    public static bool IsRuledByAir(Simulator simulator, double upward, double speed, double spinRate)
    {
        // Compare the drag or lift at the maximum airspeed with the weight minus the buoyancy.
        double most = speed + simulator.Scene.Air.Wind.Length;
        simulator.AirFactors(most, spinRate, out double drag, out double lift);
        return most * Math.Max(drag, Math.Abs(lift)) > Ruling * Math.Abs(upward);
    }
}
