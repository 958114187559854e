using System.Runtime.CompilerServices;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Game;

/// <summary>The sizes that the pages tell are those that there are.</summary>
public sealed class SizeTests
{
    [Fact]
    public void The_pages_tell_the_sizes_of_a_state_as_they_are()
    {
        string page = RepositoryFiles.Text("docs/networking.md");
        Assert.Contains($"| `BallState` | {Unsafe.SizeOf<BallState>()} bytes in memory |", page);
        Assert.Contains($"| `Snapshot.Write`, `Snapshot.Read` | {Snapshot.Size} bytes, with a checksum |", page);
        Assert.Contains($"| `TryWriteQuantized`, `ReadQuantized` | {Snapshot.QuantizedSize} bytes |", page);
        Assert.Contains($"array<Byte>[{Snapshot.Size}]", RepositoryFiles.Text("docs/netcode.md"));
        Assert.Equal(24, Snapshot.QuantizedSize);
        Assert.Contains($"Every {Recording.KeyframeTicks} ticks a recording has a whole state", page);
    }
}
