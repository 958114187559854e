namespace FootballPhysics.Tests.Scenes;

/// <summary>The drag curve of a ball by its roughness.</summary>
public sealed class RoughnessTests
{
    [Fact]
    public void The_rougher_a_ball_the_earlier_its_crisis_and_the_higher_its_drag_above_it()
    {
        DragCurve last = DragCurve.OfRoughness(0);
        for (int i = 1; i <= 20; i++)
        {
            DragCurve curve = DragCurve.OfRoughness(0.05 * i);
            Assert.True(curve.CriticalReynolds < last.CriticalReynolds && curve.Supercritical > last.Supercritical);
            new Scene { Ball = new BallProperties { DragCurve = curve } }.Validate();
            last = curve;
        }
    }

    /// <summary>The law goes through what was measured: the smoothest ball of the tunnel and its middle ones, and the Trionda's crisis at 12.1 m/s.</summary>
    [Fact]
    public void Its_ends_and_middle_are_the_tunnels()
    {
        Assert.Equal(DragCurve.Jabulani.CriticalReynolds, DragCurve.OfRoughness(0).CriticalReynolds, 0.01 * 272_000);
        Assert.Equal(DragCurve.Brazuca.CriticalReynolds, DragCurve.OfRoughness(0.30).CriticalReynolds, 0.02 * 188_000);
        Assert.Equal(12.1, BallProperties.Trionda.DragCurve.CriticalReynolds * 1.5139e-5 / 0.22, 0.15);
        Assert.Equal(95_000, BallProperties.Modern.DragCurve.CriticalReynolds, 1_000.0);
    }

    [Theory]
    [InlineData(-0.01)]
    [InlineData(1.01)]
    [InlineData(double.NaN)]
    public void What_is_out_of_range_is_refused(double roughness) =>
        Assert.Contains("roughness", Assert.Throws<ArgumentOutOfRangeException>(() => DragCurve.OfRoughness(roughness)).Message, StringComparison.Ordinal);
}
