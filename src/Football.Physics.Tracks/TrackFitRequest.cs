namespace FootballPhysics.Tracks;

/// <summary>A request for a fit: the numbers to find from a track beside the launch, and what is known of them before.</summary>
public sealed record TrackFitRequest
{
    /// <summary>True to find by how much the drag differs from the scene's law. Default false.</summary>
    public bool Drag { get; init; }

    /// <summary>True to find by how much the Magnus force differs from the scene's law. Default false.</summary>
    public bool Lift { get; init; }

    /// <summary>True to find by how much the ground's normal restitution differs. Default false.</summary>
    public bool Restitution { get; init; }

    /// <summary>True to find by how much the ground's friction, at impacts and in slides, differs. Default false.</summary>
    public bool Friction { get; init; }

    /// <summary>The velocity to begin with, m/s; default the one that the first points suggest.</summary>
    public Vector3d? Velocity { get; init; }

    /// <summary>The spin to begin with, which is also the likeliest before the track was seen, rad/s; default none.</summary>
    public Vector3d Spin { get; init; }

    /// <summary>Standard deviation of each component of the spin before the track was seen, rad/s: a track tells little of a spin along the way. Above 0; default 60.</summary>
    public double SpinDeviation { get; init; } = 60;

    /// <summary>Standard deviation of the factors of drag, lift, restitution and friction, about 1, before the track was seen. Above 0; default 0.3.</summary>
    public double FactorDeviation { get; init; } = 0.3;

    /// <summary>
    /// Other balls that it may have been: the fit is made with each of them too, for <see cref="TrackFitResult.DeviationOverBalls"/>. Deviations of one fit are those of the noise
    /// alone: with a wrong ball they are four to twelve times too small. Default none.
    /// </summary>
    public IReadOnlyList<BallProperties> OtherBalls { get; init; } = [];

    /// <summary>Length of a step, s. 1e-4 … 0.1; default 0.02.</summary>
    public double TimeStep { get; init; } = 0.02;

    internal void Validate()
    {
        if (Velocity is { } velocity)
        {
            Check.Size("fit.velocity", velocity, Limits.Speed, "m/s");
        }

        Check.Size("fit.spin", Spin, Limits.Spin, "rad/s");
        Check.Positive("fit.spinDeviation", SpinDeviation);
        Check.Positive("fit.factorDeviation", FactorDeviation);
        Check.Within("fit.timeStep", TimeStep, 1e-4, 0.1);
        Check.Member("fit.otherBalls", OtherBalls);
        for (int i = 0; i < OtherBalls.Count; i++)
        {
            Check.GivenItem("fit.otherBalls", i, OtherBalls[i], "a ball");
            OtherBalls[i].Validate();
        }
    }
}

/// <summary>Where a camera saw a ball.</summary>
public readonly struct TrackPoint
{
    /// <summary>A point of a track.</summary>
    /// <param name="time">When, s.</param>
    /// <param name="position">Where the centre was seen, m.</param>
    /// <param name="noise">Standard deviation of each coordinate, m.</param>
    public TrackPoint(double time, Vector3d position, double noise = 0.02)
    {
        Time = time;
        Position = position;
        Noise = noise;
    }

    /// <summary>When, s.</summary>
    public double Time { get; }

    /// <summary>Where the centre was seen, m.</summary>
    public Vector3d Position { get; }

    /// <summary>Standard deviation of each coordinate, m.</summary>
    public double Noise { get; }
}
