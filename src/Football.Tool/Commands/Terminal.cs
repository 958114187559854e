using System.Text;
using Microsoft.Win32.SafeHandles;
using Spectre.Console;

namespace FootballPhysics.Tool.Commands;

/// <summary>The input and the outputs of a command. Data goes to the output. Tables and hints for people go to the terminal.</summary>
internal sealed class Terminal
{
    /// <summary>The width of a table that is not shown in a terminal, in columns: wide enough that no line breaks.</summary>
    private const int Unlimited = 1000;

    public Terminal(Stream input, Stream output, Stream error, bool outputRedirected, bool errorRedirected)
    {
        Input = input;
        Output = new StandardStream(output, carriesData: true);
        OutputRedirected = outputRedirected;
        ErrorRedirected = errorRedirected;
        Text = Writer(Output);
        StreamWriter errors = Writer(new StandardStream(error, carriesData: false));
        Error = new PersonWriter(errors);
        Person = outputRedirected ? Error : new PersonWriter(Text);
        ErrorConsole = Console(errors, errorRedirected);
        PersonConsole = outputRedirected ? ErrorConsole : Console(Text, redirected: false);
    }

    public Stream Input { get; }

    /// <summary>The output for data.</summary>
    public Stream Output { get; }

    /// <summary>The output for data, as text.</summary>
    public TextWriter Text { get; }

    public TextWriter Error { get; }

    public bool OutputRedirected { get; }

    public bool ErrorRedirected { get; }

    /// <summary>The output for tables and hints, as plain text.</summary>
    public TextWriter Person { get; }

    /// <summary>The output for tables and hints.</summary>
    public IAnsiConsole PersonConsole { get; }

    /// <summary>The output for the progress.</summary>
    public IAnsiConsole ErrorConsole { get; }

    /// <summary>Creates the terminal of this process.</summary>
    public static Terminal OfProcess() => new(
        Descriptor.IsInherited(0) ? Open(System.Console.OpenStandardInput) : Stream.Null,
        Descriptor.IsInherited(1) ? OpenOutput() : Closed(),
        Descriptor.IsInherited(2) ? Open(System.Console.OpenStandardError) : Stream.Null,
        System.Console.IsOutputRedirected,
        System.Console.IsErrorRedirected);

    /// <summary>Opens the standard output so that a closed pipe is reported: a console stream hides it, a file stream does not.</summary>
    /// <remarks>
    /// A file stream does not advance the offset that a file shares with the programs before and after this one. It is therefore used only for
    /// streams without an offset.
    /// </remarks>
    private static Stream OpenOutput()
    {
        if (System.Console.IsOutputRedirected && !OperatingSystem.IsWindows())
        {
            try
            {
                var pipe = new FileStream(new SafeFileHandle(1, ownsHandle: false), FileAccess.Write, bufferSize: 0);
                if (!pipe.CanSeek)
                {
                    return pipe;
                }
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
            {
                // Use the console stream instead.
            }
        }

        return Open(System.Console.OpenStandardOutput);
    }

    /// <summary>Returns an output without a reader: the first byte ends the run.</summary>
    private static MemoryStream Closed()
    {
        var stream = new MemoryStream();
        stream.Dispose();
        return stream;
    }

    private static Stream Open(Func<Stream> open)
    {
        try
        {
            return open();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return Stream.Null;
        }
    }

    private static StreamWriter Writer(Stream stream) =>
        new(stream, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false)) { AutoFlush = true, NewLine = "\n" };

    private static IAnsiConsole Console(TextWriter writer, bool redirected)
    {
        bool plain = redirected || Environment.GetEnvironmentVariable("TERM") == "dumb";
        IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = plain ? AnsiSupport.No : AnsiSupport.Yes,
            ColorSystem = plain ? ColorSystemSupport.NoColors : ColorSystemSupport.Standard,
            Interactive = plain ? InteractionSupport.No : InteractionSupport.Yes,
            Out = new AnsiConsoleOutput(writer),
        });
        if (redirected)
        {
            console.Profile.Width = Unlimited;
        }

        return console;
    }
}
