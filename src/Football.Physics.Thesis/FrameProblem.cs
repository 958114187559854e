using FootballPhysics.Numerics;

namespace FootballPhysics.Thesis;

/// <summary>The boundary-value problem of the thesis' single-target methods.</summary>
/// <remarks>It simulates kicks in the game's own frames. The residual is the closest point between frames.</remarks>
internal sealed class FrameProblem
{
    /// <summary>The share of the tolerance at which the methods end. The rest covers the error of the closest point between frames.</summary>
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

    /// <summary>The velocity of the last kick, in m/s.</summary>
    public Vector3d Velocity { get; private set; }

    /// <summary>The closest point of the last kick, between frames.</summary>
    public Vector3d Closest { get; private set; }

    /// <summary>The miss of the last kick, between frames, in m.</summary>
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
        Velocity = velocity;
        _frames.Fly(in _frame.From, in velocity, in spin, in _frame.Target);
        Closest = _frames.Target.Closest;
        Miss = Vector3d.Distance(Closest, in _frame.Target);
        if (Miss < _bestMiss)
        {
            _bestMiss = Miss;
            _best = kick;
        }
    }

    /// <summary>Simulates the highest and lowest kicks. Returns true if the target is in reach (4.1.2).</summary>
    /// <remarks>It is in reach if they pass above and below it.</remarks>
    /// <param name="extreme">The extreme kick to return if the target is out of reach.</param>
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
            // A kick along the ground passes below the target, so skip its simulation.
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

        // Rotate the extreme kick horizontally, as later iterations of the thesis would.
        extreme = Solution(in kick, kick.Elevation == _bounds.Highest ? Miss : lowMiss, 0);
        extreme.Reason = _frame.IsDegenerate ? AimReason.NoDirection : AimReason.SameSide;
        return false;
    }

    /// <summary>Returns the horizontal angle from the direction that the ball took to the target, in rad.</summary>
    public double HorizontalAngle()
    {
        Vector3d guess = Closest - _frame.From;
        Vector3d target = _frame.Target - _frame.From;

        // The ŷ component of guess × target, and their horizontal dot product.
        double sine = (guess.Z * target.X) - (guess.X * target.Z);
        double cosine = (guess.X * target.X) + (guess.Z * target.Z);
        return Elementary.Atan2(sine, cosine);
    }

    /// <summary>Returns the best kick so far.</summary>
    public AimSolution Best(int iterations) => Solution(in _best, _bestMiss, iterations);

    /// <summary>Returns the solution for a kick and its miss, in m.</summary>
    public AimSolution Solution(in Kick kick, double miss, int iterations) => new()
    {
        Reason = miss <= _tolerance ? AimReason.Hit : AimReason.NoneFound,
        Kick = kick,
        Forward = _frame.Forward,
        Speed = _speed,
        Miss = miss,
        Iterations = iterations,
    };
}

/// <summary>The thesis' Method A (4.1): simulate, then rotate the velocity by the angle between the ball's path and the target.</summary>
internal sealed class AngleAim
{
    /// <summary>The number of rotations after which one predicts the next: the first is from a far kick, and shrinks the miss more.</summary>
    private const int LeastRotations = 2;

    /// <summary>The contraction below which it predicts the next, and the share of the tolerance that a predicted miss may use; the rest covers the prediction's error.</summary>
    private const double Clear = 0.3;
    private const double Sure = 0.8;

    private readonly FrameProblem _problem;

    public AngleAim(AimContext context, FrameShooter frames) => _problem = new FrameProblem(context, frames);

    public AimSolution Find(AimRequest request)
    {
        _problem.Set(request, request.TopSpin, request.SideSpin);
        return _problem.BetweenExtremes(out AimSolution extreme) ? Iterate(request, FrameProblem.Margin) : extreme;
    }

    /// <summary>Iterates from a given kick: the fallback of the two-point method.</summary>
    /// <param name="request">The request.</param>
    /// <param name="start">The first kick.</param>
    /// <param name="margin">The share of the tolerance at which it ends.</param>
    public AimSolution Refine(AimRequest request, in Kick start, double margin)
    {
        _problem.Set(request, start.Top, start.Side);
        _problem.Fly(in start);
        return Iterate(request, margin);
    }

    private AimSolution Iterate(AimRequest request, double margin)
    {
        int iterations = 0;
        double before = double.PositiveInfinity;
        while (_problem.Miss > margin * request.Tolerance && iterations < request.MaximumIterations)
        {
            iterations++;
            Kick turned = Turned();
            if (turned.Elevation == _problem.Kick.Elevation && turned.Azimuth == _problem.Kick.Azimuth)
            {
                break;
            }

            // A rotation shrinks the miss by about the same factor as the last one: skip a flight that would only confirm a hit.
            double contraction = _problem.Miss / before;
            before = _problem.Miss;
            if (iterations > LeastRotations && contraction < Clear && contraction * before < Sure * margin * request.Tolerance && turned.Elevation > _problem.Bounds.Lowest && turned.Elevation < _problem.Bounds.Highest)
            {
                return _problem.Solution(in turned, contraction * before, iterations);
            }

            _problem.Fly(in turned);
        }

        return _problem.Best(iterations);
    }

    private Kick Turned()
    {
        ref readonly TargetFrame frame = ref _problem.Frame;
        Vector3d direction = _problem.Velocity;
        return AngleCorrection.Turn(_problem.Closest - frame.From, frame.Target - frame.From, ref direction)
            ? frame.Turned(_problem.Kick, in direction, _problem.Bounds)
            : _problem.Kick;
    }
}

/// <summary>The thesis' correction of a kick (4.1).</summary>
/// <remarks>It rotates the velocity by the rotation that maps the direction the ball took to the direction of the target.</remarks>
internal static class AngleCorrection
{
    /// <summary>Rotates a direction about u_guess × u_target by the angle between them.</summary>
    /// <param name="guess">The vector from the ball's start to its closest point.</param>
    /// <param name="target">The vector from the ball's start to the target.</param>
    /// <param name="direction">The direction of the kick, of any length.</param>
    /// <returns>False if the angle is zero, or the axis undefined.</returns>
    public static bool Turn(in Vector3d guess, in Vector3d target, ref Vector3d direction)
    {
        // Rodrigues' formula. The normal's length is the sine of the angle, and dot its cosine, both times the same product of lengths.
        Vector3d normal = Vector3d.Cross(in guess, in target);
        double dot = Vector3d.Dot(in guess, in target);
        double lengths = Math.Sqrt(normal.LengthSquared + (dot * dot));
        if (!(normal.LengthSquared > 0 && lengths + dot > 0))
        {
            return false;
        }

        Vector3d turned = (dot * direction) + Vector3d.Cross(in normal, in direction) + (Vector3d.Dot(in normal, in direction) / (lengths + dot) * normal);
        direction = turned / lengths;
        return true;
    }
}

/// <summary>The thesis' Method B (4.2): bisect the elevation, and correct the azimuth by the horizontal angle each time.</summary>
internal sealed class BisectionAim
{
    private readonly FrameProblem _problem;

    public BisectionAim(AimContext context, FrameShooter frames) => _problem = new FrameProblem(context, frames);

    public AimSolution Find(AimRequest request) => Find(request, request.TopSpin, request.SideSpin);

    /// <summary>Finds a kick with other spins than those of the request.</summary>
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

    /// <summary>Condition: a kick of this elevation passes above the target. The search ends if it hits.</summary>
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
