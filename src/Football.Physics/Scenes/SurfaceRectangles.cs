using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>Rectangles of the pitch with another material: worn turf in a goalmouth, a wet half.</summary>
public sealed class SurfaceRectangles : ISurfacePattern
{
    private readonly Rectangle[] _rectangles;

    /// <summary>Creates a pattern from rectangles. If several overlap, the last one applies.</summary>
    /// <param name="rectangles">The corners on the ground, in m, and the material between them. Components are within ±1e6; x and z of Max are above those of Min; y is ignored.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names it.</exception>
    public SurfaceRectangles(params (Vector3d Min, Vector3d Max, SurfaceMaterial Surface)[] rectangles)
    {
        Check.Given(nameof(rectangles), rectangles);
        _rectangles = new Rectangle[rectangles.Length];
        var surfaces = new SurfaceMaterial[rectangles.Length];
        MinimumWidth = Limits.Length;
        for (int i = 0; i < rectangles.Length; i++)
        {
            // Copy the corners, so that later changes to the array have no effect.
            (Vector3d min, Vector3d max, SurfaceMaterial surface) = rectangles[i];
            string field = Check.Item("rectangles", i);
            Check.Given(field + ".surface", surface);
            Check.Place(field + ".min", min);
            Check.Place(field + ".max", max);
            Check.Within(field + ".max[0]", max.X, min.X, Limits.Length, exclusiveLow: true);
            Check.Within(field + ".max[2]", max.Z, min.Z, Limits.Length, exclusiveLow: true);
            _rectangles[i] = new Rectangle(min.X, min.Z, max.X, max.Z);
            surfaces[i] = surface;

            // The shortest side of all rectangles: no step on the ground may skip over it.
            MinimumWidth = Math.Min(MinimumWidth, Math.Min(max.X - min.X, max.Z - min.Z));
        }

        Surfaces = surfaces;
    }

    /// <inheritdoc/>
    public IReadOnlyList<SurfaceMaterial> Surfaces { get; }

    /// <inheritdoc/>
    public double MinimumWidth { get; }

    /// <inheritdoc/>
    public int At(double x, double z)
    {
        // The last rectangle that contains the point is on top. If none does, return −1, the ground's own material.
        int i = _rectangles.Length - 1;
        while (i >= 0 && !_rectangles[i].Holds(x, z))
        {
            i--;
        }

        return i;
    }

    private readonly struct Rectangle(double minX, double minZ, double maxX, double maxZ)
    {
        public bool Holds(double x, double z) => x >= minX && x <= maxX && z >= minZ && z <= maxZ;
    }
}
