using System.CommandLine;
using System.Text;
using System.Text.Json;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Tool.Tests;

/// <summary>Runs the command in this process, with its input and outputs in memory.</summary>
internal sealed record FootballCommand(int ExitCode, string Output, string Error)
{
    /// <summary>A scenario as short as it can be, without its braces.</summary>
    public const string Launch = "\"launch\":{\"position\":[0,1,0],\"velocity\":[1,0,0]}";

    /// <summary>The laboratories, where a test has them at hand; null: the tool alone.</summary>
    public static Func<Terminal, Command>? Laboratories { get; set; }

    public IReadOnlyList<JsonElement> Lines => [.. Split(Output).Select(line => JsonDocument.Parse(line).RootElement)];

    public JsonElement Result => Assert.Single(Lines);

    public string ErrorLine => Assert.Single(Split(Error));

    public static FootballCommand Run(string input, params string[] args) => Run(Encoding.UTF8.GetBytes(input), args);

    public static FootballCommand Run(byte[] input, params string[] args)
    {
        using var output = new MemoryStream();
        return Run(new MemoryStream(input), output, redirected: true, args) with { Output = Encoding.UTF8.GetString(output.ToArray()) };
    }

    /// <summary>Runs it as in a terminal that shows both outputs.</summary>
    public static FootballCommand InTerminal(string input, params string[] args)
    {
        using var output = new MemoryStream();
        return Run(new MemoryStream(Encoding.UTF8.GetBytes(input)), output, redirected: false, args) with { Output = Encoding.UTF8.GetString(output.ToArray()) };
    }

    /// <summary>Runs it with streams of one's own; what it writes is the caller's to look at.</summary>
    public static FootballCommand Run(Stream input, Stream output, bool redirected, params string[] args)
    {
        using var error = new MemoryStream();
        int exitCode = CommandLineEntry.Run(args, new Terminal(input, output, error, outputRedirected: redirected, errorRedirected: redirected), Laboratories);
        return new FootballCommand(exitCode, "", Encoding.UTF8.GetString(error.ToArray()));
    }

    public static FootballCommand Simulate(string input, params string[] args) => Run(input, ["simulate", "-", .. args]);

    /// <summary>Plays one scenario, which must not be refused.</summary>
    public static JsonElement Play(string scenario, params string[] args)
    {
        FootballCommand done = Simulate(scenario, args);
        Assert.Equal("", done.Error);
        Assert.Equal(0, done.ExitCode);
        return done.Result;
    }

    private static string[] Split(string text) => text.Split('\n', StringSplitOptions.RemoveEmptyEntries);
}
