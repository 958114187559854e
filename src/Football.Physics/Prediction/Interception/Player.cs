using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>A model of a player who runs to the ball, with a reaction time, an acceleration and a top speed.</summary>
/// <remarks>
/// He keeps his velocity until his reaction time. From his position at that time, he can reach any position within a distance D(s). Here s is the time since
/// the reaction, and D(s) = ½ a s² while s ≤ v/a, then v (s − v/2a). He can reach the ball when its horizontal distance from that starting position is at most
/// D plus his reach, and its height is between his limits.
/// </remarks>
public readonly struct Player
{
    /// <summary>Creates a player with the values of a fit adult.</summary>
    public Player()
    {
    }

    /// <summary>The position, in m; components within ±1e6. Its height is ignored.</summary>
    public Vector3d Position { get; init; }

    /// <summary>The velocity, in m/s; speed at most 1000. Its vertical part is ignored.</summary>
    public Vector3d Velocity { get; init; }

    /// <summary>The reaction time, in s; not negative. Default 0.2.</summary>
    public double Reaction { get; init; } = 0.2;

    /// <summary>The acceleration, in m/s²; above 0. Default 6.</summary>
    public double Acceleration { get; init; } = 6;

    /// <summary>The top speed, in m/s; above 0, at most 1000. Default 8.</summary>
    public double Speed { get; init; } = 8;

    /// <summary>The maximum horizontal distance at which he can play the ball, in m; not negative. Default 0.6.</summary>
    public double Reach { get; init; } = 0.6;

    /// <summary>The minimum height of the ball's centre that he can play, in m. Default 0.</summary>
    public double MinimumHeight { get; init; }

    /// <summary>The maximum height of the ball's centre that he can play, in m. Default 2.3.</summary>
    /// <remarks>Typical values: 0.6 with the foot, 2.3 with the head, 2.7 with a keeper's hands.</remarks>
    public double MaximumHeight { get; init; } = 2.3;

    /// <summary>Returns a copy with another reaction time, in s, and additional reach, in m.</summary>
    internal Player Reacting(double reaction, double further = 0) => new()
    {
        Position = Position,
        Velocity = Velocity,
        Reaction = reaction,
        Acceleration = Acceleration,
        Speed = Speed,
        Reach = Reach + further,
        MinimumHeight = MinimumHeight,
        MaximumHeight = MaximumHeight,
    };

    /// <summary>Throws if a number is out of range.</summary>
    internal void Validate()
    {
        Check.Place("runner.position", Position);
        Check.Size("runner.velocity", Velocity, Limits.Speed, "m/s");
        Check.Within("runner.reaction", Reaction, 0, Limits.Time);
        Check.Positive("runner.acceleration", Acceleration);
        Check.Within("runner.speed", Speed, 0, Limits.Speed, exclusiveLow: true);
        Check.Within("runner.reach", Reach, 0, Limits.Length);
        Check.Within("runner.heights[0]", MinimumHeight, -Limits.Length, Limits.Length);
        Check.Within("runner.heights[1]", MaximumHeight, MinimumHeight, Limits.Length);
    }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant($"player at {Position:0.###}, {Velocity:0.###} m/s, up to {Speed:0.###} m/s");
}
