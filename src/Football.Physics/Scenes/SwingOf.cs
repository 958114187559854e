namespace FootballPhysics.Scenes;

/// <summary>Computes the greatest speed that a rotation gives to any part of a shape.</summary>
internal static class SwingOf
{
    /// <summary>The distance from the axis below which a point counts as fixed, in m.</summary>
    /// <remarks>It is a thousandth of the largest gap that counts as contact.</remarks>
    private const double OnAxis = 1e-13;

    /// <summary>Returns the greatest speed of any part of a rotating shape, in m/s.</summary>
    /// <remarks>It is 0 if the rotation does not change the shape. A sphere moves with its centre, and a capsule with its axis: a rotation about these changes nothing.</remarks>
    /// <param name="shape">The shape.</param>
    /// <param name="spin">Ω in the shape's axes, in rad/s.</param>
    /// <param name="pivot">The pivot in the shape's frame, in m.</param>
    public static double Shape(IShape shape, in Vector3d spin, in Vector3d pivot)
    {
        double swing = shape switch
        {
            SphereShape sphere => OfPoint(sphere.Center, in spin, in pivot),
            CapsuleShape capsule => Math.Max(OfPoint(capsule.From, in spin, in pivot), OfPoint(capsule.To, in spin, in pivot)),
            PlaneShape plane => Vector3d.Cross(in spin, plane.Normal).Length > OnAxis * spin.Length ? double.PositiveInfinity : 0,
            _ => OfBox(shape.Bounds, in spin, in pivot),
        };
        return swing > OnAxis * spin.Length ? swing : 0;
    }

    /// <summary>Returns the greatest speed at the corners of a box: |Ω × (c − o)| is convex in c, so a corner has the maximum.</summary>
    private static double OfBox(in Bounds3d box, in Vector3d spin, in Vector3d pivot)
    {
        if (!box.IsFinite)
        {
            return double.PositiveInfinity;
        }

        double most = 0;
        for (int corner = 0; corner < 8; corner++)
        {
            var at = new Vector3d((corner & 1) == 0 ? box.Min.X : box.Max.X, (corner & 2) == 0 ? box.Min.Y : box.Max.Y, (corner & 4) == 0 ? box.Min.Z : box.Max.Z);
            most = Math.Max(most, OfPoint(in at, in spin, in pivot));
        }

        return most;
    }

    private static double OfPoint(in Vector3d point, in Vector3d spin, in Vector3d pivot) => Vector3d.Cross(in spin, point - pivot).Length;
}
