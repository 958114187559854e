using System.Globalization;
using System.Text;
using System.Text.Json;
using System.Text.Unicode;

namespace Football.Physics.Headless.Json;

/// <summary>Reads JSON text into values; a text that is not JSON is reported with the field at which it goes wrong.</summary>
internal ref struct JsonLoader
{
    /// <summary>Levels of objects and arrays; a batch line needs four.</summary>
    private const int Deepest = 64;

    private readonly ReadOnlySpan<byte> _text;
    private readonly List<string> _path;
    private Utf8JsonReader _reader;
    private JsonValue? _root;
    private bool _complete;

    private JsonLoader(ReadOnlySpan<byte> text)
    {
        _text = text;
        _path = [];
        _reader = new Utf8JsonReader(text, new JsonReaderOptions { MaxDepth = Deepest + 2 });
    }

    /// <summary>Reads one value that is the whole text.</summary>
    /// <exception cref="JsonFaultException">The text is not JSON.</exception>
    public static JsonValue Load(ReadOnlySpan<byte> text)
    {
        var loader = new JsonLoader(text);
        if (!Utf8.IsValid(text))
        {
            throw loader.Fault(JsonFault.NotJson, "", "bytes that are not UTF-8", InvalidAt(text));
        }

        try
        {
            loader.Next();
            JsonValue value = loader.Value();
            loader._complete = true;
            loader.Next();
            return value;
        }
        catch (JsonException)
        {
            throw loader.Diagnose();
        }
        catch (InvalidOperationException)
        {
            // An escape sequence of half a character.
            throw loader.FaultHere(JsonFault.NotJson);
        }
    }

    private static int InvalidAt(ReadOnlySpan<byte> text)
    {
        int at = 0;
        while (Rune.DecodeFromUtf8(text[at..], out _, out int length) == System.Buffers.OperationStatus.Done)
        {
            at += length;
        }

        return at;
    }

    private static string Join(List<string> path)
    {
        var text = new StringBuilder();
        foreach (string part in path)
        {
            if (text.Length > 0 && !part.StartsWith('['))
            {
                text.Append('.');
            }

            text.Append(part);
        }

        return text.ToString();
    }

    /// <summary>The next token; the reader throws where there should be one and is none.</summary>
    private void Next() => _reader.Read();

    private JsonValue Value()
    {
        if (_path.Count >= Deepest)
        {
            throw FaultHere(JsonFault.TooDeep);
        }

        switch (_reader.TokenType)
        {
            case JsonTokenType.StartObject:
                JsonValue made = JsonValue.Object();
                _root ??= made;
                for (Next(); _reader.TokenType != JsonTokenType.EndObject; Next())
                {
                    string name = _reader.GetString()!;
                    _path.Add(name);
                    Next();
                    made.Members.Add(new JsonMember(name, Value()));
                    _path.RemoveAt(_path.Count - 1);
                }

                return made;
            case JsonTokenType.StartArray:
                JsonValue array = JsonValue.Array();
                _root ??= array;
                _path.Add("[0]");
                for (Next(); _reader.TokenType != JsonTokenType.EndArray; Next())
                {
                    array.Items.Add(Value());
                    _path[^1] = $"[{array.Items.Count.ToString(CultureInfo.InvariantCulture)}]";
                }

                _path.RemoveAt(_path.Count - 1);
                return array;
            case JsonTokenType.String:
                return JsonValue.String(_reader.GetString()!);
            case JsonTokenType.Number:
                return JsonValue.Number(Encoding.UTF8.GetString(_reader.ValueSpan));
            case JsonTokenType.Null:
                return JsonValue.Null();
            default:
                return JsonValue.Boolean(_reader.TokenType == JsonTokenType.True);
        }
    }

    /// <summary>What stopped the reader.</summary>
    private readonly JsonFaultException Diagnose()
    {
        int at = (int)_reader.BytesConsumed;
        while (at < _text.Length && _text[at] is (byte)' ' or (byte)'\t' or (byte)'\r' or (byte)'\n' or (byte)',' or (byte)':')
        {
            at++;
        }

        if (!_complete && (at >= _text.Length || OnlyEndsEarly()))
        {
            bool blank = _text.IndexOfAnyExcept(" \t\r\n"u8) < 0;
            return Fault(blank ? JsonFault.Empty : JsonFault.CutOff, Join(_path), "", _text.Length);
        }

        int end = at + 1;
        while (end < _text.Length && end - at < 4 * Quote.Longest && !IsDelimiter(_text[end]))
        {
            end++;
        }

        string token = Encoding.UTF8.GetString(_text[at..end]);
        string bare = token.TrimStart('-', '+');
        bool notFinite = bare.StartsWith("nan", StringComparison.OrdinalIgnoreCase) || bare.StartsWith("inf", StringComparison.OrdinalIgnoreCase)
            || bare.StartsWith("1.#", StringComparison.Ordinal);
        return Fault(_complete ? JsonFault.MoreFollows : notFinite ? JsonFault.NotFinite : JsonFault.NotJson, Join(_path), token, at);
    }

    /// <summary>Whether the text is the beginning of JSON.</summary>
    private readonly bool OnlyEndsEarly()
    {
        var reader = new Utf8JsonReader(_text, isFinalBlock: false, new JsonReaderState(new JsonReaderOptions { MaxDepth = Deepest + 2 }));
        try
        {
            while (reader.Read())
            {
            }

            return true;
        }
        catch (JsonException)
        {
            return false;
        }
    }

    private static bool IsDelimiter(byte b) => b is (byte)',' or (byte)']' or (byte)'}' or (byte)':' or (byte)' ' or (byte)'\t' or (byte)'\r' or (byte)'\n';

    private readonly JsonFaultException FaultHere(JsonFault fault)
    {
        int at = (int)_reader.TokenStartIndex;
        return Fault(fault, Join(_path), Encoding.UTF8.GetString(_text[at..Math.Min(_text.Length, at + (2 * Quote.Longest))]), at);
    }

    private readonly JsonFaultException Fault(JsonFault fault, string path, string token, int at) =>
        new(fault, path, Quote.Short(token), at + 1, _root);
}
