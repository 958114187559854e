namespace Football.Physics;

/// <summary>Watches a simulation piece by piece.</summary>
internal abstract class PieceObserver
{
    /// <summary>Whether pieces need the acceleration at their end, which costs an evaluation each; without it they are cubic.</summary>
    public abstract bool WantsEndAcceleration { get; }

    /// <summary>Called after every piece, before the event that may end it.</summary>
    /// <returns>True when it has seen enough: the step ends here.</returns>
    public abstract bool Add(in PathPiece piece);
}
