using FsCheck;
using FsCheck.Fluent;
using Xunit;

namespace Football.Physics.Tests;

public class SphereTests
{
    [Fact]
    public void A_size_five_ball_turns_380_square_centimetres_to_the_air() =>
        Assert.Equal(0.0380132711084365, Sphere.CrossSection(0.11), 1e-15);

    [Fact]
    public void Doubling_the_radius_quadruples_the_area_exactly() =>
        Prop.ForAll(
            ArbMap.Default.ArbFor<int>().Filter(i => i > 0),
            i =>
            {
                double radius = i * 1e-3;
                return Sphere.CrossSection(2 * radius) == 4 * Sphere.CrossSection(radius);
            }).QuickCheckThrowOnFailure();
}
