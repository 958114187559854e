using System.CommandLine;
using System.Text;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Tests;

/// <summary>Every command has help with examples, and the examples work.</summary>
public sealed class HelpTests
{
    /// <summary>The file that an example of a match names: a flight of two seconds, 50 times a second.</summary>
    private static readonly string s_track = "t,x,y,z\n" + string.Concat(Enumerable.Range(0, 100).Select(i => 0.02 * i).Select(t =>
        FormattableString.Invariant($"{t:0.00},{(18 * t) - (t * t):0.####},{2 * t:0.####},{0.11 + (10 * t) - (4.9 * t * t):0.####}\n")));

    /// <summary>A camera 60 m beside the path of a ball.</summary>
    private const string Cameras = "p11,p12,p13,p14,p21,p22,p23,p24,p31,p32,p33,p34\n-960,0,-3000,57600,-540,-3000,0,38400,-1,0,0,60\n";

    /// <summary>What it saw.</summary>
    private static readonly string s_pixels = "time,u,v\n" + string.Concat(Enumerable.Range(0, 60).Select(i => 0.02 * i).Select(t =>
    {
        double depth = 60 - (0.5 * t);
        double z = -10 + (18 * t) - (t * t);
        double y = 0.11 + (6 * t) - (4.9 * t * t);
        return FormattableString.Invariant($"{t:0.00},{960 - (3000 * z / depth):0.##},{540 - (3000 * (y - 2) / depth):0.##}\n");
    }));

    public static TheoryData<string> Paths() => [.. PathsBelow(CommandLineEntry.Root(new Terminal(Stream.Null, Stream.Null, Stream.Null, true, true), Laboratories.Create), "")];

    /// <summary>True if the whole experiments run too, as in .ci/run --full. They take minutes.</summary>
    private static bool IsFull => Environment.GetEnvironmentVariable("FOOTBALL_FULL") == "1";

    /// <summary>
    /// Those that end with 0: `lab people`, `lab follow` and `lab verdicts` say by their exit codes what is missed still, and `play` opens a page.
    /// Of a laboratory with several examples, the one without options is the whole experiment.
    /// </summary>
    public static TheoryData<string> Examples() => [.. Paths().SelectMany(row => Short(ExamplesOf(row.Data).ToList())).Distinct()
        .Where(example => !example.StartsWith("football lab people", StringComparison.Ordinal) && !example.StartsWith("football lab follow", StringComparison.Ordinal)
            && !example.StartsWith("football lab verdicts", StringComparison.Ordinal) && !example.StartsWith("football play", StringComparison.Ordinal))];

    [Theory]
    [MemberData(nameof(Paths))]
    public void Its_help_has_examples(string path) => Assert.NotEmpty(ExamplesOf(path));

    [Theory]
    [MemberData(nameof(Examples))]
    public async Task Every_example_works(string example)
    {
        if (example.Contains("| jq ", StringComparison.Ordinal))
        {
            NeededPrograms.Need("apt-get install jq", "jq");
        }

        string files = (example.Contains("match.zip", StringComparison.Ordinal) ? Written("match.zip", Bundle()) : "")
            + (example.Contains("TRACK.csv", StringComparison.Ordinal) ? Written("TRACK.csv", Encoding.UTF8.GetBytes(s_track)) : "")
            + (example.Contains("PIXELS.csv", StringComparison.Ordinal) ? Written("CAMERAS.csv", Encoding.UTF8.GetBytes(Cameras)) + Written("PIXELS.csv", Encoding.UTF8.GetBytes(s_pixels)) : "");
        Shell done = await Shell.RunAsync("set -o pipefail; " + files + example);
        Assert.True(done.ExitCode == 0, $"{example}: {done.ExitCode}\n{done.Error}");
        Assert.NotEqual("", done.Output);
    }

    private static IEnumerable<string> Short(List<string> examples) =>
        IsFull || examples.Count == 1 ? examples : examples.Where(example => !(example.StartsWith("football lab ", StringComparison.Ordinal) && example.Split(' ').Length == 3));

    /// <summary>The line that writes a file.</summary>
    private static string Written(string name, byte[] bytes) => $"echo {Convert.ToBase64String(bytes)} | base64 -d > {name}; ";

    /// <summary>A bundle of as many ticks as the examples want.</summary>
    private static byte[] Bundle()
    {
        var runner = new FixedStepRunner();
        Recording segment = runner.Record();
        for (int i = 0; i < 1250; i++)
        {
            runner.Step();
        }

        return segment.ToBundle(runner.Simulator);
    }

    [Theory]
    [InlineData("help")]
    [InlineData("lab")]
    [InlineData("help", "lab")]
    public void Bare_words_list_what_there_is(params string[] args)
    {
        FootballCommand done = FootballCommand.Run("", args);
        Assert.Equal((0, ""), (done.ExitCode, done.Error));
        foreach (string name in args.Contains("lab") ? ["vacuum", "consistency", "cost", "precision", "stability", "aim", "fuzz"] : (string[])["kick", "simulate", "aim", "sweep", "replay", "gallery", "lab", "help"])
        {
            Assert.Contains($"\n  {name}", done.Output);
        }
    }

    [Theory]
    [InlineData("football lab ", "lab", "--help")]
    [InlineData("football lab vacuum ", "lab", "vacuum", "--help")]
    public void Usage_names_the_tool(string usage, params string[] args) => Assert.Contains($"Usage:\n  {usage}", FootballCommand.Run("", args).Output.ReplaceLineEndings("\n"));

    [Fact]
    public void Help_about_a_command_is_its_own() =>
        Assert.Equal(FootballCommand.Run("", "lab", "vacuum", "--help").Output, FootballCommand.Run("", "help", "lab", "vacuum").Output);

    [Theory]
    [InlineData("football: simulat is unknown to football; did you mean simulate?", "simulat")]
    [InlineData("football: labs is unknown to football; did you mean lab?", "labs")]
    [InlineData("football: vacum is unknown to football lab; did you mean vacuum?", "lab", "vacum")]
    [InlineData("football: vacum is unknown to football lab; did you mean vacuum?", "help", "lab", "vacum")]
    [InlineData("football: --bach is unknown to football simulate; did you mean --batch?", "simulate", "-", "--bach")]
    [InlineData("football: --sped is unknown to football kick; did you mean --speed?", "kick", "--sped", "27")]
    [InlineData("football: nonsense is unknown to football.", "nonsense")]
    public void What_is_misspelt_is_guessed(string message, params string[] args)
    {
        FootballCommand done = FootballCommand.Run("", args);
        Assert.Equal((2, ""), (done.ExitCode, done.Output));
        Assert.StartsWith(message + "\n", done.Error);
        Assert.EndsWith("--help describes it.\n", done.Error);
    }

    private static IEnumerable<string> PathsBelow(Command command, string path) =>
        command.Subcommands.SelectMany(sub => PathsBelow(sub, $"{path} {sub.Name}".Trim())).Prepend(path);

    private static IEnumerable<string> ExamplesOf(string path)
    {
        string help = FootballCommand.Run("", [.. path.Split(' ', StringSplitOptions.RemoveEmptyEntries), "--help"]).Output;
        if (path.Length == 0)
        {
            return [help[(help.IndexOf("Example: ", StringComparison.Ordinal) + "Example: ".Length)..].TrimEnd()];
        }

        int examples = help.IndexOf("Examples:\n", StringComparison.Ordinal);
        Assert.True(examples > 0, help);
        return help[examples..].Split('\n', StringSplitOptions.RemoveEmptyEntries).Skip(1).Select(line => line.Trim());
    }
}
