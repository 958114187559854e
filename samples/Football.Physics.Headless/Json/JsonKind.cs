namespace Football.Physics.Headless.Json;

/// <summary>What a JSON value is.</summary>
internal enum JsonKind
{
    /// <summary>{…}</summary>
    Object,

    /// <summary>[…]</summary>
    Array,

    /// <summary>"…"</summary>
    String,

    /// <summary>A number.</summary>
    Number,

    /// <summary>true or false.</summary>
    Boolean,

    /// <summary>null</summary>
    Null,
}
