using FootballPhysics.Numerics;

namespace FootballPhysics.Thesis;

/// <summary>Finds kicks by the methods of the thesis, for comparison.</summary>
/// <remarks>
/// The searches use the game's own integrator and steps, and evaluate kicks between frames. Create one per scene and reuse it: searches do not allocate. Not
/// thread-safe.
/// </remarks>
public sealed class ThesisAimer
{
    private readonly AngleAim _angle;
    private readonly BisectionAim _bisection;
    private readonly TwoPointAim _twoPoint;

    private readonly FrameShooter _frames;

    /// <summary>Compiles a scene for aiming.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <param name="settings">The integrator of the flights; default <see cref="SolverSettings.Default"/>.</param>
    /// <param name="timeStep">The step of the flights, in s. Above 0; default 0.01.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public ThesisAimer(Scene? scene = null, SolverSettings? settings = null, double timeStep = 0.01)
    {
        Check.Positive("solver.timeStep", timeStep);
        Check.AtLeast("solver.timeStep", timeStep, AimContext.LongestFlight * 1e-6);
        var simulator = new Simulator(scene, settings);
        Direct = new Aimer(simulator);
        AimContext context = Direct.Context;
        Simulator open = context.HasThings ? new Simulator(AimContext.WithoutThings(simulator.Scene), simulator.Settings) : simulator;
        _frames = new FrameShooter(context, open, timeStep);
        FrameShooter frames = _frames;
        _angle = new AngleAim(context, frames);
        _bisection = new BisectionAim(context, frames);
        _twoPoint = new TwoPointAim(context, frames, _angle, _bisection);
    }

    /// <summary>The library's own aimer for the same scene, for comparison.</summary>
    public Aimer Direct { get; }

    /// <summary>Finds a kick.</summary>
    /// <param name="request">The request.</param>
    /// <param name="method">The method.</param>
    /// <param name="measure">True to measure the miss of the result; otherwise it contains the method's own estimate.</param>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or the request for the two-point method has no waypoint.</exception>
    public AimResult Find(AimRequest request, AimMethod method, bool measure = true)
    {
        Check.Given(nameof(request), request);
        Check.Defined("aim.method", method, (int)method, 4);
        if (method == AimMethod.Direct)
        {
            return Direct.Find(request, measure);
        }

        Direct.Begin(request);
        _frames.Orientation = AimContext.OrientationOf(Direct.Context.Game, request);
        if (method == AimMethod.TwoPoint && request.Waypoint is null)
        {
            throw Check.Refusal("aim.waypoint", "null", "a point, with method twoPoint");
        }

        AimSolution solution = method switch
        {
            AimMethod.Angle => _angle.Find(request),
            AimMethod.Bisection => _bisection.Find(request),
            AimMethod.TwoPoint => _twoPoint.Find(request),
            _ => throw Check.Refusal("aim.method", method.ToString(), "Direct | Angle | Bisection | TwoPoint"),
        };
        AimResult result = Direct.Report(request, in solution, measure, passes: method == AimMethod.TwoPoint);
        if (result.Cause != AimReason.SameSide)
        {
            return result;
        }

        // Two kicks that miss exclude no other kick, so the library's own bounds decide.
        AimResult own = Direct.Find(request.Waypoint is null ? request : request with { Waypoint = null }, measure: false);
        return own.Status == AimStatus.OutOfReach ? Aimer.Failed(in result, own.Cause) : result;
    }
}
