namespace FootballPhysics.Laws;

/// <summary>A pattern of materials on the ground: mown stripes, a wet half.</summary>
/// <remarks>The simulator calls it several times per step while the ball is on the ground, so keep it pure and allocation-free.</remarks>
public interface ISurfacePattern
{
    /// <summary>The materials in addition to the ground's own. The list must not change.</summary>
    IReadOnlyList<SurfaceMaterial> Surfaces { get; }

    /// <summary>The width of the narrowest part of the pattern, in m; above 0.</summary>
    /// <remarks>For a ball on the ground, the simulator checks the pattern at least once per half of this distance.</remarks>
    double MinimumWidth { get; }

    /// <summary>Returns the material at a point of the ground.</summary>
    /// <param name="x">The x coordinate, in m.</param>
    /// <param name="z">The z coordinate, in m.</param>
    /// <returns>An index into <see cref="Surfaces"/>; any other number means the ground's own material.</returns>
    int At(double x, double z);
}
