using System.Text.Json;

namespace FootballPhysics.Scenarios.Input;

/// <summary>The values of an enumeration as the formats write them.</summary>
public static class Words
{
    /// <summary>The word for a value: its name in camel case.</summary>
    public static string Of<T>(T value)
        where T : struct, Enum => JsonNamingPolicy.CamelCase.ConvertName(value.ToString());
}
