using System.Text.Json;

namespace FootballPhysics.Labs.Tests;

/// <summary>The experiments end, say what they must, and write what they are asked to.</summary>
public sealed class LabTests
{
    [Theory]
    [InlineData("vacuum", 5)]
    [InlineData("bodies", 5)]
    [InlineData("bodies", 6)]
    [InlineData("consistency", 5)]
    [InlineData("consistency", 3)] // Shots that enter and leave the law with spin within one step.
    [InlineData("consistency", 24)]
    [InlineData("consistency", 30)]
    public void Every_target_is_reached(string lab, int seed)
    {
        var done = FootballCommand.Run("", "lab", lab, "--seed", $"{seed}");
        Assert.Equal(0, done.ExitCode);
        Assert.Contains("reached", done.Error);
        Assert.DoesNotContain("MISSED", done.Error);
        Assert.Equal(lab, done.Result.GetProperty("lab").GetString());
        Assert.Equal(seed, done.Result.GetProperty("seed").GetInt64());
    }

    [Fact]
    public void The_stress_matrix_has_a_verdict_a_cell_and_shows_one_scene()
    {
        var done = FootballCommand.Run("", "lab", "stability", "--scenes", "52", "--jobs", "1");
        Assert.Equal(0, done.ExitCode);
        JsonElement rows = done.Result.GetProperty("tables")[0].GetProperty("rows");
        Assert.Equal(13, rows.GetArrayLength());
        Assert.All(rows.EnumerateArray(), row => Assert.Equal("holds", row.GetProperty("Rk4").GetString()));
        var one = FootballCommand.Run("", "lab", "stability", "--scene", "7");
        Assert.Equal(0, one.ExitCode);
        Assert.Contains("\"launch\"", one.Error);
    }

    [Fact]
    public void Tables_and_pictures_go_to_the_files_named()
    {
        string folder = Directory.CreateTempSubdirectory("football-lab-").FullName;
        string File(string name) => Path.Combine(folder, name);
        var done = FootballCommand.Run("", "lab", "vacuum", "--json", File("a.json"), "--csv", File("a.csv"), "--plot", File("a.svg"));
        Assert.Equal(0, done.ExitCode);
        Assert.Equal(done.Output, System.IO.File.ReadAllText(File("a.json")));
        Assert.Equal(1 + 8, System.IO.File.ReadAllLines(File("a.csv")).Count(line => line.Length > 0));
        Assert.StartsWith("<svg", System.IO.File.ReadAllText(File("a.svg")));
        Directory.Delete(folder, recursive: true);
    }

    [Fact]
    public void The_stress_matrix_draws_what_a_step_that_is_too_long_does()
    {
        string folder = Directory.CreateTempSubdirectory("football-lab-").FullName;
        string file = Path.Combine(folder, "a.svg");
        Assert.Equal(0, FootballCommand.Run("", "lab", "stability", "--scenes", "13", "--jobs", "1", "--plot", file).ExitCode);
        Assert.Contains("exact", System.IO.File.ReadAllText(file));
        var one = FootballCommand.Run("", "lab", "stability", "--scene", "7", "--plot", file);
        Assert.Equal(1, one.ExitCode);
        Assert.EndsWith("football: --plot: there is nothing to draw of scene 7.\n", one.Error);
        Directory.Delete(folder, recursive: true);
    }

    [Theory]
    [InlineData("picture.pdf")]
    [InlineData("picture")]
    public void A_picture_of_another_kind_is_refused_before_anything_is_done(string file)
    {
        foreach (string lab in new[] { "vacuum", "consistency", "cost", "precision", "stability", "aim" })
        {
            var done = FootballCommand.Run("", "lab", lab, "--plot", file);
            Assert.Equal(1, done.ExitCode);
            Assert.Equal($"football: --plot is \"{file}\"; allowed: a file that ends in .svg or .png.", done.ErrorLine);
        }
    }

    [Theory]
    [InlineData("lab", "nonsense")]
    [InlineData("lab", "vacuum", "--seed", "many")]
    [InlineData("lab", "stability", "--scenes")]
    public void Wrong_usage_ends_with_2(params string[] args) => Assert.Equal(2, FootballCommand.Run("", args).ExitCode);
}
