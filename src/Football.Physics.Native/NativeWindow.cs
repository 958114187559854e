namespace FootballPhysics.Native;

/// <summary>A time interval in which a player can reach the ball.</summary>
internal unsafe struct NativeWindow
{
    /// <summary>The index of the player.</summary>
    public int Player;

    /// <summary>0.</summary>
    public int Reserved;

    /// <summary>The start, s since the launch of the ball.</summary>
    public double From;

    /// <summary>The end, s since the launch of the ball.</summary>
    public double To;

    /// <summary>The position of the ball's centre at the start, m.</summary>
    public fixed double Position[3];

    /// <summary>The velocity of the ball at the start, m/s.</summary>
    public fixed double Velocity[3];
}
