namespace FootballPhysics.Game;

/// <summary>Compares the bits of numbers: 0 and −0 differ.</summary>
internal static class Bits
{
    public static bool Same(in Vector3d a, in Vector3d b) => Same(a.X, b.X) && Same(a.Y, b.Y) && Same(a.Z, b.Z);

    public static bool Same(in Quaterniond a, in Quaterniond b) => Same(a.X, b.X) && Same(a.Y, b.Y) && Same(a.Z, b.Z) && Same(a.W, b.W);

    private static bool Same(double a, double b) => BitConverter.DoubleToInt64Bits(a) == BitConverter.DoubleToInt64Bits(b);
}
