using System.Text;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace FootballPhysics.Scenarios.Input;

/// <summary>A value that replaces a field in every scenario, or adds it if the field is not given.</summary>
public sealed class FieldOverride
{
    /// <summary>The maximum number of parts of a path: far more than any scenario has.</summary>
    private const int MostParts = 16;

    private const string Anywhere = "a member of an object, or an element of an array";

    private readonly string[] _path;
    private readonly string _value;

    private FieldOverride(string[] path, string value)
    {
        _path = path;
        _value = value;
    }

    /// <summary>Parses path=value; null if the text has another form.</summary>
    public static FieldOverride? Parse(string text)
    {
        int equals = text.IndexOf('=', StringComparison.Ordinal);
        string[] path = equals > 0 ? FieldPath.Split(text[..equals].Trim()) : [];
        return path.Length is > 0 and <= MostParts ? new FieldOverride(path, text[(equals + 1)..].Trim()) : null;
    }

    /// <summary>Parses path=range, which sets a member of the object "ranges"; null if the text has another form.</summary>
    public static FieldOverride? ParseRange(string text) =>
        Parse(text) is { } field ? new FieldOverride(["ranges", string.Join('.', field._path)], field._value) : null;

    /// <summary>Returns the scenario with the values set.</summary>
    /// <exception cref="RefusedException">There is no such field.</exception>
    public static JsonElement Apply(JsonElement scenario, IReadOnlyList<FieldOverride> overrides)
    {
        // An input that is not an object stays unchanged; the check that follows reports it.
        if (overrides.Count == 0 || scenario.ValueKind != JsonValueKind.Object)
        {
            return scenario;
        }

        var root = JsonObject.Create(scenario)!;
        foreach (FieldOverride item in overrides)
        {
            FieldPlace.Put(root, item._path, item.Value(), $"--set {string.Join('.', item._path)}");
        }

        return JsonElement.Parse(root.ToJsonString());
    }

    /// <summary>Returns the text as JSON if it is valid JSON, so that numbers and arrays need no quotes; otherwise as a string.</summary>
    private JsonNode? Value()
    {
        if (JsonText.Parse(Encoding.UTF8.GetBytes(_value), out JsonElement value) is not null)
        {
            return JsonValue.Create(_value);
        }

        return FieldPlace.Node(value);
    }
}
