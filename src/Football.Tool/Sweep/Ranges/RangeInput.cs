using System.Globalization;
using System.Text.Json;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Sweep.Columns;

namespace FootballPhysics.Tool.Sweep.Ranges;

/// <summary>Reads a range: [low, high], {"uniform"}, {"normal"}, {"list"} or {"grid"}.</summary>
internal static class RangeInput
{
    /// <summary>The maximum number of values in a list or a grid.</summary>
    private const int MostValues = 1_000_000;

    /// <summary>The minimum share of a normal distribution within its bounds.</summary>
    private const double LeastShare = 1e-6;

    private const string Forms = """[low, high] | {"uniform": [low, high]} | {"normal": [mean, deviation], "within": [low, high]} | {"list": [value, …]} | {"grid": [value, …]} | {"grid": {"from", "to", "count"}}""";

    /// <summary>Reads a range; null if the value is an ordinary value of the field.</summary>
    /// <param name="field">The field, for error messages.</param>
    /// <param name="value">The value in the input.</param>
    /// <param name="allowed">The allowed numbers; null if other code checks them.</param>
    /// <exception cref="RefusedException">The value is not a range, or one of its numbers is not allowed.</exception>
    public static FieldRange? Read(string field, JsonElement value, NumberRange? allowed)
    {
        FieldRange? range = value.ValueKind switch
        {
            JsonValueKind.Array => Uniform(value),
            JsonValueKind.Object => OfObject(value),
            _ => null,
        };
        bool isRange = value.ValueKind is JsonValueKind.Array or JsonValueKind.Object;
        if ((isRange && range is null) || (!isRange && allowed is not null && !Fits(value, allowed.Value)))
        {
            throw Refused(field, value, allowed);
        }

        return range is null || allowed is not { } limits || range.Ends.All(end => limits.Contains(end.Number)) ? range : throw Refused(field, value, allowed);
    }

    private static RefusedException Refused(string field, JsonElement value, NumberRange? allowed) => new(
        field,
        Quote.Short(string.Join(' ', value.GetRawText().Split((char[])[' ', '\t', '\r', '\n'], StringSplitOptions.RemoveEmptyEntries))),
        allowed is { } limits ? $"{limits}, or a range of such: {Forms}" : $"a number, a word, true | false, or {Forms}");

    private static bool Fits(JsonElement value, NumberRange allowed) => Number(value) is var number && allowed.Contains(number);

    private static FieldRange? OfObject(JsonElement value)
    {
        JsonProperty[] members = [.. value.EnumerateObject()];
        return (members.Length > 0 ? members[0].Name : "", members.Length) switch
        {
            ("uniform", 1) => Uniform(members[0].Value),
            ("normal", 1) => Normal(members[0].Value, double.NegativeInfinity, double.PositiveInfinity),
            ("normal", 2) when members[1].Name == "within" && Pair(members[1].Value, out double low, out double high) && low < high =>
                Normal(members[0].Value, low, high),
            ("list", 1) => Choice(members[0].Value, isGrid: false),
            ("grid", 1) when members[0].Value.ValueKind == JsonValueKind.Object => Spaced(members[0].Value),
            ("grid", 1) => Choice(members[0].Value, isGrid: true),
            _ => null,
        };
    }

    private static UniformRange? Uniform(JsonElement value) =>
        Pair(value, out double low, out double high) && low <= high ? new UniformRange(low, high) : null;

    private static NormalRange? Normal(JsonElement value, double low, double high)
    {
        if (!Pair(value, out double mean, out double deviation) || !(deviation > 0))
        {
            return null;
        }

        var range = new NormalRange(mean, deviation, low, high);
        return range.Share >= LeastShare ? range : null;
    }

    private static ChoiceRange? Choice(JsonElement values, bool isGrid)
    {
        if (values.ValueKind != JsonValueKind.Array || values.GetArrayLength() is < 1 or > MostValues)
        {
            return null;
        }

        var range = new ChoiceRange([.. values.EnumerateArray()], isGrid);
        return range.HasNumbers || range.Values.Count <= Column.MostWords ? range : null;
    }

    /// <summary>Returns numbers at equal distances, including both ends.</summary>
    private static ChoiceRange? Spaced(JsonElement grid)
    {
        double from = Member(grid, "from");
        double to = Member(grid, "to");
        double count = Member(grid, "count");
        if (grid.EnumerateObject().Count() != 3 || !double.IsFinite(from) || !double.IsFinite(to) || !(count >= 2) || count > MostValues || count != Math.Floor(count))
        {
            return null;
        }

        int last = (int)count - 1;
        return new ChoiceRange(
            [.. Enumerable.Range(0, last + 1).Select(i => Element(i == last ? to : from + ((to - from) * i / last)))],
            isGrid: true);
    }

    private static JsonElement Element(double number) => JsonElement.Parse(number.ToString("R", CultureInfo.InvariantCulture));

    private static double Member(JsonElement of, string name) => of.TryGetProperty(name, out JsonElement value) ? Number(value) : double.NaN;

    private static bool Pair(JsonElement value, out double first, out double second)
    {
        bool isPair = value.ValueKind == JsonValueKind.Array && value.GetArrayLength() == 2;
        first = isPair ? Number(value[0]) : double.NaN;
        second = isPair ? Number(value[1]) : double.NaN;
        return double.IsFinite(first) && double.IsFinite(second);
    }

    private static double Number(JsonElement value) =>
        value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double number) ? number : double.NaN;
}
