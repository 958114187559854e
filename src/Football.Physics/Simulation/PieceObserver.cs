namespace FootballPhysics.Prediction;

/// <summary>Observes a simulation piece by piece: for exact apexes, lengths, crossings and dense paths.</summary>
/// <remarks>Set it as <see cref="StepLog.Observer"/>.</remarks>
public abstract class PieceObserver
{
    /// <summary>True if pieces need the acceleration at their end. Default false.</summary>
    /// <remarks>It costs one evaluation per piece. Without it, the pieces are cubic.</remarks>
    public virtual bool WantsEndAcceleration => false;

    /// <summary>False if the observer ignores the states at the ends of a piece, and always needs the acceleration at its end.</summary>
    internal virtual bool WantsStates => true;

    /// <summary>Called at the start of a whole step of flight, whose acceleration is that at the end of the last piece if the ball has not changed.</summary>
    /// <returns>True if the next piece may lack the acceleration at its end.</returns>
    internal virtual bool Close(in Vector3d position, in Vector3d velocity, double spin, double time, in Vector3d acceleration) => false;

    /// <summary>Called if the last piece lacks the acceleration at its end, with the ball there and the length of the step.</summary>
    internal virtual void LeaveOpen(Stepper stepper, in BallState end, double h)
    {
    }

    /// <summary>Called after every piece, before the event that may end it.</summary>
    /// <param name="piece">The piece of the path.</param>
    /// <returns>True to end the step and the run here.</returns>
    public abstract bool Add(in PathSegment piece);

    /// <summary>Called after every piece with the full state at both ends.</summary>
    /// <param name="before">The ball at the start of the piece.</param>
    /// <param name="after">The ball at its end.</param>
    /// <param name="piece">The piece.</param>
    /// <returns>As <see cref="Add(in PathSegment)"/>, which the default implementation calls.</returns>
    public virtual bool Add(in BallState before, in BallState after, in PathSegment piece) => Add(in piece);
}
