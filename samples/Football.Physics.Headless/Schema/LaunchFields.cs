namespace Football.Physics.Headless.Schema;

/// <summary>The fields of a launch.</summary>
internal static class LaunchFields
{
    public static readonly VectorField Position = new("launch.position", VectorBound.Position, required: true);
    public static readonly VectorField Velocity = new("launch.velocity", VectorBound.Velocity, required: true);
    public static readonly VectorField Spin = new("launch.spin", VectorBound.Spin);
    public static readonly RotationField Orientation = new("launch.orientation");

    /// <summary>All of them.</summary>
    public static IReadOnlyList<Field> All { get; } = [Position, Velocity, Spin, Orientation];
}
