using Football.Physics.Headless.Json;
using Football.Physics.Headless.Schema;

namespace Football.Physics.Headless.Aim;

/// <summary>A point [x, y, z], or null for none.</summary>
internal sealed class OptionalPointField(string path) : Field<Vector3d?>(path, Point(path).Allowed + ", or null", null)
{
    private readonly VectorField _point = Point(path);

    protected override Vector3d? Parse(JsonValue value) => value.Kind == JsonKind.Null ? null
        : value.Kind == JsonKind.Array ? (Vector3d)_point.Read(value)!
        : throw Refuse(value);

    private static VectorField Point(string path) => new(path, VectorBound.Position);
}
