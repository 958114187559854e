using Football.Physics.Headless.Json;

namespace Football.Physics.Headless.Schema;

/// <summary>[x, y, z] with a bound on its size.</summary>
internal sealed class VectorField(string path, VectorBound bound, bool required = false)
    : Field<Vector3d>(path, bound.Allowed, Vector3d.Zero, required)
{
    protected override Vector3d Parse(JsonValue value)
    {
        double[] parts = Numbers.Array(Path, value, 3, Allowed);
        var vector = new Vector3d(parts[0], parts[1], parts[2]);
        return bound.Contains(vector) ? vector : throw Refuse(value);
    }
}
