using System.Text.Json;
using System.Text.Unicode;

namespace FootballPhysics.Scenarios.Input;

/// <summary>Parses strict JSON: no comments, no trailing commas, no duplicate members, limited nesting.</summary>
public static class JsonText
{
    /// <summary>The maximum nesting of objects and arrays. A batch line needs six levels.</summary>
    public const int Deepest = 64;

    private static readonly JsonDocumentOptions Strict = new() { AllowDuplicateProperties = false, MaxDepth = Deepest };

    /// <summary>Parses a text that consists of one value.</summary>
    /// <returns>The error in the text; null if there is none.</returns>
    public static JsonFault? Parse(ReadOnlySpan<byte> text, out JsonElement root)
    {
        root = default;
        try
        {
            root = JsonElement.Parse(text, Strict);
        }
        catch (Exception e) when (e is JsonException or InvalidOperationException)
        {
            return JsonFault.Find(text) ?? new JsonFault("", "not JSON", JsonFault.Allowed, null);
        }

        // The parser accepts invalid UTF-8 and escapes of half a surrogate pair; only a later read of the string fails.
        return Utf8.IsValid(text) && text.IndexOf("\\u"u8) < 0 ? null : JsonFault.Find(text);
    }
}
