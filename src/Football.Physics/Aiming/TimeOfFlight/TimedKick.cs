namespace Football.Physics;

/// <summary>A kick that is at the target at a given time, or came close to that.</summary>
internal struct TimedKick
{
    /// <summary>The time, s after the kick.</summary>
    public double Time;

    /// <summary>Velocity of the kick, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>How the ball's place at that time moves with the kick's velocity.</summary>
    public VelocityJacobian Jacobian;

    /// <summary>Velocity of the ball then, relative to the target, m/s.</summary>
    public Vector3d Arrival;

    /// <summary>Distance from the target then, m.</summary>
    public double Miss;

    /// <summary>The lowest height on the way, m.</summary>
    public double Lowest;

    /// <summary>Whether the miss is small enough.</summary>
    public bool Found;

    /// <summary>Speed of the kick, m/s; infinite where it is more than is worth knowing, not a number where it is not known.</summary>
    public double Speed;

    /// <summary>How the speed changes with the logarithm of the time, m/s, along the kicks that hit; not a number where the Jacobian is singular.</summary>
    public readonly double Slope()
    {
        // J dv/dt = −ṗ
        return Jacobian.Solve(-Arrival, out Vector3d rate) ? Time * Vector3d.Dot(in Velocity, in rate) / Velocity.Length : double.NaN;
    }

    /// <summary>The kick for a time a little later or earlier, to first order.</summary>
    public readonly TimedKick At(double time)
    {
        TimedKick next = this;
        next.Time = time;

        // p(t; v) = q(t): J dv/dt = q̇ − ṗ
        if (Jacobian.Solve(-Arrival, out Vector3d rate))
        {
            next.Velocity += (time - Time) * rate;
        }

        return next;
    }
}

/// <summary>How the place of a ball at a given time moves with the velocity of its kick, s.</summary>
internal struct VelocityJacobian
{
    private Vector3d _byX;
    private Vector3d _byY;
    private Vector3d _byZ;

    public VelocityJacobian(in Vector3d byX, in Vector3d byY, in Vector3d byZ)
    {
        _byX = byX;
        _byY = byY;
        _byZ = byZ;
    }

    /// <summary>One that stretches differently along a direction and across it.</summary>
    /// <param name="direction">Unit vector.</param>
    /// <param name="along">Along it, s.</param>
    /// <param name="across">Across it, s.</param>
    public static VelocityJacobian Along(in Vector3d direction, double along, double across)
    {
        // J = a I + (b − a) û ûᵀ
        Vector3d more = (along - across) * direction;
        return new VelocityJacobian(
            (direction.X * more) + new Vector3d(across, 0, 0),
            (direction.Y * more) + new Vector3d(0, across, 0),
            (direction.Z * more) + new Vector3d(0, 0, across));
    }

    /// <summary>The same without influence of, or on, the vertical: for a ball on the ground.</summary>
    public readonly VelocityJacobian Horizontal(double vertical) => new(_byX.Horizontal, new Vector3d(0, vertical, 0), _byZ.Horizontal);

    /// <summary>The change of velocity that moves the ball: J Δv = Δp.</summary>
    /// <returns>False where the Jacobian is singular.</returns>
    public readonly bool Solve(in Vector3d move, out Vector3d change)
    {
        // Cramer's rule
        Vector3d yz = Vector3d.Cross(in _byY, in _byZ);
        double determinant = Vector3d.Dot(in _byX, in yz);
        change = new Vector3d(
            Vector3d.Dot(in move, in yz),
            Vector3d.Dot(in _byX, Vector3d.Cross(in move, in _byZ)),
            Vector3d.Dot(in _byX, Vector3d.Cross(in _byY, in move))) / determinant;
        return change.IsFinite;
    }

    /// <summary>How the place moves with a change of the velocity: J Δv, m.</summary>
    public readonly Vector3d Product(in Vector3d change) => (change.X * _byX) + (change.Y * _byY) + (change.Z * _byZ);

    /// <summary>Broyden's update after a change of the velocity moved the ball: J += (Δp − J Δv) Δvᵀ / |Δv|².</summary>
    public void Update(in Vector3d change, in Vector3d move)
    {
        double squared = change.LengthSquared;
        if (!(squared > 0))
        {
            return;
        }

        Vector3d error = (move - Product(in change)) / squared;
        _byX += change.X * error;
        _byY += change.Y * error;
        _byZ += change.Z * error;
    }
}

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
