using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tool.Tests;

/// <summary>Two processes and a relay over UDP, a short match: late, lost and overtaking packets, one process killed and started again, and neither ball nor score apart.</summary>
public sealed class NetworkSampleTests
{
    [Theory]
    [InlineData("server", 16)]
    [InlineData("ggpo", 10)]
    public async Task Two_machines_on_a_bad_network_play_one_match_to_the_last_bit(string style, int seed)
    {
        Shell done = await Shell.RunAsync(
            $"dotnet '{Path.Combine(AppContext.BaseDirectory, "football-network.dll")}' demo --minutes 1 --delay 150 --jitter 40 --loss 0.05 --away 1 --seed {seed} --style {style}");
        Assert.True(done.ExitCode == 0, done.Output + done.Error);
        string[] lines = done.Output.Split('\n');
        Assert.StartsWith($"{style}: 3600 ticks ", lines[0]);
        Assert.Contains(style == "server" ? "another version, scene or step: " : "no server", lines[1]);
        Assert.Matches(@"ball compared at \d{3,} ticks: 0 apart", done.Output);

        // A match with goals, kick-offs and other restarts; the second process counts only those after it joined again.
        Assert.Matches(@"score of both at tick \d+: (?!0:0)(\d+:\d+) and \1, compared at \d{3,} ticks: 0 apart", done.Output);
        Assert.Matches(@"first: score .* kick-offs [1-9]", done.Output);
        Assert.True(style == "ggpo" || done.Output.Contains("divergences 0 of ", StringComparison.Ordinal) && done.Output.Contains("larger than told 0", StringComparison.Ordinal), done.Output);
        Assert.True(style == "server" || done.Output.Contains("\nrolled back ", StringComparison.Ordinal), done.Output);
    }
}
