using System.Text.Json;

namespace FootballPhysics.Tool.Commands;

/// <summary>Writes numbers that may be missing.</summary>
internal static class JsonNumbers
{
    /// <summary>Writes a number; null if there is none, or if it is infinite or not a number.</summary>
    public static void WriteFinite(this Utf8JsonWriter json, string name, double? number)
    {
        if (number is { } value && double.IsFinite(value))
        {
            json.WriteNumber(name, value);
        }
        else
        {
            json.WriteNull(name);
        }
    }
}
