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

    public readonly float Dot(Vector3 with) => (X * with.X) + (Y * with.Y) + (Z * with.Z);

    public readonly Vector3 Cross(Vector3 with) => new((Y * with.Z) - (Z * with.Y), (Z * with.X) - (X * with.Z), (X * with.Y) - (Y * with.X));

    public override readonly int GetHashCode() => HashCode.Combine(X, Y, Z);

    public static bool operator ==(Vector3 a, Vector3 b) => a.Equals(b);

    public static bool operator !=(Vector3 a, Vector3 b) => !a.Equals(b);

    public override readonly bool Equals(object? obj) => obj is Vector3 other && X == other.X && Y == other.Y && Z == other.Z;
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

    public Vector2(float x, float y)
    {
        X = x;
        Y = y;
    }
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

    /// <summary>The lengths of the columns.</summary>
    public readonly Vector3 Scale => new(X.Length(), Y.Length(), Z.Length());

    /// <summary>The rotation without the scale.</summary>
    public readonly Quaternion GetRotationQuaternion()
    {
        (Vector3 x, Vector3 y, Vector3 z) = (X * (1 / X.Length()), Y * (1 / Y.Length()), Z * (1 / Z.Length()));
        float w = 1 + x.X + y.Y + z.Z;
        (Quaternion q, float most) = (new Quaternion(y.Z - z.Y, z.X - x.Z, x.Y - y.X, w), w);
        (q, most) = 1 + x.X - y.Y - z.Z is var i && i > most ? (new Quaternion(i, x.Y + y.X, z.X + x.Z, y.Z - z.Y), i) : (q, most);
        (q, most) = 1 - x.X + y.Y - z.Z is var j && j > most ? (new Quaternion(x.Y + y.X, j, y.Z + z.Y, z.X - x.Z), j) : (q, most);
        (q, most) = 1 - x.X - y.Y + z.Z is var k && k > most ? (new Quaternion(z.X + x.Z, y.Z + z.Y, k, x.Y - y.X), k) : (q, most);
        float s = 0.5f / MathF.Sqrt(most);
        return new Quaternion(q.X * s, q.Y * s, q.Z * s, q.W * s);
    }

    public override readonly int GetHashCode() => HashCode.Combine(X, Y, Z);

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

    public static Transform3D Identity => new(Basis.Identity, Vector3.Zero);

    public override readonly int GetHashCode() => HashCode.Combine(Basis, Origin);

    public static Transform3D operator *(Transform3D a, Transform3D b) => new(a.Basis * b.Basis, (a.Basis * b.Origin) + a.Origin);
}

public sealed class StringName
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

    public static implicit operator Variant(GodotObject? value) => new(value!);

    public static implicit operator Variant(Vector3[] value) => new(value);

    public static implicit operator Variant(Vector2[] value) => new(value);

    public static implicit operator Variant(int[] value) => new(value);

    public Rid AsRid() => (Rid)Value;

    public ulong AsUInt64() => (ulong)Value;

    public Vector3 AsVector3() => (Vector3)Value;

    public string AsString() => (string)Value;

    public double AsDouble() => (double)Value;
}

public struct Color
{
    public float R;
    public float G;
    public float B;
    public float A;

    public Color(float r, float g, float b, float a = 1)
    {
        R = r;
        G = g;
        B = b;
        A = a;
    }

    public static Color operator *(Color color, float scale) => new(color.R * scale, color.G * scale, color.B * scale, color.A * scale);

    public override readonly int GetHashCode() => HashCode.Combine(R, G, B, A);

    public static bool operator ==(Color a, Color b) => a.Equals(b);

    public static bool operator !=(Color a, Color b) => !a.Equals(b);

    public override readonly bool Equals(object? obj) => obj is Color other && (R, G, B, A) == (other.R, other.G, other.B, other.A);
}
