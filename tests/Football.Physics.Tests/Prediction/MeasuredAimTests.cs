using Football.Physics.Headless.Lab;

namespace Football.Physics.Tests.Predictors;

/// <summary>Aims in the measured profile, in weather, wind and gusts, beside those of the published one.</summary>
public sealed class MeasuredAimTests
{
    private const int Count = 150;

    private static readonly Lazy<double> s_published = new(() => ProfileAims.Of(Scene.Published, 3, Count).Simulations);

    /// <summary>A wind that blows a kick far aside is searched for with more flights, in both profiles.</summary>
    private static readonly Lazy<double> s_inWind =
        new(() => ProfileAims.Of(ProfileAims.Scenes.Single(item => item.Name == "published, wind of 7 m/s").Scene, 3, Count).Simulations);

    public static TheoryData<string> Scenes() => [.. ProfileAims.Scenes.Select(item => item.Name)];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Every_kick_is_found_to_a_millimetre_with_no_more_flights(string name)
    {
        Scene scene = ProfileAims.Scenes.Single(item => item.Name == name).Scene;
        (int hits, double simulations, _, double worst) = ProfileAims.Of(scene, 3, Count);
        Assert.Equal(Count, hits);
        Assert.InRange(worst, 0, 1e-3);

        // In a steady wind some kicks of both profiles fall to the slow search: now and then others by these laws than by those.
        Assert.InRange(simulations, 1, scene.Air.IsStill ? 1.01 * s_published.Value : 1.5 * Math.Max(s_inWind.Value, s_published.Value));
    }
}
