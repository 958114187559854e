namespace FootballPhysics.Tracks;

/// <summary>A request for the fit of a whole match: which numbers are found of which one value holds for the whole track, and how far each may be off what the scene says.</summary>
public sealed record MatchFitRequest
{
    /// <summary>True to find the wind, level and steady. Default true.</summary>
    public bool Wind { get; init; } = true;

    /// <summary>True to find the ball's drag: a factor, and with the measured laws the Reynolds number of its crisis. Default true.</summary>
    public bool Drag { get; init; } = true;

    /// <summary>True to find the Reynolds number of the drag crisis where <see cref="Drag"/> is not asked for. Measured laws alone. Default false.</summary>
    public bool Crisis { get; init; }

    /// <summary>True to find a factor of the Magnus force. Default false: it is known only together with each flight's spin.</summary>
    public bool Lift { get; init; }

    /// <summary>True to find the surface: restitution, its rise with obliqueness, friction. Default true.</summary>
    public bool Surface { get; init; } = true;

    /// <summary>True to find the height of the ground. Default true; else it is the scene's.</summary>
    public bool Height { get; init; } = true;

    /// <summary>Standard deviation of each component of the wind before the track was seen, m/s. Above 0; default 3.</summary>
    public double WindDeviation { get; init; } = 3;

    /// <summary>Standard deviation of the factors of drag and lift, about 1, before the track was seen. Above 0; default 0.3.</summary>
    public double FactorDeviation { get; init; } = 0.3;

    /// <summary>Standard deviation of the Reynolds number of the drag crisis before the track was seen. Above 0; default 40 000.</summary>
    public double CrisisDeviation { get; init; } = 40_000;

    /// <summary>Standard deviation of each component of a flight's spin before the track was seen, rad/s. Above 0; default 40.</summary>
    public double SpinDeviation { get; init; } = 40;

    internal void Validate()
    {
        Check.Positive("match.windDeviation", WindDeviation);
        Check.Positive("match.factorDeviation", FactorDeviation);
        Check.Positive("match.crisisDeviation", CrisisDeviation);
        Check.Positive("match.spinDeviation", SpinDeviation);
    }
}
