namespace FootballPhysics;

/// <summary>Something that happens to one ball, or to two.</summary>
internal readonly struct Happening(double time, int ball, int other)
{
    public readonly double Time = time;
    public readonly int Ball = ball;

    /// <summary>The other ball, or none.</summary>
    public readonly int Other = other;

    /// <summary>No other ball.</summary>
    public const int NoOther = -1;

    /// <summary>Nothing, ever.</summary>
    public static Happening None => new(double.PositiveInfinity, NoOther, NoOther);

    /// <summary>True when two balls meet.</summary>
    public bool IsMeeting => Other != NoOther;

    /// <summary>The earlier of two events. At one time that which is asked first: that of the ball of the lower number, its meetings with others first, that with the lowest before.</summary>
    public static Happening Earlier(in Happening next, in Happening first) => next.Time < first.Time ? next : first;
}
