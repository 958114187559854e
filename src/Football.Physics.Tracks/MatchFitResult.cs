using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>The result of a match fit: the pieces in order of time, and the shared parameters.</summary>
public sealed class MatchFitResult
{
    private readonly Estimate[] _estimates;

    internal MatchFitResult(IReadOnlyList<MatchPiece> pieces, Estimate[] estimates, Scene scene)
    {
        Pieces = pieces;
        _estimates = estimates;
        Names = [.. estimates.Select(estimate => estimate.Name)];
        Scene = scene;
    }

    /// <summary>The pieces, in order of time.</summary>
    public IReadOnlyList<MatchPiece> Pieces { get; }

    /// <summary>The names of the estimated parameters.</summary>
    /// <remarks>
    /// Wind and ball: wind.x, wind.z (m/s), drag (a factor), crisis (a Reynolds number), lift (a factor). Ground: groundHeight (m), restitution,
    /// restitutionRise, friction (of impacts), slidingFriction, rollingFriction, rollingFrictionBySpeed (s/m). The last three are present only if the
    /// ball slid or rolled untouched.
    /// </remarks>
    public IReadOnlyList<string> Names { get; }

    /// <summary>The answers that are reliable to within their standard deviations.</summary>
    /// <remarks>
    /// Launches need a deviation of at most 1 m/s, and spins of at most 20 rad/s, in a fifth of the flights. None is reliable if
    /// <see cref="Suspicions"/> names a fault that could not be removed.
    /// </remarks>
    public MatchAnswers GoodFor => Verdict.Answers;

    /// <summary>The suspected faults of the track. Lines and held points were left out; the others make all answers unreliable.</summary>
    public TrackSuspicions Suspicions => Verdict.Suspicions;

    /// <summary>The verdict in words: the reliable answers, and what to check.</summary>
    public string Explanation => Verdict.Explanation;

    internal MatchVerdict Verdict { get; set; } = null!;

    /// <summary>The scene with all estimated parameters.</summary>
    public Scene Scene { get; }

    /// <summary>The root mean square of the residuals in flights of 0.3 s or longer, in m.</summary>
    /// <remarks>0 if there are no such flights.</remarks>
    public double Rms { get; internal init; }

    /// <summary>The number of flights of 0.3 s or longer.</summary>
    public int Flights { get; internal init; }

    /// <summary>The share of the points above 0.5 m that belong to flights of 0.3 s or longer.</summary>
    /// <remarks>1 if there are no such points.</remarks>
    public double Covered { get; internal init; }

    /// <summary>The standard deviation of the track's coordinates from one point to the next, in m.</summary>
    public double Noise { get; internal init; }

    /// <summary>The number of impacts from which the surface was estimated.</summary>
    public int Impacts { get; internal init; }

    /// <summary>The intervals in which the ball slid or rolled untouched, in order, with the resistance in each.</summary>
    /// <remarks>Empty if the surface was not requested.</remarks>
    public IReadOnlyList<GroundWindow> Windows { get; internal init; } = [];

    /// <summary>The mean speed of the rolling intervals, in m/s, at which c₀ + c₁ v is most accurate.</summary>
    /// <remarks>0 if there are no rolling intervals.</remarks>
    public double RollingSpeed { get; internal init; }

    /// <summary>The standard deviation of c₀ + c₁ v at <see cref="RollingSpeed"/>.</summary>
    /// <remarks>The standard deviations of c₀ and c₁ alone are larger, because the two are correlated.</remarks>
    public double RollingDeviation { get; internal init; }

    /// <summary>Returns the value of a parameter.</summary>
    /// <param name="index">The index in <see cref="Names"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="index"/> is out of range.</exception>
    public double Value(int index)
    {
        Check.Index(nameof(index), index, Names.Count);
        return _estimates[index].Value;
    }

    /// <summary>Returns the standard error of a parameter, from the scatter of the residuals and their autocorrelation.</summary>
    /// <param name="index">The index in <see cref="Names"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="index"/> is out of range.</exception>
    public double StandardError(int index)
    {
        Check.Index(nameof(index), index, Names.Count);
        return _estimates[index].Deviation;
    }
}

/// <summary>An estimated parameter of a match.</summary>
internal readonly record struct Estimate(string Name, double Value, double Deviation);
