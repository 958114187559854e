using System.Text;
using System.Xml.Linq;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Commands;

/// <summary>An output file. It is opened before the computation, so that an error appears at once.</summary>
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
    /// <param name="path">The path of the file.</param>
    /// <exception cref="RefusedException">The file cannot be written.</exception>
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

    /// <summary>Throws if two outputs are the same file, or an output is also an input.</summary>
    /// <param name="inputs">The paths of the input files; - is standard input.</param>
    /// <param name="outputs">The option and the path of each output; the path is null if not given.</param>
    /// <exception cref="RefusedException">Two paths refer to the same file.</exception>
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

    /// <summary>Throws if an output would overwrite the input.</summary>
    /// <param name="input">The path of the input; - is standard input.</param>
    /// <param name="outputs">The option and the path of each file. One option can write several files in turn.</param>
    /// <exception cref="RefusedException">An output is the input.</exception>
    public static void RefuseSameAs(string input, IReadOnlyList<(string Option, string Path)> outputs)
    {
        foreach ((string option, string path) in outputs)
        {
            RefuseSame([input], (option, path));
        }
    }

    /// <summary>True if the exception is about the name or the permissions of a file.</summary>
    public static bool IsFileFault(Exception e) => e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException;

    /// <summary>Replaces the content of the file.</summary>
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
