using System.Text.Json;
using System.Text.Unicode;

namespace FootballPhysics.Scenarios.Input;

/// <summary>JSON read strictly: no comments, no trailing commas, no member twice, no depth without end.</summary>
public static class JsonText
{
    /// <summary>Levels of objects and arrays; a batch line needs six.</summary>
    public const int Deepest = 64;

    private static readonly JsonDocumentOptions Strict = new() { AllowDuplicateProperties = false, MaxDepth = Deepest };

    /// <summary>Reads the value that is the whole text.</summary>
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

        // Invalid UTF-8 and escapes of half a character do not stop the parser, only later reads of the string.
        return Utf8.IsValid(text) && text.IndexOf("\\u"u8) < 0 ? null : JsonFault.Find(text);
    }
}
