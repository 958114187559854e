namespace FootballPhysics.Native;

/// <summary>A model of a player who runs to the ball. fp_player_default sets the numbers of a fit adult.</summary>
internal unsafe struct NativePlayer
{
    /// <summary>Position, m; components within ±1e6. Its height is ignored.</summary>
    public fixed double Position[3];

    /// <summary>Velocity, m/s; speed at most 1000. Its vertical part is ignored.</summary>
    public fixed double Velocity[3];

    /// <summary>The reaction time, s; 0 or more. Until then, he keeps his velocity.</summary>
    public double Reaction;

    /// <summary>The acceleration, m/s^2; above 0.</summary>
    public double Acceleration;

    /// <summary>The top speed, m/s; above 0, at most 1000.</summary>
    public double Speed;

    /// <summary>The maximum horizontal distance at which he can play the ball, m; 0 or more.</summary>
    public double Reach;

    /// <summary>The minimum height of the ball's centre that he can play, m.</summary>
    public double MinimumHeight;

    /// <summary>The maximum height of the ball's centre that he can play, m: about 0.6 with the foot, 2.3 with the head, 2.7 with a keeper's hands.</summary>
    public double MaximumHeight;
}
