namespace FootballPhysics;

/// <summary>The properties of a ball: mass, radius, inertia, drag curve, knuckle force.</summary>
/// <remarks>Numbers are tagged: law (the Laws of the Game, or exact mechanics), measured, derived, guess (no measurement found).</remarks>
public sealed record BallProperties
{
    /// <summary>Below this radius, m, a ball is a marble: the rest energy of a football would end its roll at a third of a metre a second.</summary>
    private const double SmallRadius = 0.02;

    /// <summary>Mass, kg. 0.001 … 100, and no less than a twentieth of that of the air it displaces; default 0.43 (law: 0.41 … 0.45).</summary>
    public double Mass { get; init; } = 0.43;

    /// <summary>Radius, m. 0.005 … 5; default 0.11 (law: 68 … 70 cm around). A ball below 2 cm rests below the share (r/2 cm)³ of <see cref="Ground.RestEnergy"/>.</summary>
    public double Radius { get; init; } = 0.11;

    /// <summary>Inertia factor α in I = α m r². 0.1 … 1; default 2/3, a thin shell (derived; layered balls ±0.03, guess).</summary>
    public double InertiaFactor { get; init; } = 2.0 / 3.0;

    /// <summary>Factor on the restitution of every surface: a soft ball bounces less. 0 … 1.2; default 1. No surface gets more than 1 by it, except a bumper.</summary>
    public double Bounce { get; init; } = 1;

    /// <summary>Drag coefficient without spin, for <see cref="AerodynamicModel.Measured"/> alone. Default <see cref="DragCurve.Modern"/>.</summary>
    public DragCurve DragCurve { get; init; } = DragCurve.Modern with { };

    /// <summary>
    /// K, standard deviation of the knuckle force across the motion at 30 m/s without spin, N; see <see cref="ForceSet.KnuckleSeed"/>.
    /// 0 … 100; default 1.5 (guess, within what Hong and Asai 2014 measured on other balls, 0.6 … 3.1).
    /// </summary>
    public double KnuckleForce { get; init; } = 1.5;

    /// <summary>
    /// The layers that the ball ignores, bit k for layer k, as <see cref="Layers.Of"/> gives them: obstacles, bodies, engine colliders and zones of these layers do not exist for
    /// this ball, such as a thrower's own hands. Default none.
    /// </summary>
    public uint Ignores { get; init; }

    /// <summary>
    /// The default: a match ball of today as it flies in a match. Its drag curve is that of roughness 0.86: measured on one match, and closer to the flights of a second one than the balls
    /// in wind tunnels. Knuckle force 1.5 N guess.
    /// </summary>
    public static BallProperties Modern { get; } = new();

    /// <summary>A match football in a wind tunnel's still air: the mean drag curve of three balls, <see cref="DragCurve.Generic"/>. JSON calls it generic.</summary>
    public static BallProperties Tunnel { get; } = new() { DragCurve = DragCurve.Generic };

    /// <summary>Adidas Tango 12 (2012). Drag measured; knuckle force 1.6 N: guess for this ball, Cafusa's measured 1.0 … 2.2.</summary>
    public static BallProperties Tango12 { get; } = new() { DragCurve = DragCurve.Tango12, KnuckleForce = 1.6 };

    /// <summary>Adidas Teamgeist (2006). Drag measured; knuckle force 0.75 N measured (Hong and Asai 2014: 0.6 … 0.9).</summary>
    public static BallProperties Teamgeist { get; } = new() { DragCurve = DragCurve.Teamgeist, KnuckleForce = 0.75 };

    /// <summary>Adidas Jabulani (2010). Drag measured; knuckle force 2.1 N measured (Hong and Asai 2014: 1.1 … 3.1).</summary>
    public static BallProperties Jabulani { get; } = new() { DragCurve = DragCurve.Jabulani, KnuckleForce = 2.1 };

    /// <summary>Adidas Brazuca (2014). Drag measured; knuckle force 1.5 N guess.</summary>
    public static BallProperties Brazuca { get; } = new() { DragCurve = DragCurve.Brazuca, KnuckleForce = 1.5 };

    /// <summary>
    /// Adidas Telstar 18 (2018), in a tunnel. Crisis as Brazuca's and long kicks 8 … 9 % shorter, measured (Goff, Hong and Asai 2018, as they told it); the numbers from that derived: C_D above the crisis
    /// 8 % higher. Knuckle force 1.5 N guess.
    /// </summary>
    public static BallProperties Telstar18 { get; } = new()
    {
        DragCurve = DragCurve.Brazuca with { Supercritical = 1.08 * DragCurve.Brazuca.Supercritical, Risen = 1.08 * DragCurve.Brazuca.Risen },
    };

    /// <summary>Nike Flight 2020. No measurement found: roughness 0.33, guess (0.25 … 0.5: moulded grooves).</summary>
    public static BallProperties Flight2020 { get; } = new() { DragCurve = DragCurve.OfRoughness(0.33) };

    /// <summary>Adidas Al Rihla (2022), in a tunnel. Crisis a little later than Trionda's and near Brazuca's, as told; roughness 0.31 from that, derived.</summary>
    public static BallProperties AlRihla { get; } = new() { DragCurve = DragCurve.OfRoughness(0.31) };

    /// <summary>Adidas Fussballliebe (2024). No measurement found: roughness 0.32, guess (0.25 … 0.45).</summary>
    public static BallProperties Fussballliebe { get; } = new() { DragCurve = DragCurve.OfRoughness(0.32) };

    /// <summary>
    /// Adidas Trionda (2026), in a tunnel. Crisis at 27 mph (12.1 m/s), earlier than Al Rihla's, Telstar 18's and Brazuca's, measured (University of Tsukuba, as reported); roughness 0.35
    /// from that, derived; more drag at high speed than those, as reported: C_D above the crisis 10 % higher, guess.
    /// </summary>
    public static BallProperties Trionda { get; } = new()
    {
        DragCurve = DragCurve.OfRoughness(0.35) with { Supercritical = 0.164, Risen = 0.197 },
    };

    /// <summary>A youth football, size 4 (0.37 kg, 64.8 cm around; law: the middle of the usual range for that size).</summary>
    public static BallProperties YouthFootball { get; } = new() { Mass = 0.37, Radius = 0.103 };

    /// <summary>A futsal ball, size 4 low-bounce (0.42 kg, 63 cm around; law: the middle of the futsal Laws' range).</summary>
    public static BallProperties Futsal { get; } = new() { Mass = 0.42, Radius = 0.100 };

    /// <summary>A beach ball: large, and light enough for the air to rule it (0.1 kg, radius 0.2 m; guess).</summary>
    public static BallProperties BeachBall { get; } = Tunnel with { Mass = 0.1, Radius = 0.2 };

    /// <summary>A medicine ball: heavy and solid (3 kg, radius 0.12 m, guess; α 2/5, derived).</summary>
    public static BallProperties MedicineBall { get; } = Tunnel with { Mass = 3.0, Radius = 0.12, InertiaFactor = 0.4 };

    /// <summary>The presets by the names that JSON, the command line and the engines use.</summary>
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

    /// <summary>Moment of inertia I = α m r², kg m².</summary>
    public double MomentOfInertia => InertiaFactor * Mass * Radius * Radius;

    /// <summary>The most that may damp a spin of this ball, N m s: so that none ends within 10 µs.</summary>
    internal double MostDamping => Math.Min(1.0, 1e5 * MomentOfInertia);

    /// <summary>The share of the ground's rest energy at which the ball rests: as small as its volume where the ball is a marble.</summary>
    internal double RestShare => Radius < SmallRadius ? Radius / SmallRadius * (Radius / SmallRadius) * (Radius / SmallRadius) : 1;

    internal void Validate()
    {
        SceneFields.Check(SceneFields.Ball, this, "ball.");

        // Also where the laws of the scene do not follow it: another scene may.
        Check.Member("ball.dragCurve", DragCurve);
        DragCurve.Validate();
    }
}
