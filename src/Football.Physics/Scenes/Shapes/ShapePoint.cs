namespace FootballPhysics.Shapes;

/// <summary>The result of a query at a point: signed distance, normal and curvature.</summary>
public readonly struct ShapePoint
{
    /// <summary>Creates the result of a query at a point.</summary>
    /// <param name="distance">The signed distance from the surface, in m: positive outside.</param>
    /// <param name="normal">The gradient of the distance: the outward unit normal.</param>
    /// <param name="curvature">The Hessian of the distance, in 1/m: the rate of change of the normal with position. Zero for a plane.</param>
    public ShapePoint(double distance, in Vector3d normal, in SymmetricMatrix3d curvature)
    {
        Distance = distance;
        Normal = normal;
        Curvature = curvature;
    }

    /// <summary>The signed distance from the surface, in m: positive outside.</summary>
    public double Distance { get; }

    /// <summary>The gradient of the distance: the outward unit normal.</summary>
    public Vector3d Normal { get; }

    /// <summary>The Hessian of the distance, in 1/m: the rate of change of the normal with position. Zero for a plane.</summary>
    public SymmetricMatrix3d Curvature { get; }

    /// <summary>True if the curvature is zero.</summary>
    internal bool IsFlat =>
        Curvature.XX == 0 && Curvature.XY == 0 && Curvature.XZ == 0 && Curvature.YY == 0 && Curvature.YZ == 0 && Curvature.ZZ == 0;
}
