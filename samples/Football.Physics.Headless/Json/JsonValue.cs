using System.Text;

namespace Football.Physics.Headless.Json;

/// <summary>A JSON value that remembers how it was written, keeps members given twice, and can be edited.</summary>
internal sealed class JsonValue
{
    private static readonly List<JsonMember> NoMembers = [];
    private static readonly List<JsonValue> NoItems = [];

    private JsonValue(JsonKind kind, string text)
    {
        Kind = kind;
        Text = text;
        Members = kind == JsonKind.Object ? [] : NoMembers;
        Items = kind == JsonKind.Array ? [] : NoItems;
    }

    public JsonKind Kind { get; }

    /// <summary>The text of a string, otherwise the value as it was written.</summary>
    public string Text { get; }

    /// <summary>Members of an object, in the order given.</summary>
    public List<JsonMember> Members { get; }

    /// <summary>Items of an array.</summary>
    public List<JsonValue> Items { get; }

    public static JsonValue Object() => new(JsonKind.Object, "");

    public static JsonValue Array() => new(JsonKind.Array, "");

    public static JsonValue String(string text) => new(JsonKind.String, text);

    public static JsonValue Number(string text) => new(JsonKind.Number, text);

    public static JsonValue Boolean(bool value) => new(JsonKind.Boolean, value ? "true" : "false");

    public static JsonValue Null() => new(JsonKind.Null, "null");

    /// <summary>The first member of that name, or null.</summary>
    public JsonValue? Find(string name)
    {
        foreach (JsonMember member in Members)
        {
            if (member.Name == name)
            {
                return member.Value;
            }
        }

        return null;
    }

    /// <summary>Puts a member in the place of all that have its name.</summary>
    public void Replace(string name, JsonValue value)
    {
        Members.RemoveAll(member => member.Name == name);
        Members.Add(new JsonMember(name, value));
    }

    /// <summary>The value on one short line, for a message.</summary>
    public override string ToString()
    {
        var text = new StringBuilder();
        Append(text);
        return Quote.Short(text.ToString());
    }

    private void Append(StringBuilder text)
    {
        // A message shows the beginning only; the rest of a long value need not be put together.
        if (text.Length > Quote.Longest)
        {
            return;
        }

        switch (Kind)
        {
            case JsonKind.Object:
                AppendAll(text, '{', '}', Members, static (into, member) =>
                {
                    into.Append('"').Append(Quote.Beginning(member.Name)).Append("\": ");
                    member.Value.Append(into);
                });
                break;
            case JsonKind.Array:
                AppendAll(text, '[', ']', Items, static (into, item) => item.Append(into));
                break;
            case JsonKind.String:
                text.Append('"').Append(Quote.Beginning(Text)).Append('"');
                break;
            default:
                text.Append(Quote.Beginning(Text));
                break;
        }
    }

    private static void AppendAll<T>(StringBuilder text, char open, char close, List<T> values, Action<StringBuilder, T> append)
    {
        text.Append(open);
        string separator = "";
        foreach (T value in values)
        {
            if (text.Length > Quote.Longest)
            {
                break;
            }

            text.Append(separator);
            append(text, value);
            separator = ", ";
        }

        text.Append(close);
    }
}
