using System.Text;
using System.Xml.Linq;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Commands;

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

    /// <summary>Opens the file; null if no path is given.</summary>
    /// <param name="option">The name of the option, for error messages.</param>
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
            throw new RefusedException($"{option} {Quote.File(path)} cannot be written. Pass a file that can be written.");
        }
    }

    /// <summary>Refuses outputs of which two go to one file, or one to a file that is read.</summary>
    /// <param name="inputs">The paths of the input files; - is standard input.</param>
    /// <param name="outputs">The option and the path of each output; the path is null if not given.</param>
    /// <exception cref="RefusedException">Two are the same file.</exception>
    public static void RefuseSame(IEnumerable<string> inputs, params IReadOnlyList<(string Option, string? Path)> outputs)
    {
        var taken = inputs.Where(path => path != "-").Select(path => (By: "the input", File: FileIdentity.Of(path))).ToList();
        foreach ((string option, string path) in outputs.Where(output => output.Path is not null).Select(output => (output.Option, output.Path!)))
        {
            // Several outputs can go to one device.
            if (FileIdentity.Of(path) is { } file && !System.IO.Path.GetFullPath(path).StartsWith("/dev/", StringComparison.Ordinal))
            {
                if (taken.FirstOrDefault(other => other.File == file) is { By: { } by })
                {
                    throw new RefusedException($"{option} {Quote.File(path)} is also the file of {by}. Pass another file.");
                }

                taken.Add((option, file));
            }
        }
    }

    /// <summary>Refuses files that would be written over the one that is read.</summary>
    /// <param name="input">The path of the input; - is standard input.</param>
    /// <param name="outputs">The option and the path of each file. One option can write several files in turn.</param>
    /// <exception cref="RefusedException">One of them is the input.</exception>
    public static void RefuseSameAs(string input, IReadOnlyList<(string Option, string Path)> outputs)
    {
        foreach ((string option, string path) in outputs)
        {
            RefuseSame([input], (option, path));
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
