namespace FootballPhysics;

public sealed partial record SurfaceMaterial
{
    /// <summary>The default: mown and watered match turf. Its values come from the bounces, slides and rolls of three tracked matches.</summary>
    /// <remarks>
    /// Measured: restitution 0.67 (0.62 … 0.74), η 0.45 (0 … 0.7), e_t −0.15 (−0.3 … −0.1), impact friction 0.42 (0.28 … 0.42), sliding friction 0.45 (0.41 … 0.49),
    /// c₀ 0.064, which with c₁ gives 0.076 at 4 m/s (0.05 … 0.11). Derived: V_e 20 m/s (15 … ∞). Guess: c₁ 0.003 (0 … 0.007), b.
    /// <para>It passes FIFA's tests of a wet natural pitch (drop 0.60 … 1.00 m, angle 45 … 80 %, roll 4 … 10 m).</para>
    /// </remarks>
    public static SurfaceMaterial MatchTurf { get; } = new();

    /// <summary>Dry, mown turf.</summary>
    /// <remarks>
    /// Measured: restitution 0.622, e_t 0.20 and c₀ 0.070, which pass FIFA's tests (drop 0.60 … 1.00 m, angle 45 … 60 %, roll 4 … 10 m).
    /// The impact friction is 1.2 (derived: at least 0.91). The other values are guesses.
    /// </remarks>
    public static SurfaceMaterial DryTurf { get; } = new()
    {
        NormalRestitution = 0.622,
        RestitutionSpeedScale = 30,
        GrazingRestitutionGain = 0,
        TangentialRestitution = 0.2,
        ImpactFriction = 1.2,
        SlidingFriction = 0.5,
        RollingResistance = 0.07,
        RollingResistancePerSpeed = 0.006,
    };

    /// <summary>Artificial turf.</summary>
    /// <remarks>
    /// Measured: restitution 0.622, e_t 0.20 and c₀ 0.069, which pass the FIFA Quality Pro tests (drop 0.60 … 0.85 m, angle 45 … 60 %, roll 4 … 8 m).
    /// The impact friction is 1.2 (derived: at least 0.91). The other values are guesses.
    /// </remarks>
    public static SurfaceMaterial ArtificialTurf { get; } = DryTurf with { SlidingFriction = 0.55, RollingResistance = 0.069, RollingResistancePerSpeed = 0.008 };

    /// <summary>Watered turf, on which a ball skids.</summary>
    /// <remarks>Measured: restitution 0.570 (FIFA's drop test: 0.60 … 1.00 m). The other values are guesses; impact friction 0.50 gives 67 % in the angle
    /// test.</remarks>
    public static SurfaceMaterial WetTurf { get; } = DryTurf with
    {
        NormalRestitution = 0.57,
        ImpactFriction = 0.5,
        SlidingFriction = 0.25,
        RollingResistance = 0.064,
        TorsionalPatchRadius = 0.015,
    };

    /// <summary>Hard, dry ground (guess).</summary>
    /// <remarks>In FIFA's drop test, the ball rebounds to 1.01 m, the upper end of the range for natural pitches.</remarks>
    public static SurfaceMaterial HardGround { get; } = DryTurf with
    {
        NormalRestitution = 0.74,
        ImpactFriction = 0.9,
        RollingResistance = 0.04,
        RollingResistancePerSpeed = 0.002,
        TorsionalPatchRadius = 0.012,
    };

    /// <summary>Long grass (guess).</summary>
    /// <remarks>In FIFA's roll test, the ball rolls 3.5 m, near the former lower limit of 3 m.</remarks>
    public static SurfaceMaterial LongGrass { get; } = DryTurf with
    {
        NormalRestitution = 0.5,
        TangentialRestitution = 0.1,
        ImpactFriction = 1.3,
        SlidingFriction = 0.6,
        RollingResistance = 0.13,
        RollingResistancePerSpeed = 0.015,
        TorsionalPatchRadius = 0.03,
    };

    /// <summary>An indoor court (guess).</summary>
    public static SurfaceMaterial Indoor { get; } = DryTurf with
    {
        NormalRestitution = 0.77,
        ImpactFriction = 0.8,
        SlidingFriction = 0.55,
        RollingResistance = 0.015,
        RollingResistancePerSpeed = 0.001,
        TorsionalPatchRadius = 0.006,
    };

    /// <summary>Concrete.</summary>
    /// <remarks>Measured: restitution 0.861 (a test ball dropped from 2 m rises to 1.35 ± 0.03 m, EN 12235). The other values are guesses.</remarks>
    public static SurfaceMaterial Concrete { get; } = DryTurf with
    {
        NormalRestitution = 0.861,
        ImpactFriction = 0.8,
        SlidingFriction = 0.6,
        RollingResistance = 0.013,
        RollingResistancePerSpeed = 0.001,
        TorsionalPatchRadius = 0.005,
    };

    /// <summary>Snow (guess).</summary>
    public static SurfaceMaterial Snow { get; } = DryTurf with
    {
        NormalRestitution = 0.25,
        TangentialRestitution = 0,
        ImpactFriction = 0.4,
        SlidingFriction = 0.2,
        RollingResistance = 0.2,
        RollingResistancePerSpeed = 0.01,
        TorsionalPatchRadius = 0.03,
    };

    /// <summary>The frame of a goal: steel or aluminium (guess).</summary>
    /// <remarks>Other authors assume a restitution of 0.65 … 0.80 at 6 m/s.</remarks>
    public static SurfaceMaterial GoalFrame { get; } = DryTurf with
    {
        NormalRestitution = 0.8,
        TangentialRestitution = 0.1,
        ImpactFriction = 0.3,
        SlidingFriction = 0.3,
        RollingResistance = 0.05,
        RollingResistancePerSpeed = 0,
        TorsionalPatchRadius = 0,
    };

    /// <summary>Wooden boards around a pitch (guess): stiffer than a plastic panel, softer than concrete.</summary>
    public static SurfaceMaterial Wood { get; } = GoalFrame with { NormalRestitution = 0.65, ImpactFriction = 0.4, SlidingFriction = 0.4, RollingResistance = 0.02, TorsionalPatchRadius = 0.005 };

    /// <summary>Advertising boards: thin, flexible panels (guess).</summary>
    public static SurfaceMaterial Board { get; } = GoalFrame with { NormalRestitution = 0.5, ImpactFriction = 0.35, SlidingFriction = 0.35, RollingResistance = 0.03, TorsionalPatchRadius = 0.005 };

    /// <summary>A boot or a leg: leather on a limb that yields (guess).</summary>
    /// <remarks>In measured kicks, e is 0.4 … 0.7, including the effect of the foot's mass.</remarks>
    public static SurfaceMaterial Boot { get; } = GoalFrame with { NormalRestitution = 0.5, ImpactFriction = 0.5, SlidingFriction = 0.5, TorsionalPatchRadius = 0.01 };

    /// <summary>A head (guess).</summary>
    public static SurfaceMaterial Head { get; } = Boot with { NormalRestitution = 0.45 };

    /// <summary>A goalkeeper's glove: soft, with a strong grip (guess).</summary>
    public static SurfaceMaterial Glove { get; } = Boot with { NormalRestitution = 0.25, TangentialRestitution = 0, ImpactFriction = 1, SlidingFriction = 0.9, RollingResistance = 0.1 };

    /// <summary>A second ball, for collisions between two balls. Guess: no measurement was found.</summary>
    /// <remarks>Two air-filled shells rebound from each other roughly as a single shell rebounds from a floor.</remarks>
    public static SurfaceMaterial Ball { get; } = GoalFrame with { NormalRestitution = 0.78, TangentialRestitution = 0, ImpactFriction = 0.4, SlidingFriction = 0.4 };

    /// <summary>The turf of the published profile: a constant restitution, and no limit on the friction in an impact.</summary>
    /// <remarks>
    /// Restitution is 0.6, sliding friction 0.5 and rolling friction 0.05, all as published. <see cref="Ground.PublishedTurf"/> also restricts the air forces
    /// on the ground.
    /// </remarks>
    public static SurfaceMaterial PublishedTurf { get; } = new()
    {
        NormalRestitution = 0.6,
        RestitutionSpeedScale = double.PositiveInfinity,
        GrazingRestitutionGain = 0,
        TangentialRestitution = 0.5,
        SpinRestitution = 0.8,
        ImpactFriction = double.PositiveInfinity,
        SlidingFriction = 0.5,
        RollingResistance = 0.05,
        RollingResistancePerSpeed = 0,
        SpinDamping = 0.002,
        TorsionalPatchRadius = 0,
    };

    /// <summary>Wet turf with the laws of <see cref="PublishedTurf"/> (guess).</summary>
    public static SurfaceMaterial PublishedWetTurf { get; } = PublishedTurf with { NormalRestitution = 0.5, SlidingFriction = 0.25, RollingResistance = 0.035 };

    /// <summary>A hard, smooth court with the laws of <see cref="PublishedTurf"/> (guess).</summary>
    public static SurfaceMaterial PublishedCourt { get; } = PublishedTurf with { NormalRestitution = 0.75, SlidingFriction = 0.6, RollingResistance = 0.015 };

    /// <summary>Sand with the laws of <see cref="PublishedTurf"/> (guess).</summary>
    public static SurfaceMaterial PublishedSand { get; } = PublishedTurf with
    {
        NormalRestitution = 0.15,
        TangentialRestitution = 0,
        SlidingFriction = 0.7,
        RollingResistance = 0.3,
    };

    /// <summary>The frame of a goal in the published profile: restitution 0.7 at every speed (guess).</summary>
    public static SurfaceMaterial PublishedGoalFrame { get; } = GoalFrame with
    {
        NormalRestitution = 0.7,
        RestitutionSpeedScale = double.PositiveInfinity,
        TangentialRestitution = 0.3,
        SpinRestitution = 0.8,
        SpinDamping = 0.002,
    };

    /// <summary>The presets, by their names in JSON, on the command line and in the engines.</summary>
    public static IReadOnlyDictionary<string, SurfaceMaterial> Presets { get; } = new Dictionary<string, SurfaceMaterial>
    {
        ["matchTurf"] = MatchTurf,
        ["dryTurf"] = DryTurf,
        ["artificialTurf"] = ArtificialTurf,
        ["wetTurf"] = WetTurf,
        ["hardGround"] = HardGround,
        ["longGrass"] = LongGrass,
        ["indoor"] = Indoor,
        ["concrete"] = Concrete,
        ["snow"] = Snow,
        ["goalFrame"] = GoalFrame,
        ["ball"] = Ball,
        ["wood"] = Wood,
        ["board"] = Board,
        ["boot"] = Boot,
        ["head"] = Head,
        ["glove"] = Glove,
        ["publishedTurf"] = PublishedTurf,
        ["publishedWetTurf"] = PublishedWetTurf,
        ["publishedCourt"] = PublishedCourt,
        ["publishedSand"] = PublishedSand,
        ["publishedGoalFrame"] = PublishedGoalFrame,
    };
}
