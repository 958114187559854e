namespace FootballPhysics.Batch;

/// <summary>The method that computed a spread.</summary>
public enum GoalChanceMethod
{
    /// <summary>The derivatives of one kick: the spread is small enough to be mapped linearly to the plane.</summary>
    Derivatives,

    /// <summary>The simulation of many random kicks.</summary>
    Flights,
}
