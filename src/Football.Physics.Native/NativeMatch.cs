namespace FootballPhysics.Native;

/// <summary>
/// A match: a scene with bodies that move and obstacles that have a mass, and balls that are stepped together. Concurrent calls wait for each other. The pointer
/// is a handle, not an address.
/// </summary>
internal struct NativeMatch
{
}
