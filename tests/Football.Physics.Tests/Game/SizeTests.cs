using System.Runtime.CompilerServices;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Game;

/// <summary>The sizes that the pages tell are those that there are.</summary>
public sealed class SizeTests
{
    [Fact]
    public void The_pages_tell_the_sizes_of_a_state_as_they_are()
    {
        string network = RepositoryFiles.Text("docs/network.md");
        Assert.Contains($"`BallState`, {Unsafe.SizeOf<BallState>()} bytes ({Snapshot.Size} as bytes with `Snapshot.Write`, {Snapshot.QuantizedSize} in the", RepositoryFiles.Text("docs/determinism.md"));
        Assert.Contains($"`Snapshot.Write`, {Snapshot.Size} bytes", network);
        Assert.Contains($"array<Byte>[{Snapshot.Size}]", network);
        Assert.Equal(24, Snapshot.QuantizedSize);
        Assert.Contains($"Every {Recording.KeyframeTicks} ticks a recording has a whole state", RepositoryFiles.Text("docs/determinism.md"));
    }
}
