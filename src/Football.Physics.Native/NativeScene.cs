namespace FootballPhysics.Native;

/// <summary>
/// A checked and compiled scene. It is immutable. Any number of threads may use it concurrently, even while one of them frees it. The pointer is a handle, not
/// an address.
/// </summary>
internal struct NativeScene
{
}
