namespace Football.Physics;

/// <summary>
/// The boundary-value problem as the thesis' single-target methods see it: kicks are flown in the game's own frames, and their residual is the
/// closest point between frames.
/// </summary>
internal sealed class FrameProblem
{
    /// <summary>The closest point between frames is a little off the true one: methods end this far inside the tolerance.</summary>
    public const double Margin = 0.9;

    private readonly AimContext _context;
    private readonly FrameShooter _frames;
    private TargetFrame _frame;
    private ElevationBounds _bounds;
    private double _speed;
    private double _tolerance;
    private Kick _best;
    private double _bestMiss;

    public FrameProblem(AimContext context, FrameShooter frames)
    {
        _context = context;
        _frames = frames;
    }

    public ref readonly TargetFrame Frame => ref _frame;

    public ElevationBounds Bounds => _bounds;

    /// <summary>The last kick.</summary>
    public Kick Kick { get; private set; }

    /// <summary>Its closest point between frames.</summary>
    public Vector3d Closest { get; private set; }

    /// <summary>Its miss distance between frames.</summary>
    public double Miss { get; private set; }

    /// <summary>Sets the problem.</summary>
    public void Set(AimRequest request, double top, double side)
    {
        _frame = _context.Frame(request);
        _bounds = ElevationBounds.Of(request);
        _speed = request.Speed;
        _tolerance = request.Tolerance;
        Kick = new Kick { Top = top, Side = side };
        Miss = double.PositiveInfinity;
        Closest = _frame.From;
        _bestMiss = double.PositiveInfinity;
        _best = Kick;
    }

    public void Fly(in Kick kick)
    {
        Kick = kick;
        kick.Vectors(_speed, in _frame.Forward, out Vector3d velocity, out Vector3d spin);
        _frames.Fly(in _frame.From, in velocity, in spin, in _frame.Target);
        Closest = _frames.Target.Closest;
        Miss = Vector3d.Distance(Closest, in _frame.Target);
        if (Miss < _bestMiss)
        {
            _bestMiss = Miss;
            _best = kick;
        }
    }

    /// <summary>Flies the highest and the lowest kick: the target is in reach where they pass above and below it (4.1.2).</summary>
    /// <param name="extreme">Where it is not: the extreme kick to return.</param>
    public bool BetweenExtremes(out AimSolution extreme)
    {
        extreme = default;
        Kick kick = Kick;
        kick.Elevation = _bounds.Lowest;
        Elementary.SinCos(_bounds.Lowest, out double sine, out _);
        double targetHeight = _frame.Target.Y;
        double lowHeight = _frame.From.Y;
        double lowMiss = double.PositiveInfinity;
        if (!(targetHeight > _frame.From.Y + _tolerance && _context.StaysDown(in _frame.From, _speed * sine)))
        {
            // Along the ground it passes below: that needs no flight.
            Fly(in kick);
            lowHeight = Closest.Y;
            lowMiss = Miss;
        }

        kick.Elevation = _bounds.Highest;
        Fly(in kick);
        bool above = Closest.Y > targetHeight || Miss <= _tolerance;
        if (above && (lowHeight < targetHeight || lowMiss <= _tolerance))
        {
            return true;
        }

        if (lowHeight > targetHeight)
        {
            kick.Elevation = _bounds.Lowest;
        }

        // The extreme kick, turned horizontally as the thesis' later iterations would.
        extreme = Solution(in kick, kick.Elevation == _bounds.Highest ? Miss : lowMiss, 0);
        extreme.Status = _frame.IsDegenerate ? AimStatus.Degenerate : AimStatus.OutOfReach;
        return false;
    }

    /// <summary>The horizontal angle from where the ball went to the target, rad.</summary>
    public double HorizontalAngle()
    {
        Vector3d guess = Closest - _frame.From;
        Vector3d target = _frame.Target - _frame.From;

        // ŷ-component of guess × target over their horizontal scalar product
        double sine = (guess.Z * target.X) - (guess.X * target.Z);
        double cosine = (guess.X * target.X) + (guess.Z * target.Z);
        return Elementary.Atan2(sine, cosine);
    }

    /// <summary>The best kick so far.</summary>
    public AimSolution Best(int iterations) => Solution(in _best, _bestMiss, iterations);

    private AimSolution Solution(in Kick kick, double miss, int iterations) => new()
    {
        Status = miss <= _tolerance ? AimStatus.Hit : AimStatus.NotConverged,
        Kick = kick,
        Forward = _frame.Forward,
        Speed = _speed,
        Miss = miss,
        Iterations = iterations,
    };
}
