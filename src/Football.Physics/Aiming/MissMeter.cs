namespace FootballPhysics.Aiming;

/// <summary>Measures by what a kick misses what a request asks for, before its first impact: in steps that leave no doubt.</summary>
internal sealed class MissMeter
{
    private readonly AimContext _context;
    private readonly Simulator _simulator;
    private readonly MeasuredFlight _shot;
    private AimRequest? _measured;
    private Vector3d _measuredVelocity;
    private Vector3d _measuredSpin;
    private double? _measuredTime;
    private MeasuredMiss _miss;

    /// <param name="context">What the searches share.</param>
    /// <param name="simulator">The scene.</param>
    public MissMeter(AimContext context, Simulator simulator)
    {
        _context = context;
        _simulator = simulator;
        _shot = new MeasuredFlight(simulator);
    }

    /// <summary>The name of what is in the way.</summary>
    public string? NameOf(int thing) => _simulator.NameOf(thing);

    /// <summary>Forgets the last measurement: what is in the scene may have moved.</summary>
    public void Forget() => _measured = null;

    /// <summary>Flies a kick and measures; what was measured last is not flown again.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="velocity">Its velocity, m/s.</param>
    /// <param name="spin">Its spin, rad/s.</param>
    /// <param name="time">When to measure, or at the first impact if that is before, s after the kick; null for the closest approach.</param>
    public MeasuredMiss Measure(AimRequest request, in Vector3d velocity, in Vector3d spin, double? time = null)
    {
        // The kick that was measured last, as a solver and then the report ask for it.
        if (ReferenceEquals(request, _measured) && velocity == _measuredVelocity && spin == _measuredSpin && time == _measuredTime)
        {
            return _miss;
        }

        (_measured, _measuredVelocity, _measuredSpin, _measuredTime) = (request, velocity, spin, time);
        BallState state = _simulator.LaunchAt(request.From, velocity, spin, request.KickTime);
        double step = MeasuringStep.Of(_simulator, _context.Upward, velocity.Length, spin.Length);

        // On the clock of the scene the target has been on its way since time 0.
        Vector3d target = AimContext.Raised(_simulator, request.Target) - (request.KickTime * request.TargetVelocity);

        // At a time: where the ball is then, and not where it was closest.
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
/// <param name="Distance">Distance from the target, m.</param>
/// <param name="ThroughDistance">Distance from the point on the way, m; null without one.</param>
/// <param name="Time">When the ball is closest to the target, s.</param>
/// <param name="Position">Where it is then, m.</param>
/// <param name="Blocker">The first thing but the ground that the ball meets on its way, as events number them; <see cref="MeasuredFlight.NoThing"/> where it meets none.</param>
internal readonly record struct MeasuredMiss(double Distance, double? ThroughDistance, double Time, Vector3d Position, int Blocker = MeasuredFlight.NoThing);

/// <summary>The step of a flight that leaves no doubt by what it misses a target: its own error is far below a millimetre.</summary>
internal static class MeasuringStep
{
    /// <summary>Step of an ordinary flight, s; and of one that the air rules, that spins faster than it flies, or in a storm.</summary>
    private const double Ordinary = 0.02;
    private const double Fine = 0.005;

    /// <summary>Wind of a storm, m/s.</summary>
    private const double Storm = 25;

    /// <summary>The air rules where drag or lift are so much stronger than gravity.</summary>
    private const double Ruling = 3;

    /// <summary>The step for a kick, s.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="upward">Upward acceleration by gravity and buoyancy, m/s².</param>
    /// <param name="speed">Speed of the kick, m/s.</param>
    /// <param name="spinRate">Its spin, rad/s.</param>
    public static double Of(Simulator simulator, double upward, double speed, double spinRate) =>
        IsRuledByAir(simulator, upward, speed, spinRate) || simulator.Scene.Air.Wind.Length > Storm
            || simulator.Scene.Ball.Radius * spinRate > speed ? Fine : Ordinary;

    /// <summary>True when, at a speed, drag or lift are so much stronger than gravity that ways bend into loops, or end in the air.</summary>
    public static bool IsRuledByAir(Simulator simulator, double upward, double speed, double spinRate)
    {
        // Drag or lift at the greatest speed through the air, against weight less buoyancy.
        double most = speed + simulator.Scene.Air.Wind.Length;
        simulator.AirFactors(most, spinRate, out double drag, out double lift);
        return most * Math.Max(drag, Math.Abs(lift)) > Ruling * Math.Abs(upward);
    }
}
