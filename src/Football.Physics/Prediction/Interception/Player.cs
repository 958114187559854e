namespace FootballPhysics.Prediction;

/// <summary>
/// A player who goes for the ball. Until his reaction time he goes on as he does; from there he can be anywhere within
/// D(s) = ½ a s² while s ≤ v/a, then v (s − v/2a), s being the time since.
/// </summary>
/// <remarks>He meets the ball when its horizontal distance from that place is no more than D and his reach together, and its height is within his.</remarks>
public readonly struct Player
{
    /// <summary>A player with the numbers of a fit adult.</summary>
    public Player()
    {
    }

    /// <summary>Where he is, m; components within ±1e6. Its height does not count.</summary>
    public Vector3d Position { get; init; }

    /// <summary>His velocity, m/s; speed at most 1000. Its vertical part does not count.</summary>
    public Vector3d Velocity { get; init; }

    /// <summary>Reaction time, s; not negative. Default 0.2.</summary>
    public double Reaction { get; init; } = 0.2;

    /// <summary>Acceleration, m/s²; above 0. Default 6.</summary>
    public double Acceleration { get; init; } = 6;

    /// <summary>Top speed, m/s; above 0, at most 1000. Default 8.</summary>
    public double Speed { get; init; } = 8;

    /// <summary>How far from him he can play the ball, horizontally, m; not negative. Default 0.6.</summary>
    public double Reach { get; init; } = 0.6;

    /// <summary>Least height of the ball's centre at which he can play it, m. Default 0.</summary>
    public double MinimumHeight { get; init; }

    /// <summary>Greatest such height, m: 0.6 with the foot, 2.3 with the head, 2.7 with a keeper's hands. Default 2.3.</summary>
    public double MaximumHeight { get; init; } = 2.3;

    /// <summary>A copy with another reaction time, s, and with so much more reach, m.</summary>
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

    /// <summary>Refuses numbers out of range.</summary>
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
