using System.Runtime.CompilerServices;
using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Game;

/// <summary>The sizes that the pages tell are those that there are.</summary>
public sealed class SizeTests
{
    [Theory]
    [InlineData("docs/determinism.md")]
    [InlineData("docs/network.md")]
    public void A_page_tells_the_sizes_of_a_state_as_they_are(string page)
    {
        string text = RepositoryFiles.Text(page);
        Assert.Contains($"{Snapshot.Size} bytes", text);
        Assert.Contains(page.EndsWith("network.md", StringComparison.Ordinal) ? "array<Byte>[" + Snapshot.Size + "]" : $"`BallState`, {Unsafe.SizeOf<BallState>()} bytes", text);
        Assert.Equal(24, Snapshot.WireSize);
        Assert.Contains($"{Snapshot.WireSize} ", text);
        Assert.Equal(64, MatchSegment.KeyframeTicks);
    }
}
