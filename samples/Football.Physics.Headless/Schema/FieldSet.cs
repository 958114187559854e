using Football.Physics.Headless.Json;

namespace Football.Physics.Headless.Schema;

/// <summary>All fields of an input, from which it is read and checked.</summary>
internal sealed class FieldSet
{
    private readonly List<Field> _fields;
    private readonly Dictionary<string, Field> _byPath;
    private readonly Dictionary<string, List<string>> _memberNames = [];

    public FieldSet(params IEnumerable<Field>[] groups)
    {
        _fields = [.. groups.SelectMany(group => group)];
        _byPath = _fields.ToDictionary(field => field.Path);
        _memberNames[""] = [];
        foreach (Field field in _fields)
        {
            AddMember(field.Path);
        }
    }

    /// <summary>Whether an object at the root has such a member.</summary>
    public bool HasRootMember(string name) => _memberNames[""].Contains(name);

    /// <summary>What is allowed at a path, where something is known about it.</summary>
    public string? Allowed(string path)
    {
        int bracket = path.IndexOf('[', StringComparison.Ordinal);
        string field = bracket < 0 ? path : path[..bracket];
        return _byPath.TryGetValue(field, out Field? found) ? found.Allowed
            : _memberNames.TryGetValue(field, out List<string>? names) ? "{" + string.Join(", ", names) + "}"
            : null;
    }

    /// <summary>Reads and checks every field.</summary>
    /// <exception cref="RefusedException">A field is unknown, missing, given twice, of the wrong type or out of range.</exception>
    public FieldValues Read(JsonValue root)
    {
        var values = new FieldValues();
        ReadObject("", root, values);
        foreach (Field field in _fields)
        {
            if (field.Required && !values.Has(field))
            {
                throw new RefusedException(field.Path, "missing", field.Allowed);
            }
        }

        return values;
    }

    private void ReadObject(string path, JsonValue value, FieldValues values)
    {
        List<string> names = _memberNames[path];
        if (value.Kind != JsonKind.Object)
        {
            throw new RefusedException(path.Length > 0 ? path : "the scenario", value.ToString(), "an object {" + string.Join(", ", names) + "}");
        }

        var seen = new HashSet<string>();
        foreach ((string name, JsonValue member) in value.Members)
        {
            string memberPath = path.Length > 0 ? path + "." + name : name;
            if (!names.Contains(name))
            {
                throw Unknown(path, name, memberPath, member);
            }

            if (!seen.Add(name))
            {
                throw new RefusedException(memberPath, $"given twice (again as {member})", "once");
            }

            if (_byPath.TryGetValue(memberPath, out Field? field))
            {
                values.Set(field, field.Read(member));
            }
            else
            {
                ReadObject(memberPath, member, values);
            }
        }
    }

    private RefusedException Unknown(string parent, string name, string path, JsonValue value)
    {
        string? meant = Spelling.Closest(name, _memberNames[parent]);
        string? meantPath = meant is null ? ElsewhereNamed(name) : parent.Length > 0 ? parent + "." + meant : meant;
        string hint = meantPath is null ? "." : $"; did you mean {meantPath}?";
        string place = parent.Length > 0 ? "in " + parent : "at the top";
        return new RefusedException($"{Quote.Short(path)} is unknown (given {value}); allowed {place}: {string.Join(" | ", _memberNames[parent])}{hint}");
    }

    /// <summary>A field of exactly that name in another object: the user forgot, or mistook, what it belongs to.</summary>
    private string? ElsewhereNamed(string name) =>
        _fields.Find(field => field.Path == name || field.Path.EndsWith("." + name, StringComparison.OrdinalIgnoreCase))?.Path;

    private void AddMember(string path)
    {
        int dot = path.LastIndexOf('.');
        string parent = dot < 0 ? "" : path[..dot];
        if (!_memberNames.TryGetValue(parent, out List<string>? names))
        {
            names = [];
            _memberNames[parent] = names;
            AddMember(parent);
        }

        names.Add(path[(dot + 1)..]);
    }
}
