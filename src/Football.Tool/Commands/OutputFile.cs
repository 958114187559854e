using System.Text;
using System.Xml.Linq;
using Football.Scenarios.Input;

namespace Football.Tool.Commands;

/// <summary>A file that is opened before the work that fills it, so that nobody waits for nothing.</summary>
internal sealed class OutputFile : IDisposable
{
    private readonly FileStream _stream;

    private OutputFile(FileStream stream, string path)
    {
        _stream = stream;
        Path = path;
    }

    public string Path { get; }

    /// <summary>Opens it; null where none was asked for.</summary>
    /// <param name="option">Who asks, for a message.</param>
    /// <param name="path">Its name.</param>
    /// <exception cref="RefusedException">It cannot be written.</exception>
    public static OutputFile? Open(string option, string? path)
    {
        if (path is null)
        {
            return null;
        }

        try
        {
            return new OutputFile(new FileStream(path, FileMode.OpenOrCreate, FileAccess.Write, FileShare.ReadWrite), path);
        }
        catch (Exception e) when (IsFileFault(e))
        {
            throw new RefusedException(option, $"{Quote.File(path)}, which cannot be written", "a file that can be written");
        }
    }

    /// <summary>Whether the exception is about the name or the rights of a file.</summary>
    public static bool IsFileFault(Exception e) => e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException;

    /// <summary>Writes all of it.</summary>
    public void Write(ReadOnlySpan<byte> content)
    {
        if (_stream.CanSeek)
        {
            _stream.SetLength(0);
        }

        _stream.Write(content);
        _stream.Flush();
    }

    public void Write(string content) => Write(Encoding.UTF8.GetBytes(content));

    public void Write(XElement drawing) => Write(drawing.ToString(SaveOptions.DisableFormatting) + "\n");

    public void Dispose() => _stream.Dispose();
}
