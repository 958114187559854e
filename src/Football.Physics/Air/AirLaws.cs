namespace FootballPhysics;

/// <summary>The aerodynamic laws of a scene at a point, through one virtual call: what everything but the hot step of flight asks. Immutable, for any number of threads.</summary>
internal abstract class AirLaws
{
    /// <summary>True when drag acts.</summary>
    public bool Drags { get; protected init; }

    /// <summary>True when the Magnus force acts.</summary>
    public bool Lifts { get; protected init; }

    /// <summary>True when spin decays.</summary>
    public bool SpinDecays { get; protected init; }

    /// <inheritdoc cref="IFlightAir.Jumps"/>
    public bool Jumps { get; protected init; }

    /// <inheritdoc cref="SceneAir.Bound"/>
    public RateBound Bound { get; protected init; }

    /// <summary>The speed, m/s, up to which <see cref="OrdinaryBound"/> holds: twice that of any kick.</summary>
    public const double OrdinarySpeed = 100;

    /// <summary>The bound up to that speed: closer than one for every speed where a coefficient grows with it.</summary>
    public RateBound OrdinaryBound { get; protected init; }

    /// <summary>The laws that a scene names, without its own forces.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The scene names a law that there is not.</exception>
    public static AirLaws Of(Scene scene) => Of(scene, 1, 1);

    /// <summary>Those laws with drag and Magnus force times factors.</summary>
    public static AirLaws Of(Scene scene, double drag, double lift)
    {
        ForceSet forces = scene.Forces;
        bool hasConstants = forces.Drag == ForceLaw.Constant || forces.Magnus == ForceLaw.Constant || forces.SpinDecay == ForceLaw.Constant;
        bool hasFits = forces.Drag == ForceLaw.Empirical || forces.Magnus == ForceLaw.Empirical || forces.SpinDecay == ForceLaw.Empirical;

        // Tables are of fitted laws, with factors for what is left out; with a constant law, or none at all, each is asked by itself.
        return hasConstants || !hasFits ? new MixedLaws(scene, drag, lift) : forces.Coefficients switch
        {
            AerodynamicModel.Published => new TableLaws<PublishedLaw>(scene, drag, lift),
            AerodynamicModel.Regularized => new TableLaws<RegularisedLaw>(scene, drag, lift),
            AerodynamicModel.Measured => new TableLaws<MeasuredLaw>(scene, drag, lift),
            _ => throw Check.Unknown("forces.coefficients", forces.Coefficients),
        };
    }

    /// <inheritdoc cref="IFlightLaws.Factors"/>
    public abstract void Factors(
        double speedSquared, double spinRate, double acrossSquared, DragBranch region, out double drag, out double lift, out double decay);

    /// <inheritdoc cref="IFlightAir.FactorsPerSpin"/>
    public virtual bool FactorsPerSpin(
        double speedSquared, double spinSquared, double crossSquared, DragBranch region, out double drag, out double lift, out double decay)
    {
        bool spins = spinSquared > AirRates.NoSpin;

        // |ω̂ × u|² = |ω × u|²/|ω|², then lift and decay per unit of spin.
        double perSquared = spins ? 1.0 / spinSquared : 0;
        double rate = spins ? Math.Sqrt(spinSquared) : 0;
        Factors(speedSquared, rate, perSquared * crossSquared, region, out drag, out lift, out decay);
        double perRate = spins ? perSquared * rate : 1.0;
        lift *= perRate;
        decay *= perRate;
        return spins;
    }

    /// <summary>A bound that holds with a factor too.</summary>
    protected static RateBound Scaled(in RateBound bound, double factor)
    {
        double most = Math.Max(1.0, Math.Abs(factor));
        return new RateBound(most * bound.PerSpeed, most * bound.PerSpin, most * bound.Constant);
    }
}
