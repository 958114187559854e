namespace System.Text.Json.Serialization;

/// <summary>Replaces the enumeration of newer targets, which include a JSON serializer.</summary>
[Flags]
internal enum JsonNumberHandling
{
    /// <summary>Numbers are written as JSON numbers.</summary>
    Strict = 0,

    /// <summary>Infinities and NaN are written by name.</summary>
    AllowNamedFloatingPointLiterals = 4,
}
