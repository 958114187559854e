namespace FootballPhysics;

/// <summary>A kind of body: shape, surface and effective mass.</summary>
/// <remarks>Pass a kind to <see cref="KinematicBodies.Add(string, BodyKind, int)"/>.</remarks>
public sealed record BodyKind
{
    /// <summary>The shape, in the body's frame.</summary>
    public required IShape Shape { get; init; }

    /// <summary>The material of the surface.</summary>
    public required SurfaceMaterial Surface { get; init; }

    /// <summary>The effective mass at the surface, in kg; above 0. Default infinite: the ball does not move the body.</summary>
    public double Mass { get; init; } = double.PositiveInfinity;

    /// <summary>A boot and lower leg, centred on the middle of the foot: 28 cm long, 1.9 kg.</summary>
    /// <remarks>Guess: published effective masses for kicks are 1.5 … 3 kg.</remarks>
    public static BodyKind Boot { get; } = new()
    {
        Shape = new CapsuleShape(new Vector3d(0, 0, 0.09), new Vector3d(0, 0, -0.09), 0.05),
        Surface = SurfaceMaterial.Boot,
        Mass = 1.9,
    };

    /// <summary>A head on its neck: a sphere about the origin, with a radius of 10 cm and a mass of 5 kg.</summary>
    /// <remarks>Guess: a head weighs 4.5 … 5 kg.</remarks>
    public static BodyKind Head { get; } = new() { Shape = new SphereShape(Vector3d.Zero, 0.1), Surface = SurfaceMaterial.Head, Mass = 5 };

    /// <summary>An upright player, about the point between his feet: 1.8 m tall, 75 kg.</summary>
    /// <remarks>Guess.</remarks>
    public static BodyKind Player { get; } = new()
    {
        Shape = new CapsuleShape(new Vector3d(0, 0.25, 0), new Vector3d(0, 1.55, 0), 0.25),
        Surface = SurfaceMaterial.Boot,
        Mass = 75,
    };

    /// <summary>A training cone, about the centre of its base: 30 cm tall, 0.3 kg.</summary>
    /// <remarks>Guess.</remarks>
    public static BodyKind Cone { get; } = new()
    {
        Shape = new CapsuleShape(new Vector3d(0, 0.08, 0), new Vector3d(0, 0.22, 0), 0.08),
        Surface = SurfaceMaterial.Board,
        Mass = 0.3,
    };

    /// <summary>A corner flag on a sprung base, about the centre of its base: 1.5 m tall (Law 1), 3 cm thick.</summary>
    /// <remarks>The effective mass at the height of the ball is 0.8 kg (guess).</remarks>
    public static BodyKind CornerFlag { get; } = new()
    {
        Shape = new CapsuleShape(new Vector3d(0, 0.015, 0), new Vector3d(0, 1.485, 0), 0.015),
        Surface = SurfaceMaterial.Board,
        Mass = 0.8,
    };
}
