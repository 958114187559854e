namespace FootballPhysics.Tracks;

/// <summary>Result of the fit of a match: its pieces in order of time, and the numbers of which one value holds for all of it.</summary>
public sealed class MatchFitResult
{
    private readonly double[] _values;
    private readonly double[] _deviations;

    internal MatchFitResult(IReadOnlyList<MatchPiece> pieces, IReadOnlyList<string> names, double[] values, double[] deviations, Scene scene)
    {
        Pieces = pieces;
        Names = names;
        _values = values;
        _deviations = deviations;
        Scene = scene;
    }

    /// <summary>The pieces, in order of time.</summary>
    public IReadOnlyList<MatchPiece> Pieces { get; }

    /// <summary>Names of the numbers that were found: wind.x, wind.z (m/s), drag (a factor), crisis (a Reynolds number), lift (a factor), groundHeight (m), restitution, restitutionRise, friction (of impacts), slidingFriction, rollingFriction, rollingFrictionBySpeed (s/m); the last three only if the ball slid or rolled untouched.</summary>
    public IReadOnlyList<string> Names { get; }

    /// <summary>The scene with all numbers that were found.</summary>
    public Scene Scene { get; }

    /// <summary>Root of the mean square over all points in flights of 0.3 s and longer, m; 0 where there is none.</summary>
    public double Rms { get; internal init; }

    /// <summary>Flights of 0.3 s and longer.</summary>
    public int Flights { get; internal init; }

    /// <summary>The share of the points more than 0.5 m over the ground that are in those flights; 1 where there is no such point.</summary>
    public double Covered { get; internal init; }

    /// <summary>Standard deviation of the track's coordinates from one point to the next, m.</summary>
    public double Noise { get; internal init; }

    /// <summary>Impacts that the surface was found from.</summary>
    public int Impacts { get; internal init; }

    /// <summary>The times in which the ball slid or rolled untouched, in order, with the resistance of the ground in each; none if the surface was not asked for.</summary>
    public IReadOnlyList<GroundWindow> Windows { get; internal init; } = [];

    /// <summary>Mean speed of the windows in which the ball rolls, m/s: there c₀ + c₁ v is known best. 0 if there are none.</summary>
    public double RollingSpeed { get; internal init; }

    /// <summary>Standard deviation of c₀ + c₁ v at <see cref="RollingSpeed"/>; those of c₀ and c₁ alone are larger, as one makes up for the other.</summary>
    public double RollingDeviation { get; internal init; }

    /// <summary>A number.</summary>
    /// <param name="index">Which of <see cref="Names"/>, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="index"/> is out of range.</exception>
    public double Value(int index)
    {
        Check.Index(nameof(index), index, Names.Count);
        return _values[index];
    }

    /// <summary>Standard deviation of a number: by the scatter of the distances and how long they stay on one side.</summary>
    /// <param name="index">Which of <see cref="Names"/>, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="index"/> is out of range.</exception>
    public double StandardError(int index)
    {
        Check.Index(nameof(index), index, Names.Count);
        return _deviations[index];
    }
}
