namespace FootballPhysics.Thesis;

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

/// <summary>The thesis' Method A (4.1): fly, and turn the velocity by the angle between where the ball went and the target.</summary>
internal sealed class AngleAim
{
    private readonly FrameProblem _problem;

    public AngleAim(AimContext context, FrameShooter frames) => _problem = new FrameProblem(context, frames);

    public AimSolution Find(AimRequest request)
    {
        _problem.Set(request, request.TopSpin, request.SideSpin);
        return _problem.BetweenExtremes(out AimSolution extreme) ? Iterate(request, FrameProblem.Margin) : extreme;
    }

    /// <summary>The iteration alone, from a kick that is not an extreme one: the two-point method's last resort.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="start">Where to begin.</param>
    /// <param name="margin">Share of the tolerance within which it ends.</param>
    public AimSolution Refine(AimRequest request, in Kick start, double margin)
    {
        _problem.Set(request, start.Top, start.Side);
        _problem.Fly(in start);
        return Iterate(request, margin);
    }

    private AimSolution Iterate(AimRequest request, double margin)
    {
        int iterations = 0;
        while (_problem.Miss > margin * request.Tolerance && iterations < request.MaximumIterations)
        {
            iterations++;
            Kick turned = Turned();
            if (turned.Elevation == _problem.Kick.Elevation && turned.Azimuth == _problem.Kick.Azimuth)
            {
                break;
            }

            _problem.Fly(in turned);
        }

        return _problem.Best(iterations);
    }

    private Kick Turned()
    {
        ref readonly TargetFrame frame = ref _problem.Frame;
        _problem.Kick.Vectors(1.0, in frame.Forward, out Vector3d direction, out _);
        return AngleCorrection.Turn(_problem.Closest - frame.From, frame.Target - frame.From, ref direction)
            ? frame.Turned(_problem.Kick, in direction, _problem.Bounds)
            : _problem.Kick;
    }
}

/// <summary>The thesis' correction of a kick (4.1): its velocity is turned as the way to where the ball went must be turned to lead to the target.</summary>
internal static class AngleCorrection
{
    /// <summary>Turns a direction about u_guess × u_target by the angle between them.</summary>
    /// <param name="guess">From the ball to where it went.</param>
    /// <param name="target">From the ball to where it is to go.</param>
    /// <param name="direction">The direction of the kick.</param>
    /// <returns>False where there is nothing to turn by, or no axis to turn about.</returns>
    public static bool Turn(in Vector3d guess, in Vector3d target, ref Vector3d direction)
    {
        Vector3d normal = Vector3d.Cross(in guess, in target);
        double sine = normal.Length;
        if (!(sine > 0))
        {
            return false;
        }

        double angle = Elementary.Atan2(sine, Vector3d.Dot(in guess, in target));
        direction = Quaterniond.FromAxisAngle(normal / sine, angle).Rotate(in direction);
        return true;
    }
}

/// <summary>The thesis' Method B (4.2): bisection over the elevation, the azimuth corrected by the horizontal angle each time.</summary>
internal sealed class BisectionAim
{
    private readonly FrameProblem _problem;

    public BisectionAim(AimContext context, FrameShooter frames) => _problem = new FrameProblem(context, frames);

    public AimSolution Find(AimRequest request) => Find(request, request.TopSpin, request.SideSpin);

    /// <summary>Finds a kick with spins other than the request's.</summary>
    public AimSolution Find(AimRequest request, double top, double side)
    {
        _problem.Set(request, top, side);
        if (!_problem.BetweenExtremes(out AimSolution extreme))
        {
            return extreme;
        }

        double low = _problem.Bounds.Lowest;
        double high = _problem.Bounds.Highest;
        var passes = new PassesAbove(_problem, FrameProblem.Margin * request.Tolerance);
        if (_problem.Miss > passes.Tolerance)
        {
            Roots.Bisect(ref passes, ref low, ref high, request.MaximumIterations);
        }

        return _problem.Best(passes.Iterations);
    }

    /// <summary>The condition that a kick of an elevation passes above the target; done where it hits.</summary>
    private struct PassesAbove : ICondition
    {
        private readonly FrameProblem _problem;
        private double _azimuth;

        public PassesAbove(FrameProblem problem, double tolerance)
        {
            _problem = problem;
            _azimuth = problem.Kick.Azimuth + problem.HorizontalAngle();
            Tolerance = tolerance;
            Iterations = 0;
        }

        public double Tolerance { get; }

        public int Iterations { get; private set; }

        public bool Evaluate(double x, out bool holds)
        {
            Iterations++;
            Kick kick = _problem.Kick;
            kick.Elevation = x;
            kick.Azimuth = _azimuth;
            _problem.Fly(in kick);
            _azimuth += _problem.HorizontalAngle();
            holds = !(_problem.Closest.Y < _problem.Frame.Target.Y);
            return !(_problem.Miss > Tolerance);
        }
    }
}
