using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tool.Tests;

/// <summary>The sample that a newcomer reads first runs, and is as short as it says.</summary>
public sealed class MinimalSampleTests
{
    [Fact]
    public async Task It_plays_looks_ahead_and_aims()
    {
        Shell done = await Shell.RunAsync($"dotnet '{Path.Combine(AppContext.BaseDirectory, "Minimal.dll")}'");
        Assert.Equal((0, ""), (done.ExitCode, done.Error));
        Assert.StartsWith("will cross the goal line after ", done.Output);
        foreach (string kind in (string[])["Impact", "Roll", "Rest"])
        {
            Assert.Contains($" s  {kind} ", done.Output);
        }

        Assert.Contains("Hit: velocity ", done.Output);
    }

    [Fact]
    public void It_has_fifty_lines() => Assert.InRange(RepositoryFiles.Text("samples/Minimal/Program.cs").Count(c => c == '\n'), 30, 52);
}
