namespace FootballPhysics.Game;

/// <summary>An input that belongs to a tick, a player and a ball.</summary>
/// <typeparam name="T">The type of the input.</typeparam>
internal interface IMatchInput<T>
{
    long Tick { get; }

    int Player { get; }

    int Ball { get; }

    /// <summary>True if another input is bit-identical.</summary>
    bool IsSame(in T other);
}
