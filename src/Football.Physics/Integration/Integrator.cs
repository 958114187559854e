namespace FootballPhysics;

/// <summary>The one-step methods on offer.</summary>
/// <remarks>
/// Velocity Verlet is not offered: its advantage rests on an acceleration that depends on position alone. A ball's drag and Magnus
/// force depend on velocity and spin, so the new acceleration needs the new velocity and the other way round; solved by iteration
/// it costs as much as midpoint, and solved by extrapolation it is a worse midpoint.
/// </remarks>
public enum Integrator
{
    /// <summary>Explicit Euler: order 1, one evaluation a step.</summary>
    Euler = 0,

    /// <summary>Semi-implicit (symplectic) Euler: order 1, one evaluation a step.</summary>
    SemiImplicitEuler = 1,

    /// <summary>Midpoint Runge–Kutta: order 2, two evaluations a step.</summary>
    Rk2 = 2,

    /// <summary>Classical Runge–Kutta: order 4, four evaluations a step.</summary>
    Rk4 = 3,
}
