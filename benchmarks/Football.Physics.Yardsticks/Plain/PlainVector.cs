namespace FootballPhysics.Yardsticks;

/// <summary>An ordinary vector: three doubles and operators.</summary>
public readonly struct PlainVector(double x, double y, double z)
{
    public double X { get; } = x;

    public double Y { get; } = y;

    public double Z { get; } = z;

    public double Length => Math.Sqrt((X * X) + (Y * Y) + (Z * Z));

    public static double Dot(in PlainVector a, in PlainVector b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z);

    public static PlainVector Cross(in PlainVector a, in PlainVector b) => new((a.Y * b.Z) - (a.Z * b.Y), (a.Z * b.X) - (a.X * b.Z), (a.X * b.Y) - (a.Y * b.X));

    public static PlainVector operator +(in PlainVector a, in PlainVector b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static PlainVector operator -(in PlainVector a, in PlainVector b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static PlainVector operator *(double s, in PlainVector a) => new(s * a.X, s * a.Y, s * a.Z);

    public static implicit operator PlainVector(Vector3d v) => new(v.X, v.Y, v.Z);

    public static implicit operator Vector3d(PlainVector v) => new(v.X, v.Y, v.Z);
}
