using Football.Physics.Headless.Json;
using Football.Physics.Headless.Schema;

namespace Football.Physics.Headless.Aim;

/// <summary>A whole number, 1 or more.</summary>
internal sealed class CountField(string path, int defaultValue) : Field<int>(path, $"a whole number from 1 to {int.MaxValue}", defaultValue)
{
    protected override int Parse(JsonValue value)
    {
        double number = Numbers.Of(value);
        return number is >= 1 and <= int.MaxValue && number == Math.Floor(number) ? (int)number : throw Refuse(value);
    }
}
