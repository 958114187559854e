namespace FootballPhysics.Engines;

/// <summary>Converts between the coordinate frames of the library and an engine, including handedness.</summary>
/// <remarks>
/// The library is right-handed: x right, y up, −z forward. Positions and velocities are polar vectors, spins and the vector part of a rotation are axial
/// vectors. An axial vector converts like a polar one if both frames have the same handedness; otherwise all its components change their sign. To swap two
/// axes is to mirror. Each conversion is exact, except that a negated component is never −0. A 0 from the engine therefore gives the same kick as a 0 in
/// the library.
/// </remarks>
public readonly struct EngineFrame
{
    private readonly Axes _axes;

    private EngineFrame(Axes axes) => _axes = axes;

    /// <summary>The frames.</summary>
    private enum Axes
    {
        YUpRight,
        YUpLeft,
        ZUpRight,
        ZUpLeft,
    }

    /// <summary>The right-handed frame with y up and −z forward, which is the library's own frame.</summary>
    /// <remarks>Godot, MonoGame, Stride and glTF use this frame. Conversions change nothing.</remarks>
    public static EngineFrame RightHanded => new(Axes.YUpRight);

    /// <summary>The left-handed frame with y up and z forward, used by Unity.</summary>
    /// <remarks>Vectors become (x, y, −z) in the library, spins (−x, −y, z).</remarks>
    public static EngineFrame LeftHanded => new(Axes.YUpLeft);

    /// <summary>The right-handed frame with z up, used by Blender, ROS, MuJoCo and Source 2.</summary>
    /// <remarks>Vectors and spins become (x, z, −y) in the library.</remarks>
    public static EngineFrame ZUpRightHanded => new(Axes.ZUpRight);

    /// <summary>The left-handed frame with z up, x forward and y right, used by Unreal.</summary>
    /// <remarks>Vectors become (y, z, −x) in the library, spins (−y, −z, x). Unreal's lengths are in cm: divide them by 100 first.</remarks>
    public static EngineFrame ZUpLeftHanded => new(Axes.ZUpLeft);

    private bool IsMirrored => _axes is Axes.YUpLeft or Axes.ZUpLeft;

    /// <summary>Converts a position, velocity, direction or force (a polar vector) from the engine to the library.</summary>
    /// <remarks>With y up, the same conversion leads back to the engine.</remarks>
    /// <param name="vector">The vector in the engine.</param>
    /// <returns>The vector in the library.</returns>
    public Vector3d Vector(Vector3d vector) => _axes switch
    {
        Axes.YUpRight => vector,
        Axes.YUpLeft => new Vector3d(vector.X, vector.Y, 0.0 - vector.Z),
        Axes.ZUpRight => new Vector3d(vector.X, vector.Z, 0.0 - vector.Y),
        _ => new Vector3d(vector.Y, vector.Z, 0.0 - vector.X),
    };

    /// <summary>Converts a position, velocity, direction or force (a polar vector) from the library to the engine.</summary>
    /// <param name="vector">The vector in the library.</param>
    /// <returns>The vector in the engine.</returns>
    public Vector3d VectorToEngine(Vector3d vector) => _axes switch
    {
        Axes.ZUpRight => new Vector3d(vector.X, 0.0 - vector.Z, vector.Y),
        Axes.ZUpLeft => new Vector3d(0.0 - vector.Z, vector.X, vector.Y),
        _ => Vector(vector),
    };

    /// <summary>Converts a spin or torque (an axial vector) from the engine to the library.</summary>
    /// <remarks>With y up, the same conversion leads back to the engine.</remarks>
    /// <param name="spin">The spin in the engine.</param>
    /// <returns>The spin in the library.</returns>
    public Vector3d Spin(Vector3d spin) => Axial(Vector(spin));

    /// <summary>Converts a spin or torque (an axial vector) from the library to the engine.</summary>
    /// <param name="spin">The spin in the library.</param>
    /// <returns>The spin in the engine.</returns>
    public Vector3d SpinToEngine(Vector3d spin) => Axial(VectorToEngine(spin));

    /// <summary>Converts a rotation from the engine to the library.</summary>
    /// <remarks>With y up, the same conversion leads back to the engine.</remarks>
    /// <param name="rotation">The rotation in the engine.</param>
    /// <returns>The rotation in the library.</returns>
    public Quaterniond Rotation(Quaterniond rotation) => With(rotation, Spin(new Vector3d(rotation.X, rotation.Y, rotation.Z)));

    /// <summary>Converts a rotation from the library to the engine.</summary>
    /// <param name="rotation">The rotation in the library.</param>
    /// <returns>The rotation in the engine.</returns>
    public Quaterniond RotationToEngine(Quaterniond rotation) => With(rotation, SpinToEngine(new Vector3d(rotation.X, rotation.Y, rotation.Z)));

    private Vector3d Axial(Vector3d vector) => IsMirrored ? new Vector3d(0.0 - vector.X, 0.0 - vector.Y, 0.0 - vector.Z) : vector;

    private static Quaterniond With(Quaterniond rotation, Vector3d axis) => new(axis.X, axis.Y, axis.Z, rotation.W);
}
