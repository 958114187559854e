using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>A kick, the spread of a player's kicks, a goal, and the number of kicks to simulate.</summary>
public sealed record GoalChanceRequest
{
    /// <summary>The maximum number of kicks.</summary>
    internal const int MostKicks = 100_000_000;

    /// <summary>The maximum number of kicks that are simulated one by one.</summary>
    internal const int MostAlone = 1000;

    /// <summary>The position of the ball, in m; components within ±1e6.</summary>
    public required Vector3d Position { get; init; }

    /// <summary>The intended velocity, in m/s; at most 1000, not vertical.</summary>
    public required Vector3d Velocity { get; init; }

    /// <summary>The intended spin, in rad/s; at most 10 000, default 0.</summary>
    public Vector3d Spin { get; init; }

    /// <summary>The orientation of the ball at the kick; it is normalised. Default null: that of a launch without one (<see cref="Simulator.LaunchOrientation"/>).</summary>
    /// <remarks>Only the knuckle force depends on it.</remarks>
    public Quaterniond? Orientation { get; init; }

    /// <summary>The spread of the player's kicks.</summary>
    public required KickSpread Spread { get; init; }

    /// <summary>The goal.</summary>
    public required Goal Goal { get; init; }

    /// <summary>The goalkeeper at the time of the kick, with the reach and heights of his dive; default none.</summary>
    public Player? Keeper { get; init; }

    /// <summary>The number of kicks to simulate if derivatives are not accurate. 2 … 100 000 000; default 2000.</summary>
    /// <remarks>A kick takes 2 to 6 µs; kicks near the frame of the goal take longest. The error falls at least in proportion to the inverse square root of the
    /// number. With <see cref="ForceSet.KnuckleSeed"/>, at most 1000 can be simulated.</remarks>
    public int Kicks { get; init; } = GoalChance.Flights;

    /// <summary>The seed of the random kicks; default 0. Equal seeds give equal kicks.</summary>
    public long Seed { get; init; }

    /// <summary>True to simulate even if derivatives are accurate; default false.</summary>
    public bool AlwaysSimulate { get; init; }

    internal void Validate()
    {
        Check.Given(nameof(Spread), Spread);
        Check.Given(nameof(Goal), Goal);
        Check.Within("goalChance.kicks", Kicks, 2, MostKicks);
    }
}
