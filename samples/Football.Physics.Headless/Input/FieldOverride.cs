using System.Globalization;
using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace Football.Physics.Headless.Input;

/// <summary>A value that takes the place of a field's in every scenario, whether the field was given or not.</summary>
internal sealed class FieldOverride
{
    /// <summary>Far deeper than any scenario.</summary>
    private const int MostParts = 16;

    private const string Anywhere = "a member of an object, or an element of an array";

    private readonly string[] _path;
    private readonly string _value;

    private FieldOverride(string[] path, string value)
    {
        _path = path;
        _value = value;
    }

    /// <summary>Reads path=value; null where it is not of that form.</summary>
    public static FieldOverride? Parse(string text)
    {
        int equals = text.IndexOf('=', StringComparison.Ordinal);
        string[] path = equals > 0 ? FieldPath.Split(text[..equals].Trim()) : [];
        return path.Length is > 0 and <= MostParts ? new FieldOverride(path, text[(equals + 1)..].Trim()) : null;
    }

    /// <summary>A scenario with the values in their places.</summary>
    /// <exception cref="RefusedException">There is no such place.</exception>
    public static JsonElement Apply(JsonElement scenario, IReadOnlyList<FieldOverride> overrides)
    {
        // What is no object is left as it is: the check that follows names it.
        if (overrides.Count == 0 || scenario.ValueKind != JsonValueKind.Object)
        {
            return scenario;
        }

        var root = JsonObject.Create(scenario)!;
        foreach (FieldOverride item in overrides)
        {
            item.Apply(root);
        }

        return JsonSerializer.SerializeToElement(root);
    }

    /// <summary>Puts the value in its place; objects on the way are made where they are missing.</summary>
    private void Apply(JsonNode at)
    {
        for (int i = 0; i < _path.Length - 1; i++)
        {
            if (at is JsonObject members)
            {
                members[_path[i]] ??= new JsonObject();
                at = members[_path[i]]!;
            }
            else
            {
                at = Elements(at, i)[Index(at, i)] ?? throw NoPlace(i + 1, Anywhere);
            }
        }

        int end = _path.Length - 1;
        if (at is JsonObject parent)
        {
            parent[_path[end]] = Value();
        }
        else
        {
            Elements(at, end)[Index(at, end)] = Value();
        }
    }

    private JsonArray Elements(JsonNode at, int part) => at as JsonArray ?? throw NoPlace(part, Anywhere);

    private int Index(JsonNode at, int part) =>
        int.TryParse(_path[part], NumberStyles.None, CultureInfo.InvariantCulture, out int index) && index < Elements(at, part).Count
            ? index
            : throw NoPlace(part, $"an element from 0 to {Elements(at, part).Count - 1}");

    private RefusedException NoPlace(int part, string allowed) => new(
        $"--set {string.Join('.', _path)}", $"no place: {Quote.Short(string.Join('.', _path[..part]))} has no {Quote.Short(_path[part])}", allowed);

    /// <summary>JSON where the text is JSON, so that numbers and arrays need no quotes; otherwise the text itself.</summary>
    private JsonNode? Value()
    {
        if (JsonText.Parse(Encoding.UTF8.GetBytes(_value), out JsonElement value) is not null)
        {
            return JsonValue.Create(_value);
        }

        return value.ValueKind switch
        {
            JsonValueKind.Object => JsonObject.Create(value),
            JsonValueKind.Array => JsonArray.Create(value),
            _ => JsonValue.Create(value),
        };
    }
}
