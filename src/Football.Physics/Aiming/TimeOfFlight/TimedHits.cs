namespace Football.Physics;

/// <summary>What the searches over time share: which kicks are allowed, which hit, and how they are told.</summary>
internal sealed class TimedHits
{
    /// <summary>How far, rad, a kick may be off its bounds: it is put on them then.</summary>
    public const double OffBounds = 1e-9;

    private const int MostRootSteps = 16;

    private readonly AimContext _context;

    public TimedHits(AimContext context) => _context = context;

    /// <summary>Whether a kick is slow enough, and within its bounds.</summary>
    public static bool IsAllowed(TimedProblem problem, in TimedKick kick, double fastest) =>
        kick.Found && (kick.Speed <= fastest || IsNearly(problem, in kick, fastest)) && problem.Violation(in kick) <= OffBounds;

    /// <summary>Whether a kick that is a little slower than this one hits as well.</summary>
    public static bool IsNearly(TimedProblem problem, in TimedKick kick, double speed) =>
        kick.Found && kick.Miss + (Math.Abs(kick.Speed - speed) * kick.Time) <= problem.Tolerance;

    /// <summary>Whether a kick, put on its bounds, hits, measured.</summary>
    public bool IsHit(TimedProblem problem, in TimedKick kick, double speed, out AimSolution solution)
    {
        solution = Solution(problem, in kick, speed, AimStatus.Hit);
        if (!kick.Found || problem.Violation(in kick) > OffBounds)
        {
            return false;
        }

        solution.Vectors(out Vector3d velocity, out Vector3d spin);
        solution.Miss = _context.Miss.Measure(problem.Request, in velocity, in spin).Distance;
        return solution.Miss <= problem.Request.Tolerance;
    }

    public static AimSolution Solution(TimedProblem problem, in TimedKick kick, double speed, AimStatus status) => new()
    {
        Status = status,
        Kick = problem.KickOf(in kick.Velocity),
        Forward = problem.Frame.Forward,
        Speed = speed,
        Miss = kick.Miss,
        Time = kick.Time,
    };

    public static void Illinois<TFunction>(ref TFunction function, double low, double atLow, double high, double atHigh)
        where TFunction : struct, IFunction => Roots.Illinois(ref function, low, atLow, high, atHigh, 1e-12 * high, MostRootSteps);
}
