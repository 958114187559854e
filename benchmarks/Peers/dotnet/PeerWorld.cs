namespace FootballPhysics.Peers;

/// <summary>The objects of an experiment.</summary>
public sealed record PeerOptions
{
    public bool Ground { get; init; }

    public bool Post { get; init; }

    public bool Rolling { get; init; }

    /// <summary>No air: gravity and the ground only, as in the other engines.</summary>
    public bool Vacuum { get; init; }
}

/// <summary>Balls in one engine.</summary>
/// <typeparam name="TState">The saved state of a ball.</typeparam>
public interface IPeerWorld<TState>
{
    void Add(Vector3d position, Vector3d velocity, Vector3d spin);

    void Step(double h);

    TState Save(int ball);

    void Restore(int ball, in TState state);

    Vector3d Position(int ball);

    Vector3d Velocity(int ball);

    ulong Hash(int ball);
}
