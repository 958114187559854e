namespace Football.Physics.Headless.Schema;

/// <summary>The fields that make up a scene: ball, air, gravity, forces, ground.</summary>
internal static class SceneFields
{
    private static readonly BallProperties DefaultBall = BallProperties.Football;
    private static readonly Air DefaultAir = new();
    private static readonly ForceSet DefaultForces = new();
    private static readonly Ground DefaultGround = Ground.Turf;

    private static readonly NumberField Mass = new("ball.mass", DefaultBall.Mass, NumberRange.Positive, "kg");
    private static readonly NumberField Radius = new("ball.radius", DefaultBall.Radius, NumberRange.AboveZeroTo(Limits.Length), "m");
    private static readonly NumberField InertiaFactor = new("ball.inertiaFactor", DefaultBall.InertiaFactor, NumberRange.AboveZeroTo(1));

    private static readonly NumberField Density = new("air.density", DefaultAir.Density, NumberRange.NotNegative, "kg/m³");
    private static readonly NumberField Viscosity = new("air.kinematicViscosity", DefaultAir.KinematicViscosity, NumberRange.Positive, "m²/s");
    private static readonly VectorField Wind = new("air.wind", VectorBound.Velocity);

    private static readonly NumberField Gravity = new("gravity", Scene.Default.Gravity, NumberRange.NotNegative, "m/s²");

    private static readonly FlagField Buoyancy = new("forces.buoyancy", DefaultForces.Buoyancy);
    private static readonly ChoiceField<ForceLaw> Drag = Law("forces.drag", DefaultForces.Drag);
    private static readonly ChoiceField<ForceLaw> Magnus = Law("forces.magnus", DefaultForces.Magnus);
    private static readonly ChoiceField<ForceLaw> SpinDecay = Law("forces.spinDecay", DefaultForces.SpinDecay);

    private static readonly ChoiceField<CoefficientForm> Coefficients = new(
        "forces.coefficients", DefaultForces.Coefficients, ("published", CoefficientForm.Published), ("regularised", CoefficientForm.Regularised));

    private static readonly NumberField DragCoefficient = new("forces.dragCoefficient", DefaultForces.DragCoefficient, NumberRange.NotNegative);
    private static readonly NumberField MagnusCoefficient = new("forces.magnusCoefficient", DefaultForces.MagnusCoefficient, NumberRange.Any);
    private static readonly NumberField SpinDecayCoefficient =
        new("forces.spinDecayCoefficient", DefaultForces.SpinDecayCoefficient, NumberRange.NotNegative, "N m s");

    private static readonly NumberField NormalRestitution = new("ground.normalRestitution", DefaultGround.NormalRestitution, NumberRange.Within(0, 1));

    private static readonly PairField TangentialRestitution = new(
        "ground.tangentialRestitution", (DefaultGround.TangentialRestitutionX, DefaultGround.TangentialRestitutionZ), NumberRange.Within(-1, 1));

    private static readonly NumberField SpinRestitution = new("ground.spinRestitution", DefaultGround.SpinRestitution, NumberRange.Within(0, 1));
    private static readonly NumberField SlidingFriction = new("ground.slidingFriction", DefaultGround.SlidingFriction, NumberRange.NotNegative);
    private static readonly NumberField RollingFriction = new("ground.rollingFriction", DefaultGround.RollingFriction, NumberRange.NotNegative);
    private static readonly NumberField SpinDamping = new("ground.spinDamping", DefaultGround.SpinDamping, NumberRange.NotNegative, "N m s");

    private static readonly NumberField MinimumBounceSpeed =
        new("ground.minimumBounceSpeed", DefaultGround.MinimumBounceSpeed, NumberRange.AtLeast(0.001), "m/s");

    private static readonly NumberField RestEnergy = new("ground.restEnergy", DefaultGround.RestEnergy, NumberRange.Positive, "J");
    private static readonly NumberField Height = new("ground.height", DefaultGround.Height, NumberRange.Within(-Limits.Length, Limits.Length), "m");

    private static readonly ChoiceField<GroundAerodynamics> OnGround = new(
        "ground.aerodynamics", DefaultGround.Aerodynamics, ("horizontal", GroundAerodynamics.Horizontal), ("none", GroundAerodynamics.None));

    /// <summary>All of them.</summary>
    public static IReadOnlyList<Field> All { get; } =
    [
        Mass, Radius, InertiaFactor,
        Density, Viscosity, Wind,
        Gravity,
        Buoyancy, Drag, Magnus, SpinDecay, Coefficients, DragCoefficient, MagnusCoefficient, SpinDecayCoefficient,
        NormalRestitution, TangentialRestitution, SpinRestitution, SlidingFriction, RollingFriction, SpinDamping,
        MinimumBounceSpeed, RestEnergy, Height, OnGround,
    ];

    /// <summary>The scene that the values describe.</summary>
    public static Scene Build(FieldValues values) => new()
    {
        Ball = new BallProperties
        {
            Mass = values.Get(Mass),
            Radius = values.Get(Radius),
            InertiaFactor = values.Get(InertiaFactor),
        },
        Air = new Air
        {
            Density = values.Get(Density),
            KinematicViscosity = values.Get(Viscosity),
            Wind = values.Get(Wind),
        },
        Gravity = values.Get(Gravity),
        Forces = new ForceSet
        {
            Buoyancy = values.Get(Buoyancy),
            Drag = values.Get(Drag),
            Magnus = values.Get(Magnus),
            SpinDecay = values.Get(SpinDecay),
            Coefficients = values.Get(Coefficients),
            DragCoefficient = values.Get(DragCoefficient),
            MagnusCoefficient = values.Get(MagnusCoefficient),
            SpinDecayCoefficient = values.Get(SpinDecayCoefficient),
        },
        Ground = new Ground
        {
            NormalRestitution = values.Get(NormalRestitution),
            TangentialRestitutionX = values.Get(TangentialRestitution).X,
            TangentialRestitutionZ = values.Get(TangentialRestitution).Z,
            SpinRestitution = values.Get(SpinRestitution),
            SlidingFriction = values.Get(SlidingFriction),
            RollingFriction = values.Get(RollingFriction),
            SpinDamping = values.Get(SpinDamping),
            MinimumBounceSpeed = values.Get(MinimumBounceSpeed),
            RestEnergy = values.Get(RestEnergy),
            Height = values.Get(Height),
            Aerodynamics = values.Get(OnGround),
        },
    };

    private static ChoiceField<ForceLaw> Law(string path, ForceLaw defaultValue) =>
        new(path, defaultValue, ("empirical", ForceLaw.Empirical), ("constant", ForceLaw.Constant), ("none", ForceLaw.None));
}
