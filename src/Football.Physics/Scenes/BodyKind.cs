namespace FootballPhysics;

/// <summary>A kind of body: its shape, its surface, and the mass behind that. The presets are for <see cref="KinematicBodies.Add(string, BodyKind, int)"/>.</summary>
public sealed record BodyKind
{
    /// <summary>Its shape, in its own frame.</summary>
    public required IShape Shape { get; init; }

    /// <summary>SurfaceMaterial of the body.</summary>
    public required SurfaceMaterial Surface { get; init; }

    /// <summary>Mass behind its surface, kg; above 0; default infinite: the ball does not move it.</summary>
    public double Mass { get; init; } = double.PositiveInfinity;

    /// <summary>A boot with its leg, about the middle of the foot: 28 cm long, 1.9 kg. Evidence: guess (effective masses of 1.5 … 3 kg are used for kicks).</summary>
    public static BodyKind Boot { get; } = new()
    {
        Shape = new CapsuleShape(new Vector3d(0, 0, 0.09), new Vector3d(0, 0, -0.09), 0.05),
        Surface = SurfaceMaterial.Boot,
        Mass = 1.9,
    };

    /// <summary>A head that a neck holds, about its centre: radius 10 cm, 5 kg. Evidence: guess (a head weighs 4.5 … 5 kg).</summary>
    public static BodyKind Head { get; } = new() { Shape = new SphereShape(Vector3d.Zero, 0.1), Surface = SurfaceMaterial.Head, Mass = 5 };

    /// <summary>A player upright, about the point where he stands: 1.8 m tall, 75 kg. Evidence: guess.</summary>
    public static BodyKind Player { get; } = new()
    {
        Shape = new CapsuleShape(new Vector3d(0, 0.25, 0), new Vector3d(0, 1.55, 0), 0.25),
        Surface = SurfaceMaterial.Boot,
        Mass = 75,
    };

    /// <summary>A training cone, about the point where it stands: 30 cm tall, 0.3 kg. Evidence: guess.</summary>
    public static BodyKind Cone { get; } = new()
    {
        Shape = new CapsuleShape(new Vector3d(0, 0.08, 0), new Vector3d(0, 0.22, 0), 0.08),
        Surface = SurfaceMaterial.Board,
        Mass = 0.3,
    };

    /// <summary>A corner flag on its sprung foot, about the point where it stands: 1.5 m tall (Law 1), 3 cm thick, 0.8 kg at the ball's height. Evidence: guess.</summary>
    public static BodyKind CornerFlag { get; } = new()
    {
        Shape = new CapsuleShape(new Vector3d(0, 0.015, 0), new Vector3d(0, 1.485, 0), 0.015),
        Surface = SurfaceMaterial.Board,
        Mass = 0.8,
    };
}
