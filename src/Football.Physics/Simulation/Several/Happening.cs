namespace FootballPhysics.Simulation;

/// <summary>An event of one ball, or a contact of two.</summary>
internal readonly struct Happening(double time, int ball, int other)
{
    public readonly double Time = time;
    public readonly int Ball = ball;

    /// <summary>The other ball, or <see cref="NoOther"/>.</summary>
    public readonly int Other = other;

    /// <summary>No other ball.</summary>
    public const int NoOther = -1;

    /// <summary>No event: its time is infinite.</summary>
    public static Happening None => new(double.PositiveInfinity, NoOther, NoOther);

    /// <summary>True if two balls touch.</summary>
    public bool IsMeeting => Other != NoOther;

    /// <summary>Returns the earlier of two events; if they are simultaneous, <paramref name="first"/>.</summary>
    /// <remarks>The search runs in the order of ball indices; for each ball, contacts with other balls come first, in the order of their indices.</remarks>
    public static Happening Earlier(in Happening next, in Happening first) => next.Time < first.Time ? next : first;
}
