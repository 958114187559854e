namespace FootballPhysics.Native;

/// <summary>An event of one of the balls of a match.</summary>
internal unsafe struct NativeMatchEvent
{
    /// <summary>The event. fp_match_name writes the name of its object.</summary>
    public NativeEvent Event;

    /// <summary>The index of the ball.</summary>
    public int Ball;

    /// <summary>The index of the other ball in an impact of two balls; otherwise -1.</summary>
    public int OtherBall;

    /// <summary>The index of the body that the ball hit or touches; otherwise -1.</summary>
    public int Body;

    /// <summary>0.</summary>
    public int Reserved;

    /// <summary>The impulse on the ball in an impact, N s; zero for other events. The other object received the opposite impulse.</summary>
    public fixed double Impulse[3];

    /// <summary>The energy that a bumper added to the ball, J; otherwise 0.</summary>
    public double AddedEnergy;
}
