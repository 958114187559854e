using FootballPhysics.Golden;
using FootballPhysics.Package.Tests;

namespace FootballPhysics.Native.Tests;

/// <summary>The hashes of a filter that tests/Native/follow.c, tests/Python/test_filter.py and the program on ARM64 reproduce.</summary>
public sealed class FollowTests
{
    [Fact]
    public void Three_streams_have_the_hashes_of_the_file() => Repository.AssertCurrent("tests/Native/follow.txt", string.Concat(GoldenFollow.Lines().Select(line => line + "\n")));
}
