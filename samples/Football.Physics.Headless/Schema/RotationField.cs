using Football.Physics.Headless.Json;

namespace Football.Physics.Headless.Schema;

/// <summary>A quaternion [x, y, z, w] of any size but zero.</summary>
internal sealed class RotationField(string path) : Field<Quaterniond>(path, "four finite numbers [x, y, z, w], not all zero", Quaterniond.Identity)
{
    protected override Quaterniond Parse(JsonValue value)
    {
        double[] parts = Numbers.Array(Path, value, 4, Allowed);

        // Scaled first, so that the square of a very large or very small one is neither infinite nor zero.
        double largest = parts.Max(Math.Abs);
        return largest > 0
            ? new Quaterniond(parts[0] / largest, parts[1] / largest, parts[2] / largest, parts[3] / largest).Normalised()
            : throw Refuse(value);
    }
}
