namespace FootballPhysics.Thesis;

/// <summary>Flies kicks in the game's own steps, as the thesis does, and looks at the frames between them.</summary>
internal sealed class FrameShooter : KickObserver
{
    private readonly AimContext _context;
    private readonly Simulator _simulator;
    private readonly double _timeStep;
    private readonly KickFlight _flight;
    private FrameApproach? _before;

    /// <param name="context">Where flights are counted.</param>
    /// <param name="simulator">The scene with the game's own integrator.</param>
    /// <param name="timeStep">The game's own step, s.</param>
    public FrameShooter(AimContext context, Simulator simulator, double timeStep)
    {
        _context = context;
        _simulator = simulator;
        _timeStep = timeStep;
        _flight = new KickFlight(simulator, this);
    }

    /// <summary>How the last flight came to the point that it was for.</summary>
    public FrameApproach Target { get; } = new();

    /// <summary>How it came to a point on the way.</summary>
    public FrameApproach Through { get; } = new();

    /// <summary>Flies a kick past a point.</summary>
    public void Fly(in Vector3d from, in Vector3d velocity, in Vector3d spin, in Vector3d point)
    {
        Target.Begin(in from, in point);
        Run(in from, in velocity, in spin, null);
    }

    /// <summary>Flies a kick past a point, and until a plane through it is crossed.</summary>
    public void FlyToPlane(in Vector3d from, in Vector3d velocity, in Vector3d spin, in Vector3d point, in Vector3d normal)
    {
        Target.Begin(in from, in point);
        Target.WantCrossing(in normal);
        Run(in from, in velocity, in spin, null);
    }

    /// <summary>Flies a kick past two points.</summary>
    public void FlyThrough(in Vector3d from, in Vector3d velocity, in Vector3d spin, in Vector3d through, in Vector3d point)
    {
        Target.Begin(in from, in point);
        Through.Begin(in from, in through);
        Run(in from, in velocity, in spin, Through);
    }

    public override double StepFrom(in BallState state, out bool watches)
    {
        watches = false;
        return _timeStep;
    }

    public override bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended)
    {
        // What comes before the target is looked at until it is passed; the flight ends with the ground, or past both.
        _before = _before is not null && _before.Add(in after) ? null : _before;
        ended |= Target.Add(in after) && _before is null;
        return false;
    }

    private void Run(in Vector3d from, in Vector3d velocity, in Vector3d spin, FrameApproach? before)
    {
        BallState state = _simulator.Launch(from, velocity, spin);
        _before = before;
        _flight.Fly(ref state, AimContext.LongestFlight);
        _context.CountSimulation(_flight.Pieces);
    }
}

/// <summary>A flight's closest approach to a point by the thesis' fast error (4.1.3): on the segments beside the nearest frame.</summary>
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

    /// <summary>True when the plane through the point was crossed.</summary>
    public bool Crossed { get; private set; }

    /// <summary>Where, between frames, m.</summary>
    public Vector3d Crossing { get; private set; }

    /// <summary>The closest point between frames, m.</summary>
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

    /// <summary>Distance of the closest point between frames from the point, m.</summary>
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

    /// <summary>Also asks for the crossing of the vertical plane through the point.</summary>
    public void WantCrossing(in Vector3d normal)
    {
        _normal = normal;
        _wantsCrossing = true;
    }

    /// <summary>Takes the next frame.</summary>
    /// <returns>True when it has seen enough.</returns>
    public bool Add(in BallState frame)
    {
        Vector3d p = frame.Position;
        double squared = (p - _point).LengthSquared;
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

            // Past the nearest frame: the answer is known.
            passed = Vector3d.Dot(p - _point, frame.Velocity) > 0;
        }

        if (_wantsCrossing && !Crossed)
        {
            double before = Vector3d.Dot(_previous - _point, in _normal);
            double after = Vector3d.Dot(p - _point, in _normal);
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
