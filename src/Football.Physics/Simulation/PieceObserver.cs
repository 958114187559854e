namespace FootballPhysics.Prediction;

/// <summary>A watcher of a simulation, piece by piece: for exact apexes, lengths, crossings, dense paths. Set as <see cref="StepLog.Observer"/>.</summary>
public abstract class PieceObserver
{
    /// <summary>True when pieces need the acceleration at their end, which costs an evaluation each; without it they are cubic. Default false.</summary>
    public virtual bool WantsEndAcceleration => false;

    /// <summary>Called after every piece, before the event that may end it.</summary>
    /// <param name="piece">The piece of the path.</param>
    /// <returns>True when it has seen enough: the step, and the run, end here.</returns>
    public abstract bool Add(in PathSegment piece);

    /// <summary>Called after every piece with the whole state at both ends, for who needs more than the path.</summary>
    /// <param name="before">The ball at the piece's start.</param>
    /// <param name="after">The ball at its end.</param>
    /// <param name="piece">The piece.</param>
    /// <returns>As <see cref="Add(in PathSegment)"/>, which it calls unless it is overridden.</returns>
    public virtual bool Add(in BallState before, in BallState after, in PathSegment piece) => Add(in piece);
}
