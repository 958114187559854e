namespace FootballPhysics.Prediction;

/// <summary>How far to look ahead, and in which steps. It ends at the first of the conditions that are set.</summary>
public sealed record LookAheadRequest
{
    /// <summary>How long to look ahead at most, s. Above 0, at most 1e12; default 10.</summary>
    public double Duration { get; init; } = 10;

    /// <summary>
    /// Length of a step, s. Above 0, at least 1e-12 of the duration; default 0.08, which with RK4 is within a few micrometres of the
    /// truth. Through forces of a game's own, which may be stiffer than air, a step above 40 ms is divided until a step and its halves agree
    /// to 1 µm, and what no step can follow is refused. With the game's own integrator and step the prediction is the future bit for bit.
    /// </summary>
    public double TimeStep { get; init; } = 0.08;

    /// <summary>The event that ends it. Default <see cref="StopAt.Rest"/>.</summary>
    public StopAt StopAt { get; init; } = StopAt.Rest;

    /// <summary>A plane whose crossing ends it; default none.</summary>
    public Plane3d? UntilPlane { get; init; }

    /// <summary>
    /// A point that ends it once the ball has passed it: once it is further away over the ground than at its closest, recedes, and neither wind, spin nor
    /// things in the way can bring it back. Default none.
    /// </summary>
    public Vector3d? UntilPassing { get; init; }

    /// <summary>
    /// Moves the game's bodies (<see cref="Scene.Bodies"/>) to where they will be at a time, s: called with the time of the start and after every step.
    /// They are put back when the look-ahead is over. Default none: they go on as they go now.
    /// </summary>
    public Action<double>? MoveBodies { get; init; }

    /// <summary>Refuses steps that the ball's clock would not notice.</summary>
    internal void CheckClock(in BallState from) => Check.Advances("lookAhead.timeStep", TimeStep, from.Time + Duration);

    internal void Validate()
    {
        Check.Within("lookAhead.duration", Duration, 0, Limits.Time, exclusiveLow: true);
        Check.Within("lookAhead.timeStep", TimeStep, 0, Limits.Time, exclusiveLow: true);

        // At most 10¹² steps.
        Check.AtLeast("lookAhead.timeStep", TimeStep, Duration * 1e-12);
        Check.Defined("lookAhead.stopAt", StopAt, (int)StopAt, 3);
        UntilPlane?.Validate("lookAhead.untilPlane");
        if (UntilPassing is { } point)
        {
            Check.Place("lookAhead.untilPassing", point);
        }
    }
}
