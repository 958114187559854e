namespace Football.Physics.Headless.Schema;

/// <summary>The values of all fields of a schema, checked, defaults filled in.</summary>
internal sealed class FieldValues
{
    private readonly Dictionary<Field, object?> _values = [];

    public T Get<T>(Field<T> field) => (T)(_values.TryGetValue(field, out object? value) ? value : field.DefaultValue)!;

    /// <summary>Whether the field was given.</summary>
    public bool Has(Field field) => _values.ContainsKey(field);

    public void Set(Field field, object? value) => _values[field] = value;
}
