using Football.Physics.Headless.Json;

namespace Football.Physics.Headless.Schema;

/// <summary>A number within a range.</summary>
internal sealed class NumberField(string path, double defaultValue, NumberRange range, string unit = "", bool required = false)
    : Field<double>(path, range.Describe(unit), defaultValue, required)
{
    protected override double Parse(JsonValue value)
    {
        double number = Numbers.Of(value);
        return range.Contains(number) ? number : throw Refuse(value);
    }
}
