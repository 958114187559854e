namespace FootballPhysics.Tool.Tests;

/// <summary>How the command is called, and what it says when it is called wrongly.</summary>
public sealed class UsageTests
{
    [Theory]
    [InlineData("simulate")]
    [InlineData("nonsense")]
    [InlineData("simulate", "-", "--nonsense")]
    [InlineData("simulate", "-", "more")]
    [InlineData("simulate", "-", "--set")]
    [InlineData("simulate", "-", "--set", "nonsense")]
    [InlineData("simulate", "-", "--set", "=1")]
    [InlineData("simulate", "-", "--batch", "--jobs", "0")]
    [InlineData("simulate", "-", "--batch", "--jobs", "-1")]
    [InlineData("simulate", "-", "--batch", "--jobs", "many")]
    [InlineData("simulate", "-", "--batch", "--jobs")]
    [InlineData("gallery", "--out")]
    public void Wrong_usage_ends_with_2_and_a_word_on_the_error_output(params string[] args)
    {
        var done = FootballCommand.Run("", args);
        Assert.Equal(2, done.ExitCode);
        Assert.Equal("", done.Output);
        Assert.StartsWith("football: ", done.Error);
    }

    [Fact]
    public void A_file_that_is_not_there_is_refused()
    {
        var done = FootballCommand.Run("", "simulate", "no such file.json");
        Assert.Equal(1, done.ExitCode);
        Assert.StartsWith("football: FILE \"no such file.json\" cannot be read. ", done.ErrorLine);
    }

    [Fact]
    public void A_file_is_read()
    {
        string file = Path.Combine(AppContext.BaseDirectory, "usage-test.json");
        File.WriteAllText(file, $"{{{FootballCommand.Launch}}}");
        var done = FootballCommand.Run("", "simulate", file);
        Assert.Equal(0, done.ExitCode);
        Assert.Equal(FootballCommand.Play($"{{{FootballCommand.Launch}}}").GetRawText(), done.Result.GetRawText());
    }

    [Fact]
    public void Help_lists_the_commands_on_one_screen()
    {
        var done = FootballCommand.Run("", "--help");
        Assert.Equal((0, ""), (done.ExitCode, done.Error));
        string[] lines = done.Output.TrimEnd().Split('\n');
        Assert.InRange(lines.Length, 12, 17);
        Assert.All(lines, line => Assert.InRange(line.Length, 1, 80));
        foreach (string name in (string[])["kick", "simulate", "aim", "intercept", "chance", "fit", "follow", "sweep", "play", "replay", "bundle", "gallery", "lab", "help"])
        {
            Assert.Contains(lines, line => line.StartsWith($"  {name} ", StringComparison.Ordinal));
        }
    }

    [Fact]
    public void Without_arguments_it_prints_the_help()
    {
        var done = FootballCommand.Run("");
        Assert.Equal((0, FootballCommand.Run("", "--help").Output, ""), (done.ExitCode, done.Output, done.Error));
    }
}
