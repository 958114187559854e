namespace FootballPhysics.Tool.Gallery;

/// <summary>Converts positions from the view of a spectator behind the kick: along the view, to its left, and up.</summary>
/// <remarks>The gallery looks along −z, which is forward in the library's convention; −x is then to the left.</remarks>
internal static class ViewFrame
{
    /// <summary>Returns a direction or velocity of the given size, from the angles to the left of the view and upwards, in degrees.</summary>
    public static Vector3d Direction(double size, double left, double up)
    {
        (double sinLeft, double cosLeft) = Math.SinCos(left * Math.PI / 180);
        (double sinUp, double cosUp) = Math.SinCos(up * Math.PI / 180);
        return new Vector3d(-size * cosUp * sinLeft, size * sinUp, -size * cosUp * cosLeft);
    }

    public static double Along(Vector3d place) => -place.Z;

    public static double Left(Vector3d place) => -place.X;
}
