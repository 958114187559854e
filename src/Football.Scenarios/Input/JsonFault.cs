using System.Buffers;
using System.Globalization;
using System.Text;
using System.Text.Json;

namespace FootballPhysics.Scenarios.Input;

/// <summary>The error in a text that is not strict JSON.</summary>
/// <param name="Path">The path of the field with the error; empty for the root.</param>
/// <param name="Value">The text at the error, as shown in the message.</param>
/// <param name="Expected">The allowed text.</param>
/// <param name="Name">The member "name" of the root if it precedes the error; otherwise null.</param>
public sealed record JsonFault(string Path, string Value, string Expected, string? Name)
{
    /// <summary>The requirement for every part of an input.</summary>
    public const string Allowed = "strict JSON (finite numbers, no comments, no trailing commas)";

    private static readonly JsonReaderOptions Options = new() { MaxDepth = JsonText.Deepest };

    /// <summary>Finds the first error; null if there is none.</summary>
    public static JsonFault? Find(ReadOnlySpan<byte> text)
    {
        var place = new JsonPlace();
        if (InvalidAt(text) is { } invalid)
        {
            return place.Fault(string.Create(CultureInfo.InvariantCulture, $"not UTF-8 at byte {invalid + 1}"), "a JSON object in UTF-8");
        }

        // Not the final block: the reader then accepts a text that ends too early.
        var reader = new Utf8JsonReader(text, isFinalBlock: false, new JsonReaderState(Options));
        try
        {
            while (reader.Read())
            {
                if (place.Enter(ref reader) is { } twice)
                {
                    return twice;
                }
            }
        }
        catch (JsonException)
        {
            return Stopped(text, (int)reader.BytesConsumed, place);
        }
        catch (InvalidOperationException)
        {
            // An escape contains half a surrogate pair; the reader has already passed the string.
            return Stopped(text, (int)reader.TokenStartIndex, place);
        }

        return place.Ended ? null
            : text.IndexOfAnyExcept(" \t\r\n"u8) < 0 ? place.Fault("empty", "a JSON object")
            : place.Fault(string.Create(CultureInfo.InvariantCulture, $"cut off after byte {text.Length}"), Allowed);
    }

    private static JsonFault Stopped(ReadOnlySpan<byte> text, int at, JsonPlace place)
    {
        while (at < text.Length && " \t\r\n,:"u8.Contains(text[at]))
        {
            at++;
        }

        int end = at + 1;
        while (end < text.Length && !" \t\r\n,:]}"u8.Contains(text[end]))
        {
            end++;
        }

        string token = Quote.Short(Encoding.UTF8.GetString(text[Math.Min(at, text.Length)..Math.Min(end, text.Length)]));
        string where = string.Create(CultureInfo.InvariantCulture, $"byte {Math.Min(at, text.Length - 1) + 1}");
        string more = token.Length > 0 ? token : "a separator";
        return place.Ended ? place.Fault($"more than one value ({more} at {where})", "one JSON object; one a line with --batch")
            : place.Depth >= JsonText.Deepest ? place.Fault($"nested too deep ({where})", $"{JsonText.Deepest} levels at most")
            : place.Fault($"{token}, which is not JSON ({where})", Allowed);
    }

    private static int? InvalidAt(ReadOnlySpan<byte> text)
    {
        int at = 0;
        while (at < text.Length)
        {
            if (Rune.DecodeFromUtf8(text[at..], out _, out int length) != OperationStatus.Done)
            {
                return at;
            }

            at += length;
        }

        return null;
    }
}
