namespace FootballPhysics.Shapes;

/// <summary>A shape that the ball can hit, given by a signed distance function.</summary>
/// <remarks>
/// You can implement your own. The simulator calls it several times per step when the ball is near, so keep it pure and allocation-free.
/// </remarks>
public interface IShape
{
    /// <summary>The strongest concave curvature of the surface, in 1/m; 0 if the shape is convex.</summary>
    /// <remarks>
    /// The inner side of a ring or a pipe is hollow in one direction: the value is 1/radius, and must be below the curvature of the ball, 1/r. A bowl is hollow
    /// in both directions: the value must be at most 1/(2r). The contact search relies on the value. If it is too small, the simulator replaces it and reports
    /// that in <see cref="Simulator.Warnings"/>.
    /// </remarks>
    double MaximumConcaveCurvature { get; }

    /// <summary>A bounding box of the shape; infinite if the shape is unbounded.</summary>
    Bounds3d Bounds { get; }

    /// <summary>Returns the signed distance, outward normal and curvature at a point.</summary>
    /// <param name="point">The point, in m.</param>
    ShapePoint At(in Vector3d point);
}
