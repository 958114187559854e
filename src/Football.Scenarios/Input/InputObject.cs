using System.Text.Json;
using FootballPhysics.Scenes;

namespace FootballPhysics.Scenarios.Input;

/// <summary>An object of the input. Code reads its members one by one, each with its default.</summary>
/// <remarks>
/// Members that are never read are unknown. Errors are recorded and reported by <see cref="InputFields.Check"/>. A value that is not a number becomes
/// NaN, which the range check rejects.
/// </remarks>
/// <param name="fields">All fields of the input.</param>
/// <param name="path">The path of the object.</param>
/// <param name="element">The object; null if it is not given or not an object.</param>
public sealed class InputObject(InputFields fields, string path, JsonElement? element)
{
    private const string FiniteNumber = "a finite number";

    private readonly List<string> _known = fields.NamesIn(path);

    /// <summary>Returns a member that is an object; an empty one if it is missing.</summary>
    public InputObject Object(string name) => new(fields, Join(name), Take(name) is { ValueKind: JsonValueKind.Object } member ? member : null);

    /// <summary>Returns a number.</summary>
    public double Number(string name, double fallback) => Take(name) is { } value ? NumberOf(value) : fallback;

    /// <summary>Returns a required number.</summary>
    public double Number(string name) => Take(name) is { } value ? NumberOf(value) : Refuse(name, FiniteNumber, double.NaN);

    /// <summary>Returns a number; infinity if it is null.</summary>
    public double Limit(string name, double fallback) => Take(name) is not { } value ? fallback
        : value.ValueKind == JsonValueKind.Null ? double.PositiveInfinity
        : NumberOf(value);

    /// <summary>Returns a string.</summary>
    public string Text(string name, string fallback) => Take(name) is not { } value ? fallback
        : value.ValueKind == JsonValueKind.String ? value.GetString()!
        : Refuse(name, "a text", fallback);

    /// <summary>Returns a string that must be one of the allowed ones.</summary>
    public string OneOf(string name, params string[] allowed) =>
        Take(name) is { ValueKind: JsonValueKind.String } value && allowed.Contains(value.GetString()) ? value.GetString()!
        : Refuse(name, string.Join(" | ", allowed), allowed[0]);

    /// <summary>Returns the strings of a list; null if it is missing.</summary>
    public string[]? Texts(string name) => Take(name) is not { } value ? null
        : value.ValueKind == JsonValueKind.Array && value.EnumerateArray().All(item => item.ValueKind == JsonValueKind.String)
            ? [.. value.EnumerateArray().Select(item => item.GetString()!)]
        : Refuse<string[]?>(name, "a list of texts", null);

    /// <summary>Returns the objects of a list; empty if it is missing.</summary>
    public IReadOnlyList<InputObject> Objects(string name)
    {
        if (Take(name) is not { } value)
        {
            return [];
        }

        return value.ValueKind == JsonValueKind.Array
            ? [.. value.EnumerateArray().Select((item, i) => fields.Item($"{Join(name)}[{i}]", item))]
            : Refuse<IReadOnlyList<InputObject>>(name, "a list of objects", []);
    }

    /// <summary>Returns a table of numbers with rows of equal length; null if it is missing or invalid.</summary>
    public double[,]? Table(string name)
    {
        const string Allowed = "a table [[…], …] of finite numbers, with rows of one length";
        if (Take(name) is not { ValueKind: JsonValueKind.Array } value
            || value.GetArrayLength() == 0 || value[0] is not { ValueKind: JsonValueKind.Array } first || first.GetArrayLength() is not (> 0 and int columns)
            || !value.EnumerateArray().All(row => row.ValueKind == JsonValueKind.Array && row.GetArrayLength() == columns))
        {
            return Refuse<double[,]?>(name, Allowed, null);
        }

        // Enumerate the rows: access by index searches from the first element each time.
        var table = new double[value.GetArrayLength(), columns];
        int i = 0;
        foreach (JsonElement row in value.EnumerateArray())
        {
            int j = 0;
            foreach (JsonElement number in row.EnumerateArray())
            {
                table[i, j] = NumberOf(number);
                if (!double.IsFinite(table[i, j]))
                {
                    return Refuse<double[,]?>($"{name}[{i}][{j}]", FiniteNumber, null);
                }

                j++;
            }

            i++;
        }

        return table;
    }

    /// <summary>Returns a number above 0.</summary>
    public double Positive(string name, double fallback)
    {
        double number = Number(name, fallback);
        return number > 0 && double.IsFinite(number) ? number : Refuse(name, $"{FiniteNumber} above 0", fallback);
    }

    /// <summary>Returns a whole number.</summary>
    public int Whole(string name, int fallback) => Take(name) is not { } value ? fallback
        : NumberOf(value) is var number && number == Math.Floor(number) && Math.Abs(number) <= int.MaxValue ? (int)number
        : Refuse(name, $"a whole number, at most {int.MaxValue}", fallback);

    /// <summary>Returns a whole number of 64 bits.</summary>
    public long Seed(string name, long fallback) => Take(name) is not { } value ? fallback
        : value.ValueKind == JsonValueKind.Number && value.TryGetInt64(out long number) ? number
        : Refuse(name, $"a whole number, {long.MinValue} … {long.MaxValue}", fallback);

    /// <summary>Returns a list of layers, 0 … 31; empty if it is missing.</summary>
    public int[] Layers(string name)
    {
        if (Take(name) is not { } value)
        {
            return [];
        }

        double[] layers = value.ValueKind == JsonValueKind.Array ? [.. value.EnumerateArray().Select(NumberOf)] : [double.NaN];
        return layers.All(layer => layer == Math.Floor(layer) && layer is >= 0 and <= FootballPhysics.Layers.Highest)
            ? Array.ConvertAll(layers, layer => (int)layer)
            : Refuse<int[]>(name, $"a list of layers, whole numbers 0 … {FootballPhysics.Layers.Highest}", []);
    }

    /// <summary>Returns a 64-bit whole number, or null.</summary>
    public long? OptionalWhole(string name, long? fallback = null) => Take(name) is not { } value ? fallback
        : value.ValueKind == JsonValueKind.Null ? null
        : value.ValueKind == JsonValueKind.Number && value.TryGetInt64(out long number) ? number
        : Refuse<long?>(name, $"a whole number, {long.MinValue} … {long.MaxValue}, or null", fallback);

    /// <summary>Returns a number above 0; null if it is missing.</summary>
    public double? OptionalPositive(string name) => Has(name) ? Positive(name, 1) : null;

    /// <summary>Returns true or false.</summary>
    public bool Flag(string name, bool fallback) => Take(name) is not { } value ? fallback
        : value.ValueKind is JsonValueKind.True or JsonValueKind.False ? value.GetBoolean()
        : Refuse(name, "true | false", fallback);

    /// <summary>Returns a member of an enumeration, written in camel case.</summary>
    public T Choice<T>(string name, T fallback)
        where T : struct, Enum
    {
        if (Take(name) is not { } value)
        {
            return fallback;
        }

        T[] values = Enum.GetValues<T>();
        int found = value.ValueKind == JsonValueKind.String ? Array.FindIndex(values, item => value.ValueEquals(Words.Of(item))) : -1;
        return found >= 0 ? values[found] : Refuse(name, string.Join(" | ", values.Select(Words.Of)), fallback);
    }

    /// <summary>Returns the name of one of several presets.</summary>
    /// <param name="name">The member.</param>
    /// <param name="presets">The presets.</param>
    /// <param name="fallback">The name of the default.</param>
    public string Preset<T>(string name, IReadOnlyDictionary<string, T> presets, string fallback) =>
        Take(name) is not { } value ? fallback
        : value.ValueKind == JsonValueKind.String && presets.ContainsKey(value.GetString()!) ? value.GetString()!
        : Refuse(name, string.Join(" | ", presets.Keys), fallback);

    /// <summary>Returns a part of the scene with all its numbers; missing ones have the default's values.</summary>
    internal T Numbers<T>(NumberField<T>[] numbers, T defaults)
    {
        foreach (NumberField<T> field in numbers)
        {
            double value = field.Get(defaults);
            double given = double.IsPositiveInfinity(field.Most) ? Limit(field.Name, value) : Number(field.Name, value);
            defaults = given.Equals(value) ? defaults : field.With(defaults, given);
        }

        return defaults;
    }

    /// <summary>Returns three numbers.</summary>
    public Vector3d Vector(string name, Vector3d fallback)
    {
        double[] v = Numbers(name, "[x, y, z]", [fallback.X, fallback.Y, fallback.Z]);
        return new Vector3d(v[0], v[1], v[2]);
    }

    /// <summary>Returns three required numbers.</summary>
    public Vector3d Vector(string name) => Has(name) ? Vector(name, Vector3d.Zero) : Refuse(name, "[x, y, z], 3 finite numbers", Vector3d.Zero);

    /// <summary>Returns three numbers, or null.</summary>
    public Vector3d? OptionalVector(string name) => Take(name) is { ValueKind: not JsonValueKind.Null } ? Vector(name, Vector3d.Zero) : null;

    /// <summary>Returns a required list of finite numbers of the given length.</summary>
    public double[] Numbers(string name, string form, int count) =>
        Has(name) ? Numbers(name, form, new double[count]) : Refuse(name, $"{form}, {count} finite numbers", new double[count]);

    /// <summary>Returns a list of finite numbers with the length of the default.</summary>
    /// <param name="name">The member.</param>
    /// <param name="form">The form of the list, such as [x, y, z].</param>
    /// <param name="fallback">The default.</param>
    public double[] Numbers(string name, string form, double[] fallback)
    {
        if (Take(name) is not { } value)
        {
            return fallback;
        }

        string allowed = $"{form}, {fallback.Length} finite numbers";
        if (value.ValueKind != JsonValueKind.Array || value.GetArrayLength() != fallback.Length)
        {
            return Refuse(name, allowed, fallback);
        }

        double[] numbers = [.. value.EnumerateArray().Select(NumberOf)];
        int wrong = Array.FindIndex(numbers, number => !double.IsFinite(number));
        return wrong < 0 ? numbers : Refuse($"{name}[{wrong}]", $"{FiniteNumber} ({Join(name)}: {allowed})", fallback);
    }

    /// <summary>Returns two numbers. A single number counts for both.</summary>
    public double[] OneOrTwo(string name, string form, double[] fallback) =>
        Take(name) is { ValueKind: JsonValueKind.Number } value ? [NumberOf(value), NumberOf(value)] : Numbers(name, form, fallback);

    /// <summary>Returns a number in a range.</summary>
    public double Within(string name, double fallback, NumberRange allowed)
    {
        double number = Number(name, fallback);
        return allowed.Contains(number) ? number : Refuse(name, allowed.ToString(), fallback);
    }

    /// <summary>Returns a list of ascending numbers from 0; empty if it is missing.</summary>
    public IReadOnlyList<double> Ascending(string name)
    {
        if (Take(name) is not { } value)
        {
            return [];
        }

        double[] numbers = value.ValueKind == JsonValueKind.Array ? [.. value.EnumerateArray().Select(NumberOf)] : [double.NaN];
        bool ascends = numbers.All(number => double.IsFinite(number) && number >= 0) && numbers.Zip(numbers.Skip(1)).All(pair => pair.First < pair.Second);
        return ascends ? numbers : Refuse<IReadOnlyList<double>>(name, "a list of finite numbers from 0 on, each above the one before", []);
    }

    /// <summary>Creates an object of the library from members of this object. If the library rejects them, it returns null and records the error.</summary>
    public T? Make<T>(Func<T> make)
        where T : class
    {
        try
        {
            return make();
        }
        catch (ArgumentException e)
        {
            fields.Refuse(LibraryRefusal.Of(e, fields, path) ?? new RefusedException($"{path}: {e.Message}"));
            return null;
        }
    }

    /// <summary>True if the member is given.</summary>
    public bool Has(string name) => Take(name) is not null;

    /// <summary>True if the member is an object.</summary>
    public bool IsObject(string name) => Take(name) is { ValueKind: JsonValueKind.Object };

    /// <summary>True if the member is a list.</summary>
    public bool IsArray(string name) => Take(name) is { ValueKind: JsonValueKind.Array };

    /// <summary>Rejects a member if another one that excludes it is given.</summary>
    public void Exclude(string name, string other)
    {
        if (Has(name) && Has(other))
        {
            Refuse(name, $"{name} or {other}, not both", 0);
        }
    }

    /// <summary>Rejects a member unless a condition holds.</summary>
    public void Demand(string name, bool holds, string allowed)
    {
        if (!holds)
        {
            Refuse(name, allowed, 0);
        }
    }

    private static double NumberOf(JsonElement value) =>
        value.ValueKind == JsonValueKind.Number && value.TryGetDouble(out double number) ? number : double.NaN;

    private string Join(string name) => path.Length > 0 ? $"{path}.{name}" : name;

    private JsonElement? Take(string name)
    {
        if (!_known.Contains(name))
        {
            _known.Add(name);
        }

        return element is { } from && from.TryGetProperty(name, out JsonElement member) ? member : null;
    }

    private T Refuse<T>(string name, string allowed, T instead)
    {
        string at = Join(name);
        fields.Refuse(new RefusedException(at, fields.Text(at) ?? "missing", allowed));
        return instead;
    }
}
