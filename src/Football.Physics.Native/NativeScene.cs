namespace FootballPhysics.Native;

/// <summary>
/// A scene, checked and compiled; nothing changes it, and any number of threads may use it at once, also while one of them frees it. The pointer is a handle,
/// not an address.
/// </summary>
internal struct NativeScene
{
}
