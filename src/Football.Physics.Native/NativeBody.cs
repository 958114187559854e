namespace FootballPhysics.Native;

/// <summary>A body that your game moves: a player, a foot, a head, a keeper's hand.</summary>
internal unsafe struct NativeBody
{
    /// <summary>Position, m; components within ±1e6.</summary>
    public fixed double Position[3];

    /// <summary>Orientation, body to world, a quaternion x, y, z, w of any length except 0.</summary>
    public fixed double Orientation[4];

    /// <summary>Velocity, m/s; at most 1000. A ball that hits a body with a mass changes it until you move the body again.</summary>
    public fixed double Velocity[3];

    /// <summary>Spin about the position, rad/s; at most 10 000.</summary>
    public fixed double Spin[3];

    /// <summary>The time of the position, s: the time of the balls before the step. The next step fails if they differ by more than 0.25 s.</summary>
    public double Time;

    /// <summary>The impulse of the balls on the body in the last step, N s: the sum over its reported impacts. fp_match_move_bodies ignores it.</summary>
    public fixed double Impulse[3];

    /// <summary>1 if the body is in play; 0 if it is withdrawn, so that no ball hits it. A body is at the origin and in play until you move it.</summary>
    public int InPlay;

    /// <summary>0.</summary>
    public int Reserved;
}
