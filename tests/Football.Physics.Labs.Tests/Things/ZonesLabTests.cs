using FootballPhysics.Labs.Zones;

namespace FootballPhysics.Labs.Tests.Things;

/// <summary>Zones against a dense sampling of the path.</summary>
public sealed class ZonesLabTests
{
    [Fact]
    public void Every_crossing_is_reported_in_order_and_no_zone_changes_a_path()
    {
        var plays = new ZonePlays();
        for (int i = 0; i < 150; i++)
        {
            plays.Play(20261127, i);
        }

        Assert.Equal(150, plays.Counts["paths"]);
        Assert.All(ZonePlays.Faults, fault => Assert.Equal(0, plays.Counts[fault]));
        Assert.InRange(plays.WorstTime, 0, 1e-9);
        Assert.InRange(plays.WorstPlace, 0, 1e-9);
        Assert.All(ZoneDraw.Shapes, shape => Assert.True(plays.Counts["events: " + shape] > 30, shape));
        Assert.False(plays.Failed);
    }
}
