using System.Text;

namespace Football.Physics.Headless.Commands;

/// <summary>Where the command reads and writes: data to the output; what is meant for a person to where a person sees it.</summary>
internal sealed class Terminal
{
    public Terminal(Stream input, Stream output, TextWriter error, bool outputRedirected, bool errorRedirected)
    {
        Input = input;
        Output = output;
        Error = error;
        OutputRedirected = outputRedirected;
        ErrorRedirected = errorRedirected;
        Text = new StreamWriter(output, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false)) { AutoFlush = true, NewLine = "\n" };
        Person = outputRedirected ? error : Text;
    }

    public Stream Input { get; }

    /// <summary>Data.</summary>
    public Stream Output { get; }

    /// <summary>The output, as text.</summary>
    public TextWriter Text { get; }

    public TextWriter Error { get; }

    public bool OutputRedirected { get; }

    public bool ErrorRedirected { get; }

    /// <summary>Tables and hints.</summary>
    public TextWriter Person { get; }

    /// <summary>The process' own.</summary>
    public static Terminal OfProcess() => new(
        Console.OpenStandardInput(),
        Console.OpenStandardOutput(),
        Console.Error,
        Console.IsOutputRedirected,
        Console.IsErrorRedirected);
}
