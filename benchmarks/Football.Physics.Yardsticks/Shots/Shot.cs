namespace FootballPhysics.Yardsticks;

/// <summary>One launch: position, velocity and spin (SI units).</summary>
public readonly record struct Shot(Vector3d Position, Vector3d Velocity, Vector3d Spin)
{
    /// <summary>The centre of a football on the ground at the origin of the pitch.</summary>
    public static Vector3d Spot { get; } = new(0, BallProperties.Tunnel.Radius, 0);

    /// <summary>Returns the same shot from another height of the centre, m.</summary>
    public Shot From(double height) => this with { Position = new Vector3d(Position.X, height, Position.Z) };
}
