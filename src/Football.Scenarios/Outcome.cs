namespace FootballPhysics.Scenarios;

/// <summary>The result of a shot.</summary>
public sealed record Outcome
{
    public required Moment Final { get; init; }

    public required IReadOnlyList<BallEvent> Events { get; init; }

    /// <summary>The ends of several balls; empty where there is one, whose end is <see cref="Final"/>.</summary>
    public IReadOnlyList<Moment> Balls { get; init; } = [];

    /// <summary>The paths of several balls, with one entry per step, launch first; empty if not requested.</summary>
    public IReadOnlyList<IReadOnlyList<Moment>> BallSamples { get; init; } = [];

    /// <summary>The impulse on the ball of an impact with something that has a mass, or of one ball among several with anything but the ground, N s; null for others.</summary>
    public Func<BallEvent, Vector3d?> ImpulseOf { get; init; } = _ => null;

    /// <summary>The greatest height of the centre, m; 0 for several balls.</summary>
    public required double Apex { get; init; }

    public required long Steps { get; init; }

    public required long Evaluations { get; init; }

    /// <summary>The path, with one entry per step, launch first; null if not requested.</summary>
    public IReadOnlyList<Moment>? Samples { get; init; }

    /// <summary>The derivatives of the end by the launch; null if not requested.</summary>
    public LaunchDerivatives? Derivatives { get; init; }

    /// <summary>The name of the collider or zone of an event; null if there is none.</summary>
    public required Func<int, string?> NameOf { get; init; }

    /// <summary>The name of the object that a ball hits in an event: an object of the scene or another ball; null if there is none.</summary>
    public string? SurfaceOf(in BallEvent item) => item.OtherBall >= 0 ? FormattableString.Invariant($"ball {item.OtherBall}") : NameOf(item.ColliderIndex);

    /// <summary>Impacts, those of events that were missed included.</summary>
    public required long Bounces { get; init; }

    /// <summary>Events that happened between those that were kept.</summary>
    public required long Missed { get; init; }
}
