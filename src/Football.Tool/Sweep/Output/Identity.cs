using System.Text.Json;

namespace FootballPhysics.Tool.Sweep.Output;

/// <summary>The parameters that determine the bytes of a data set. Shards that differ in them do not belong together.</summary>
/// <param name="Program">The program and its version.</param>
/// <param name="Format">The file format.</param>
/// <param name="Seed">The seed.</param>
/// <param name="Count">The number of rows of the complete sweep.</param>
/// <param name="Sweep">The input of the sweep, on one line.</param>
internal sealed record Identity(string Program, string Format, long Seed, long Count, string Sweep)
{
    public static Identity Read(JsonElement from) => new(
        from.GetProperty("program").GetString()!,
        from.GetProperty("format").GetString()!,
        from.GetProperty("seed").GetInt64(),
        from.GetProperty("count").GetInt64(),
        JsonSerializer.Serialize(from.GetProperty("sweep")));

    public void WriteTo(Utf8JsonWriter json)
    {
        json.WriteString("program", Program);
        json.WriteString("format", Format);
        json.WriteNumber("seed", Seed);
        json.WriteNumber("count", Count);
        json.WritePropertyName("sweep");
        json.WriteRawValue(Sweep);
    }

    /// <summary>Describes the first difference from another identity; null if they are equal.</summary>
    public string? Difference(Identity other) =>
        Program != other.Program ? $"its program is {other.Program}, not {Program}"
        : Format != other.Format ? $"its format is {other.Format}, not {Format}"
        : Seed != other.Seed ? FormattableString.Invariant($"its seed is {other.Seed}, not {Seed}")
        : Count != other.Count ? FormattableString.Invariant($"its count is {other.Count}, not {Count}")
        : Sweep != other.Sweep ? "its scene, ranges or rows are others"
        : null;
}
