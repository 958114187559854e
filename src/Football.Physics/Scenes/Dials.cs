using System.Globalization;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics;

/// <summary>The condition of ball and pitch in a designer's words: pressure, wetness, wear, mud.</summary>
/// <remarks>Each dial changes numbers of a scene by a formula. A dial at its default value changes nothing.</remarks>
public sealed record Dials
{
    /// <summary>The pressure at which FIFA tests balls, in bar: a drop from 2 m on concrete rebounds to 1.35 m.</summary>
    internal const double UsualPressure = 0.8;

    /// <summary>L, the share of energy that a ball of that pressure loses on concrete: 1 − 0.861².</summary>
    private const double UsualLoss = 0.258679;

    /// <summary>The specific gas constant of air times 20 °C, in J/kg.</summary>
    private const double GasEnergy = Weather.DryGas * 293.15;

    /// <summary>The number of pascals in a bar.</summary>
    private const double Bar = 1e5;

    /// <summary>The gauge pressure of the ball, in bar.</summary>
    /// <remarks>
    /// 0.6 … 1.1 (law); default 0.8 (FIFA's tests). The pressure scales <see cref="BallProperties.Bounce"/> by √((1 − L √(0.8/p))/(1 − L)), L = 0.259. The
    /// stiffness of a thin shell grows with p, so its deformation and its loss fall as 1/√p (derived). The pressure also changes the ball's mass, through the
    /// air inside at 20 °C (law).
    /// </remarks>
    public double Pressure { get; init; } = UsualPressure;

    /// <summary>The water on the pitch and in the ball, in addition to the water that the scene already includes. 0 … 1; default 0.</summary>
    /// <remarks>
    /// At 1 the ball is 10 % heavier, the maximum in FIFA's water test (measured). The ground's restitution falls by 8.4 %, the effect of watering (measured).
    /// Impact friction falls by a third, to the lowest value in three matches (measured). Sliding friction falls by 45 % and
    /// <see cref="SurfaceMaterial.TorsionalPatchRadius"/> by a quarter (guess).
    /// </remarks>
    public double Wetness { get; init; }

    /// <summary>The wear of the ball. 0 … 1; default 0.</summary>
    /// <remarks>
    /// A wear of w moves the drag crisis to Re_c (80/272)^(0.14 w); at 1, it acts like a roughness increase of 0.14. Wear is known to move the crisis
    /// (measured, Appl. Sci. 11, 7204, 2021); the amount is a guess. It has no effect if <see cref="ForceSet.Drag"/> does not use the ball's curve.
    /// </remarks>
    public double Wear { get; init; }

    /// <summary>The mud on the pitch and the ball. 0 … 1; default 0.</summary>
    /// <remarks>
    /// At 1 the ball is 5 % heavier. The ground's restitution falls by 60 %, its rise η to 0 and sliding friction by 40 %; c₀ grows by 0.12. All are guesses.
    /// </remarks>
    public double Mud { get; init; }

    /// <summary>Returns a copy of a scene with its ball and ground in this condition.</summary>
    /// <remarks>Obstacles, goals and bodies stay the same, but the ball's pressure changes its bounce on them too.</remarks>
    /// <param name="scene">The scene; it is not changed.</param>
    /// <exception cref="ArgumentOutOfRangeException">A dial is out of range, or the pressure takes too much air from a light ball.</exception>
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
        // V is the volume, p the pressure, R the gas constant, and T the temperature.
        // The change in the mass of the air inside the ball: Δm = Δp V/(R T).
        double volume = 4.0 / 3.0 * Math.PI * ball.Radius * ball.Radius * ball.Radius;
        double air = (Pressure - UsualPressure) * Bar * volume / GasEnergy;
        double dry = ball.Mass * (1.0 + (0.1 * Wetness) + (0.05 * Mud));
        if (dry + air < BallProperties.LeastMass && dry >= BallProperties.LeastMass)
        {
            // Name the dial: the mass that the game has set is in range.
            double least = Math.Ceiling(1000.0 * (UsualPressure + ((BallProperties.LeastMass - dry) * GasEnergy / (Bar * volume)))) / 1000.0;
            throw Check.Refusal("dials.pressure", Pressure.ToString("R", CultureInfo.InvariantCulture), FormattableString.Invariant($"{least:R} … 1.1 for a ball of {ball.Mass:R} kg and {ball.Radius:R} m"));
        }

        DragCurve curve = ball.DragCurve;
        return ball with
        {
            Mass = dry + air,
            Pressure = Pressure,
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
