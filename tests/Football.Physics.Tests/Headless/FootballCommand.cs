using System.Text;
using System.Text.Json;
using Football.Physics.Headless.Commands;

namespace Football.Physics.Tests.Headless;

/// <summary>Runs the command in this process, with its input and outputs in memory.</summary>
internal sealed record FootballCommand(int ExitCode, string Output, string Error)
{
    /// <summary>A scenario as short as it can be, without its braces.</summary>
    public const string Launch = "\"launch\":{\"position\":[0,1,0],\"velocity\":[1,0,0]}";

    public IReadOnlyList<JsonElement> Lines => [.. Split(Output).Select(line => JsonDocument.Parse(line).RootElement)];

    public JsonElement Result => Assert.Single(Lines);

    public string ErrorLine => Assert.Single(Split(Error));

    public static FootballCommand Run(string input, params string[] args) => Run(Encoding.UTF8.GetBytes(input), args);

    public static FootballCommand Run(byte[] input, params string[] args)
    {
        using var output = new MemoryStream();
        using var error = new StringWriter { NewLine = "\n" };
        int exitCode = CommandLineEntry.Run(args, new Terminal(new MemoryStream(input), output, error, outputRedirected: true, errorRedirected: true));
        return new FootballCommand(exitCode, Encoding.UTF8.GetString(output.ToArray()), error.ToString());
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
