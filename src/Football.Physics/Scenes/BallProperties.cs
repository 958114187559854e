namespace Football.Physics;

/// <summary>What the ball is made of.</summary>
public sealed record BallProperties
{
    /// <summary>Mass, kg. Above 0, 1e-300 … 1e100; default 0.43.</summary>
    public double Mass { get; init; } = 0.43;

    /// <summary>Radius, m. Above 0, 1e-9 … 1e6; default 0.11.</summary>
    public double Radius { get; init; } = 0.11;

    /// <summary>Inertia factor α in I = α m r². Above 0, 1e-12 … 1; default 2/3, a thin shell.</summary>
    public double InertiaFactor { get; init; } = 2.0 / 3.0;

    /// <summary>A match football, size 5.</summary>
    public static BallProperties Football { get; } = new();

    /// <summary>A youth football, size 4 (0.37 kg, 64.8 cm around: the middle of the Laws' usual range for that size).</summary>
    public static BallProperties YouthFootball { get; } = new() { Mass = 0.37, Radius = 0.103 };

    /// <summary>A futsal ball, size 4 low-bounce (0.42 kg, 63 cm around: the middle of the futsal Laws' range).</summary>
    public static BallProperties Futsal { get; } = new() { Mass = 0.42, Radius = 0.100 };

    /// <summary>A beach ball: large, and light enough for the air to rule it (0.1 kg, radius 0.2 m).</summary>
    public static BallProperties BeachBall { get; } = new() { Mass = 0.1, Radius = 0.2 };

    /// <summary>A medicine ball: heavy and solid (3 kg, radius 0.12 m, α 2/5).</summary>
    public static BallProperties MedicineBall { get; } = new() { Mass = 3.0, Radius = 0.12, InertiaFactor = 0.4 };

    /// <summary>Moment of inertia I = α m r², kg m².</summary>
    public double MomentOfInertia => InertiaFactor * Mass * Radius * Radius;
}
