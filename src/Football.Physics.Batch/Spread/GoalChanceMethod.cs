namespace FootballPhysics.Batch;

/// <summary>How a scatter was found.</summary>
public enum GoalChanceMethod
{
    /// <summary>By the derivatives of one kick: the spread is so small that its ellipse is the kick's own, mapped to the plane.</summary>
    Derivatives,

    /// <summary>By many kicks that were flown.</summary>
    Flights,
}
