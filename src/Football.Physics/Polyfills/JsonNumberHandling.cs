namespace System.Text.Json.Serialization;

/// <summary>Stands in for the enumeration of newer targets, which have a JSON serializer of their own.</summary>
[Flags]
internal enum JsonNumberHandling
{
    /// <summary>Numbers are numbers.</summary>
    Strict = 0,

    /// <summary>Infinities and NaN are their names.</summary>
    AllowNamedFloatingPointLiterals = 4,
}
