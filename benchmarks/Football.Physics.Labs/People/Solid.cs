namespace FootballPhysics.Labs.People;

/// <summary>Distances in closed form, implemented independently of the library's shapes.</summary>
internal static class Solid
{
    /// <summary>Returns the distance from the surface of a capsule; negative inside.</summary>
    public static double Capsule(Vector3d place, Vector3d from, Vector3d to, double radius)
    {
        Vector3d axis = to - from;
        double share = Math.Clamp(Vector3d.Dot(place - from, axis) / axis.LengthSquared, 0, 1);
        return (place - (from + (share * axis))).Length - radius;
    }

    /// <summary>Returns the distance from the surface of an axis-aligned box; negative inside.</summary>
    public static double Box(Vector3d place, Vector3d center, Vector3d half)
    {
        double x = Math.Abs(place.X - center.X) - half.X;
        double y = Math.Abs(place.Y - center.Y) - half.Y;
        double z = Math.Abs(place.Z - center.Z) - half.Z;
        double outside = new Vector3d(Math.Max(x, 0), Math.Max(y, 0), Math.Max(z, 0)).Length;
        return outside > 0 ? outside : Math.Max(x, Math.Max(y, z));
    }

    /// <summary>Returns the distance from the surface of a rotated box.</summary>
    public static double Box(Vector3d place, Vector3d at, Quaterniond turned, Vector3d center, Vector3d half) =>
        Box(new Quaterniond(-turned.X, -turned.Y, -turned.Z, turned.W).Rotate(place - at), center, half);
}
