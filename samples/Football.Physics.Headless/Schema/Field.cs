using Football.Physics.Headless.Json;

namespace Football.Physics.Headless.Schema;

/// <summary>A field of the input: its path, and what is allowed there.</summary>
internal abstract class Field(string path, string allowed, bool required)
{
    /// <summary>Dotted path from the root of a scenario.</summary>
    public string Path { get; } = path;

    /// <summary>What is allowed, for a message.</summary>
    public string Allowed { get; } = allowed;

    /// <summary>Whether it must be given.</summary>
    public bool Required { get; } = required;

    /// <summary>The value where none is given.</summary>
    public abstract object? DefaultValue { get; }

    /// <summary>Reads the value.</summary>
    /// <exception cref="RefusedException">It is of the wrong type, or out of range.</exception>
    public abstract object? Read(JsonValue value);

    protected RefusedException Refuse(JsonValue value) => new(Path, value.ToString(), Allowed);
}
