namespace Football.Physics;

/// <summary>Watches a simulation piece by piece.</summary>
internal abstract class PieceObserver
{
    /// <summary>Whether pieces need the acceleration at their end, which costs an evaluation each; without it they are cubic.</summary>
    public abstract bool WantsEndAcceleration { get; }

    /// <summary>Called after every piece, before the event that may end it.</summary>
    /// <returns>True when it has seen enough: the step ends here.</returns>
    public abstract bool Add(in PathPiece piece);

    /// <summary>The same with the whole state at both ends, for who needs more than the path.</summary>
    /// <param name="before">The ball at the piece's start.</param>
    /// <param name="after">The ball at its end.</param>
    /// <param name="piece">The piece.</param>
    public virtual bool Add(in BallState before, in BallState after, in PathPiece piece) => Add(in piece);
}
