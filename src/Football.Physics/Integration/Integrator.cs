namespace FootballPhysics;

/// <summary>The available one-step methods.</summary>
/// <remarks>
/// Velocity Verlet is not included, because it is useful only if the acceleration depends on position alone. Drag and Magnus force depend on velocity and
/// spin, so the new acceleration needs the new velocity, and vice versa. With iteration, Verlet costs as much as midpoint; with extrapolation, it is less
/// accurate than midpoint.
/// </remarks>
public enum Integrator
{
    /// <summary>Explicit Euler: order 1, one evaluation per step.</summary>
    Euler = 0,

    /// <summary>Semi-implicit (symplectic) Euler: order 1, one evaluation per step.</summary>
    SemiImplicitEuler = 1,

    /// <summary>Midpoint Runge–Kutta: order 2, two evaluations per step.</summary>
    Rk2 = 2,

    /// <summary>Classical Runge–Kutta: order 4, four evaluations per step.</summary>
    Rk4 = 3,
}
