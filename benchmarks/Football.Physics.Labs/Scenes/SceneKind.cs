namespace Football.Physics.Labs.Scenes;

/// <summary>A kind of random scene with an independent answer.</summary>
internal abstract class SceneKind
{
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
            var random = new LabRandom(LabRandom.Mix(seed, index));

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
    protected abstract SceneOutcome Play(LabRandom random);

    /// <summary>A limit, widened by the error of the steps themselves, which may be cut elsewhere: twice that, and at most tenfold.</summary>
    protected static double Widened(double limit, double ofSteps) => limit + Math.Min(10 * limit, double.IsNaN(ofSteps) ? 0 : 2 * ofSteps);
}
