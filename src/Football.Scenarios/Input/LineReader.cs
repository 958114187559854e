using System.Buffers;

namespace FootballPhysics.Scenarios.Input;

/// <summary>Reads lines, or a complete text, from a stream. It keeps only the beginning of a long line or text.</summary>
public sealed class LineReader(Stream input)
{
    /// <summary>The maximum size of one object, in bytes: far more than a scenario needs, and small enough for memory.</summary>
    public const int LongestInput = 1 << 20;

    /// <summary>The maximum length of a line, in bytes. A longer line counts as endless.</summary>
    private const int LongestLine = 1 << 26;

    private readonly byte[] _chunk = new byte[64 * 1024];
    private int _start;
    private int _end;

    /// <summary>The number of bytes read so far.</summary>
    public long BytesRead { get; private set; }

    /// <summary>Returns the next line without its line break; null at the end of the input.</summary>
    /// <exception cref="RefusedException">The line exceeds the maximum length.</exception>
    public InputLine? ReadLine() => Read(wholeText: false);

    /// <summary>Returns the rest of the input, truncated after <see cref="LongestInput"/> bytes.</summary>
    public InputLine ReadToEnd() => Read(wholeText: true) ?? new InputLine([], false);

    private InputLine? Read(bool wholeText)
    {
        var kept = new ArrayBufferWriter<byte>(512);
        long length = 0;
        bool ended = false;
        bool any = false;
        while (!ended && (!wholeText || length <= LongestInput) && Fill())
        {
            any = true;
            ReadOnlySpan<byte> rest = _chunk.AsSpan(_start, _end - _start);
            int newline = wholeText ? -1 : rest.IndexOf((byte)'\n');
            ended = newline >= 0;
            ReadOnlySpan<byte> part = ended ? rest[..newline] : rest;
            length += part.Length;
            kept.Write(part[..Math.Min(part.Length, LongestInput - kept.WrittenCount)]);
            _start += part.Length + (ended ? 1 : 0);
            if (length > LongestLine)
            {
                throw new RefusedException("the input", $"a line of more than {LongestLine} bytes", $"one object per line, at most {LongestInput} bytes each");
            }
        }

        return any ? new InputLine(kept.WrittenSpan.ToArray(), length > LongestInput) : null;
    }

    private bool Fill()
    {
        if (_start < _end)
        {
            return true;
        }

        bool first = BytesRead == 0;
        _start = 0;
        _end = input.Read(_chunk);

        // A byte order mark may arrive in parts, or alone: read on until the text after it is there.
        while (first && _end is > 0 and <= 3 && "\uFEFF"u8.StartsWith(_chunk.AsSpan(0, _end)) && input.Read(_chunk.AsSpan(_end)) is > 0 and int more)
        {
            _end += more;
        }

        BytesRead += _end;
        _start = first && _chunk.AsSpan(0, _end).StartsWith("\uFEFF"u8) ? 3 : 0;
        return _start < _end;
    }
}
