namespace FootballPhysics.Laws;

/// <summary>The materials of a pitch from place to place: a mown stripe, a wet half. A game's own is one such function.</summary>
/// <remarks>It is asked several times a step on the ground, so it should be a pure function that allocates nothing.</remarks>
public interface ISurfacePattern
{
    /// <summary>The surfaces that there are besides the ground's own. Always the same.</summary>
    IReadOnlyList<SurfaceMaterial> Surfaces { get; }

    /// <summary>No part of the pattern is narrower, m; above 0. A ball that slides or rolls goes no further than half of it without looking.</summary>
    double MinimumWidth { get; }

    /// <summary>The surface under a place.</summary>
    /// <param name="x">Across, m.</param>
    /// <param name="z">Along, m.</param>
    /// <returns>Its index among <see cref="Surfaces"/>; any other number for the ground's own.</returns>
    int At(double x, double z);
}
