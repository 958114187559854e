using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics;

/// <summary>The properties of a ball: mass, radius, inertia, drag curve, knuckle force.</summary>
/// <remarks>Each number states its evidence: law (the Laws of the Game, or exact mechanics), measured, derived, or guess (no measurement found).</remarks>
public sealed record BallProperties
{
    /// <summary>The radius below which a ball counts as a marble, in m.</summary>
    /// <remarks>With the rest energy of a football, a marble would stop rolling at a third of a metre per second.</remarks>
    private const double SmallRadius = 0.02;

    /// <summary>The mass, in kg.</summary>
    /// <remarks>0.001 … 100, and at least a twentieth of the mass of the displaced air; default 0.43 (law: 0.41 … 0.45).</remarks>
    public double Mass { get; init; } = 0.43;

    /// <summary>The radius, in m.</summary>
    /// <remarks>
    /// 0.005 … 5; default 0.11 (law: a circumference of 68 … 70 cm). For a ball below 2 cm, <see cref="Ground.RestEnergy"/> is scaled by (r/2 cm)³.
    /// </remarks>
    public double Radius { get; init; } = 0.11;

    /// <summary>The inertia factor α in I = α m r².</summary>
    /// <remarks>0.1 … 1; default 2/3, a thin shell (derived; layered balls ±0.03, guess).</remarks>
    public double InertiaFactor { get; init; } = 2.0 / 3.0;

    /// <summary>The factor that scales the restitution of every surface; below 1 for a soft ball.</summary>
    /// <remarks>0 … 1.2; default 1. The scaled restitution is at most 1, except on a bumper.</remarks>
    public double Bounce { get; init; } = 1;

    /// <summary>The drag curve without spin; only <see cref="AerodynamicModel.Measured"/> uses it.</summary>
    /// <remarks>Default: the curve of <see cref="Modern"/>.</remarks>
    public DragCurve DragCurve { get; init; } = DragCurve.Modern with { };

    /// <summary>K, the standard deviation of the lateral knuckle force at 30 m/s without spin, in N.</summary>
    /// <remarks>
    /// The force acts if <see cref="ForceSet.KnuckleSeed"/> is set. 0 … 100; default 1.5 (guess, within the 0.6 … 3.1 that Hong and Asai 2014 measured on other balls).
    /// </remarks>
    public double KnuckleForce { get; init; } = 1.5;

    /// <summary>The layers that the ball ignores, as a bit set from <see cref="Layers.Of"/>. Default: none.</summary>
    /// <remarks>The ball passes through obstacles, bodies and engine colliders on these layers, for instance a thrower's own hands. Zones on these layers do
    /// not report the ball.</remarks>
    public uint Ignores { get; init; }

    /// <summary>The default: a present-day match ball in match play.</summary>
    /// <remarks>
    /// The drag curve has roughness 0.86, measured in one match. It also fits the flights of a second match better than wind-tunnel curves do. The knuckle
    /// force is 1.5 N (guess).
    /// </remarks>
    public static BallProperties Modern { get; } = new();

    /// <summary>A match football in the still air of a wind tunnel: the mean of three balls.</summary>
    /// <remarks>The name in JSON is "generic".</remarks>
    public static BallProperties Tunnel { get; } = new() { DragCurve = DragCurve.Generic };

    /// <summary>Adidas Tango 12 (2012).</summary>
    /// <remarks>The drag is measured. The knuckle force is 1.6 N (guess, from the measured 1.0 … 2.2 N of the Cafusa).</remarks>
    public static BallProperties Tango12 { get; } = new() { DragCurve = DragCurve.Tango12, KnuckleForce = 1.6 };

    /// <summary>Adidas Teamgeist (2006).</summary>
    /// <remarks>The drag is measured. The knuckle force is 0.75 N (measured, Hong and Asai 2014: 0.6 … 0.9).</remarks>
    public static BallProperties Teamgeist { get; } = new() { DragCurve = DragCurve.Teamgeist, KnuckleForce = 0.75 };

    /// <summary>Adidas Jabulani (2010).</summary>
    /// <remarks>The drag is measured. The knuckle force is 2.1 N (measured, Hong and Asai 2014: 1.1 … 3.1).</remarks>
    public static BallProperties Jabulani { get; } = new() { DragCurve = DragCurve.Jabulani, KnuckleForce = 2.1 };

    /// <summary>Adidas Brazuca (2014).</summary>
    /// <remarks>The drag is measured. The knuckle force is 1.5 N (guess).</remarks>
    public static BallProperties Brazuca { get; } = new() { DragCurve = DragCurve.Brazuca, KnuckleForce = 1.5 };

    /// <summary>Adidas Telstar 18 (2018), from wind-tunnel measurements.</summary>
    /// <remarks>
    /// Measured: the same crisis as the Brazuca, and long kicks 8 … 9 % shorter (Goff, Hong and Asai 2018, as reported). Derived from that: C_D above the
    /// crisis is 8 % higher. The knuckle force is 1.5 N (guess).
    /// </remarks>
    public static BallProperties Telstar18 { get; } = new()
    {
        DragCurve = DragCurve.Brazuca with { Supercritical = 1.08 * DragCurve.Brazuca.Supercritical, Risen = 1.08 * DragCurve.Brazuca.Risen },
    };

    /// <summary>Nike Flight 2020.</summary>
    /// <remarks>No measurement was found. The roughness is 0.33 (guess, 0.25 … 0.5, for moulded grooves).</remarks>
    public static BallProperties Flight2020 { get; } = new() { DragCurve = DragCurve.OfRoughness(0.33) };

    /// <summary>Adidas Al Rihla (2022), from wind-tunnel measurements.</summary>
    /// <remarks>The drag crisis is reported to be slightly above that of Trionda and near that of Brazuca; the roughness of 0.31 is derived from
    /// this.</remarks>
    public static BallProperties AlRihla { get; } = new() { DragCurve = DragCurve.OfRoughness(0.31) };

    /// <summary>Adidas Fussballliebe (2024).</summary>
    /// <remarks>No measurement was found. The roughness is 0.32 (guess, 0.25 … 0.45).</remarks>
    public static BallProperties Fussballliebe { get; } = new() { DragCurve = DragCurve.OfRoughness(0.32) };

    /// <summary>Adidas Trionda (2026), from wind-tunnel measurements.</summary>
    /// <remarks>
    /// Measured (University of Tsukuba, as reported): the crisis is at 27 mph (12.1 m/s), earlier than for Al Rihla, Telstar 18 and Brazuca. The
    /// roughness of 0.35 is derived from this speed. Drag at high speed is reported to be higher, so C_D above the crisis is increased by 10 % (guess).
    /// </remarks>
    public static BallProperties Trionda { get; } = new()
    {
        DragCurve = DragCurve.OfRoughness(0.35) with { Supercritical = 0.164, Risen = 0.197 },
    };

    /// <summary>A youth football, size 4: 0.37 kg, 64.8 cm in circumference.</summary>
    /// <remarks>Law: the middle of the usual range for that size.</remarks>
    public static BallProperties YouthFootball { get; } = new() { Mass = 0.37, Radius = 0.103 };

    /// <summary>A futsal ball, size 4, low bounce: 0.42 kg, 63 cm in circumference.</summary>
    /// <remarks>Law: the middle of the range in the futsal Laws.</remarks>
    public static BallProperties Futsal { get; } = new() { Mass = 0.42, Radius = 0.100 };

    /// <summary>A beach ball: large, and so light that the air dominates its flight.</summary>
    /// <remarks>0.1 kg, radius 0.2 m (guess).</remarks>
    public static BallProperties BeachBall { get; } = Tunnel with { Mass = 0.1, Radius = 0.2 };

    /// <summary>A medicine ball: heavy and solid.</summary>
    /// <remarks>3 kg, radius 0.12 m (guess); α 2/5 (derived).</remarks>
    public static BallProperties MedicineBall { get; } = Tunnel with { Mass = 3.0, Radius = 0.12, InertiaFactor = 0.4 };

    /// <summary>The presets, by their names in JSON, on the command line and in the engines.</summary>
    public static IReadOnlyDictionary<string, BallProperties> Presets { get; } = new Dictionary<string, BallProperties>
    {
        ["modern"] = Modern,
        ["generic"] = Tunnel,
        ["tango12"] = Tango12,
        ["teamgeist"] = Teamgeist,
        ["jabulani"] = Jabulani,
        ["brazuca"] = Brazuca,
        ["telstar18"] = Telstar18,
        ["flight2020"] = Flight2020,
        ["alRihla"] = AlRihla,
        ["fussballliebe"] = Fussballliebe,
        ["trionda"] = Trionda,
        ["youthFootball"] = YouthFootball,
        ["futsal"] = Futsal,
        ["beachBall"] = BeachBall,
        ["medicineBall"] = MedicineBall,
    };

    /// <summary>The moment of inertia I = α m r², in kg m².</summary>
    public double MomentOfInertia => InertiaFactor * Mass * Radius * Radius;

    /// <summary>The minimum mass of a ball, in kg.</summary>
    internal const double LeastMass = 0.001;

    /// <summary>The maximum damping of this ball's spin, in N m s: it keeps every decay time above 10 µs.</summary>
    internal double MostDamping => Math.Min(1.0, 1e5 * MomentOfInertia);

    /// <summary>The share of the ground's rest energy at which the ball rests: 1, or (r/2 cm)³ for a marble.</summary>
    internal double RestShare => Radius < SmallRadius ? Radius / SmallRadius * (Radius / SmallRadius) * (Radius / SmallRadius) : 1;

    internal void Validate()
    {
        SceneFields.Check(SceneFields.Ball, this, "ball.");

        // Check the curve even if this scene's laws ignore it, because another scene may use the same ball.
        Check.Member("ball.dragCurve", DragCurve);
        DragCurve.Validate();
    }
}
