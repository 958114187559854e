namespace FootballPhysics.Tests.Support;

/// <summary>Differences between results, as the reference cases define them.</summary>
internal static class Differences
{
    /// <summary>The largest component of the difference, relative to max(1, |expected|).</summary>
    public static double Relative(in Vector3d actual, in Vector3d expected) =>
        Math.Max(Relative(actual.X, expected.X), Math.Max(Relative(actual.Y, expected.Y), Relative(actual.Z, expected.Z)));

    public static double Relative(double actual, double expected) => Math.Abs(actual - expected) / Math.Max(1, Math.Abs(expected));

    /// <summary>Norm of the difference of two rotations, up to the sign of the quaternion: half the angle between them, in radians.</summary>
    public static double Rotation(in Quaterniond actual, in Quaterniond expected) =>
        Math.Min(Norm(in actual, in expected, 1), Norm(in actual, in expected, -1));

    private static double Norm(in Quaterniond a, in Quaterniond b, double sign)
    {
        double x = a.X - (sign * b.X);
        double y = a.Y - (sign * b.Y);
        double z = a.Z - (sign * b.Z);
        double w = a.W - (sign * b.W);
        return Math.Sqrt((x * x) + (y * y) + (z * z) + (w * w));
    }
}
