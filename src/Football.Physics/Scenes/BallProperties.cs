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

    /// <summary>K, the standard deviation per axis of the knuckle force of the seams, at 30 m/s without spin, in N.</summary>
    /// <remarks>
    /// The force acts if <see cref="ForceSet.KnuckleSeed"/> is set. 0 … 100; default 1.2 (measured: five types of balls, kicked by a robot at 29 m/s over 22 m, have
    /// 0.9 … 2.2 N; German Sport University Cologne).
    /// </remarks>
    public double KnuckleForce { get; init; } = 1.2;

    /// <summary>The seed of the seams: it determines the knuckle force of each orientation.</summary>
    /// <remarks>Balls of one seed are alike. The field of a seed is not that of a real ball (guess); its size and smoothness are. Any integer; default 1.</remarks>
    public long SeamSeed { get; init; } = 1;

    /// <summary>Λ, the size of the reverse lift near the drag crisis.</summary>
    /// <remarks>
    /// A smooth ball that spins bends the wrong way near its crisis. 0 … 1; default 0: the measured lift of match balls is positive (spin parameter 0.05 … 0.71). Only
    /// <see cref="AerodynamicModel.Measured"/> uses it.
    /// </remarks>
    public double ReverseLift { get; init; }

    /// <summary>The gauge pressure, in bar.</summary>
    /// <remarks>
    /// Only the outputs of an impact depend on it (<see cref="Simulator.ImpactOf"/>). <see cref="Dials.Pressure"/> sets it, together with mass and bounce. 0.6 … 1.1
    /// (law); default 0.8 (FIFA's tests).
    /// </remarks>
    public double Pressure { get; init; } = Dials.UsualPressure;

    /// <summary>The layers that the ball ignores, as a bit set from <see cref="Layers.Of"/>. Default: none.</summary>
    /// <remarks>The ball passes through obstacles, bodies and engine colliders on these layers, for instance a thrower's own hands. Zones on these layers do
    /// not report the ball.</remarks>
    public uint Ignores { get; init; }

    /// <summary>
    /// The default: a present-day match ball in match play. Mass and radius: law. Drag: measured in one match (roughness 0.86). Knuckle force: 1.2 N,
    /// measured on five types. Seams: guess.
    /// </summary>
    /// <remarks>
    /// The curve also fits the flights of a second match better than wind-tunnel curves do.
    /// </remarks>
    public static BallProperties Modern { get; } = new();

    /// <summary>
    /// A match football in the still air of a wind tunnel. Mass and radius: law. Drag: derived, the mean of three measured balls. Knuckle force: 1.2 N,
    /// measured on five other types. Seams: guess.
    /// </summary>
    /// <remarks>
    /// The name in JSON is "generic".
    /// </remarks>
    public static BallProperties Tunnel { get; } = new() { DragCurve = DragCurve.Generic, SeamSeed = 2 };

    /// <summary>
    /// Adidas Tango 12 (2012). Mass and radius: law. Drag: measured. Knuckle force: 1.3 N, derived. Seams: guess.
    /// </summary>
    /// <remarks>
    /// Drag: Kiratidis and Leinweber. Knuckle force: the default times a ratio of Hong and Asai 2014.
    /// </remarks>
    public static BallProperties Tango12 { get; } = new() { DragCurve = DragCurve.Tango12, KnuckleForce = 1.3, SeamSeed = 3 };

    /// <summary>
    /// Adidas Teamgeist (2006). Mass and radius: law. Drag: measured. Knuckle force: 0.6 N, derived. Seams: guess.
    /// </summary>
    /// <remarks>
    /// Drag: Kiratidis and Leinweber. Knuckle force: the default times a ratio of Hong and Asai 2014.
    /// </remarks>
    public static BallProperties Teamgeist { get; } = new() { DragCurve = DragCurve.Teamgeist, KnuckleForce = 0.6, SeamSeed = 4 };

    /// <summary>
    /// Adidas Jabulani (2010). Mass and radius: law. Drag: measured. Knuckle force: 1.65 N, derived. Seams: guess.
    /// </summary>
    /// <remarks>
    /// Drag: Kiratidis and Leinweber. Knuckle force: the default times a ratio of Hong and Asai 2014.
    /// </remarks>
    public static BallProperties Jabulani { get; } = new() { DragCurve = DragCurve.Jabulani, KnuckleForce = 1.65, SeamSeed = 5 };

    /// <summary>
    /// Adidas Brazuca (2014). Mass and radius: law. Drag: measured. Knuckle force: 1.2 N, measured on five other types. Seams: guess.
    /// </summary>
    /// <remarks>
    /// Drag: Kiratidis and Leinweber.
    /// </remarks>
    public static BallProperties Brazuca { get; } = new() { DragCurve = DragCurve.Brazuca, SeamSeed = 6 };

    /// <summary>
    /// Adidas Telstar 18 (2018). Mass and radius: law. Drag: derived from reported ranges; no drag curve of this ball was read. Knuckle force: 1.2 N,
    /// measured on five other types. Seams: guess.
    /// </summary>
    /// <remarks>
    /// Reported: the crisis is at 2.7e5, against 2.3e5 of Brazuca (Asai and Hong 2021), and the range is 8 … 10 % below that of Brazuca (Goff, Hong and Asai
    /// 2018, press).
    /// </remarks>
    public static BallProperties Telstar18 { get; } = new() { DragCurve = DragCurve.Telstar18, SeamSeed = 7 };

    /// <summary>
    /// Nike Flight 2020. Mass and radius: law. Drag: guess; only its place in an order is measured. Knuckle force: 1.2 N, measured on five other types.
    /// Seams: guess.
    /// </summary>
    /// <remarks>
    /// Measured: an earlier crisis and slightly more drag than a ball of 32 panels (Asai and Hong 2021).
    /// </remarks>
    public static BallProperties Flight2020 { get; } = new() { DragCurve = DragCurve.Flight2020, SeamSeed = 8 };

    /// <summary>
    /// Adidas Al Rihla (2022). Mass and radius: law. Drag: derived from reported ranges; no drag curve of this ball was read. Knuckle force: 1.2 N, measured
    /// on five other types. Seams: guess.
    /// </summary>
    /// <remarks>
    /// Reported: the crisis is slightly above that of Trionda and near that of Brazuca. The roughness of 0.31 is derived from this.
    /// </remarks>
    public static BallProperties AlRihla { get; } = new() { DragCurve = DragCurve.OfRoughness(0.31), SeamSeed = 9 };

    /// <summary>
    /// Adidas Fussballliebe (2024). Mass and radius: law. Drag: guess; only its place in an order is measured. Knuckle force: 1.2 N, measured on five other
    /// types. Seams: guess.
    /// </summary>
    /// <remarks>
    /// Measured: the shortest flight of ten balls, and an earlier crisis (KJSS 35(2):392, 2024).
    /// </remarks>
    public static BallProperties Fussballliebe { get; } = new() { DragCurve = DragCurve.Fussballliebe, SeamSeed = 10 };

    /// <summary>
    /// Adidas Trionda (2026). Mass and radius: law. Crisis: measured; drag above it: guess, derived from reported ranges; no drag curve of this ball was
    /// read. Knuckle force: 1.2 N, measured on five other types. Seams: guess.
    /// </summary>
    /// <remarks>
    /// Measured (University of Tsukuba, as reported): the crisis is at 27 mph (12.1 m/s), earlier than for Al Rihla, Telstar 18 and Brazuca; the roughness of
    /// 0.35 is derived from this speed. Reported: more drag at speed, and a flight that is a few metres shorter (press).
    /// </remarks>
    public static BallProperties Trionda { get; } = new() { DragCurve = DragCurve.Trionda, SeamSeed = 11 };

    /// <summary>
    /// A youth football, size 4: 0.37 kg, 64.8 cm in circumference. Mass and radius: law. Drag and knuckle force: measured on larger balls. Seams: guess.
    /// </summary>
    /// <remarks>
    /// Law: the middle of the usual range for that size.
    /// </remarks>
    public static BallProperties YouthFootball { get; } = new() { Mass = 0.37, Radius = 0.103, SeamSeed = 12 };

    /// <summary>
    /// A futsal ball, size 4, low bounce: 0.42 kg, 63 cm in circumference. Mass and radius: law. Drag and knuckle force: measured on other balls. Seams:
    /// guess.
    /// </summary>
    /// <remarks>
    /// Law: the middle of the range in the futsal Laws.
    /// </remarks>
    public static BallProperties Futsal { get; } = new() { Mass = 0.42, Radius = 0.100, SeamSeed = 13 };

    /// <summary>
    /// A beach ball: large, and so light that the air dominates its flight. Mass and radius: guess. Drag: derived from a smooth sphere. Reverse lift, knuckle
    /// force and seams: guess.
    /// </summary>
    /// <remarks>
    /// 0.1 kg, radius 0.2 m. Drag: Achenbach 1972. Reverse lift: 0.30 (guess, 0 … 0.4).
    /// </remarks>
    public static BallProperties BeachBall { get; } = new() { Mass = 0.1, Radius = 0.2, DragCurve = DragCurve.SmoothSphere, ReverseLift = 0.30, SeamSeed = 14 };

    /// <summary>
    /// A medicine ball: heavy and solid. Mass and radius: guess. Moment of inertia: derived. Drag, knuckle force and seams: guess, those of footballs.
    /// </summary>
    /// <remarks>
    /// 3 kg, radius 0.12 m, α 2/5.
    /// </remarks>
    public static BallProperties MedicineBall { get; } = Tunnel with { Mass = 3.0, Radius = 0.12, InertiaFactor = 0.4, SeamSeed = 15 };

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
