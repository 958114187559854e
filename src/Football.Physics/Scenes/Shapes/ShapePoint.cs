namespace FootballPhysics.Shapes;

/// <summary>The answer of a shape about a point: signed distance, normal, and how the normal turns.</summary>
public readonly struct ShapePoint
{
    /// <summary>Makes the answer of a shape.</summary>
    /// <param name="distance">Signed distance from the surface, m: positive outside.</param>
    /// <param name="normal">Its gradient, of length 1: the outward normal.</param>
    /// <param name="curvature">Its Hessian, 1/m: how the normal turns. Zero for a plane.</param>
    public ShapePoint(double distance, in Vector3d normal, in SymmetricMatrix3d curvature)
    {
        Distance = distance;
        Normal = normal;
        Curvature = curvature;
    }

    /// <summary>Signed distance from the surface, m: positive outside.</summary>
    public double Distance { get; }

    /// <summary>Its gradient, of length 1: the outward normal.</summary>
    public Vector3d Normal { get; }

    /// <summary>Its Hessian, 1/m: how the normal turns. Zero for a plane.</summary>
    public SymmetricMatrix3d Curvature { get; }

    /// <summary>True when the normal does not turn.</summary>
    internal bool IsFlat =>
        Curvature.XX == 0 && Curvature.XY == 0 && Curvature.XZ == 0 && Curvature.YY == 0 && Curvature.YZ == 0 && Curvature.ZZ == 0;
}
