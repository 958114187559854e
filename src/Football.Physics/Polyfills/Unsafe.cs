#if !NET5_0_OR_GREATER
namespace System.Runtime.CompilerServices;

/// <summary>What older targets lack of the type of this name.</summary>
internal static class Unsafe
{
    /// <summary>Declares a value to be assigned that its user assigns later.</summary>
    public static void SkipInit<T>(out T value) => value = default!;
}
#endif
