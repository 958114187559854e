namespace FootballPhysics.Native;

/// <summary>
/// The whole state of a ball, plain: copy it to save, to restore and to roll back; balls in the same state have the same bytes. fp_launch makes one; all
/// zero bytes are none.
/// </summary>
internal unsafe struct NativeState
{
    /// <summary>How many bytes a state has.</summary>
    public const int Size = 216;

    /// <summary>The bytes: of use to the library alone, and to this version of it.</summary>
    public fixed byte Bytes[Size];
}
