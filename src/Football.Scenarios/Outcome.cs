namespace FootballPhysics.Scenarios;

/// <summary>What became of a shot.</summary>
public sealed record Outcome
{
    public required Moment Final { get; init; }

    public required IReadOnlyList<BallEvent> Events { get; init; }

    /// <summary>The ends of several balls; empty where there is one, whose end is <see cref="Final"/>.</summary>
    public IReadOnlyList<Moment> Balls { get; init; } = [];

    /// <summary>The paths of several balls, one each, one entry a step, launch first; empty where none were asked for.</summary>
    public IReadOnlyList<IReadOnlyList<Moment>> BallSamples { get; init; } = [];

    /// <summary>The impulse on the ball of an impact with something that has a mass, or of one ball among several with anything but the ground, N s; null for others.</summary>
    public Func<BallEvent, Vector3d?> ImpulseOf { get; init; } = _ => null;

    /// <summary>Greatest height of the centre, m; 0 where there are several balls.</summary>
    public required double Apex { get; init; }

    public required long Steps { get; init; }

    public required long Evaluations { get; init; }

    /// <summary>The path, one entry a step, launch first; null where none was asked for.</summary>
    public IReadOnlyList<Moment>? Samples { get; init; }

    /// <summary>How the end changes with the launch; null where that was not asked for.</summary>
    public LaunchDerivatives? Derivatives { get; init; }

    /// <summary>The name of what an event tells of; null for none.</summary>
    public required Func<int, string?> NameOf { get; init; }

    /// <summary>The name of what a ball meets in an event: a thing of the scene, or another ball; null for none.</summary>
    public string? SurfaceOf(in BallEvent item) => item.OtherBall >= 0 ? FormattableString.Invariant($"ball {item.OtherBall}") : NameOf(item.ColliderIndex);

    /// <summary>Impacts, those of events that were missed included.</summary>
    public required long Bounces { get; init; }

    /// <summary>Events that happened between those that were kept.</summary>
    public required long Missed { get; init; }
}
