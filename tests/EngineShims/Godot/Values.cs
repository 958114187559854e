namespace Godot;

public struct Vector3
{
    public float X;
    public float Y;
    public float Z;

    public Vector3(float x, float y, float z)
    {
        X = x;
        Y = y;
        Z = z;
    }

    public static Vector3 Zero => default;

    public static Vector3 Forward => new(0, 0, -1);

    public static Vector3 operator +(Vector3 a, Vector3 b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    public static Vector3 operator -(Vector3 a, Vector3 b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    public static Vector3 operator *(Vector3 a, float s) => new(a.X * s, a.Y * s, a.Z * s);

    public readonly float Length() => MathF.Sqrt((X * X) + (Y * Y) + (Z * Z));
}

public struct Quaternion
{
    public float X;
    public float Y;
    public float Z;
    public float W;

    public Quaternion(float x, float y, float z, float w)
    {
        X = x;
        Y = y;
        Z = z;
        W = w;
    }
}

public struct Vector2
{
    public float X;
    public float Y;
}

/// <summary>Three columns, as Godot has them.</summary>
public struct Basis
{
    public Vector3 X;
    public Vector3 Y;
    public Vector3 Z;

    public Basis(Vector3 x, Vector3 y, Vector3 z)
    {
        X = x;
        Y = y;
        Z = z;
    }

    public Basis(Quaternion q)
    {
        X = new Vector3(1 - (2 * ((q.Y * q.Y) + (q.Z * q.Z))), 2 * ((q.X * q.Y) + (q.W * q.Z)), 2 * ((q.X * q.Z) - (q.W * q.Y)));
        Y = new Vector3(2 * ((q.X * q.Y) - (q.W * q.Z)), 1 - (2 * ((q.X * q.X) + (q.Z * q.Z))), 2 * ((q.Y * q.Z) + (q.W * q.X)));
        Z = new Vector3(2 * ((q.X * q.Z) + (q.W * q.Y)), 2 * ((q.Y * q.Z) - (q.W * q.X)), 1 - (2 * ((q.X * q.X) + (q.Y * q.Y))));
    }

    public static Basis Identity => new(new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1));

    public static Vector3 operator *(Basis basis, Vector3 v) => new(
        (basis.X.X * v.X) + (basis.Y.X * v.Y) + (basis.Z.X * v.Z),
        (basis.X.Y * v.X) + (basis.Y.Y * v.Y) + (basis.Z.Y * v.Z),
        (basis.X.Z * v.X) + (basis.Y.Z * v.Y) + (basis.Z.Z * v.Z));

    public readonly Basis Transposed() => new(new Vector3(X.X, Y.X, Z.X), new Vector3(X.Y, Y.Y, Z.Y), new Vector3(X.Z, Y.Z, Z.Z));

    public readonly Quaternion GetRotationQuaternion()
    {
        // Enough for turns of less than half a circle.
        float w = 0.5f * MathF.Sqrt(1 + X.X + Y.Y + Z.Z);
        return new Quaternion((Y.Z - Z.Y) / (4 * w), (Z.X - X.Z) / (4 * w), (X.Y - Y.X) / (4 * w), w);
    }

    public static Basis operator *(Basis a, Basis b) => new(a * b.X, a * b.Y, a * b.Z);
}

public struct Transform3D
{
    public Basis Basis;
    public Vector3 Origin;

    public Transform3D(Basis basis, Vector3 origin)
    {
        Basis = basis;
        Origin = origin;
    }

    public static Transform3D operator *(Transform3D a, Transform3D b) => new(a.Basis * b.Basis, (a.Basis * b.Origin) + a.Origin);
}

public readonly struct StringName
{
    private readonly string _name;

    public StringName(string name) => _name = name;

    public static implicit operator StringName(string name) => new(name);

    public override string ToString() => _name;
}

public readonly struct Variant
{
    private Variant(object value) => Value = value;

    public object Value { get; }

    public static implicit operator Variant(Vector3 value) => new(value);

    public static implicit operator Variant(double value) => new(value);

    public static implicit operator Variant(int value) => new(value);

    public static implicit operator Variant(ulong value) => new(value);

    public static implicit operator Variant(string value) => new(value);

    public static implicit operator Variant(Rid value) => new(value);

    public Rid AsRid() => (Rid)Value;

    public ulong AsUInt64() => (ulong)Value;

    public Vector3 AsVector3() => (Vector3)Value;

    public string AsString() => (string)Value;
}
