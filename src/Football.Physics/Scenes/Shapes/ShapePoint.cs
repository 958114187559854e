namespace FootballPhysics.Shapes;

/// <summary>The result of a query at a point: signed distance, normal and curvature.</summary>
public readonly struct ShapePoint
{
    // The curvature; around an axis or a point: the axis, then the distance from it.
    private readonly SymmetricMatrix3d _curvature;
    private readonly bool _isRound;

    /// <summary>Creates the result of a query at a point.</summary>
    /// <param name="distance">The signed distance from the surface, in m: positive outside.</param>
    /// <param name="normal">The gradient of the distance: the outward unit normal.</param>
    /// <param name="curvature">The Hessian of the distance, in 1/m: the rate of change of the normal with position. Zero for a plane.</param>
    public ShapePoint(double distance, in Vector3d normal, in SymmetricMatrix3d curvature)
    {
        Distance = distance;
        Normal = normal;
        _curvature = curvature;
    }

    /// <summary>Creates the result of a query at a point whose nearest point of the surface lies around an axis, or around a point.</summary>
    /// <remarks>The curvature is computed when it is read, because most queries need only the distance and the normal.</remarks>
    /// <param name="distance">The signed distance from the surface, in m.</param>
    /// <param name="normal">The outward unit normal.</param>
    /// <param name="axis">The unit vector along the axis; zero around a point.</param>
    /// <param name="radius">The distance from the axis or the point, in m; above 0.</param>
    internal ShapePoint(double distance, in Vector3d normal, in Vector3d axis, double radius)
        : this(distance, in normal, new SymmetricMatrix3d(axis.X, axis.Y, axis.Z, radius, 0, 0)) => _isRound = true;

    /// <summary>The signed distance from the surface, in m: positive outside.</summary>
    public double Distance { get; }

    /// <summary>The gradient of the distance: the outward unit normal.</summary>
    public Vector3d Normal { get; }

    /// <summary>The Hessian of the distance, in 1/m: the rate of change of the normal with position. Zero for a plane.</summary>
    public SymmetricMatrix3d Curvature => _isRound ? SymmetricMatrix3d.AroundAxis(Normal, new Vector3d(_curvature.XX, _curvature.XY, _curvature.XZ), _curvature.YY) : _curvature;

    /// <summary>True if the curvature is zero.</summary>
    internal bool IsFlat =>
        !_isRound && _curvature.XX == 0 && _curvature.XY == 0 && _curvature.XZ == 0 && _curvature.YY == 0 && _curvature.YZ == 0 && _curvature.ZZ == 0;
}
