using System.Buffers;

namespace Football.Physics.Headless.Input;

/// <summary>Reads lines, or a whole text, from a stream; of a long one only the beginning is kept.</summary>
internal sealed class LineReader(Stream input)
{
    private readonly byte[] _chunk = new byte[64 * 1024];
    private int _start;
    private int _end;
    private bool _begun;

    /// <summary>The next line without its end, or null at the end of the input.</summary>
    public InputLine? ReadLine() => Read(wholeText: false);

    /// <summary>Everything that is left.</summary>
    public InputLine ReadToEnd() => Read(wholeText: true) ?? new InputLine([], 0);

    private InputLine? Read(bool wholeText)
    {
        var kept = new ArrayBufferWriter<byte>(512);
        long length = 0;
        bool any = false;
        while (Fill())
        {
            any = true;
            ReadOnlySpan<byte> rest = _chunk.AsSpan(_start, _end - _start);
            int newline = wholeText ? -1 : rest.IndexOf((byte)'\n');
            ReadOnlySpan<byte> part = newline < 0 ? rest : rest[..newline];
            length += part.Length;
            kept.Write(part[..Math.Min(part.Length, InputCase.LongestInput - kept.WrittenCount)]);
            _start += part.Length;
            if (newline >= 0)
            {
                _start++;
                break;
            }
        }

        return any ? new InputLine(kept.WrittenSpan.ToArray(), length) : null;
    }

    private bool Fill()
    {
        if (_start < _end)
        {
            return true;
        }

        _start = 0;
        _end = input.Read(_chunk);
        if (!_begun)
        {
            SkipByteOrderMark();
        }

        return _start < _end;
    }

    private void SkipByteOrderMark()
    {
        _begun = true;
        while (_end is 1 or 2)
        {
            int more = input.Read(_chunk.AsSpan(_end));
            if (more == 0)
            {
                break;
            }

            _end += more;
        }

        if (_chunk.AsSpan(0, _end).StartsWith("\uFEFF"u8))
        {
            _start = 3;
        }
    }
}
