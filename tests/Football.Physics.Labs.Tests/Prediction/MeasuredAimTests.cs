namespace FootballPhysics.Labs.Tests.Predictors;

/// <summary>Aims in the measured profile, in weather, wind and gusts, beside those of the published one.</summary>
public sealed class MeasuredAimTests
{
    private const int Count = 150;

    private static readonly Lazy<double> s_published = new(() => ProfileAims.Of(Scene.Published, 3, Count).Simulations);

    public static TheoryData<string> Scenes() => [.. ProfileAims.Scenes.Select(item => item.Name)];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Every_kick_is_found_to_a_millimetre_with_hardly_more_flights(string name)
    {
        Scene scene = ProfileAims.Scenes.Single(item => item.Name == name).Scene;
        (int hits, double simulations, _, double worst) = ProfileAims.Of(scene, 3, Count);
        Assert.Equal(Count, hits);
        Assert.InRange(worst, 0, 1e-3);

        // The rehearsal of a kick knows steady laws that bend little; what it does not know takes flights.
        Assert.InRange(simulations, 1, s_published.Value + (scene.Air.IsStill ? 0.5 : 3.0));
    }
}
