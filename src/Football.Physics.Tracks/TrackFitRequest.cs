using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>A request for a track fit: the parameters to estimate besides the launch, and their priors.</summary>
public sealed record TrackFitRequest
{
    /// <summary>True to estimate a factor of the drag relative to the scene's law. Default false.</summary>
    public bool Drag { get; init; }

    /// <summary>True to estimate a factor of the Magnus force relative to the scene's law. Default false.</summary>
    public bool Lift { get; init; }

    /// <summary>True to estimate a factor of the ground's normal restitution. Default false.</summary>
    public bool Restitution { get; init; }

    /// <summary>True to estimate a factor of the ground's friction, at impacts and in slides. Default false.</summary>
    public bool Friction { get; init; }

    /// <summary>The initial velocity of the search, in m/s; default: an estimate from the first points.</summary>
    public Vector3d? Velocity { get; init; }

    /// <summary>The initial spin of the search and its prior mean, in rad/s; default 0.</summary>
    public Vector3d Spin { get; init; }

    /// <summary>The prior standard deviation of each component of the spin, in rad/s. Above 0; default 60.</summary>
    /// <remarks>A track reveals little about spin along the velocity.</remarks>
    public double SpinDeviation { get; init; } = 60;

    /// <summary>The prior standard deviation of the factors of drag, lift, restitution and friction, whose prior mean is 1. Above 0; default 0.3.</summary>
    public double FactorDeviation { get; init; } = 0.3;

    /// <summary>True if the launch is on the ground. Default false.</summary>
    /// <remarks>The height of the launch is then that of contact, to 1 cm. From the pixels of one camera, this gives the depth of a flight without a bounce.</remarks>
    public bool FromGround { get; init; }

    /// <summary>The scale of the prior of the launch's height above contact, a Cauchy distribution, in m; infinite for none.</summary>
    internal double HeightScale { get; init; } = double.PositiveInfinity;

    /// <summary>The standard deviation of a normal prior of that height instead, for starts of searches, in m; infinite for none.</summary>
    internal double HeightDeviation { get; init; } = double.PositiveInfinity;

    /// <summary>Other balls that could be the tracked ball. Default none.</summary>
    /// <remarks>
    /// The fit is repeated with each of them, for <see cref="TrackFitResult.DeviationOverBalls"/>. The standard errors of a single fit contain only
    /// the noise: with a wrong ball they are four to twelve times too small.
    /// </remarks>
    public IReadOnlyList<BallProperties> OtherBalls { get; init; } = [];

    /// <summary>The length of a step, in s. 1e-4 … 0.1; default 0.02.</summary>
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

/// <summary>An observed position of a ball.</summary>
public readonly struct TrackPoint
{
    /// <summary>Creates a point of a track.</summary>
    /// <param name="time">The time, in s.</param>
    /// <param name="position">The observed position of the centre, in m.</param>
    /// <param name="noise">The standard deviation of each coordinate, in m; default 0.02.</param>
    public TrackPoint(double time, Vector3d position, double noise = 0.02)
    {
        Time = time;
        Position = position;
        Noise = noise;
    }

    /// <summary>The time, in s.</summary>
    public double Time { get; }

    /// <summary>The observed position of the centre, in m.</summary>
    public Vector3d Position { get; }

    /// <summary>The standard deviation of each coordinate, in m.</summary>
    public double Noise { get; }

    /// <summary>Checks the points of a track: their number, the order of their times, and their ranges.</summary>
    internal static void Validate(TrackPoint[] track, int fewest, Action<string, double> noise)
    {
        Check.AtLeast("track's points", track.Length, fewest);
        for (int i = 0; i < track.Length; i++)
        {
            string at = Check.Item("track", i);
            Check.Within(at + ".time", track[i].Time, i > 0 ? track[i - 1].Time : -Limits.Time, Limits.Time);
            Check.Place(at + ".position", track[i].Position);
            noise(at + ".noise", track[i].Noise);
        }
    }
}
