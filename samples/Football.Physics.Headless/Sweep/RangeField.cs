using Football.Physics.Headless.Json;
using Football.Physics.Headless.Schema;

namespace Football.Physics.Headless.Sweep;

/// <summary>A number, or the two ends [low, high] of a range to draw from.</summary>
internal sealed class RangeField(string path, (double Low, double High) defaultValue, NumberRange range, string unit)
    : Field<(double Low, double High)>(path, $"{range.Describe(unit)}, or [low, high] of such", defaultValue)
{
    protected override (double Low, double High) Parse(JsonValue value)
    {
        if (value.Kind != JsonKind.Array)
        {
            double number = Numbers.Of(value);
            return range.Contains(number) ? (number, number) : throw Refuse(value);
        }

        double[] ends = Numbers.Array(Path, value, 2, Allowed);
        return range.Contains(ends[0]) && range.Contains(ends[1]) && ends[0] <= ends[1] ? (ends[0], ends[1]) : throw Refuse(value);
    }
}
