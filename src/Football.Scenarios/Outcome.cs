namespace FootballPhysics.Scenarios;

/// <summary>The result of a shot.</summary>
public sealed record Outcome
{
    public required Moment Final { get; init; }

    public required IReadOnlyList<BallEvent> Events { get; init; }

    /// <summary>The final states of several balls; empty for one ball, whose final state is <see cref="Final"/>.</summary>
    public IReadOnlyList<Moment> Balls { get; init; } = [];

    /// <summary>The paths of several balls, with one entry per step, launch first; empty if not requested.</summary>
    public IReadOnlyList<IReadOnlyList<Moment>> BallSamples { get; init; } = [];

    /// <summary>Returns the impulse on the ball in an event, in N s; null for most events.</summary>
    /// <remarks>Single ball: impacts with objects that have a mass. Several balls: all impacts except those on the ground.</remarks>
    public Func<BallEvent, Vector3d?> ImpulseOf { get; init; } = _ => null;

    /// <summary>Returns the outputs of an impact.</summary>
    public Func<BallEvent, Impact> ImpactOf { get; init; } = _ => default;

    /// <summary>The greatest height of the ball's centre, in m; 0 for several balls.</summary>
    public required double Apex { get; init; }

    public required long Steps { get; init; }

    public required long Evaluations { get; init; }

    /// <summary>The path, with one entry per step, launch first; null if not requested.</summary>
    public IReadOnlyList<Moment>? Samples { get; init; }

    /// <summary>The derivatives of the final state with respect to the launch; null if not requested.</summary>
    public LaunchDerivatives? Derivatives { get; init; }

    /// <summary>The name of the collider or zone of an event; null if there is none.</summary>
    public required Func<int, string?> NameOf { get; init; }

    /// <summary>The name of the object that a ball hits in an event: an object of the scene or another ball; null if there is none.</summary>
    public string? SurfaceOf(in BallEvent item) => item.OtherBall >= 0 ? FormattableString.Invariant($"ball {item.OtherBall}") : NameOf(item.ColliderIndex);

    /// <summary>The number of impacts, including those of events that were dropped.</summary>
    public required long Bounces { get; init; }

    /// <summary>The number of dropped events. They happened between the kept ones.</summary>
    public required long Missed { get; init; }
}
