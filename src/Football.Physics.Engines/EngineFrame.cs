namespace FootballPhysics.Engines;

/// <summary>Converts between the coordinate frames of the library and an engine, including handedness.</summary>
/// <remarks>
/// The library is right-handed: x right, y up, −z forward. A left-handed engine with y up and z forward (Unity) shows the same world mirrored in the
/// xy plane. Positions and velocities are polar vectors: the mirror negates z. Spins and the vector part of a rotation are axial vectors: the mirror
/// negates x and y. Each conversion is its own inverse and exact, except that a negated component is never −0. A 0 from the engine therefore gives the same
/// kick as a 0 in the library.
/// </remarks>
public readonly struct EngineFrame
{
    private readonly bool _mirrored;

    private EngineFrame(bool mirrored) => _mirrored = mirrored;

    /// <summary>The right-handed frame with y up and −z forward, which is the library's own frame.</summary>
    /// <remarks>Godot, MonoGame, Stride and glTF use this frame. Conversions change nothing.</remarks>
    public static EngineFrame RightHanded => new(false);

    /// <summary>The left-handed frame with y up and z forward, used by Unity.</summary>
    public static EngineFrame LeftHanded => new(true);

    /// <summary>Converts a position, velocity, direction or force (a polar vector) in either direction.</summary>
    /// <param name="vector">The vector in one frame.</param>
    /// <returns>The vector in the other frame.</returns>
    public Vector3d Vector(Vector3d vector) => _mirrored ? new Vector3d(vector.X, vector.Y, 0.0 - vector.Z) : vector;

    /// <summary>Converts a spin or torque (an axial vector) in either direction.</summary>
    /// <param name="spin">The spin in one frame.</param>
    /// <returns>The spin in the other frame.</returns>
    public Vector3d Spin(Vector3d spin) => _mirrored ? new Vector3d(0.0 - spin.X, 0.0 - spin.Y, spin.Z) : spin;

    /// <summary>Converts a rotation in either direction.</summary>
    /// <param name="rotation">The rotation in one frame.</param>
    /// <returns>The rotation in the other frame.</returns>
    public Quaterniond Rotation(Quaterniond rotation) => _mirrored
        ? new Quaterniond(0.0 - rotation.X, 0.0 - rotation.Y, rotation.Z, rotation.W)
        : rotation;
}
