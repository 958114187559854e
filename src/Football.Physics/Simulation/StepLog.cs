namespace Football.Physics;

/// <summary>What a step or a run reports beside the state: events in order, and counts. One a ball (or a thread); reused.</summary>
public sealed class StepLog
{
    /// <summary>Makes an empty log.</summary>
    /// <param name="eventCapacity">Events to make room for, at least 1; default 32. It grows when one step has more.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="eventCapacity"/> is below 1.</exception>
    public StepLog(int eventCapacity = 32) => Events = new EventBuffer(eventCapacity);

    /// <summary>The events since the last <see cref="Clear"/>, in order.</summary>
    public EventBuffer Events { get; }

    /// <summary>Integrated pieces of motion: one a step, and one more for every event or split inside it.</summary>
    public long Steps { get; internal set; }

    /// <summary>Right-hand sides evaluated, those spent on locating events included.</summary>
    public long Evaluations { get; internal set; }

    /// <summary>
    /// Those of the <see cref="Steps"/> that relaxed to the balance of forces, because the air is so much stronger than the ball's
    /// inertia that a step would have to be divided into thousands of parts. 0 for anything like a football.
    /// </summary>
    public long Relaxed { get; internal set; }

    /// <summary>Whether the step ended early at the event asked for.</summary>
    internal bool Halted { get; set; }

    /// <summary>The event at which steps end early.</summary>
    internal StopAt StopAt { get; set; }

    /// <summary>Watches every piece of motion; null costs nothing.</summary>
    internal PieceObserver? Observer { get; set; }

    /// <summary>Forgets events and counts.</summary>
    public void Clear()
    {
        Events.Clear();
        Steps = 0;
        Evaluations = 0;
        Relaxed = 0;
        Halted = false;
    }
}
