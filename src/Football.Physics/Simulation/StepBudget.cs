namespace FootballPhysics.Simulation;

/// <summary>The counters that bound the work of a ball's step (contact.md, Limits of the work).</summary>
/// <remarks>A step that is taken in several calls keeps the counters between the calls.</remarks>
internal struct StepBudget
{
    /// <summary>Pieces so far.</summary>
    public int Pieces;

    /// <summary>Evaluations of the forces in the earlier calls.</summary>
    public long Evaluations;

    /// <summary>Events in the earlier calls.</summary>
    public int Events;

    /// <summary>Splits at the jump in the drag law so far.</summary>
    public int Splits;

    /// <summary>Impacts so far.</summary>
    public int AllImpacts;

    /// <summary>Impacts that followed one another at about one instant.</summary>
    public int Quick;

    /// <summary>Instants at which the ball stayed on a surface after an impact.</summary>
    public int Stays;

    /// <summary>Time of the last of these instants, s.</summary>
    public double LastStay;

    /// <summary>Time of the last impact, s.</summary>
    public double LastImpact;

    /// <summary>Impacts that were resolved together and not reported one by one.</summary>
    public int MergedImpacts;

    /// <summary>Number of changes of the contact set, or of its modes, while several contacts are active.</summary>
    public int SetChanges;

    /// <summary>Pieces so far with several active contacts.</summary>
    public int SetPieces;

    /// <summary>Parts with velocity-level impulses so far.</summary>
    public int Parts;

    /// <summary>Parts shortened because a contact normal turns.</summary>
    public int Turns;

    /// <summary>Number of slide and roll events reported for a ball on several surfaces.</summary>
    public int Named;

    /// <summary>Number of times the ball has lost grip and started to slip.</summary>
    public int Slips;

    /// <summary>Number of times moving objects have started to squeeze the ball.</summary>
    public int Squeezes;

    /// <summary>Hits by moving objects so far.</summary>
    public int Hits;

    /// <summary>The speed of the ball at the start of the step, or after a later impact with another ball, m/s.</summary>
    public double Arrival;

    /// <summary>The speed that the fastest mover that has hit the ball in this step gives it, (1 + e) |V|, m/s.</summary>
    public double Fastest;

    /// <summary>Pieces that were shorter than the budget allows for all, to follow custom forces.</summary>
    public int ShortPieces;

    /// <summary>True if custom forces were not followed.</summary>
    public bool IsStiff;

    /// <summary>After this many events, a step of up to 0.25 s reports only rest, goals and squeezes, which are rare, and counts the
    /// others.</summary>
    private const int MostEvents = 20;
    private const double UsualStep = 0.25;

    /// <summary>True if an event is reported and not only counted.</summary>
    /// <param name="kind">The kind of the event.</param>
    /// <param name="before">The number of earlier events of the step.</param>
    /// <param name="length">Length of the step, s.</param>
    public static bool Reports(BallEventKind kind, int before, double length) =>
        before < MostEvents * Math.Max(1.0, length / UsualStep) || kind is BallEventKind.Rest or BallEventKind.Goal or BallEventKind.Pinned;
}
