namespace FootballPhysics.Native;

/// <summary>
/// The complete state of a ball, as plain bytes. Copy it to save, restore or roll back. Balls in the same state have the same bytes. fp_launch creates a state;
/// all zero bytes are not a valid one.
/// </summary>
internal unsafe struct NativeState
{
    /// <summary>The number of bytes of a state.</summary>
    public const int Size = 216;

    /// <summary>The bytes. Only this version of the library reads them.</summary>
    public fixed byte Bytes[Size];
}
