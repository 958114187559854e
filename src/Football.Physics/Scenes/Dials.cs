namespace FootballPhysics;

/// <summary>The condition of ball and pitch in a designer's words. Each dial changes numbers of a scene by a formula; at its default it changes none.</summary>
public sealed record Dials
{
    /// <summary>Pressure of a ball that rises to 1.35 m from 2 m on concrete, bar: FIFA tests balls at it.</summary>
    private const double UsualPressure = 0.8;

    /// <summary>L, the share of its energy that a ball of that pressure loses on concrete: 1 − 0.861².</summary>
    private const double UsualLoss = 0.258679;

    /// <summary>Specific gas constant of air times 20 °C, J/kg.</summary>
    private const double GasEnergy = 287.058 * 293.15;

    /// <summary>Pascal in a bar.</summary>
    private const double Bar = 1e5;

    /// <summary>
    /// Pressure of the ball above that of the air, bar. 0.6 … 1.1 (law); default 0.8 (FIFA's tests). Changes <see cref="BallProperties.Bounce"/> by √((1 − L √(0.8/p))/(1 − L)), L = 0.259:
    /// the stiffness of a thin shell grows with p, so it deforms, and loses, as 1/√p (derived). Changes the mass by that of the air at 20 °C (law).
    /// </summary>
    public double Pressure { get; init; } = UsualPressure;

    /// <summary>
    /// Water on the pitch and in the ball, more than in the given scene. 0 … 1; default 0. At 1 the ball is 10 % heavier, the most that FIFA's water test allows (measured).
    /// The ground's restitution falls by 8.4 %, as from dry to watered turf (measured), impact friction by a third, to the least of three matches (measured), sliding friction by 45 % and
    /// <see cref="SurfaceMaterial.TorsionalPatchRadius"/> by a quarter (guess).
    /// </summary>
    public double Wetness { get; init; }

    /// <summary>
    /// Wear of the ball. 0 … 1; default 0. Moves the drag crisis to Re_c (80/272)^(0.14 w), as 0.14 more roughness does: use moves the crisis (measured, Appl. Sci. 11, 7204, 2021);
    /// how far, guess. Of no effect where <see cref="ForceSet.Drag"/> does not follow the ball's curve.
    /// </summary>
    public double Wear { get; init; }

    /// <summary>
    /// Mud on the pitch and on the ball. 0 … 1; default 0. All guess: at 1 the ball is 5 % heavier; the ground's restitution falls by 60 %, its rise η to 0, sliding friction by 40 %;
    /// c₀ grows by 0.12.
    /// </summary>
    public double Mud { get; init; }

    /// <summary>A scene with its ball and ground in this condition. Obstacles, goals and bodies are as before, but the ball bounces on them as its pressure lets it.</summary>
    /// <param name="scene">The scene; it stays as it is.</param>
    /// <exception cref="ArgumentOutOfRangeException">A dial is out of range.</exception>
    public Scene Apply(Scene scene)
    {
        if (scene is null)
        {
            throw new ArgumentNullException(nameof(scene));
        }

        SceneFields.Check(SceneFields.Dials, this, "dials.");
        return this == new Dials() ? scene : scene with { Ball = Apply(scene.Ball), Ground = Apply(scene.Ground) };
    }

    private BallProperties Apply(BallProperties ball)
    {
        // Δm = Δp V/(R T)
        double volume = 4.0 / 3.0 * Math.PI * ball.Radius * ball.Radius * ball.Radius;
        double air = (Pressure - UsualPressure) * Bar * volume / GasEnergy;
        DragCurve curve = ball.DragCurve;
        return ball with
        {
            Mass = (ball.Mass * (1.0 + (0.1 * Wetness) + (0.05 * Mud))) + air,
            Bounce = ball.Bounce * Math.Sqrt((1.0 - (UsualLoss * Math.Sqrt(UsualPressure / Pressure))) / (1.0 - UsualLoss)),
            DragCurve = Wear > 0 ? curve.WithCrisisAt(curve.CriticalReynolds * Elementary.Exp(0.14 * Wear * Elementary.Log(80.0 / 272.0))) : curve,
        };
    }

    private Ground Apply(Ground ground) => Wetness > 0 || Mud > 0
        ? ground with { Material = Apply(ground.Material), Pattern = ground.Pattern is { } pattern ? new Changed(pattern, this) : null }
        : ground;

    private SurfaceMaterial Apply(SurfaceMaterial material) => material with
    {
        NormalRestitution = material.NormalRestitution * (1.0 - (0.084 * Wetness)) * (1.0 - (0.6 * Mud)),
        GrazingRestitutionGain = material.GrazingRestitutionGain * (1.0 - Mud),
        ImpactFriction = material.ImpactFriction * (1.0 - (Wetness / 3.0)),
        SlidingFriction = material.SlidingFriction * (1.0 - (0.45 * Wetness)) * (1.0 - (0.4 * Mud)),
        RollingResistance = Math.Min(10, material.RollingResistance + (0.12 * Mud)),
        TorsionalPatchRadius = material.TorsionalPatchRadius * (1.0 - (0.25 * Wetness)),
    };

    /// <summary>A pattern whose surfaces are in another condition.</summary>
    private sealed class Changed(ISurfacePattern pattern, Dials dials) : ISurfacePattern
    {
        public IReadOnlyList<SurfaceMaterial> Surfaces { get; } = [.. pattern.Surfaces.Select(dials.Apply)];

        public double MinimumWidth => pattern.MinimumWidth;

        public int At(double x, double z) => pattern.At(x, z);
    }
}
