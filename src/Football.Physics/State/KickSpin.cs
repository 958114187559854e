namespace Football.Physics;

/// <summary>The spin of a kick in two numbers, relative to the launch direction: ω = top · (ŷ × d) + side · ŷ.</summary>
public static class KickSpin
{
    /// <summary>The spin vector of a kick.</summary>
    /// <param name="direction">Direction of the kick; its horizontal part must not be zero where there is top spin.</param>
    /// <param name="top">Topspin, rad/s; negative is backspin.</param>
    /// <param name="side">Sidespin, rad/s; positive is counter-clockwise seen from above.</param>
    /// <exception cref="ArgumentOutOfRangeException">A vertical kick with top spin has no axis for it, or a number is not finite.</exception>
    public static Vector3d Vector(Vector3d direction, double top, double side)
    {
        Check.Within("topSpin", top, -Limits.Spin, Limits.Spin);
        Check.Within("sideSpin", side, -Limits.Spin, Limits.Spin);
        Vector3d flat = direction.Horizontal;
        double length = flat.Length;
        if (!(length > 0))
        {
            return top == 0 ? new Vector3d(0, side, 0) : throw Check.Refusal("direction", direction.ToString(), "not vertical where there is top spin");
        }

        // ŷ × d = (d_z, 0, −d_x)
        Vector3d d = flat / length;
        return new Vector3d(top * d.Z, side, -(top * d.X));
    }

    internal static Vector3d Direction(Vector3d direction)
    {
        double length = direction.Length;
        return length > 0 && double.IsFinite(length)
            ? direction / length
            : throw Check.Refusal("direction", direction.ToString(), "finite components, not all zero");
    }
}
