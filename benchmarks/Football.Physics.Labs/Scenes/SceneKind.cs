using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Scenes;

/// <summary>A kind of random scene with an independent reference.</summary>
internal abstract class SceneKind
{
    /// <summary>The largest error of the steps, as a share of the limit.</summary>
    private const double StepShare = 0.2;

    /// <summary>The largest number of parts of a step.</summary>
    private const int MostParts = 64;

    /// <summary>The name of the kind, for the option and the table.</summary>
    public abstract string Name { get; }

    /// <summary>The check, for the notes below the table.</summary>
    public abstract string Claim { get; }

    /// <summary>The number of scenes simulated per requested scene.</summary>
    public virtual int Share => 1;

    /// <summary>Simulates one scene; an exception of the library counts as a fault.</summary>
    /// <param name="seed">The seed of all scenes.</param>
    /// <param name="index">The index of the scene.</param>
    public SceneOutcome Play(long seed, long index)
    {
        try
        {
            var random = new SeededRandom(SeededRandom.Mix(seed, index));

            // The first numbers of neighbouring seeds are not independent.
            random.Next();
            return Play(random);
        }
        catch (Exception exception) when (exception is ArgumentException or InvalidOperationException or ArithmeticException or IndexOutOfRangeException)
        {
            return new SceneOutcome("thrown", false, double.PositiveInfinity, 0, exception.Message);
        }
    }

    /// <summary>Draws and simulates one scene.</summary>
    protected abstract SceneOutcome Play(SeededRandom random);

    /// <summary>Returns the number of parts into which the steps of a scene are divided, so that their own error is a small share of the limit. The remaining error is that of the contact.</summary>
    /// <param name="limit">The limit, m or m/s.</param>
    /// <param name="ofSteps">Returns the difference between a run with this many parts and one with four times as many.</param>
    protected static int Divide(double limit, Func<int, double> ofSteps)
    {
        int parts = 1;
        while (parts < MostParts && !(ofSteps(parts) <= StepShare * limit))
        {
            parts *= 2;
        }

        return parts;
    }
}

/// <summary>The result of the library in one scene, compared with an independent reference.</summary>
/// <param name="Group">The group of scenes that are counted together.</param>
/// <param name="Agrees">True if the library gives the same yes or no: hits, climbs, rests.</param>
/// <param name="Error">The error of a number; 0 if only a yes or no is compared.</param>
/// <param name="Limit">The largest allowed error.</param>
/// <param name="Detail">Numbers for finding the fault.</param>
internal readonly record struct SceneOutcome(string Group, bool Agrees, double Error, double Limit, string Detail)
{
    /// <summary>True if the library is right.</summary>
    public bool Holds => Agrees && Error <= Limit;
}
