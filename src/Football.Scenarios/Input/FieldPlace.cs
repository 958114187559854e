using System.Globalization;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace FootballPhysics.Scenarios.Input;

/// <summary>Sets values in a JSON tree.</summary>
public static class FieldPlace
{
    private const string Anywhere = "a member of an object, or an element of an array";

    /// <summary>Sets a value at a path, and creates missing objects on the path.</summary>
    /// <param name="root">The root of the tree.</param>
    /// <param name="path">The parts of the path, outermost first.</param>
    /// <param name="value">The value.</param>
    /// <param name="who">The name of the option, for error messages.</param>
    /// <exception cref="RefusedException">There is no such field.</exception>
    public static void Put(JsonNode root, ReadOnlySpan<string> path, JsonNode? value, string who)
    {
        JsonNode at = root;
        for (int i = 0; i < path.Length - 1; i++)
        {
            if (at is JsonObject members)
            {
                at = members[path[i]] ??= char.IsAsciiDigit(path[i + 1].FirstOrDefault()) ? throw NoPlace(path, i + 1, who, "an element of an array that is there") : new JsonObject();
            }
            else
            {
                at = Elements(at, path, i, who)[Index(at, path, i, who)] ?? throw NoPlace(path, i + 1, who, Anywhere);
            }
        }

        int end = path.Length - 1;
        if (at is JsonObject parent)
        {
            parent[path[end]] = value;
        }
        else
        {
            Elements(at, path, end, who)[Index(at, path, end, who)] = value;
        }
    }

    /// <summary>Converts a value to a node of a tree.</summary>
    public static JsonNode? Node(JsonElement value) => value.ValueKind switch
    {
        JsonValueKind.Object => JsonObject.Create(value),
        JsonValueKind.Array => JsonArray.Create(value),
        _ => JsonValue.Create(value),
    };

    private static JsonArray Elements(JsonNode at, ReadOnlySpan<string> path, int part, string who) => at as JsonArray ?? throw NoPlace(path, part, who, Anywhere);

    private static int Index(JsonNode at, ReadOnlySpan<string> path, int part, string who)
    {
        int count = Elements(at, path, part, who).Count;
        return int.TryParse(path[part], NumberStyles.None, CultureInfo.InvariantCulture, out int index) && index < count
            ? index
            : throw NoPlace(path, part, who, $"an element from 0 to {count - 1}");
    }

    private static RefusedException NoPlace(ReadOnlySpan<string> path, int part, string who, string allowed) =>
        new(who, $"no place: {Quote.Short(string.Join('.', path[..part].ToArray()))} has no {Quote.Short(path[part])}", allowed);
}
