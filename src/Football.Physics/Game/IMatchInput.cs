namespace FootballPhysics.Game;

/// <summary>An input that belongs to a tick, a player and a ball.</summary>
/// <typeparam name="T">The type of the input.</typeparam>
internal interface IMatchInput<T>
{
    long Tick { get; }

    int Player { get; }

    int Ball { get; }

    /// <summary>The noun of the inputs in messages, such as "kicks".</summary>
    string Noun { get; }

    /// <summary>The minimum size of an input in bytes, including tick and player.</summary>
    int Smallest { get; }

    /// <summary>True if another input is bit-identical.</summary>
    bool IsSame(in T other);

    /// <summary>Writes everything except the tick and the player.</summary>
    void Write(ref ByteWriter writer);

    /// <summary>Reads an input that <see cref="Write"/> wrote.</summary>
    T Read(long tick, int player, ref ByteReader reader);
}
