// The golden lines of balls among objects: each scene with the settings of a variant, in turn.

namespace FootballPhysics.Golden;

public static class GoldenThings
{
    private static readonly (string Name, bool IsPublished, Integrator Integrator, int Rate)[] s_variants =
    {
        ("default Rk4 60", false, Integrator.Rk4, 60),
        ("published Rk4 100", true, Integrator.Rk4, 100),
        ("default Rk2 60", false, Integrator.Rk2, 60),
        ("default Rk4 100", false, Integrator.Rk4, 100),
        ("published Rk2 60", true, Integrator.Rk2, 60),
        ("default Rk4 30", false, Integrator.Rk4, 30),
        ("published Rk4 60", true, Integrator.Rk4, 60),
    };

    /// <summary>The hash of each simulation.</summary>
    /// <param name="met">Gets the kinds of events, and the names of everything that a ball touched.</param>
    public static IEnumerable<KeyValuePair<string, ulong>> Hashes(ISet<string> met)
    {
        int variant = 0;
        foreach ((string name, Func<Scene, GoldenPlay> make) in Plays())
        {
            (string with, bool isPublished, Integrator integrator, int rate) = s_variants[variant++ % s_variants.Length];
            yield return GoldenShots.Named(name + " " + with, make(isPublished ? Scene.Published : GoldenGames.Plain).Run(integrator, rate, met));
        }
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Plays()
    {
        return GoldenContacts.Plays().Concat(GoldenSqueezes.Plays()).Concat(GoldenMovers.Plays()).Concat(GoldenGrounds.Plays()).Concat(GoldenGroups.Plays());
    }
}
