using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>The integrator of a scene, and the methods that locate impacts and the end of a slide.</summary>
public sealed record SolverSettings
{
    /// <summary>The integrator. Default <see cref="Integrator.Rk4"/>.</summary>
    public Integrator Integrator { get; init; } = Integrator.Rk4;

    /// <summary>The method that finds the time of impact. Default <see cref="CollisionTiming.Exact"/>.</summary>
    public CollisionTiming CollisionTiming { get; init; } = CollisionTiming.Exact;

    /// <summary>The tolerance of <see cref="CollisionTiming.Bisection"/>, in s; above 0. Default 1e-6.</summary>
    public double CollisionTolerance { get; init; } = 1e-6;

    /// <summary>The method that finds the end of a slide. Default <see cref="RollingTransition.Exact"/>.</summary>
    public RollingTransition RollingTransition { get; init; } = RollingTransition.Exact;

    /// <summary>True if steps end at the jump in the drag law. Set it to false only to measure the effect.</summary>
    internal bool LocateJump { get; init; } = true;

    /// <summary>RK4 with exact impacts and transitions.</summary>
    public static SolverSettings Default { get; } = new();

    /// <summary>Returns the cheapest integrator and step for an accuracy: RK4 with steps of 80 ms, 40 ms or 5 ms.</summary>
    /// <param name="accuracy">The maximum error of a shot from the kick to the impact.</param>
    /// <param name="timeStep">The longest step to use, in s. Shorter steps are more accurate.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="accuracy"/> is not a value of the enumeration.</exception>
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

    /// <summary>Throws if a setting is out of range.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A setting is out of range. The message names the field, the value and the
    /// range.</exception>
    internal void Validate()
    {
        Check.Defined("solver.integrator", Integrator, (int)Integrator, 4);
        Check.Defined("solver.collisionTiming", CollisionTiming, (int)CollisionTiming, 2);
        Check.Positive("solver.collisionTolerance", CollisionTolerance);
        Check.Defined("solver.rollingTransition", RollingTransition, (int)RollingTransition, 2);
    }
}

/// <summary>The method that finds the time of impact inside a step.</summary>
public enum CollisionTiming
{
    /// <summary>Solves the step itself for the time of impact: in closed form, or by one Newton correction.</summary>
    Exact = 0,

    /// <summary>The thesis' bisection with re-integration (2.4.4), down to <see cref="SolverSettings.CollisionTolerance"/>.</summary>
    Bisection = 1,
}

/// <summary>The method that finds the end of a slide.</summary>
public enum RollingTransition
{
    /// <summary>Ends the slide at the instant inside the step at which the slip reaches zero.</summary>
    Exact = 0,

    /// <summary>The thesis' heuristic (2.27, 2.28): ends the slide at the end of a step in which the slip grew or fell below 1 mm/s.</summary>
    Heuristic = 1,
}
