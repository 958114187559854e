namespace FootballPhysics.Laws;

/// <summary>Rectangles of a pitch that are made of something else: worn turf in a goal's mouth, a wet half.</summary>
public sealed class SurfaceRectangles : ISurfacePattern
{
    private readonly Rectangle[] _rectangles;

    /// <summary>Makes a pattern.</summary>
    /// <param name="rectangles">Corners on the ground, m, components within ±1e6 and each of the second above that of the first (heights do not count), and what is between them. Of several at a place the last counts.</param>
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
            // Copied, corner by corner: who gave the array cannot change it afterwards.
            (Vector3d min, Vector3d max, SurfaceMaterial surface) = rectangles[i];
            string field = Check.Item("rectangles", i);
            Check.Given(field + ".surface", surface);
            Check.Place(field + ".min", min);
            Check.Place(field + ".max", max);
            Check.Within(field + ".max[0]", max.X, min.X, Limits.Length, exclusiveLow: true);
            Check.Within(field + ".max[2]", max.Z, min.Z, Limits.Length, exclusiveLow: true);
            _rectangles[i] = new Rectangle(min.X, min.Z, max.X, max.Z);
            surfaces[i] = surface;

            // The narrowest side of all: no step on the ground may pass over it unseen.
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
        // The last one on top; −1, the ground's own, where there is none.
        int i = _rectangles.Length - 1;
        while (i >= 0 && !_rectangles[i].Holds(x, z))
        {
            i--;
        }

        return i;
    }

    private readonly struct Rectangle
    {
        private readonly double _minX;
        private readonly double _minZ;
        private readonly double _maxX;
        private readonly double _maxZ;

        public Rectangle(double minX, double minZ, double maxX, double maxZ)
        {
            _minX = minX;
            _minZ = minZ;
            _maxX = maxX;
            _maxZ = maxZ;
        }

        public bool Holds(double x, double z) => x >= _minX && x <= _maxX && z >= _minZ && z <= _maxZ;
    }
}
