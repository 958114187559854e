namespace FootballPhysics.Shapes;

/// <summary>The shape of a thing that can be hit: a function of a point. A game's own shape is one such function.</summary>
/// <remarks>It is asked several times a step where the ball is near, so it should be a pure function that allocates nothing.</remarks>
public interface IShape
{
    /// <summary>
    /// The strongest curvature of a hollow of the shape, 1/m; 0 where it is convex. At most half of that of the ball, 1/(2r). The search for contact
    /// relies on it: nothing that bends more can be promised not to be passed through.
    /// </summary>
    double MaximumConcaveCurvature { get; }

    /// <summary>A box around the shape; infinite where the shape is unbounded.</summary>
    Bounds3d Bounds { get; }

    /// <summary>Signed distance, outward normal and curvature at a point.</summary>
    /// <param name="point">A point, m.</param>
    ShapePoint At(in Vector3d point);
}
