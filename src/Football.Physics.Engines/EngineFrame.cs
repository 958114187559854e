namespace FootballPhysics.Engines;

/// <summary>Maps between the library's frame and an engine's: the one place where handedness is dealt with.</summary>
/// <remarks>
/// The library is right-handed: x right, y up, −z forward. A left-handed engine with y up and z forward (Unity) shows the same
/// world in a mirror across the xy plane. Positions and velocities are polar vectors: the mirror turns z around. Spins are axial
/// vectors, and so is the vector part of a rotation: the mirror turns x and y around. Each mapping is its own inverse and loses
/// no bit, except that a component that is turned around is never −0: an engine's 0 and the library's 0 are the same kick.
/// </remarks>
public readonly struct EngineFrame : IEquatable<EngineFrame>
{
    private readonly bool _mirrored;

    private EngineFrame(bool mirrored) => _mirrored = mirrored;

    /// <summary>Right-handed, y up, −z forward: Godot, MonoGame, Stride, glTF, and the library itself. Nothing changes.</summary>
    public static EngineFrame RightHanded => new(false);

    /// <summary>Left-handed, y up, z forward: Unity.</summary>
    public static EngineFrame LeftHanded => new(true);

    /// <summary>Compares by value.</summary>
    /// <param name="a">One frame.</param>
    /// <param name="b">The other frame.</param>
    public static bool operator ==(EngineFrame a, EngineFrame b) => a.Equals(b);

    /// <summary>Compares by value.</summary>
    /// <param name="a">One frame.</param>
    /// <param name="b">The other frame.</param>
    public static bool operator !=(EngineFrame a, EngineFrame b) => !a.Equals(b);

    /// <summary>A position, velocity, direction or force (polar vector), in either direction.</summary>
    /// <param name="vector">The vector in one frame.</param>
    /// <returns>The vector in the other frame.</returns>
    public Vector3d Vector(Vector3d vector) => _mirrored ? new Vector3d(vector.X, vector.Y, 0.0 - vector.Z) : vector;

    /// <summary>A spin or torque (axial vector), in either direction.</summary>
    /// <param name="spin">The spin in one frame.</param>
    /// <returns>The spin in the other frame.</returns>
    public Vector3d Spin(Vector3d spin) => _mirrored ? new Vector3d(0.0 - spin.X, 0.0 - spin.Y, spin.Z) : spin;

    /// <summary>A rotation, in either direction.</summary>
    /// <param name="rotation">The rotation in one frame.</param>
    /// <returns>The rotation in the other frame.</returns>
    public Quaterniond Rotation(Quaterniond rotation) => _mirrored
        ? new Quaterniond(0.0 - rotation.X, 0.0 - rotation.Y, rotation.Z, rotation.W)
        : rotation;

    /// <inheritdoc/>
    public bool Equals(EngineFrame other) => _mirrored == other._mirrored;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is EngineFrame other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => _mirrored ? 1 : 0;
}
