namespace FootballPhysics.Thesis;

/// <summary>Simulates kicks in the game's own steps, as the thesis does, and checks the path between frames.</summary>
internal sealed class FrameShooter
{
    private readonly AimContext _context;
    private readonly Simulator _simulator;
    private readonly double _timeStep;
    private readonly StepLog _log = new() { IgnoresZones = true };

    /// <param name="context">Counts the flights.</param>
    /// <param name="simulator">The scene with the game's own integrator.</param>
    /// <param name="timeStep">The game's own step, in s.</param>
    public FrameShooter(AimContext context, Simulator simulator, double timeStep)
    {
        _context = context;
        _simulator = simulator;
        _timeStep = timeStep;
        Orientation = simulator.LaunchOrientation;
    }

    /// <summary>The orientation of the ball at the kick.</summary>
    public Quaterniond Orientation { get; set; }

    /// <summary>The closest approach of the last flight to its target.</summary>
    public FrameApproach Target { get; } = new();

    /// <summary>The closest approach of the last flight to its waypoint.</summary>
    public FrameApproach Through { get; } = new();

    /// <summary>Simulates a kick past a point.</summary>
    public void Fly(in Vector3d from, in Vector3d velocity, in Vector3d spin, in Vector3d point)
    {
        Target.Begin(in from, in point);
        Run(in from, in velocity, in spin, null);
    }

    /// <summary>Simulates a kick past a point until it crosses a plane through the point.</summary>
    public void FlyToPlane(in Vector3d from, in Vector3d velocity, in Vector3d spin, in Vector3d point, in Vector3d normal)
    {
        Target.Begin(in from, in point);
        Target.TrackCrossing(in normal);
        Run(in from, in velocity, in spin, null);
    }

    /// <summary>Simulates a kick past two points.</summary>
    public void FlyThrough(in Vector3d from, in Vector3d velocity, in Vector3d spin, in Vector3d through, in Vector3d point)
    {
        Target.Begin(in from, in point);
        Through.Begin(in from, in through);
        Run(in from, in velocity, in spin, Through);
    }

    private void Run(in Vector3d from, in Vector3d velocity, in Vector3d spin, FrameApproach? before)
    {
        // Track the waypoint until the ball has passed it. The flight ends on the ground, or past both points.
        BallState state = _simulator.LaunchAt(in from, in velocity, in spin, 0, Orientation);
        _log.Clear();
        bool isOver = false;
        while (!isOver && state.Time < AimContext.LongestFlight && _log.Steps < AimContext.MostPieces)
        {
            bool ended = _simulator.StepToImpact(ref state, _timeStep, _log);
            before = before is not null && before.Add(in state) ? null : before;
            isOver = (Target.Add(in state) && before is null) || ended;
        }

        _context.CountSimulation(_log.Steps);
    }
}

/// <summary>The closest approach of a flight to a point by the thesis' fast error (4.1.3), on the segments next to the nearest frame.</summary>
internal sealed class FrameApproach
{
    private Vector3d _point;
    private Vector3d _previous;
    private Vector3d _nearest;
    private Vector3d _before;
    private Vector3d _after;
    private bool _hasBefore;
    private bool _hasAfter;
    private double _best;
    private Vector3d _normal;
    private bool _wantsCrossing;

    /// <summary>True if the flight crossed the plane through the point.</summary>
    public bool Crossed { get; private set; }

    /// <summary>The crossing, between frames, in m.</summary>
    public Vector3d Crossing { get; private set; }

    /// <summary>The closest point, between frames, in m.</summary>
    public Vector3d Closest
    {
        get
        {
            Vector3d best = _nearest;
            double squared = _best;
            if (_hasBefore)
            {
                Take(OnSegment(in _before, in _nearest), ref best, ref squared);
            }

            if (_hasAfter)
            {
                Take(OnSegment(in _nearest, in _after), ref best, ref squared);
            }

            return best;
        }
    }

    /// <summary>The distance between the closest point and the target point, in m.</summary>
    public double Miss => Vector3d.Distance(Closest, in _point);

    /// <summary>Starts a flight.</summary>
    public void Begin(in Vector3d from, in Vector3d point)
    {
        _point = point;
        _previous = from;
        _nearest = from;
        _best = (from - point).LengthSquared;
        _hasBefore = false;
        _hasAfter = false;
        _wantsCrossing = false;
        Crossed = false;
    }

    /// <summary>Also tracks the crossing of the vertical plane through the point.</summary>
    public void TrackCrossing(in Vector3d normal)
    {
        _normal = normal;
        _wantsCrossing = true;
    }

    /// <summary>Adds the next frame.</summary>
    /// <returns>True if no more frames are needed.</returns>
    public bool Add(in BallState frame)
    {
        Vector3d p = frame.Position;
        Vector3d gap = p - _point;
        double squared = gap.LengthSquared;
        bool passed = false;
        if (squared < _best)
        {
            _best = squared;
            _before = _previous;
            _nearest = p;
            _hasBefore = true;
            _hasAfter = false;
        }
        else
        {
            if (!_hasAfter)
            {
                _after = p;
                _hasAfter = true;
            }

            // The ball has passed the nearest frame, so the result is final.
            passed = Vector3d.Dot(in gap, frame.Velocity) > 0;
        }

        if (_wantsCrossing && !Crossed)
        {
            double before = Vector3d.Dot(_previous - _point, in _normal);
            double after = Vector3d.Dot(in gap, in _normal);
            if (before < 0 && after >= 0)
            {
                Crossed = true;
                Crossing = _previous + (before / (before - after) * (p - _previous));
            }
        }

        _previous = p;
        return passed && (!_wantsCrossing || Crossed);
    }

    private Vector3d OnSegment(in Vector3d a, in Vector3d b)
    {
        Vector3d ab = b - a;
        double length = ab.LengthSquared;
        double s = length > 0 ? Vector3d.Dot(_point - a, in ab) / length : 0;
        return a + ((s < 0 ? 0 : s > 1 ? 1 : s) * ab);
    }

    private void Take(in Vector3d candidate, ref Vector3d best, ref double squared)
    {
        double distance = (candidate - _point).LengthSquared;
        if (distance < squared)
        {
            squared = distance;
            best = candidate;
        }
    }
}
