using System.Globalization;
using System.Text.Json;

namespace FootballPhysics.Scenarios.Input;

/// <summary>Collects the known fields of an input, the given fields, and their errors.</summary>
public sealed class InputFields
{
    private readonly JsonElement _root;

    /// <summary>The known members of each object, by its path.</summary>
    private readonly Dictionary<string, List<string>> _names = [];

    /// <summary>The objects in lists, by path.</summary>
    private readonly Dictionary<string, JsonElement> _items = [];

    private RefusedException? _refusal;

    /// <summary>Creates an instance without known fields.</summary>
    /// <param name="root">The whole input.</param>
    public InputFields(JsonElement root)
    {
        _root = root;
        Root = new InputObject(this, "", root.ValueKind == JsonValueKind.Object ? root : null);
    }

    /// <summary>The root object.</summary>
    public InputObject Root { get; }

    /// <summary>The input, as parsed.</summary>
    public JsonElement Document => _root;

    /// <summary>Returns the list of known member names of the object at a path; callers add names to it.</summary>
    public List<string> NamesIn(string path) => _names.TryGetValue(path, out List<string>? names) ? names : _names[path] = [];

    /// <summary>Registers an object in a list. Its members are checked like those of other objects.</summary>
    public InputObject Item(string path, JsonElement item)
    {
        _items[path] = item;
        return new InputObject(this, path, item.ValueKind == JsonValueKind.Object ? item : null);
    }

    /// <summary>Records an error. Only the first one is kept.</summary>
    public void Refuse(RefusedException refusal) => _refusal ??= refusal;

    /// <summary>Throws the first error. Call it after all members have been read.</summary>
    /// <exception cref="RefusedException">A field is unknown, missing or of the wrong type.</exception>
    public void Check()
    {
        CheckMembers("", _root);
        foreach ((string path, JsonElement item) in _items)
        {
            CheckMembers(path, item);
        }

        if (_refusal is not null)
        {
            throw _refusal;
        }
    }

    /// <summary>Returns the text of a field in the input, on one line; null if it is not given.</summary>
    public string? Text(string path)
    {
        JsonElement at = _root;
        foreach (string part in FieldPath.Split(path))
        {
            bool found = at.ValueKind switch
            {
                JsonValueKind.Object => at.TryGetProperty(part, out at),
                JsonValueKind.Array => int.TryParse(part, NumberStyles.None, CultureInfo.InvariantCulture, out int index) && Element(ref at, index),
                _ => false,
            };
            if (!found)
            {
                return null;
            }
        }

        return Text(at);
    }

    private static bool Element(ref JsonElement at, int index)
    {
        bool there = index < at.GetArrayLength();
        at = there ? at[index] : at;
        return there;
    }

    /// <summary>Returns the text of a value, on one line.</summary>
    private static string Text(JsonElement value) =>
        Quote.Short(string.Join(' ', value.GetRawText().Split((char[])[' ', '\t', '\r', '\n'], StringSplitOptions.RemoveEmptyEntries)));

    private void CheckMembers(string path, JsonElement value)
    {
        List<string> names = _names[path];
        if (value.ValueKind != JsonValueKind.Object)
        {
            throw new RefusedException(path.Length > 0 ? path : "the scenario", Text(value), $"an object {{{string.Join(", ", names)}}}");
        }

        foreach (JsonProperty member in value.EnumerateObject())
        {
            string memberPath = path.Length > 0 ? $"{path}.{member.Name}" : member.Name;
            if (!names.Contains(member.Name))
            {
                throw Unknown(path, member.Name, memberPath, member.Value);
            }

            if (_names.ContainsKey(memberPath))
            {
                CheckMembers(memberPath, member.Value);
            }
        }
    }

    private RefusedException Unknown(string parent, string name, string path, JsonElement value)
    {
        string? meant = Spelling.Closest(name, _names[parent]);
        string? meantPath = meant is null ? ElsewhereNamed(name) : parent.Length > 0 ? $"{parent}.{meant}" : meant;
        string hint = meantPath is null ? "." : $"; did you mean {meantPath}?";
        string place = parent.Length > 0 ? $"in {parent}" : "at the top";
        return new RefusedException($"{Quote.Short(path)} is unknown (given {Text(value)}); allowed {place}: {string.Join(" | ", _names[parent])}{hint}");
    }

    /// <summary>
    /// Returns the path of a field of this name, ignoring case, in another object; null if there is none. The user may have put the field into the
    /// wrong object.
    /// </summary>
    private string? ElsewhereNamed(string name) => _names
        .Where(parent => parent.Value.Contains(name, StringComparer.OrdinalIgnoreCase))
        .Select(parent => (parent.Key.Length > 0 ? parent.Key + "." : "") + parent.Value.First(item => item.Equals(name, StringComparison.OrdinalIgnoreCase)))
        .FirstOrDefault();
}
