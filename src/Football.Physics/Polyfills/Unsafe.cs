#if !NET5_0_OR_GREATER
namespace System.Runtime.CompilerServices;

/// <summary>Members of the type of this name that older targets lack.</summary>
internal static class Unsafe
{
    /// <summary>Declares a value to be assigned that its user assigns later: its address has been taken, which costs nothing.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe void SkipInit<T>(out T value)
        where T : unmanaged
    {
        fixed (T* address = &value)
        {
        }
    }
}
#endif
