#if !NET5_0_OR_GREATER
namespace System.Runtime.CompilerServices;

/// <summary>Members of this type that older targets lack.</summary>
internal static class Unsafe
{
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
