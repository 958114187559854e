namespace FootballPhysics.Scenes;

/// <summary>The numbers of a scene, each with its name, unit, meaning, range, access, and the evidence for its default.</summary>
/// <remarks>Validation, reading and writing of JSON, the scene hash and the tables in the docs use these lists.</remarks>
internal static class SceneFields
{
    /// <summary>The numbers of a surface material.</summary>
    public static NumberField<SurfaceMaterial>[] Material { get; } =
    [
        new("normalRestitution", "", "normal restitution at 6 m/s", "measured: three matches", 0, 3, m => m.NormalRestitution, (m, v) => m with { NormalRestitution = v }),
        new("restitutionSpeed", "m/s", "approach speed at which the restitution falls", "derived: FIFA rigs", 0, double.PositiveInfinity, m => m.RestitutionSpeedScale, (m, v) => m with { RestitutionSpeedScale = v }, isAboveLeast: true),
        new("restitutionRise", "", "rise of the restitution of oblique impacts", "measured: two matches", 0, 1, m => m.GrazingRestitutionGain, (m, v) => m with { GrazingRestitutionGain = v }),
        new("tangentialRestitution", "", "tangential restitution; of level ground also `[x, z]`", "measured: three matches", -1, 1, m => m.TangentialRestitution, (m, v) => m with { TangentialRestitution = v }),
        new("spinRestitution", "", "restitution of the spin about the normal", "guess", 0, 1, m => m.SpinRestitution, (m, v) => m with { SpinRestitution = v }),
        new("impactFriction", "", "friction of an impact", "measured: three matches", 0, double.PositiveInfinity, m => m.ImpactFriction, (m, v) => m with { ImpactFriction = v }),
        new("slidingFriction", "", "friction of a slide", "measured: three matches", 0, 10, m => m.SlidingFriction, (m, v) => m with { SlidingFriction = v }),
        new("rollingFriction", "", "rolling friction at rest", "measured: two matches", 0, 10, m => m.RollingResistance, (m, v) => m with { RollingResistance = v }),
        new("rollingFrictionBySpeed", "s/m", "growth of the rolling friction with speed", "guess", 0, 1, m => m.RollingResistancePerSpeed, (m, v) => m with { RollingResistancePerSpeed = v }),
        new("spinDamping", "N m s", "damping of the spin about the normal", "guess", 0, 1, m => m.SpinDamping, (m, v) => m with { SpinDamping = v }),
        new("drillingLength", "m", "lever of the drilling friction", "guess", 0, 1, m => m.TorsionalPatchRadius, (m, v) => m with { TorsionalPatchRadius = v }),
        new("minimumExitSpeed", "m/s", "least speed off an object, of a bumper", "a game sets it", 0, Limits.Speed, m => m.MinimumExitSpeed, (m, v) => m with { MinimumExitSpeed = v }),
    ];

    /// <summary>The numbers of the ground's material, without the tangential restitution: the ground has one along x and one along z.</summary>
    public static NumberField<SurfaceMaterial>[] GroundMaterial { get; } = [.. Material.Where(field => field.Name != "tangentialRestitution")];

    /// <summary>The numbers of the ground other than its material, height and shape.</summary>
    public static NumberField<Ground>[] Ground { get; } =
    [
        new("minimumBounceSpeed", "m/s", "slowest speed off the ground that is a bounce", "guess", 0.001, 10, g => g.MinimumBounceSpeed, (g, v) => g with { MinimumBounceSpeed = v }),
        new("restEnergy", "J", "energy at which a ball rests", "guess", 1e-12, 100, g => g.RestEnergy, (g, v) => g with { RestEnergy = v }),
    ];

    /// <summary>The numbers of a ball.</summary>
    public static NumberField<BallProperties>[] Ball { get; } =
    [
        new("mass", "kg", "mass", "law: 0.41 … 0.45", BallProperties.LeastMass, 100, b => b.Mass, (b, v) => b with { Mass = v }),
        new("radius", "m", "radius", "law: 68 … 70 cm around", 0.005, 5, b => b.Radius, (b, v) => b with { Radius = v }),
        new("inertiaFactor", "", "moment of inertia, in m r²", "derived: a thin shell", 0.1, 1, b => b.InertiaFactor, (b, v) => b with { InertiaFactor = v }),
        new("bounce", "", "factor on every restitution", "derived: 1 at 0.8 bar", 0, 1.2, b => b.Bounce, (b, v) => b with { Bounce = v }),
        new("pressure", "bar", "gauge pressure, for the outputs of impacts", "law: 0.6 … 1.1", 0.6, 1.1, b => b.Pressure, (b, v) => b with { Pressure = v }),
        new("knuckleForce", "N", "deviation of the knuckle force at 30 m/s", "measured: 0.9 … 2.2", 0, 100, b => b.KnuckleForce, (b, v) => b with { KnuckleForce = v }),
        new("reverseLift", "", "lift against the spin of a smooth ball near its crisis", "guess: 0 for match balls", 0, 1, b => b.ReverseLift, (b, v) => b with { ReverseLift = v }),
    ];

    /// <summary>The numbers of a drag curve. The ranges of two of them depend on other numbers, see <see cref="DragCurve"/>.</summary>
    public static NumberField<DragCurve>[] Drag { get; } =
    [
        new("subcritical", "", "drag coefficient below the crisis", "measured: wind tunnel", 0.01, 2, c => c.Subcritical, (c, v) => c with { Subcritical = v }),
        new("criticalReynolds", "", "Reynolds number of the crisis", "measured: one match", DragCurve.LeastCriticalReynolds, DragCurve.MostReynolds, c => c.CriticalReynolds, (c, v) => c with { CriticalReynolds = v }),
        new("width", "", "width of the crisis", "measured: one match", DragCurve.LeastWidth, DragCurve.MostWidth, c => c.Width, (c, v) => c with { Width = v }),
        new("supercritical", "", "drag coefficient above the crisis", "measured: one match", 0.01, 2, c => c.Supercritical, (c, v) => c with { Supercritical = v }),
        new("risen", "", "drag coefficient after it has risen again", "derived", 0.01, 4, c => c.Risen, (c, v) => c with { Risen = v }),
        new("riseFrom", "", "Reynolds number where it begins to rise", "derived", DragCurve.LeastCriticalReynolds, DragCurve.MostReynolds, c => c.RiseFrom, (c, v) => c with { RiseFrom = v }),
        new("riseTo", "", "Reynolds number where the rise ends", "derived", 0, double.MaxValue, c => c.RiseTo, (c, v) => c with { RiseTo = v }),
    ];

    /// <summary>The condition of ball and pitch, as set by a designer.</summary>
    public static NumberField<Dials>[] Dials { get; } =
    [
        new("pressure", "bar", "pressure of the ball", "law: 0.6 … 1.1", 0.6, 1.1, d => d.Pressure, (d, v) => d with { Pressure = v }),
        new("wetness", "", "water on pitch and ball", "a game sets it", 0, 1, d => d.Wetness, (d, v) => d with { Wetness = v }),
        new("wear", "", "wear of the ball", "a game sets it", 0, 1, d => d.Wear, (d, v) => d with { Wear = v }),
        new("mud", "", "mud on pitch and ball", "a game sets it", 0, 1, d => d.Mud, (d, v) => d with { Mud = v }),
    ];

    /// <summary>The numbers of the air.</summary>
    public static NumberField<Air>[] Air { get; } =
    [
        new("density", "kg/m³", "density", "derived: air at 20 °C, rounded", 0, 100, a => a.Density, (a, v) => a with { Density = v }),
        new("kinematicViscosity", "m²/s", "kinematic viscosity", "derived: air at 20 °C, rounded", 1e-7, 0.1, a => a.KinematicViscosity, (a, v) => a with { KinematicViscosity = v }),
    ];

    /// <summary>The coefficients of the constant laws.</summary>
    public static NumberField<ForceSet>[] Forces { get; } =
    [
        new("dragCoefficient", "", "drag coefficient of the constant law", "published", 0, 10, f => f.DragCoefficient, (f, v) => f with { DragCoefficient = v }),
        new("magnusCoefficient", "", "lift coefficient of the constant law", "published", -10, 10, f => f.MagnusCoefficient, (f, v) => f with { MagnusCoefficient = v }),
        new("spinDecayCoefficient", "N m s", "spin damping of the constant law", "published", 0, 1, f => f.SpinDecayCoefficient, (f, v) => f with { SpinDecayCoefficient = v }),
    ];

    /// <summary>The greatest depth and the force coefficients of a net.</summary>
    public static NumberField<Net>[] Net { get; } =
    [
        new("give", "m", "greatest depth of a ball", "guess", 0.05, 1e6, n => n.Give, (n, v) => n with { Give = v }),
        new("stiffness", "N/m", "stiffness", "guess", 0, 1e5, n => n.Stiffness, (n, v) => n with { Stiffness = v }),
        new("damping", "s/m", "damping of the stiffness", "guess", 0, 100, n => n.Damping, (n, v) => n with { Damping = v }),
        new("tangentialDamping", "N s/m²", "damping along the net", "guess", 0, 1e4, n => n.TangentialDamping, (n, v) => n with { TangentialDamping = v }),
        new("spinDamping", "N s", "damping of the spin", "guess", 0, 10, n => n.SpinDamping, (n, v) => n with { SpinDamping = v }),
    ];

    /// <summary>Throws for the first number that is out of its range.</summary>
    /// <param name="fields">The numbers.</param>
    /// <param name="part">The object that contains them.</param>
    /// <param name="prefix">The text before their names in the message.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range.</exception>
    public static void Check<T>(NumberField<T>[] fields, T part, string prefix)
    {
        foreach (NumberField<T> field in fields)
        {
            Numerics.Check.Within(prefix + field.Name, field.Get(part), field.Least, field.Most, field.IsAboveLeast);
        }
    }
}
