using FootballPhysics.Numerics;
using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>The aerodynamic laws of a scene behind one virtual call, for all code except the hot flight step. Immutable and thread-safe.</summary>
internal abstract class AirLaws
{
    /// <summary>A squared spin below this, in rad²/s², counts as no spin, so that no product with its reciprocal overflows.</summary>
    public const double NoSpin = 1e-100;

    /// <summary>True if drag acts.</summary>
    public bool Drags { get; protected init; }

    /// <summary>True if the Magnus force acts.</summary>
    public bool Lifts { get; protected init; }

    /// <summary>True if spin decays.</summary>
    public bool SpinDecays { get; protected init; }

    /// <inheritdoc cref="IFlightAir.Jumps"/>
    public bool Jumps { get; protected init; }

    /// <inheritdoc cref="SceneAir.Bound"/>
    public RateBound Bound { get; protected init; }

    /// <summary>The maximum speed for <see cref="OrdinaryBound"/>, in m/s: twice the speed of any kick.</summary>
    public const double OrdinarySpeed = 100;

    /// <summary>The bound up to <see cref="OrdinarySpeed"/>. It is tighter than <see cref="Bound"/> if a coefficient grows with speed.</summary>
    public RateBound OrdinaryBound { get; protected init; }

    /// <summary>Returns the laws of a scene, without its custom forces.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The scene contains an undefined law.</exception>
    public static AirLaws Of(Scene scene) => Of(scene, 1, 1);

    /// <summary>Returns the laws of a scene, with drag and Magnus force multiplied by factors.</summary>
    public static AirLaws Of(Scene scene, double drag, double lift)
    {
        ForceSet forces = scene.Forces;

        // Tables contain absent forces and constant coefficients. Evaluate laws without any table one by one.
        return !HasFits(forces) ? new MixedLaws(scene, drag, lift) : forces.Coefficients switch
        {
            AerodynamicModel.Published => new TableLaws<PublishedLaw>(scene, drag, lift),
            AerodynamicModel.Regularized => new TableLaws<RegularisedLaw>(scene, drag, lift),
            AerodynamicModel.Measured => new TableLaws<MeasuredLaw>(scene, drag, lift),
            _ => throw Check.Unknown("forces.coefficients", forces.Coefficients),
        };
    }

    /// <summary>True if at least one force of a scene is fitted to measurements, so that tables contain its laws.</summary>
    public static bool HasFits(ForceSet forces) =>
        forces.Drag == ForceLaw.Empirical || forces.Magnus == ForceLaw.Empirical || forces.SpinDecay == ForceLaw.Empirical;

    /// <inheritdoc cref="IFlightLaws.Factors"/>
    public abstract void Factors(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay);

    /// <inheritdoc cref="IFlightAir.FactorsPerSpin"/>
    public virtual bool FactorsPerSpin(
        double speedSquared, double spinSquared, double crossSquared, DragBranch region, out double drag, out double lift, out double decay)
    {
        bool spins = spinSquared > NoSpin;

        // |ω̂ × u|² = |ω × u|²/|ω|²; then compute lift and decay per unit of spin.
        double perSquared = spins ? 1.0 / spinSquared : 0;
        double rate = spins ? Math.Sqrt(spinSquared) : 0;
        Factors(speedSquared, rate, perSquared * crossSquared, region, out drag, out lift, out decay);
        double perRate = spins ? perSquared * rate : 1.0;
        lift *= perRate;
        decay *= perRate;
        return spins;
    }

    /// <summary>Returns a bound that also holds with a factor.</summary>
    protected static RateBound Scaled(in RateBound bound, double factor)
    {
        double most = Math.Max(1.0, Math.Abs(factor));
        return new RateBound(most * bound.PerSpeed, most * bound.PerSpin, most * bound.Constant);
    }
}
