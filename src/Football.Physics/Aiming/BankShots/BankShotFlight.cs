using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Aiming;

/// <summary>Simulates bank shots in the full scene; their miss by elevation and azimuth is a least-squares problem.</summary>
/// <remarks>
/// A kick flies until it has hit the required objects and passed its closest point to the target. The best of all kicks is stored.
/// </remarks>
internal sealed class BankShotFlight : ILeastSquares
{
    /// <summary>The step of a coarse flight, in s.</summary>
    public const double CoarseStep = 0.04;

    /// <summary>The miss below which a kick needs no correction, as a share of the tolerance.</summary>
    public const double Enough = 0.1;

    /// <summary>The maximum duration of a flight, in s.</summary>
    private const double LongestFlight = 8;

    /// <summary>The width of difference quotients, and the maximum change of a direction in one iteration, in rad.</summary>
    private const double Width = 1e-6;
    private const double LargestTurn = 0.1;

    private readonly Simulator _simulator;
    private readonly MeasuredFlight _flight;
    private readonly LeastSquares _solver;
    private readonly double _upward;
    private readonly double[] _x = new double[2];
    private AimRequest _request = new();
    private TargetFrame _frame;
    private ElevationBounds _bounds;
    private int[] _things = [];

    /// <param name="simulator">The scene.</param>
    public BankShotFlight(Simulator simulator)
    {
        _simulator = simulator;
        _upward = Weight.UpwardAcceleration(simulator.Scene);
        _flight = new MeasuredFlight(simulator);
        _solver = new LeastSquares(this, Equations);
    }

    /// <summary>The number of forward simulations since the search began.</summary>
    public int Simulations { get; set; }

    /// <summary>The number of corrections since the search began.</summary>
    public int Iterations { get; set; }

    /// <summary>The closest kick simulated in fine steps or, if no such kick hits all objects, in coarse steps.</summary>
    public Kick Best { get; private set; }

    /// <summary>The miss of the best kick.</summary>
    public MeasuredMiss Miss { get; private set; }

    /// <summary>True if the best kick was simulated in fine steps.</summary>
    public bool IsFine { get; private set; }

    /// <summary>True if the best kick hits.</summary>
    public bool Hits => IsFine && Miss.Distance <= _request.Tolerance;

    public int Unknowns => 2;

    public int Equations => 3;

    public bool IsSpent => _solver.Iterations >= _request.MaximumIterations;

    /// <summary>The fine step, which is also that of a measurement, in s.</summary>
    public double FineStep { get; private set; }

    /// <summary>Begins a search.</summary>
    public void Begin(AimRequest request, in TargetFrame frame, int[] things)
    {
        _request = request;
        _frame = frame;
        _things = things;
        _bounds = ElevationBounds.Of(request);
        FineStep = MeasuringStep.Of(_simulator, _upward, request.Speed, Kick.Of(request, 0, 0).SpinRate, MotionState.Airborne);
        Simulations = 0;
        Iterations = 0;

        // Start with a default kick, because no kick may hit the objects.
        IsFine = false;
        Best = Kick.Of(request, _bounds.Clamp(0.3), 0);
        Miss = new MeasuredMiss(Vector3d.Distance(frame.From, in frame.Target), null, 0, frame.From);
    }

    /// <summary>Simulates a kick in coarse steps.</summary>
    /// <returns>The miss; infinite if the kick does not hit the required objects.</returns>
    public double Look(double elevation, double azimuth) => Fly(elevation, azimuth, CoarseStep) ? _flight.Miss : double.PositiveInfinity;

    /// <summary>Corrects a kick by its miss.</summary>
    public void Improve(double elevation, double azimuth)
    {
        _x[0] = _bounds.Clamp(elevation);
        _x[1] = azimuth;
        _solver.Iterations = 0;
        _solver.Solve(_x);
        Iterations += _solver.Iterations;
    }

    public bool IsFree(int unknown) => true;

    public double Clamp(int unknown, double value) => unknown == 0 ? _bounds.Clamp(value) : value;

    public double LargestChange(int unknown) => LargestTurn;

    public double Difference(int unknown) => Width;

    public bool IsHit(double[] r) => new Vector3d(r[0], r[1], r[2]).Length <= Enough * _request.Tolerance;

    public bool Evaluate(double[] x, double[] r)
    {
        bool meets = Fly(x[0], x[1], FineStep);
        Vector3d gap = _flight.Position - _frame.Target;
        (r[0], r[1], r[2]) = (gap.X, gap.Y, gap.Z);
        return meets;
    }

    public void KnownColumns(double[] x, double[] j)
    {
        // There are no known columns: finite differences yield both.
    }

    private bool Fly(double elevation, double azimuth, double step)
    {
        Kick kick = Kick.Of(_request, elevation, azimuth);
        kick.Vectors(_request.Speed, in _frame.Forward, out Vector3d velocity, out Vector3d spin);
        BallState state = _simulator.LaunchAt(_request.From, velocity, spin, _request.KickTime, in _frame.Orientation);
        Simulations++;
        _flight.Fly(state, step, LongestFlight, in _frame.Target, Vector3d.Zero, null, _things);
        // A kick simulated with fine steps always takes precedence over one with coarse steps.
        bool isFine = step == FineStep;
        if (_flight.HasMetAll && (isFine == IsFine ? _flight.Miss < Miss.Distance : isFine))
        {
            (Best, IsFine) = (kick, isFine);
            Miss = new MeasuredMiss(_flight.Miss, null, _flight.Time, _flight.Position);
        }

        return _flight.HasMetAll;
    }
}
