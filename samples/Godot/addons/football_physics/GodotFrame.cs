#nullable enable
using FootballPhysics.Engines;
using Godot;

namespace FootballPhysics.GodotAddon;

/// <summary>Conversions between the library's types and Godot's, with the one conversion of handedness.</summary>
public static class GodotFrame
{
    /// <summary>Converts a position, velocity or direction from Godot to the library.</summary>
    public static Vector3d FromGodot(Vector3 vector) =>
        EngineFrame.RightHanded.Vector(new Vector3d(vector.X, vector.Y, vector.Z));

    /// <summary>Converts a spin (like RigidBody3D.AngularVelocity) from Godot to the library.</summary>
    public static Vector3d SpinFromGodot(Vector3 spin) =>
        EngineFrame.RightHanded.Spin(new Vector3d(spin.X, spin.Y, spin.Z));

    /// <summary>Converts a position, velocity or direction from the library to Godot.</summary>
    public static Vector3 ToGodot(Vector3d vector) => Rounded(EngineFrame.RightHanded.Vector(vector));

    /// <summary>Converts a spin from the library to Godot.</summary>
    public static Vector3 SpinToGodot(Vector3d spin) => Rounded(EngineFrame.RightHanded.Spin(spin));

    /// <summary>Converts a rotation from the library to Godot.</summary>
    public static Quaternion ToGodot(Quaterniond rotation)
    {
        Quaterniond q = EngineFrame.RightHanded.Rotation(rotation);
        return new Quaternion((float)q.X, (float)q.Y, (float)q.Z, (float)q.W);
    }

    /// <summary>Converts a rotation from Godot to the library.</summary>
    public static Quaterniond FromGodot(Quaternion rotation) =>
        EngineFrame.RightHanded.Rotation(new Quaterniond(rotation.X, rotation.Y, rotation.Z, rotation.W));

    private static Vector3 Rounded(Vector3d v) => new((float)v.X, (float)v.Y, (float)v.Z);
}
