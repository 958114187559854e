namespace FootballPhysics;

/// <summary>How a scene is integrated.</summary>
public sealed record SolverSettings
{
    /// <summary>The one-step method. Default <see cref="Integrator.Rk4"/>.</summary>
    public Integrator Integrator { get; init; } = Integrator.Rk4;

    /// <summary>How the instant of an impact is found. Default <see cref="CollisionTiming.Exact"/>.</summary>
    public CollisionTiming CollisionTiming { get; init; } = CollisionTiming.Exact;

    /// <summary>Where the search of <see cref="CollisionTiming.Bisection"/> ends, s. Above 0; default 1e-6.</summary>
    public double CollisionTolerance { get; init; } = 1e-6;

    /// <summary>How the end of a slide is found. Default <see cref="RollingTransition.Exact"/>.</summary>
    public RollingTransition RollingTransition { get; init; } = RollingTransition.Exact;

    /// <summary>True when steps end at the drag law's jump; off to show what that is worth.</summary>
    internal bool LocateJump { get; init; } = true;

    /// <summary>RK4, everything exact.</summary>
    public static SolverSettings Default { get; } = new();

    /// <summary>The cheapest integrator and step for a wanted accuracy: RK4 with steps of 80 ms, 40 ms or 5 ms.</summary>
    /// <param name="accuracy">How close to the exact solution a shot is to be, from the kick to the impact.</param>
    /// <param name="timeStep">The longest step to take, s. Shorter ones are only more accurate.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="accuracy"/> is none of the enumeration.</exception>
    public static SolverSettings For(Accuracy accuracy, out double timeStep)
    {
        Check.Defined(nameof(accuracy), accuracy, (int)accuracy, 3);
        timeStep = accuracy switch
        {
            Accuracy.Millimeter => 0.08,
            Accuracy.TenthOfMillimeter => 0.04,
            Accuracy.Micrometer => 0.005,
            _ => throw Check.Unknown(nameof(accuracy), accuracy),
        };
        return Default;
    }

    /// <summary>Checks every setting.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A setting is out of range; the message names field, value and range.</exception>
    public void Validate()
    {
        Check.Defined("solver.integrator", Integrator, (int)Integrator, 4);
        Check.Defined("solver.collisionTiming", CollisionTiming, (int)CollisionTiming, 2);
        Check.Positive("solver.collisionTolerance", CollisionTolerance);
        Check.Defined("solver.rollingTransition", RollingTransition, (int)RollingTransition, 2);
    }
}

/// <summary>How the instant of an impact is found inside a step.</summary>
public enum CollisionTiming
{
    /// <summary>The root of the step itself: closed form or one Newton correction.</summary>
    Exact = 0,

    /// <summary>The thesis' recursive search with re-integration (2.4.4), down to <see cref="SolverSettings.CollisionTolerance"/>.</summary>
    Bisection = 1,
}

/// <summary>How the end of a slide is found.</summary>
public enum RollingTransition
{
    /// <summary>Where the slip reaches zero, inside the step.</summary>
    Exact = 0,

    /// <summary>The thesis' heuristic (2.27, 2.28): at the end of the step in which the slip grew, or fell below 1 mm/s.</summary>
    Heuristic = 1,
}
