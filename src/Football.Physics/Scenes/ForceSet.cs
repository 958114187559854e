using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics;

/// <summary>The forces and torques of a scene. You can disable or replace each, and add your own.</summary>
public sealed record ForceSet
{
    /// <summary>True if buoyancy acts. Default true.</summary>
    public bool Buoyancy { get; init; } = true;

    /// <summary>The law of the drag force. Default <see cref="ForceLaw.Empirical"/>.</summary>
    public ForceLaw Drag { get; init; } = ForceLaw.Empirical;

    /// <summary>The law of the Magnus force. Default <see cref="ForceLaw.Empirical"/>.</summary>
    public ForceLaw Magnus { get; init; } = ForceLaw.Empirical;

    /// <summary>The law of the spin decay in air. Default <see cref="ForceLaw.Empirical"/>.</summary>
    public ForceLaw SpinDecay { get; init; } = ForceLaw.Empirical;

    /// <summary>The coefficients that the empirical laws use. Default <see cref="AerodynamicModel.Measured"/>.</summary>
    public AerodynamicModel Coefficients { get; init; } = AerodynamicModel.Measured;

    /// <summary>The drag coefficient C_D of the constant law. 0 … 10; default 0.25.</summary>
    public double DragCoefficient { get; init; } = 0.25;

    /// <summary>The Magnus coefficient C_M of the constant law. Within ±10; default 0.25.</summary>
    public double MagnusCoefficient { get; init; } = 0.25;

    /// <summary>The coefficient k of the constant spin decay, T = −k ω, in N m s. Default 0.</summary>
    /// <remarks>0 … 1, and at most the moment of inertia times 1e5/s.</remarks>
    public double SpinDecayCoefficient { get; init; }

    /// <summary>The seed of a kick for the knuckle force, a side force on a ball with little spin. Default null: no knuckle force.</summary>
    /// <remarks>
    /// The force acts only in flight, under any law. Its larger part belongs to the ball (<see cref="BallProperties.SeamSeed"/>) and depends on the orientation. Its
    /// smaller part, the wake, depends on this seed, and restarts with each kick. A ball that is launched without an orientation gets a random one from this seed.
    /// </remarks>
    public long? KnuckleSeed { get; init; }

    /// <summary>The custom forces, added in this order. Default: none.</summary>
    public IReadOnlyList<IForce> CustomForces { get; init; } = [];

    /// <summary>No air: only gravity acts in flight.</summary>
    public static ForceSet None { get; } = new() { Buoyancy = false, Drag = ForceLaw.None, Magnus = ForceLaw.None, SpinDecay = ForceLaw.None };

    /// <summary>Constant coefficients: the cheapest laws of the air.</summary>
    public static ForceSet Constant { get; } = new() { Drag = ForceLaw.Constant, Magnus = ForceLaw.Constant, SpinDecay = ForceLaw.Constant };

    /// <summary>All forces by the laws of the thesis, as published.</summary>
    public static ForceSet Published { get; } = new() { Coefficients = AerodynamicModel.Published };

    /// <summary>All forces by the regularized laws.</summary>
    public static ForceSet Regularized { get; } = new() { Coefficients = AerodynamicModel.Regularized };

    /// <summary>All forces, with the measured laws: the default.</summary>
    public static ForceSet Measured { get; } = new();

    internal void Validate()
    {
        Check.Defined("forces.drag", Drag, (int)Drag, 3);
        Check.Defined("forces.magnus", Magnus, (int)Magnus, 3);
        Check.Defined("forces.spinDecay", SpinDecay, (int)SpinDecay, 3);
        Check.Defined("forces.coefficients", Coefficients, (int)Coefficients, 3);
        SceneFields.Check(SceneFields.Forces, this, "forces.");
        Check.Member("forces.customForces", CustomForces);

        // Check this now, so that a null fails where the list is set and not in the first step.
        for (int i = 0; i < CustomForces.Count; i++)
        {
            if (CustomForces[i] is null)
            {
                throw new ArgumentNullException("forces.customForces", "forces.customForces contains null. Remove the null item.");
            }

            if (CustomForces[i] is IStiffForce stiff)
            {
                Check.Within(Check.Item("forces.customForces", i) + ".stiffness", stiff.Stiffness, 0, Limits.Stiffness);
            }
        }
    }
}
