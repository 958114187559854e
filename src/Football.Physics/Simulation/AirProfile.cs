namespace Football.Physics;

/// <summary>
/// Which laws of the air a simulator is made for. Every combination of laws and integrators is compiled code of its own; a program that is compiled
/// ahead of time (NativeAOT, IL2CPP) has the code of those profiles that it names, and of <see cref="All"/> where it names none.
/// </summary>
/// <remarks>
/// Results do not depend on the profile. Wind, winds by place and time, forces of a game's own, obstacles and all integrators work with each of them.
/// </remarks>
public abstract class AirProfile
{
    private protected AirProfile()
    {
    }

    /// <summary>Whatever laws a scene chooses: the default.</summary>
    public static AirProfile All => Every.Instance;

    /// <summary>Scenes of <see cref="ForceSet.Published"/>'s laws.</summary>
    public static AirProfile Published => One<PublishedAir<EmpiricalDrag, EmpiricalMagnus, EmpiricalSpinDecay>, PublishedLaws>.Instance;

    /// <summary>Scenes of <see cref="ForceSet.Regularised"/>'s laws.</summary>
    public static AirProfile Regularised => One<SmoothAir<RegularisedLaw, EmpiricalDrag, EmpiricalMagnus, EmpiricalSpinDecay>, RegularisedLaws>.Instance;

    /// <summary>Scenes of <see cref="ForceSet.Measured"/>'s laws, as <see cref="Scene.Default"/>.</summary>
    public static AirProfile Measured => One<SmoothAir<MeasuredLaw, MeasuredDrag, MeasuredMagnus, ProportionalSpinDecay>, MeasuredLaws>.Instance;

    /// <summary>Scenes of <see cref="ForceSet.Constant"/>'s laws.</summary>
    public static AirProfile Constant => One<AirLaws<NoDragFit, ConstantDrag, ConstantMagnus, ConstantSpinDecay>, ConstantLaws>.Instance;

    /// <summary>Scenes without drag, Magnus force and spin decay, as <see cref="Scene.Vacuum"/>.</summary>
    public static AirProfile Vacuum => One<AirLaws<NoDragFit, NoAirLaw, NoAirLaw, NoAirLaw>, NoLaws>.Instance;

    /// <summary>The name, such as "Published".</summary>
    public abstract string Name { get; }

    /// <summary>Whether a scene has the laws of this profile.</summary>
    /// <param name="scene">The scene.</param>
    /// <exception cref="ArgumentNullException"><paramref name="scene"/> is null.</exception>
    public bool Covers(Scene scene) => HasLaws((scene ?? throw new ArgumentNullException(nameof(scene))).Forces);

    /// <summary>The name.</summary>
    public sealed override string ToString() => Name;

    /// <summary>The compiled body for a scene.</summary>
    internal abstract Stepper Compile(Scene scene, SolverSettings settings);

    private protected abstract bool HasLaws(ForceSet forces);

    /// <summary>Which laws a profile has.</summary>
    private interface ILawSet
    {
        string Name { get; }

        bool Has(ForceSet forces);
    }

    private static bool AllAre(ForceSet forces, ForceLaw law) => forces.Drag == law && forces.Magnus == law && forces.SpinDecay == law;

    private readonly struct PublishedLaws : ILawSet
    {
        public string Name => nameof(Published);

        public bool Has(ForceSet forces) => AllAre(forces, ForceLaw.Empirical) && forces.Coefficients == CoefficientForm.Published;
    }

    private readonly struct RegularisedLaws : ILawSet
    {
        public string Name => nameof(Regularised);

        public bool Has(ForceSet forces) => AllAre(forces, ForceLaw.Empirical) && forces.Coefficients == CoefficientForm.Regularised;
    }

    private readonly struct MeasuredLaws : ILawSet
    {
        public string Name => nameof(Measured);

        public bool Has(ForceSet forces) => AllAre(forces, ForceLaw.Empirical) && forces.Coefficients == CoefficientForm.Measured;
    }

    private readonly struct ConstantLaws : ILawSet
    {
        public string Name => nameof(Constant);

        public bool Has(ForceSet forces) => AllAre(forces, ForceLaw.Constant);
    }

    private readonly struct NoLaws : ILawSet
    {
        public string Name => nameof(Vacuum);

        public bool Has(ForceSet forces) => AllAre(forces, ForceLaw.None);
    }

    /// <summary>One combination of laws, whose code is compiled where this type is named, and nowhere else.</summary>
    private sealed class One<TAir, TLaws> : AirProfile
        where TAir : struct, ILawsAir
        where TLaws : struct, ILawSet
    {
        public static One<TAir, TLaws> Instance { get; } = new();

        public override string Name => default(TLaws).Name;

        internal override Stepper Compile(Scene scene, SolverSettings settings)
        {
            if (!HasLaws(scene.Forces))
            {
                ForceSet forces = scene.Forces;
                throw Check.Refusal(
                    "forces", $"drag {forces.Drag}, magnus {forces.Magnus}, spinDecay {forces.SpinDecay}, coefficients {forces.Coefficients}", $"the laws of AirProfile.{Name}");
            }

            return StepperFactory.Create<TAir>(scene, settings);
        }

        private protected override bool HasLaws(ForceSet forces) => default(TLaws).Has(forces);
    }

    /// <summary>Every combination of laws.</summary>
    private sealed class Every : AirProfile
    {
        public static Every Instance { get; } = new();

        public override string Name => nameof(All);

        internal override Stepper Compile(Scene scene, SolverSettings settings)
        {
            if (StepperFactory.HasLawsAlone(scene))
            {
                var maker = new Maker { Settings = settings };
                return AirChoice.Choose<Maker, Stepper>(scene, ref maker);
            }

            LawsMaker laws = default;
            return StepperFactory.Around(scene, settings, AirChoice.Choose<LawsMaker, PointAir>(scene, ref laws));
        }

        private protected override bool HasLaws(ForceSet forces) => true;

        private struct Maker : IAirVisitor<Stepper>
        {
            public SolverSettings Settings;

            public readonly Stepper Visit<TAir>(Scene scene)
                where TAir : struct, ILawsAir
            {
                TAir air = default;
                air.Prepare(scene);
                return StepperFactory.Of(scene, Settings, in air);
            }
        }

        private struct LawsMaker : IAirVisitor<PointAir>
        {
            public readonly PointAir Visit<TAir>(Scene scene)
                where TAir : struct, ILawsAir
            {
                TAir air = default;
                air.Prepare(scene);
                return PointAir.Of(in air);
            }
        }
    }
}
