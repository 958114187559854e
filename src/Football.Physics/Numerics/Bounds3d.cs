namespace FootballPhysics.Shapes;

/// <summary>An axis-aligned bounding box.</summary>
public readonly struct Bounds3d
{
    /// <summary>Creates a box.</summary>
    /// <param name="min">The corner with the smallest coordinates, in m.</param>
    /// <param name="max">The corner with the largest coordinates, in m.</param>
    public Bounds3d(in Vector3d min, in Vector3d max)
    {
        Min = min;
        Max = max;
    }

    /// <summary>A box that contains all of space.</summary>
    public static Bounds3d Everywhere => new(
        new Vector3d(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity),
        new Vector3d(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity));

    /// <summary>The empty box: it intersects nothing, and a union with it changes nothing.</summary>
    internal static Bounds3d Nowhere => new(
        new Vector3d(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity),
        new Vector3d(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity));

    /// <summary>The corner with the smallest coordinates, in m.</summary>
    public Vector3d Min { get; }

    /// <summary>The corner with the largest coordinates, in m.</summary>
    public Vector3d Max { get; }

    /// <summary>True if the box is bounded on all sides.</summary>
    internal bool IsFinite => Min.IsFinite && Max.IsFinite;

    /// <summary>Returns a box around a point.</summary>
    /// <param name="center">The point, in m.</param>
    /// <param name="x">Half the size along x, in m.</param>
    /// <param name="y">Half the size along y, in m.</param>
    /// <param name="z">Half the size along z, in m.</param>
    public static Bounds3d Around(in Vector3d center, double x, double y, double z)
    {
        var half = new Vector3d(x, y, z);
        return new Bounds3d(center - half, center + half);
    }

    /// <summary>Returns the smallest box that contains this box and another.</summary>
    /// <param name="other">The other box.</param>
    public Bounds3d Union(in Bounds3d other) => new(
        new Vector3d(Math.Min(Min.X, other.Min.X), Math.Min(Min.Y, other.Min.Y), Math.Min(Min.Z, other.Min.Z)),
        new Vector3d(Math.Max(Max.X, other.Max.X), Math.Max(Max.Y, other.Max.Y), Math.Max(Max.Z, other.Max.Z)));

    /// <summary>Returns the box that this box and another have in common.</summary>
    /// <param name="other">The other box, which intersects this one.</param>
    internal Bounds3d Common(in Bounds3d other) => new(
        new Vector3d(Math.Max(Min.X, other.Min.X), Math.Max(Min.Y, other.Min.Y), Math.Max(Min.Z, other.Min.Z)),
        new Vector3d(Math.Min(Max.X, other.Max.X), Math.Min(Max.Y, other.Max.Y), Math.Min(Max.Z, other.Max.Z)));

    /// <summary>The centre, as a box without size.</summary>
    internal Bounds3d AtCenter
    {
        get
        {
            Vector3d center = 0.5 * (Min + Max);
            return new Bounds3d(in center, in center);
        }
    }

    /// <summary>Returns true if the two boxes have a point in common.</summary>
    /// <param name="other">The other box.</param>
    public bool Intersects(in Bounds3d other) =>
        Min.X <= other.Max.X && Max.X >= other.Min.X
        && Min.Y <= other.Max.Y && Max.Y >= other.Min.Y
        && Min.Z <= other.Max.Z && Max.Z >= other.Min.Z;

    /// <summary>Returns the box, extended on all sides.</summary>
    /// <param name="margin">The extension of each side, in m.</param>
    public Bounds3d Expanded(double margin)
    {
        var by = new Vector3d(margin, margin, margin);
        return new Bounds3d(Min - by, Max + by);
    }

    /// <summary>Returns the box, translated.</summary>
    /// <param name="by">The translation, in m.</param>
    public Bounds3d Translated(in Vector3d by) => new(Min + by, Max + by);
}
