namespace Football.Physics;

/// <summary>Watches a simulation piece by piece: a piece is smooth motion between two instants without an event between them.</summary>
internal abstract class PieceObserver
{
    /// <summary>Called after every piece.</summary>
    public abstract void Add(in Piece piece);
}
