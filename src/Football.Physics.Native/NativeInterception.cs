namespace FootballPhysics.Native;

/// <summary>The player who reaches the ball first.</summary>
internal unsafe struct NativeInterception
{
    /// <summary>The index of the player; -1 if nobody reaches the ball, and the other numbers are then 0.</summary>
    public int Player;

    /// <summary>0.</summary>
    public int Reserved;

    /// <summary>The time at which he reaches the ball, s since its launch.</summary>
    public double Time;

    /// <summary>His lead over the second player, s; infinite if no other player reaches the ball.</summary>
    public double Margin;

    /// <summary>The position of the ball's centre then, m.</summary>
    public fixed double Position[3];

    /// <summary>The velocity of the ball then, m/s.</summary>
    public fixed double Velocity[3];
}
