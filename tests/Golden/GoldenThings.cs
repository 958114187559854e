// The golden lines of balls among objects: each scene with the settings of a variant, in turn.

namespace FootballPhysics.Golden;

public static class GoldenThings
{
    private static readonly (bool IsPublished, Integrator Integrator, int Rate)[] s_variants =
    {
        (false, Integrator.Rk4, 60), (true, Integrator.Rk4, 100), (false, Integrator.Rk2, 60), (false, Integrator.Rk4, 100), (true, Integrator.Rk2, 60), (false, Integrator.Rk4, 30), (true, Integrator.Rk4, 60),
    };

    /// <summary>The hash of each simulation. The name ends with the profile, the integrator and the steps per second.</summary>
    /// <param name="met">Gets the kinds of events, and the names of everything that a ball touched.</param>
    /// <param name="every">Above 1: only every so many scenes.</param>
    public static IEnumerable<KeyValuePair<string, ulong>> Hashes(ISet<string> met, int every = 1)
    {
        int variant = 0;
        foreach ((string name, Func<Scene, GoldenPlay> make) in Plays())
        {
            (bool isPublished, Integrator integrator, int rate) = s_variants[variant % s_variants.Length];
            if (variant++ % every != 0)
            {
                continue;
            }

            GoldenPlay play = make(isPublished ? Scene.Published : GoldenGames.Plain);
            play.Integrator ??= integrator;
            string profile = play.Scene.Forces.Coefficients == AerodynamicModel.Measured ? "default" : "published";
            yield return GoldenShots.Named($"{name} {profile} {play.Integrator} {rate}", play.Run(rate, met));
        }

        foreach (KeyValuePair<string, ulong> look in GoldenRest.Looks())
        {
            yield return look;
        }
    }

    private static IEnumerable<(string Name, Func<Scene, GoldenPlay> Make)> Plays()
    {
        return GoldenContacts.Plays().Concat(GoldenSqueezes.Plays()).Concat(GoldenMovers.Plays()).Concat(GoldenGrounds.Plays()).Concat(GoldenGroups.Plays()).Concat(GoldenRest.Plays());
    }
}
