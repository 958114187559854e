using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Scenes;

/// <summary>A kind of random scene with an independent answer.</summary>
internal abstract class SceneKind
{
    /// <summary>The error of the steps is at most this share of the limit.</summary>
    private const double StepShare = 0.2;

    /// <summary>A step is divided into no more parts than this.</summary>
    private const int MostParts = 64;

    /// <summary>Its name, for the option and the table.</summary>
    public abstract string Name { get; }

    /// <summary>The check, for the notes below the table.</summary>
    public abstract string Claim { get; }

    /// <summary>How many scenes are played for each that is asked for.</summary>
    public virtual int Share => 1;

    /// <summary>Plays one scene; an exception of the library is a fault too.</summary>
    /// <param name="seed">The seed of all scenes.</param>
    /// <param name="index">The number of this one.</param>
    public SceneOutcome Play(long seed, long index)
    {
        try
        {
            var random = new SeededRandom(SeededRandom.Mix(seed, index));

            // The first number of neighbouring seeds is not independent.
            random.Next();
            return Play(random);
        }
        catch (Exception exception) when (exception is ArgumentException or InvalidOperationException or ArithmeticException or IndexOutOfRangeException)
        {
            return new SceneOutcome("thrown", false, double.PositiveInfinity, 0, exception.Message);
        }
    }

    /// <summary>Draws and plays one scene.</summary>
    protected abstract SceneOutcome Play(SeededRandom random);

    /// <summary>
    /// Into how many parts the steps of a scene must be divided, so that their own error is a small share of the limit: what is left is the error of the contact.
    /// </summary>
    /// <param name="limit">The limit, m or m/s.</param>
    /// <param name="ofSteps">The difference between a run with so many parts and one with four times as many.</param>
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
