namespace FootballPhysics;

/// <summary>The forces and torques of a scene. Each can be left out or replaced, and a game can add its own.</summary>
public sealed record ForceSet
{
    /// <summary>True for buoyancy to act. Default true.</summary>
    public bool Buoyancy { get; init; } = true;

    /// <summary>Law of the drag force. Default <see cref="ForceLaw.Empirical"/>.</summary>
    public ForceLaw Drag { get; init; } = ForceLaw.Empirical;

    /// <summary>Law of the Magnus force. Default <see cref="ForceLaw.Empirical"/>.</summary>
    public ForceLaw Magnus { get; init; } = ForceLaw.Empirical;

    /// <summary>Law of the spin decay in air. Default <see cref="ForceLaw.Empirical"/>.</summary>
    public ForceLaw SpinDecay { get; init; } = ForceLaw.Empirical;

    /// <summary>The coefficients that the empirical laws follow. Default <see cref="AerodynamicModel.Measured"/>.</summary>
    public AerodynamicModel Coefficients { get; init; } = AerodynamicModel.Measured;

    /// <summary>C_D of the constant drag law. 0 … 10; default 0.25.</summary>
    public double DragCoefficient { get; init; } = 0.25;

    /// <summary>C_M of the constant Magnus law. Within ±10; default 0.25.</summary>
    public double MagnusCoefficient { get; init; } = 0.25;

    /// <summary>k of the constant spin decay T = −k ω, N m s. 0 … 1, at most 1e5 1/s times the moment of inertia; default 0.</summary>
    public double SpinDecayCoefficient { get; init; }

    /// <summary>
    /// Seed of the knuckle force on a ball with little spin, whatever the laws are; another seed, another way to wobble. Acts in flight alone, from
    /// anew after each kick. Default null: none.
    /// </summary>
    public long? KnuckleSeed { get; init; }

    /// <summary>Forces of the game's own, added to the others in this order. Default none.</summary>
    public IReadOnlyList<IForce> CustomForces { get; init; } = [];

    /// <summary>No air: gravity alone acts in flight.</summary>
    public static ForceSet None { get; } = new() { Buoyancy = false, Drag = ForceLaw.None, Magnus = ForceLaw.None, SpinDecay = ForceLaw.None };

    /// <summary>Constant coefficients: the cheapest air.</summary>
    public static ForceSet Constant { get; } = new() { Drag = ForceLaw.Constant, Magnus = ForceLaw.Constant, SpinDecay = ForceLaw.Constant };

    /// <summary>All forces by the laws of the thesis, as published.</summary>
    public static ForceSet Published { get; } = new() { Coefficients = AerodynamicModel.Published };

    /// <summary>All forces by the regularised law.</summary>
    public static ForceSet Regularized { get; } = new() { Coefficients = AerodynamicModel.Regularized };

    /// <summary>All forces by the measured laws: the default.</summary>
    public static ForceSet Measured { get; } = new();

    internal void Validate()
    {
        Check.Defined("forces.drag", Drag, (int)Drag, 3);
        Check.Defined("forces.magnus", Magnus, (int)Magnus, 3);
        Check.Defined("forces.spinDecay", SpinDecay, (int)SpinDecay, 3);
        Check.Defined("forces.coefficients", Coefficients, (int)Coefficients, 3);
        SceneFields.Check(SceneFields.Forces, this, "forces.");
        Check.Member("forces.customForces", CustomForces);

        // Else the first step would fail, far from whoever left it out.
        foreach (IForce force in CustomForces)
        {
            if (force is null)
            {
                throw new ArgumentNullException("forces.customForces", "forces.customForces contains null. Remove the null item.");
            }
        }
    }
}
