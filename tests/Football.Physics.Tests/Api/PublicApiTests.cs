using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Api;

/// <summary>The public surface changes only on purpose: src/Football.Physics/PublicApi.txt says what it is.</summary>
public sealed class PublicApiTests
{
    [Fact]
    public void The_public_surface_is_the_one_on_record()
    {
        string[] actual = [.. PublicApi.Lines(typeof(Ball).Assembly)];
        string path = Path.Combine(RepositoryFiles.Root, "src", "Football.Physics", "PublicApi.txt");
        if (Environment.GetEnvironmentVariable("UPDATE_PUBLIC_API") == "1")
        {
            File.WriteAllText(path, string.Join('\n', actual) + "\n");
        }

        string[] recorded = File.ReadAllLines(path);
        string[] changes = [.. recorded.Except(actual).Select(line => "- " + line), .. actual.Except(recorded).Select(line => "+ " + line)];
        Assert.True(
            changes.Length == 0,
            $"The public surface has changed. If it was meant to, run the tests once with UPDATE_PUBLIC_API=1.\n{string.Join('\n', changes)}");
        Assert.Equal(recorded, actual);
    }
}
