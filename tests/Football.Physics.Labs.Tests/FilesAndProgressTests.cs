using System.Text;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Tests;

/// <summary>Long work: its files are opened before it, and it tells how far it is.</summary>
public sealed class FilesAndProgressTests
{
    [Theory]
    [InlineData("--csv", "lab", "stability", "--scenes", "1000000000000")]
    [InlineData("--json", "lab", "stability", "--scenes", "1000000000000")]
    [InlineData("--plot", "lab", "stability", "--scenes", "1000000000000")]
    [InlineData("--csv", "lab", "aim", "--full")]
    [InlineData("--svg", "kick")]
    [InlineData("--out", "gallery")]
    public void A_file_that_cannot_be_written_is_refused_before_the_work(string option, params string[] command)
    {
        foreach (string file in option == "--plot" ? (string[])["/dev/null/x.svg"] : ["", "/dev/null/x", "a\0b"])
        {
            FootballCommand done = FootballCommand.Run("", [.. command, option, file]);
            Assert.Equal((1, ""), (done.ExitCode, done.Output));
            Assert.StartsWith($"football: {option} \"", done.ErrorLine);
            Assert.Contains(" can be written.", done.ErrorLine);
        }
    }

    [Fact]
    public void A_file_that_was_longer_is_as_long_as_its_new_content()
    {
        string file = Path.Combine(AppContext.BaseDirectory, "shorter-test.json");
        File.WriteAllText(file, new string('x', 1 << 20));
        FootballCommand done = FootballCommand.Run("", "lab", "vacuum", "--json", file);
        Assert.Equal(done.Output, File.ReadAllText(file));
    }

    [Theory]
    [InlineData("sweep", "--count", "300000")]
    [InlineData("lab", "vacuum")]
    [InlineData("simulate", "progress-test.ndjson", "--batch")]
    public void Progress_has_a_percentage_a_rate_and_the_time_that_remains(params string[] args)
    {
        string file = Path.Combine(AppContext.BaseDirectory, "progress-test.ndjson");
        File.WriteAllText(file, string.Concat(Enumerable.Repeat($"{{{FootballCommand.Launch}}}\n", 5000)));
        string error = ErrorInTerminal([.. args.Select(arg => arg.EndsWith(".ndjson", StringComparison.Ordinal) ? file : arg)]);
        Assert.Matches("[1-9][0-9]*%", error);
        Assert.Contains(":", error);
    }

    [Fact]
    public void Nobody_looks_at_progress_that_is_redirected() => Assert.Equal("", FootballCommand.Run("", "sweep", "--count", "20000").Error);

    private static string ErrorInTerminal(string[] args)
    {
        using var nothing = new MemoryStream();
        using var error = new MemoryStream();
        Assert.Equal(0, CommandLineEntry.Run(args, new Terminal(nothing, Stream.Null, error, outputRedirected: true, errorRedirected: false), Laboratories.Create));
        return Encoding.UTF8.GetString(error.ToArray());
    }
}
