namespace Football.Physics;

/// <summary>
/// The boundary-value problem for one target: which elevation and azimuth make a kick of given speed and spin cross the vertical plane through
/// the target in the target itself.
/// </summary>
internal sealed class PlaneProblem
{
    private readonly AimContext _context;
    private TargetFrame _frame;
    private double _step;
    private double _firstStep;
    private FlatFire _model;
    private FittedFlight _fitted;

    public PlaneProblem(AimContext context) => _context = context;

    public AimRequest Request { get; private set; } = new();

    public ref readonly TargetFrame Frame => ref _frame;

    public ElevationBounds Bounds { get; private set; }

    /// <summary>Speed of the kicks, m/s.</summary>
    public double Speed { get; private set; }

    /// <summary>The spins of the kicks; their angles are sought.</summary>
    public Kick Spins { get; private set; }

    /// <summary>Miss distance within which the search ends, m.</summary>
    public double Tolerance { get; private set; }

    /// <summary>Whether kicks are flown in short steps, because longer ones were wrong.</summary>
    public bool IsFine => _context.Steps.AreShort;

    /// <summary>Kicks flown.</summary>
    public int Shots { get; private set; }

    /// <summary>Sets the problem.</summary>
    public void Set(AimRequest request, double speed, double top, double side)
    {
        Request = request;
        Speed = speed;
        Spins = new Kick { Top = top, Side = side };
        _frame = _context.Frame(request);
        Bounds = ElevationBounds.Of(request);
        Tolerance = AimContext.Sharp(request.Tolerance);
        Shots = 0;
        _step = _context.Steps.HitWithin(Tolerance);
        _firstStep = _context.Steps.RehearsedWithin(Tolerance);
        _context.Planes.Aim(in _frame, request.TargetVelocity);
    }

    /// <summary>A first kick, from the flight in closed form.</summary>
    /// <returns>False where that does not reach the target.</returns>
    public bool Guess(out Kick kick, out double time)
    {
        ref readonly TargetFrame frame = ref _frame;
        _model = _context.Model(Speed, Spins.SpinRate, frame.Distance);
        Vector3d toTarget = frame.Target - frame.From;
        Vector3d direction = toTarget / toTarget.Length;
        Vector3d wind = _context.Scene.Air.Wind;
        Kick spins = Spins;
        time = frame.Distance / Speed * (1.0 + (0.5 * _model.Drag * frame.Distance));
        bool reached = _model.Solve(in toTarget, wind - Request.TargetVelocity, in wind, Speed, in spins, ref direction, ref time);
        kick = frame.Turned(Spins, in direction, Bounds);
        return reached;
    }

    /// <summary>Fits the flight that kicks are rehearsed in.</summary>
    public void Fit(in Kick kick, double time)
    {
        kick.Vectors(Speed, in _frame.Forward, out Vector3d velocity, out _);
        _fitted.Fit(_context, (velocity - _context.Scene.Air.Wind).Length, kick.SpinRate, _model.Drag, time);
    }

    /// <summary>Flies a kick to the target's plane as it would fly in the fitted air.</summary>
    public PlaneShot Rehearse(in Kick kick, double time)
    {
        ref readonly TargetFrame frame = ref _frame;
        kick.Vectors(Speed, in frame.Forward, out Vector3d velocity, out Vector3d spin);
        _fitted.Begin(in frame.From, in velocity, in spin);
        var crossing = new PlaneCrossing(in frame.Target, Request.TargetVelocity, in frame.Forward);
        _fitted.Fly(time, ref crossing);
        return Shot(in kick, in crossing);
    }

    /// <summary>Flies a kick to the target's plane.</summary>
    /// <param name="kick">The kick.</param>
    /// <param name="time">About when it is there, s; 0 where that is not known.</param>
    /// <param name="isRehearsed">Whether it is to show no more than how far a rehearsed kick is off.</param>
    public PlaneShot Fly(in Kick kick, double time, bool isRehearsed)
    {
        ref readonly TargetFrame frame = ref _frame;
        kick.Vectors(Speed, in frame.Forward, out Vector3d velocity, out Vector3d spin);
        PlaneShooter planes = _context.Planes;
        planes.Fly(in frame.From, in velocity, in spin, isRehearsed ? _firstStep : _step, 0, time);
        _context.CountIteration();
        Shots++;
        PlaneShot shot = Shot(in kick, in planes.Target);
        shot.Lowest = planes.Lowest;
        return shot;
    }

    private PlaneShot Shot(in Kick kick, in PlaneCrossing crossing)
    {
        double up = crossing.Offset.Y;
        double left = Vector3d.Dot(crossing.Offset, in _frame.Left);
        return new PlaneShot { Kick = kick, Crossing = crossing, Up = up, Left = left, Miss = Math.Sqrt((up * up) + (left * left)) };
    }

    /// <summary>How the crossing of a shot moves with elevation and azimuth.</summary>
    public CrossingJacobian Jacobian(in PlaneShot shot) =>
        CrossingJacobian.Of(in shot.Kick, in shot.Crossing, in _frame, _context.Scene.Air.Wind, _context.Upward);

    /// <summary>Whether a flight to the target leaves the ground and stays above it, so that no impact comes first.</summary>
    public bool StaysClear(in PlaneShot shot)
    {
        // One that stays on the ground from its start rolls: that is another problem.
        Elementary.SinCos(shot.Kick.Elevation, out double sine, out _);
        if (_context.StaysDown(in _frame.From, Speed * sine))
        {
            return false;
        }

        double lowest = Math.Min(shot.Lowest, _frame.Target.Y + (shot.Time * Request.TargetVelocity.Y) + shot.Up);
        return lowest >= _context.Game.ContactHeight - 1e-9;
    }
}

/// <summary>A kick that was flown to the target's plane, and its residual there.</summary>
internal struct PlaneShot
{
    public Kick Kick;

    /// <summary>Whether it got there.</summary>
    public readonly bool Crossed => Crossing.Crossed;

    /// <summary>When, s.</summary>
    public readonly double Time => Crossing.Time;

    /// <summary>Height above the target there, m.</summary>
    public double Up;

    /// <summary>Distance to the left of the target there, m.</summary>
    public double Left;

    /// <summary>Distance from the target there, m.</summary>
    public double Miss;

    /// <summary>The crossing.</summary>
    public PlaneCrossing Crossing;

    /// <summary>The lowest height on the way, m.</summary>
    public double Lowest;
}
