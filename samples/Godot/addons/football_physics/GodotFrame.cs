#nullable enable
using FootballPhysics.Engines;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Conversions between the library's types and Godot's, through the one mapping of handedness.</summary>
public static class GodotFrame
{
    /// <summary>A position, velocity or direction of Godot's, for the library.</summary>
    public static Vector3d FromGodot(Vector3 vector) =>
        EngineFrame.RightHanded.Vector(new Vector3d(vector.X, vector.Y, vector.Z));

    /// <summary>A spin of Godot's (like RigidBody3D.AngularVelocity), for the library.</summary>
    public static Vector3d SpinFromGodot(Vector3 spin) =>
        EngineFrame.RightHanded.Spin(new Vector3d(spin.X, spin.Y, spin.Z));

    /// <summary>A position, velocity or direction of the library's, for Godot.</summary>
    public static Vector3 ToGodot(Vector3d vector) => Rounded(EngineFrame.RightHanded.Vector(vector));

    /// <summary>A spin of the library's, for Godot.</summary>
    public static Vector3 SpinToGodot(Vector3d spin) => Rounded(EngineFrame.RightHanded.Spin(spin));

    /// <summary>A rotation of the library's, for Godot.</summary>
    public static Quaternion ToGodot(Quaterniond rotation)
    {
        Quaterniond q = EngineFrame.RightHanded.Rotation(rotation);
        return new Quaternion((float)q.X, (float)q.Y, (float)q.Z, (float)q.W);
    }

    /// <summary>A rotation of Godot's, for the library.</summary>
    public static Quaterniond FromGodot(Quaternion rotation) =>
        EngineFrame.RightHanded.Rotation(new Quaterniond(rotation.X, rotation.Y, rotation.Z, rotation.W));

    private static Vector3 Rounded(Vector3d v) => new((float)v.X, (float)v.Y, (float)v.Z);
}
