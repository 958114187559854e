using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>A request for a match fit: the shared parameters to estimate, and their prior deviations from the scene.</summary>
public sealed record MatchFitRequest
{
    /// <summary>True to estimate a horizontal, steady wind. Default true.</summary>
    /// <remarks>
    /// The wind requires several flights in different directions. In a single flight, a sidespin of 3 rad/s resembles a crosswind of 4 m/s: the result is then close to
    /// the scene's wind, and its standard error is nearly <see cref="WindDeviation"/>.
    /// </remarks>
    public bool Wind { get; init; } = true;

    /// <summary>True to estimate the drag of the ball. Default true.</summary>
    /// <remarks>The parameters are a factor and, with the measured laws, the critical Reynolds number.</remarks>
    public bool Drag { get; init; } = true;

    /// <summary>True to estimate the critical Reynolds number even if <see cref="Drag"/> is false. Default false.</summary>
    /// <remarks>Requires the measured laws.</remarks>
    public bool Crisis { get; init; }

    /// <summary>True to estimate a factor of the Magnus force. Default false.</summary>
    /// <remarks>The factor can only be determined together with the spin of each flight.</remarks>
    public bool Lift { get; init; }

    /// <summary>True to estimate the surface: restitution, its increase at grazing impacts, and friction. Default true.</summary>
    public bool Surface { get; init; } = true;

    /// <summary>True to estimate the height of the ground; false to use that of the scene. Default true.</summary>
    public bool Height { get; init; } = true;

    /// <summary>The prior standard deviation of each component of the wind, in m/s. Above 0; default 3.</summary>
    public double WindDeviation { get; init; } = 3;

    /// <summary>The prior standard deviation of the drag and lift factors, whose prior mean is 1. Above 0; default 0.3.</summary>
    public double FactorDeviation { get; init; } = 0.3;

    /// <summary>The prior standard deviation of the critical Reynolds number. Above 0; default 40 000.</summary>
    public double CrisisDeviation { get; init; } = 40_000;

    /// <summary>The prior standard deviation of each component of a flight's spin, in rad/s. Above 0; default 40.</summary>
    public double SpinDeviation { get; init; } = 40;

    internal void Validate()
    {
        Check.Positive("match.windDeviation", WindDeviation);
        Check.Positive("match.factorDeviation", FactorDeviation);
        Check.Positive("match.crisisDeviation", CrisisDeviation);
        Check.Positive("match.spinDeviation", SpinDeviation);
    }
}
