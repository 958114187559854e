namespace FootballPhysics.Shapes;

/// <summary>A box along the axes of the world.</summary>
public readonly struct Bounds3d
{
    /// <summary>Makes a box.</summary>
    /// <param name="min">Its lowest corner, m.</param>
    /// <param name="max">Its highest corner, m.</param>
    public Bounds3d(in Vector3d min, in Vector3d max)
    {
        Min = min;
        Max = max;
    }

    /// <summary>All of space.</summary>
    public static Bounds3d Everywhere => new(
        new Vector3d(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity),
        new Vector3d(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity));

    /// <summary>No point at all: it touches nothing, and adds nothing to another box.</summary>
    internal static Bounds3d Nowhere => new(
        new Vector3d(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity),
        new Vector3d(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity));

    /// <summary>The lowest corner, m.</summary>
    public Vector3d Min { get; }

    /// <summary>The highest corner, m.</summary>
    public Vector3d Max { get; }

    /// <summary>True when it ends on all sides.</summary>
    internal bool IsFinite => Min.IsFinite && Max.IsFinite;

    /// <summary>A box around a point.</summary>
    /// <param name="center">The point, m.</param>
    /// <param name="x">Half its size along x, m.</param>
    /// <param name="y">The same, y.</param>
    /// <param name="z">The same, z.</param>
    public static Bounds3d Around(in Vector3d center, double x, double y, double z)
    {
        var half = new Vector3d(x, y, z);
        return new Bounds3d(center - half, center + half);
    }

    /// <summary>The smallest box around two.</summary>
    /// <param name="other">The other box.</param>
    public Bounds3d Union(in Bounds3d other) => new(
        new Vector3d(Math.Min(Min.X, other.Min.X), Math.Min(Min.Y, other.Min.Y), Math.Min(Min.Z, other.Min.Z)),
        new Vector3d(Math.Max(Max.X, other.Max.X), Math.Max(Max.Y, other.Max.Y), Math.Max(Max.Z, other.Max.Z)));

    /// <summary>The point in its middle, as a box.</summary>
    internal Bounds3d AtCenter
    {
        get
        {
            Vector3d center = 0.5 * (Min + Max);
            return new Bounds3d(in center, in center);
        }
    }

    /// <summary>True when two boxes have a point in common.</summary>
    /// <param name="other">The other box.</param>
    public bool Intersects(in Bounds3d other) =>
        Min.X <= other.Max.X && Max.X >= other.Min.X
        && Min.Y <= other.Max.Y && Max.Y >= other.Min.Y
        && Min.Z <= other.Max.Z && Max.Z >= other.Min.Z;

    /// <summary>The box, larger on all sides.</summary>
    /// <param name="margin">By how much, m.</param>
    public Bounds3d Expanded(double margin)
    {
        var by = new Vector3d(margin, margin, margin);
        return new Bounds3d(Min - by, Max + by);
    }

    /// <summary>The box, moved.</summary>
    /// <param name="by">By how much, m.</param>
    public Bounds3d Translated(in Vector3d by) => new(Min + by, Max + by);
}
