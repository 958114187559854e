using System.Diagnostics;

namespace FootballPhysics.Tool.Tests;

/// <summary>No command writes over what it reads, by whatever name; and names from files do not reach the terminal as they are.</summary>
public sealed class InputFilesTests : IDisposable
{
    private const string Shot = "{" + FootballCommand.Launch + ",\"stop\":{\"at\":\"time\",\"time\":0.2}}";

    private readonly string _folder = Directory.CreateTempSubdirectory("football-inputs-").FullName;

    public static TheoryData<string> Links => ["same", "dots", "symbolic", "symbolic folder", "hard"];

    [Theory]
    [MemberData(nameof(Links))]
    public void A_replay_does_not_write_over_its_input(string link)
    {
        string input = Write("shot.json", Shot);
        string output = Linked(input, link, "page.html");
        foreach (string option in (string[])["--output", "--gltf", "--svg"])
        {
            string[] page = option == "--output" ? [] : ["--output", Path.Combine(_folder, "other.html")];
            var done = FootballCommand.Run("", ["replay", input, option, output, .. page]);
            Assert.Equal(1, done.ExitCode);
            Assert.Contains(" is also the file of ", done.ErrorLine);
            Assert.Equal(Shot, File.ReadAllText(input));
        }

        // Another file beside it is written.
        Assert.Equal(0, FootballCommand.Run("", "replay", input, "--output", Path.Combine(_folder, "own.html")).ExitCode);
        Assert.Equal(Shot, File.ReadAllText(input));
    }

    [Theory]
    [InlineData("rows.ndjson")]
    [InlineData("schema.json")]
    [InlineData("manifest.json")]
    [InlineData("checkpoint.json")]
    public void A_sweep_does_not_write_over_its_input(string name)
    {
        foreach (string link in Links.Select(row => row.Data))
        {
            string folder = Path.Combine(_folder, link, "rows");
            Directory.CreateDirectory(folder);
            const string Input = "{\"launch\": {\"speed\": [20, 25]}}";
            string input = Write(Path.Combine(link, "input.json"), Input);
            string output = Path.Combine(folder, name);
            if (link is "same" or "dots")
            {
                File.Move(input, output);
                input = link == "dots" ? Path.Combine(folder, "..", "rows", name) : output;
            }
            else
            {
                Link(input, output, link == "symbolic folder" ? "symbolic" : link);
            }

            string into = folder;
            if (link == "symbolic folder")
            {
                into = Path.Combine(_folder, link, "by link");
                Directory.CreateSymbolicLink(into, folder);
            }

            var done = FootballCommand.Run("", "sweep", input, "--count", "5", "--out", into);
            Assert.Equal(1, done.ExitCode);
            Assert.StartsWith("football: ", done.ErrorLine);
            Assert.Equal(Input, File.ReadAllText(input));
        }
    }

    /// <summary>Rows of a run that ended at once are begun again; another name of that file keeps its bytes.</summary>
    [Fact]
    public void A_sweep_leaves_what_another_name_of_its_file_holds()
    {
        string folder = Path.Combine(_folder, "rows");
        Directory.CreateDirectory(folder);
        string kept = Write("kept", "");
        Link(kept, Path.Combine(folder, "rows.ndjson"), "hard");
        string input = Write("input.json", "{}");
        Assert.Equal(0, FootballCommand.Run("", "sweep", input, "--count", "5", "--out", folder).ExitCode);
        Assert.Equal("", File.ReadAllText(kept));
        Assert.Equal(5, File.ReadLines(Path.Combine(folder, "rows.ndjson")).Count());
    }

    [Fact]
    public void Names_of_a_scenario_are_shown_and_not_obeyed()
    {
        string named = "{\"name\":\"\\u001b]0;evil\\u0007\"," + Shot[1..];
        string told = FootballCommand.InTerminal(named, "simulate", "-").Output;
        Assert.DoesNotContain("\u001b]0", told);
        Assert.DoesNotContain('\u0007', told);
    }

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    private string Write(string name, string text)
    {
        string path = Path.Combine(_folder, name);
        File.WriteAllText(path, text);
        return path;
    }

    private string Linked(string input, string link, string name)
    {
        switch (link)
        {
            case "same":
                return input;
            case "dots":
                return Path.Combine(_folder, "..", Path.GetFileName(_folder), Path.GetFileName(input));
            case "symbolic folder":
                string folder = Path.Combine(_folder, "link");
                Directory.CreateSymbolicLink(folder, _folder);
                return Path.Combine(folder, Path.GetFileName(input));
            default:
                string output = Path.Combine(_folder, name);
                Link(input, output, link);
                return output;
        }
    }

    private static void Link(string from, string to, string link)
    {
        if (link == "symbolic")
        {
            File.CreateSymbolicLink(to, from);
            return;
        }

        // The library of this runtime makes no hard links.
        ProcessStartInfo start = OperatingSystem.IsWindows() ? new("cmd", ["/c", "mklink", "/H", to, from]) : new("ln", [from, to]);
        using Process process = Process.Start(start)!;
        process.WaitForExit();
        Assert.Equal(0, process.ExitCode);
    }
}
