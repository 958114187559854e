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

public struct Basis
{
    public Basis(Quaternion quaternion) => Rotation = quaternion;

    public Quaternion Rotation { get; }

    public readonly Quaternion GetRotationQuaternion() => Rotation;
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
}
