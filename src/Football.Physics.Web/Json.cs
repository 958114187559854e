using System.Buffers;
using System.Text;
using System.Text.Json;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Web;

/// <summary>Writes JSON for JavaScript, and parses its requests.</summary>
internal static class Json
{
    /// <summary>Writes an object.</summary>
    public static string Text(Action<Utf8JsonWriter> members)
    {
        var buffer = new ArrayBufferWriter<byte>();
        using (var json = new Utf8JsonWriter(buffer))
        {
            json.WriteStartObject();
            members(json);
            json.WriteEndObject();
        }

        return Encoding.UTF8.GetString(buffer.WrittenSpan);
    }

    /// <summary>Writes a list of texts.</summary>
    public static void Write(Utf8JsonWriter json, string name, IEnumerable<string> texts)
    {
        json.WriteStartArray(name);
        foreach (string text in texts)
        {
            json.WriteStringValue(text);
        }

        json.WriteEndArray();
    }

    /// <summary>Writes a number; null if it is not finite.</summary>
    public static void Write(Utf8JsonWriter json, string name, double number)
    {
        if (double.IsFinite(number))
        {
            json.WriteNumber(name, number);
        }
        else
        {
            json.WriteNull(name);
        }
    }

    /// <summary>Writes a vector.</summary>
    public static void Write(Utf8JsonWriter json, string name, Vector3d v)
    {
        json.WriteStartArray(name);
        json.WriteNumberValue(v.X);
        json.WriteNumberValue(v.Y);
        json.WriteNumberValue(v.Z);
        json.WriteEndArray();
    }

    /// <summary>Returns the name of a value in camel case.</summary>
    public static string Word<T>(T value)
        where T : struct, Enum => JsonNamingPolicy.CamelCase.ConvertName(value.ToString());

    /// <summary>Parses a request.</summary>
    /// <exception cref="RefusedException">The text is not JSON.</exception>
    public static InputFields Fields(ReadOnlySpan<byte> text)
    {
        if (text.Length > LineReader.LongestInput)
        {
            throw new RefusedException("the input", FormattableString.Invariant($"{text.Length} bytes"), FormattableString.Invariant($"at most {LineReader.LongestInput} bytes"));
        }

        JsonFault? fault = JsonText.Parse(text, out JsonElement root);
        return fault is null ? new InputFields(root) : throw new RefusedException(fault.Path.Length > 0 ? fault.Path : "the input", fault.Value, fault.Expected);
    }
}
