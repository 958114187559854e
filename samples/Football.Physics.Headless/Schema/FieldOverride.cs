using System.Text;
using Football.Physics.Headless.Json;

namespace Football.Physics.Headless.Schema;

/// <summary>A value that takes the place of a field's in every scenario, whether the field was given or not.</summary>
internal sealed class FieldOverride
{
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
        return equals > 0 ? new FieldOverride(text[..equals].Trim().Split('.'), text[(equals + 1)..].Trim()) : null;
    }

    /// <summary>Puts the value in its place; objects on the way are made where they are missing.</summary>
    public void Apply(JsonValue root)
    {
        JsonValue at = root;
        for (int i = 0; i < _path.Length - 1; i++)
        {
            JsonValue? next = at.Find(_path[i]);
            if (next is null)
            {
                next = JsonValue.Object();
                Put(at, _path[i], next);
            }

            at = next;
        }

        Put(at, _path[^1], Value());
    }

    /// <summary>What is no object is left as it is: the check that follows names it.</summary>
    private static void Put(JsonValue parent, string name, JsonValue value)
    {
        if (parent.Kind == JsonKind.Object)
        {
            parent.Replace(name, value);
        }
    }

    /// <summary>JSON where the text is JSON, so that numbers and arrays need no quotes; otherwise the text itself.</summary>
    private JsonValue Value()
    {
        try
        {
            return JsonLoader.Load(Encoding.UTF8.GetBytes(_value));
        }
        catch (JsonFaultException)
        {
            return JsonValue.String(_value);
        }
    }
}
