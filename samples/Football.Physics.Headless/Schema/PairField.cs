using Football.Physics.Headless.Json;

namespace Football.Physics.Headless.Schema;

/// <summary>Two numbers [x, z], each within a range.</summary>
internal sealed class PairField(string path, (double X, double Z) defaultValue, NumberRange range)
    : Field<(double X, double Z)>(path, $"[x, z], each {range.Describe("")}", defaultValue)
{
    protected override (double X, double Z) Parse(JsonValue value)
    {
        double[] parts = Numbers.Array(Path, value, 2, Allowed);
        for (int i = 0; i < parts.Length; i++)
        {
            if (!range.Contains(parts[i]))
            {
                throw new RefusedException($"{Path}[{i}]", value.Items[i].ToString(), range.Describe(""));
            }
        }

        return (parts[0], parts[1]);
    }
}
