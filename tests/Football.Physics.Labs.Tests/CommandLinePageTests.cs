using System.Text.Json;
using System.Text.RegularExpressions;

namespace FootballPhysics.Labs.Tests;

/// <summary>Every input on the pages about the command line and about data sets is accepted by the command that it names.</summary>
public sealed partial class CommandLinePageTests
{
    public static TheoryData<string, string> Inputs()
    {
        var data = new TheoryData<string, string>();
        foreach (Match block in Block().Matches(RepositoryFiles.Text("docs/command-line.md") + RepositoryFiles.Text("docs/data-sets.md")))
        {
            data.Add(block.Groups[1].Value, block.Groups[2].Value);
        }

        return data;
    }

    [Theory]
    [MemberData(nameof(Inputs))]
    public void Every_input_on_the_page_is_answered(string command, string input)
    {
        var done = FootballCommand.Run(input, command, "-");
        Assert.Equal(0, done.ExitCode);
        var first = done.Lines[0];
        string? said = command switch
        {
            "aim" => first.GetProperty("status").GetString(),
            "intercept" => first.GetProperty("first").GetString(),
            "fit" => first.GetProperty("verdict").GetString(),
            "sweep" => first.GetProperty("end").GetString(),
            // Several balls have an end each.
            _ => (first.TryGetProperty("balls", out JsonElement balls) ? balls[0] : first).GetProperty("final").GetProperty("state").GetString(),
        };
        Assert.Equal(command switch { "aim" => "hit", "intercept" => "nine", "fit" => "asExpected", "sweep" => "impact", _ when first.TryGetProperty("balls", out _) || input.Contains("\"at\": \"rest\"", StringComparison.Ordinal) => "stopped", _ => "airborne" }, said);
    }

    [Fact]
    public void There_are_inputs_for_every_command() => Assert.Equal(16, Inputs().Count);

    [GeneratedRegex("^```json (simulate|aim|intercept|fit|sweep)\n(.*?)^```$", RegexOptions.Multiline | RegexOptions.Singleline)]
    private static partial Regex Block();
}
