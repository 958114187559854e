namespace FootballPhysics;

/// <summary>The counters that bound a ball's step (contacts.md, Bounds). A step that is taken in several calls carries them from one call to the next.</summary>
internal struct StepBudget
{
    /// <summary>Pieces so far.</summary>
    public int Pieces;

    /// <summary>Evaluations of the forces so far.</summary>
    public long Evaluations;

    /// <summary>Events so far.</summary>
    public int Events;

    /// <summary>Splits at the drag law's jump so far.</summary>
    public int Splits;

    /// <summary>Impacts so far.</summary>
    public int AllImpacts;

    /// <summary>Impacts since time last advanced.</summary>
    public int Impacts;

    /// <summary>Impacts that were solved together and not reported one by one.</summary>
    public int Untold;

    /// <summary>The number of times that the contacts, or their modes, have changed while several of them bear the ball.</summary>
    public int SetChanges;

    /// <summary>Pieces so far in which several contacts bear the ball.</summary>
    public int SetPieces;

    /// <summary>Parts with velocity-level impulses so far.</summary>
    public int Parts;

    /// <summary>Parts so far that are shorter because a normal turns.</summary>
    public int Turns;

    /// <summary>The number of times that a ball on several surfaces was reported to slide or roll.</summary>
    public int Named;

    /// <summary>The number of times that the ball has begun to slip because its carrier could not hold it.</summary>
    public int Slips;

    /// <summary>The number of times that moving objects have begun to squeeze the ball.</summary>
    public int Squeezes;

    /// <summary>Hits by moving objects in quick succession.</summary>
    public int Hits;

    /// <summary>The time of the last of them, s.</summary>
    public double LastHit;

    /// <summary>After so many events a step of up to a quarter of a second reports only rest, goals and squeezes one by one, which are few; it counts the others.</summary>
    private const int MostEvents = 20;
    private const double UsualStep = 0.25;

    /// <summary>True if an event is reported one by one.</summary>
    /// <param name="kind">The kind of the event.</param>
    /// <param name="before">The number of events of the step before it.</param>
    /// <param name="length">Length of the step, s.</param>
    public static bool Reports(BallEventKind kind, int before, double length) =>
        before < MostEvents * Math.Max(1.0, length / UsualStep) || kind is BallEventKind.Rest or BallEventKind.Goal or BallEventKind.Pinned;

    /// <summary>The counters at the start of a step.</summary>
    public static StepBudget New => new() { LastHit = double.NegativeInfinity };
}
