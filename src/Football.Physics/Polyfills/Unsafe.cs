#if !NET5_0_OR_GREATER
namespace System.Runtime.CompilerServices;

/// <summary>Members of this type that older targets lack.</summary>
internal static class Unsafe
{
    /// <summary>Returns the element at an offset from another one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ref T Add<T>(ref T source, int offset)
        where T : unmanaged => ref InteropServices.MemoryMarshal.CreateSpan(ref source, offset + 1)[offset];

    /// <summary>Marks a value as assigned at no cost; the caller assigns it later.</summary>
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
