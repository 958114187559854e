namespace FootballPhysics.Simulation;

/// <summary>What is known of the rest of a step as a single piece.</summary>
internal enum WholeStep
{
    /// <summary>Not tried yet.</summary>
    Untried,

    /// <summary>Not taken, because the step may have to be divided.</summary>
    NotTaken,

    /// <summary>Not taken, because an object is near. A flight in the rest of the step is not tried either.</summary>
    Near,

    /// <summary>Integrated, but it contains an event. The ball has not moved.</summary>
    Ends,

    /// <summary>Taken without an event. The ball has moved.</summary>
    Done,
}
