using Football.Physics.Headless.Json;

namespace Football.Physics.Headless.Schema;

/// <summary>A field whose value has a type.</summary>
internal abstract class Field<T>(string path, string allowed, T defaultValue, bool required = false) : Field(path, allowed, required)
{
    private readonly object? _defaultValue = defaultValue;

    /// <summary>The value where none is given.</summary>
    public T Default { get; } = defaultValue;

    public override object? DefaultValue => _defaultValue;

    public override object? Read(JsonValue value) => Parse(value);

    protected abstract T Parse(JsonValue value);
}
