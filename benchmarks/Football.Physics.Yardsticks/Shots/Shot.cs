namespace FootballPhysics.Yardsticks;

/// <summary>One launch: where from, how fast, with what spin (SI units).</summary>
public readonly record struct Shot(Vector3d Position, Vector3d Velocity, Vector3d Spin)
{
    /// <summary>A football on the ground, where the pitch has its origin.</summary>
    public static Vector3d Spot { get; } = new(0, BallProperties.Tunnel.Radius, 0);

    /// <summary>The same shot from another height of the centre, m.</summary>
    public Shot From(double height) => this with { Position = new Vector3d(Position.X, height, Position.Z) };
}
