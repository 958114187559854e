namespace Football.Physics.Headless.Json;

/// <summary>What is wrong with a text that is not JSON.</summary>
internal enum JsonFault
{
    /// <summary>There is none.</summary>
    Empty,

    /// <summary>It ends too early.</summary>
    CutOff,

    /// <summary>A number that JSON cannot hold: NaN or Infinity.</summary>
    NotFinite,

    /// <summary>Something else that is not JSON.</summary>
    NotJson,

    /// <summary>More follows after the value.</summary>
    MoreFollows,

    /// <summary>Objects and arrays inside each other, deeper than anything here needs.</summary>
    TooDeep,
}
