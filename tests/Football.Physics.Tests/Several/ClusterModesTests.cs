namespace FootballPhysics.Tests.Several;

/// <summary>The forces of balls that press each other against the laws that they must fulfil: no ball is moved, and no law is solved here.</summary>
public sealed class ClusterModesTests
{
    [Theory]
    [InlineData(2, false)]
    [InlineData(2, true)]
    [InlineData(3, false)]
    [InlineData(3, true)]
    [InlineData(4, true)]
    public void Forces_fulfil_the_laws_of_every_contact(int count, bool rolls)
    {
        var random = new Random((10 * count) + (rolls ? 1 : 0));
        int found = 0;
        int pressed = 0;
        for (int i = 0; i < 30; i++)
        {
            var draw = new TouchingBalls(random, count, resists: i % 3 > 0);
            if (draw.Settle(random, rolls) && draw.Find())
            {
                found++;
                pressed += draw.Check(FormattableString.Invariant($"draw {i}"));
            }
        }

        Assert.True(found > 12 && pressed > 5, $"{found} found, {pressed} contacts of balls with load");
    }

    /// <summary>Modes hold where they were found, and no longer if a load, a grip, a slip, a spin or a roll has passed its limit.</summary>
    [Fact]
    public void Modes_end_with_any_of_their_limits()
    {
        var random = new Random(77);
        int ends = 0;
        for (int i = 0; i < 40; i++)
        {
            var draw = new TouchingBalls(random, 2 + (i % 2), resists: i % 3 > 0);
            if (draw.Settle(random, i % 4 > 0) && draw.Find())
            {
                ends += draw.CheckLimits(FormattableString.Invariant($"draw {i}"));
            }
        }

        Assert.True(ends > 60, $"{ends} limits");
    }
}
