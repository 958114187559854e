namespace Football.Physics;

/// <summary>
/// The boundary-value problem for a point on the way and a target: four unknowns (elevation, azimuth, topspin, sidespin), four equations (the
/// crossings of both points' planes, to the left and up).
/// </summary>
internal sealed class TwoPointProblem
{
    /// <summary>Unknowns, and equations.</summary>
    public const int Size = 4;

    public const int Elevation = 0;
    public const int Azimuth = 1;
    public const int Top = 2;
    public const int Side = 3;

    public const int ThroughLeft = 0;
    public const int ThroughUp = 1;
    public const int TargetLeft = 2;
    public const int TargetUp = 3;

    /// <summary>A miss distance at the point on the way well below any tolerance worth having, m.</summary>
    public const double FineThrough = 1e-2;

    private readonly AimContext _context;
    private TargetFrame _frame;
    private FittedFlight _fitted;
    private double _drag;
    private PlaneCrossing _atThrough;
    private PlaneCrossing _atTarget;
    private double _throughTime;
    private double _targetTime;
    private double _step;
    private double _firstStep;

    public TwoPointProblem(AimContext context) => _context = context;

    public AimRequest Request { get; private set; } = new();

    public ref readonly TargetFrame Frame => ref _frame;

    public ElevationBounds Bounds { get; private set; }

    /// <summary>The point on the way, m.</summary>
    public Vector3d Through { get; private set; }

    /// <summary>Its horizontal distance towards the target, m.</summary>
    public double ThroughDistance { get; private set; }

    /// <summary>Miss distance at the target within which the search ends, m.</summary>
    public double Tolerance { get; private set; }

    /// <summary>The same for the point on the way.</summary>
    public double ThroughTolerance { get; private set; }

    /// <summary>When the last kick was at the target, s.</summary>
    public double Time => _targetTime;

    /// <summary>Sets the problem.</summary>
    /// <returns>False where the point does not lie on the way to the target.</returns>
    public bool Set(AimRequest request)
    {
        Request = request;
        _frame = _context.Frame(request);
        ref readonly TargetFrame frame = ref _frame;
        Bounds = ElevationBounds.Of(request);
        Through = AimContext.Raised(_context.Game, request.Through.GetValueOrDefault());
        ThroughDistance = Vector3d.Dot(Through - frame.From, in frame.Forward);
        Tolerance = AimContext.Sharp(request.Tolerance);
        ThroughTolerance = AimContext.Sharp(request.ThroughTolerance, FineThrough);
        if (!(frame.Distance > 1e-6 && ThroughDistance > 1e-3 * frame.Distance && ThroughDistance < 0.999 * frame.Distance))
        {
            return false;
        }

        _step = _context.Steps.HitWithin(Tolerance);
        _firstStep = _context.Steps.RehearsedWithin(Tolerance);
        _context.Planes.Aim(in frame, Vector3d.Zero);
        _context.Planes.AimThrough(Through, in frame.Forward);
        return true;
    }

    /// <summary>The kick that unknowns stand for.</summary>
    public static Kick KickOf(double[] x) => new() { Elevation = x[Elevation], Azimuth = x[Azimuth], Top = x[Top], Side = x[Side] };

    /// <summary>Miss distance at the target, m.</summary>
    public static double Miss(double[] r) => Math.Sqrt((r[TargetLeft] * r[TargetLeft]) + (r[TargetUp] * r[TargetUp]));

    /// <summary>Miss distance at the point on the way, m.</summary>
    public static double ThroughMiss(double[] r) => Math.Sqrt((r[ThroughLeft] * r[ThroughLeft]) + (r[ThroughUp] * r[ThroughUp]));

    /// <summary>Largest size of a spin, rad/s.</summary>
    public double Limit(int spin) => spin == Top ? Request.MaximumTopSpin : Request.MaximumSideSpin;

    /// <summary>Prepares the air that kicks are rehearsed in.</summary>
    /// <param name="drag">About how much drag there is a length, 1/m.</param>
    /// <param name="throughTime">About when a kick passes the point on the way, s.</param>
    /// <param name="targetTime">About when it is at the target, s.</param>
    public void Prepare(double drag, double throughTime, double targetTime)
    {
        _drag = drag;
        _throughTime = throughTime;
        _targetTime = targetTime;
        _fitted = default;
    }

    /// <summary>Flies a kick to both planes as it would fly in air that is fitted to about its own spin.</summary>
    /// <returns>False where it does not reach both.</returns>
    public bool Rehearse(double[] x, double[] r)
    {
        ref readonly TargetFrame frame = ref _frame;
        Kick kick = KickOf(x);
        kick.Vectors(Request.Speed, in frame.Forward, out Vector3d velocity, out Vector3d spin);
        double spinRate = kick.SpinRate;
        if (!_fitted.Fits(spinRate))
        {
            _fitted.Fit(_context, (velocity - _context.Scene.Air.Wind).Length, spinRate, _drag, _targetTime);
        }

        _fitted.Begin(in frame.From, in velocity, in spin);
        _atThrough = new PlaneCrossing(Through, Vector3d.Zero, in frame.Forward);
        _atTarget = new PlaneCrossing(in frame.Target, Vector3d.Zero, in frame.Forward);
        bool reaches = _fitted.Fly(_throughTime, ref _atThrough) && _fitted.Fly(_targetTime, ref _atTarget);
        if (reaches)
        {
            TakeCrossings(r);
        }

        return reaches;
    }

    /// <summary>Flies a kick to both planes.</summary>
    /// <param name="x">The unknowns.</param>
    /// <param name="r">The residuals.</param>
    /// <param name="isRehearsed">Whether it is to show no more than how far a rehearsed kick is off.</param>
    /// <returns>False where it does not reach both.</returns>
    public bool Fly(double[] x, double[] r, bool isRehearsed)
    {
        KickOf(x).Vectors(Request.Speed, in _frame.Forward, out Vector3d velocity, out Vector3d spin);
        PlaneShooter planes = _context.Planes;
        planes.Fly(in _frame.From, in velocity, in spin, isRehearsed ? _firstStep : _step, _throughTime, _targetTime);
        _atThrough = planes.Through;
        _atTarget = planes.Target;
        bool reaches = _atThrough.Crossed && _atTarget.Crossed;
        if (reaches)
        {
            TakeCrossings(r);
        }

        return reaches;
    }

    /// <summary>How the last crossing of the plane of the point on the way moves with the angles of its kick.</summary>
    public CrossingJacobian JacobianAtThrough(double[] x) => Jacobian(KickOf(x), in _atThrough);

    /// <summary>The same for the plane of the target.</summary>
    public CrossingJacobian JacobianAtTarget(double[] x) => Jacobian(KickOf(x), in _atTarget);

    private CrossingJacobian Jacobian(in Kick kick, in PlaneCrossing crossing) =>
        CrossingJacobian.Of(in kick, in crossing, in _frame, _context.Scene.Air.Wind, _context.Upward);

    /// <summary>Takes the residuals, and when to look for the next crossings.</summary>
    private void TakeCrossings(double[] r)
    {
        _throughTime = _atThrough.Time;
        _targetTime = _atTarget.Time;
        r[ThroughLeft] = Vector3d.Dot(_atThrough.Offset, in _frame.Left);
        r[ThroughUp] = _atThrough.Offset.Y;
        r[TargetLeft] = Vector3d.Dot(_atTarget.Offset, in _frame.Left);
        r[TargetUp] = _atTarget.Offset.Y;
    }

    /// <summary>Whether the last flight leaves the ground and stays above it, or above where it began.</summary>
    public bool StaysClear(double[] x)
    {
        Elementary.SinCos(x[Elevation], out double sine, out _);
        double lowest = _context.Planes.Lowest;
        return !_context.StaysDown(in _frame.From, Request.Speed * sine)
            && (lowest >= _context.Game.ContactHeight - 1e-9 || lowest >= _frame.From.Y - 1e-9);
    }
}

/// <summary>
/// The start of a two-point kick in closed form. The way bends sideways like a parabola of the time, so the two bearings give azimuth and side
/// curvature; up and down likewise with gravity's fall taken out; curvatures are then turned into spins.
/// </summary>
internal static class TwoPointGuess
{
    /// <summary>Guesses the unknowns of a problem.</summary>
    /// <param name="context">The laws.</param>
    /// <param name="problem">The problem.</param>
    /// <param name="x">The unknowns.</param>
    /// <param name="throughTime">About when the kick passes the point on the way, s.</param>
    /// <param name="targetTime">About when it is at the target, s.</param>
    /// <returns>Drag a length, 1/m.</returns>
    public static double Make(AimContext context, TwoPointProblem problem, double[] x, out double throughTime, out double targetTime)
    {
        // Three rounds: times from the drag, bearings and curvatures from both points, the spin from the curvature; each changes the drag of the next.
        AimRequest request = problem.Request;
        ref readonly TargetFrame frame = ref problem.Frame;
        Vector3d wind = context.Scene.Air.Wind;
        double mostSpin = Math.Sqrt((request.MaximumTopSpin * request.MaximumTopSpin) + (request.MaximumSideSpin * request.MaximumSideSpin));
        double spinRate = Math.Max(10.0, Math.Sqrt((request.TopSpin * request.TopSpin) + (request.SideSpin * request.SideSpin)));
        double top = 0;
        double side = 0;
        double azimuth = 0;
        double elevation = 0.2;
        double drag = 0;
        throughTime = 0;
        targetTime = 0;
        for (int i = 0; i < 3; i++)
        {
            FlatFire model = context.Model(request.Speed, spinRate, frame.Distance);
            Elementary.SinCos(elevation, out _, out double cosine);
            drag = model.Drag;
            double t1 = model.TimeFor(request.Speed, problem.ThroughDistance / Math.Max(cosine, 0.3));
            double t2 = model.TimeFor(request.Speed, frame.Distance / Math.Max(cosine, 0.3));
            throughTime = t1;
            targetTime = t2;
            model.Ways(request.Speed, t1, out double s1, out _, out double fall1, out double bend1);
            model.Ways(request.Speed, t2, out double s2, out _, out double fall2, out double bend2);

            // Offsets after gravity and wind: s · slope + bend · c at both points
            double left1 = Vector3d.Dot(problem.Through - frame.From - (t1 * wind), in frame.Left);
            double left2 = Vector3d.Dot(frame.Target - frame.From - (t2 * wind), in frame.Left);
            double up1 = problem.Through.Y - frame.From.Y - (t1 * wind.Y) - (model.Upward * fall1);
            double up2 = frame.Target.Y - frame.From.Y - (t2 * wind.Y) - (model.Upward * fall2);
            double determinant = (s1 * bend2) - (s2 * bend1);
            double slopeLeft = ((left1 * bend2) - (left2 * bend1)) / determinant;
            double bendLeft = ((s1 * left2) - (s2 * left1)) / determinant;
            double slopeUp = ((up1 * bend2) - (up2 * bend1)) / determinant;
            double bendUp = ((s1 * up2) - (s2 * up1)) / determinant;

            // Lift L(|ω|) along ω: solved for |ω| by its law, L ~ |ω|^0.83
            double lift = Math.Sqrt((bendLeft * bendLeft) + (bendUp * bendUp));
            double share = model.Lift > 0 ? lift / model.Lift : 0;
            double grown = spinRate * Math.Min(Math.Max(share * (0.83 + (0.17 * share)), 0.1), 4.0);
            spinRate = Math.Min(Math.Max(grown, 0.5), 1.5 * mostSpin);
            if (!double.IsFinite(lift + slopeUp + slopeLeft))
            {
                // No way of the model passes there: straight at the target, and the single-target solver after it.
                side = 0;
                top = 0;
                break;
            }

            side = lift > 0 ? spinRate * bendLeft / lift : 0;
            top = lift > 0 ? -spinRate * bendUp / lift : 0;
            elevation = Math.Min(Math.Max(AngleOf(slopeUp), -1.2), 1.2);
            azimuth = AngleOf(slopeLeft);
        }

        x[TwoPointProblem.Elevation] = problem.Bounds.Clamp(elevation);
        x[TwoPointProblem.Azimuth] = azimuth;
        x[TwoPointProblem.Top] = Math.Min(Math.Max(top, -request.MaximumTopSpin), request.MaximumTopSpin);
        x[TwoPointProblem.Side] = Math.Min(Math.Max(side, -request.MaximumSideSpin), request.MaximumSideSpin);
        return drag;
    }

    /// <summary>The angle of a direction whose component across is known.</summary>
    private static double AngleOf(double across) => Elementary.Atan2(across, Math.Sqrt(Math.Max(0.05, 1.0 - (across * across))));
}
