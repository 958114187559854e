using System.Runtime.CompilerServices;

namespace FootballPhysics.Native;

/// <summary>The scenes and matches that C refers to.</summary>
/// <remarks>
/// A handle combines an index in a table with a counter, so a freed or invented handle is detected. An object that is freed while another thread uses it lives
/// until that call returns.
/// </remarks>
internal static class Handles
{
    /// <summary>The number of bits of a handle that hold the index. Index 0 is unused, so that no handle is null.</summary>
    private const int IndexBits = 20;

    private const nuint IndexMask = ((nuint)1 << IndexBits) - 1;

    private static readonly Lock s_lock = new();
    private static readonly Stack<int> s_free = [];
    private static Handled?[] s_objects = new Handled?[16];
    private static int s_used = 1;
    private static nuint s_given;

    /// <summary>Creates a handle for an object; 0 if the table is full.</summary>
    public static nuint Add(Handled handled)
    {
        lock (s_lock)
        {
            if (!s_free.TryPop(out int index))
            {
                if (s_used > (int)IndexMask)
                {
                    return 0;
                }

                index = s_used++;
            }

            if (index >= s_objects.Length)
            {
                // A thread that still reads the old table finds the old entries there.
                Handled?[] larger = new Handled?[2 * s_objects.Length];
                s_objects.CopyTo(larger, 0);
                Volatile.Write(ref s_objects, larger);
            }

            handled.Handle = (++s_given << IndexBits) | (nuint)index;
            Volatile.Write(ref s_objects[index], handled);
            return handled.Handle;
        }
    }

    /// <summary>Returns the object of a handle; null if the handle is invalid.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Handled? Find(nuint handle)
    {
        Handled?[] objects = Volatile.Read(ref s_objects);
        nuint index = handle & IndexMask;
        if (index < (nuint)objects.Length && Volatile.Read(ref objects[index]) is { } found && found.Handle == handle)
        {
            return found;
        }

        return null;
    }

    /// <summary>Frees a handle. Returns false if the handle is invalid.</summary>
    public static bool Remove(nuint handle)
    {
        lock (s_lock)
        {
            if (Find(handle) is null)
            {
                return false;
            }

            int index = (int)(handle & IndexMask);
            s_objects[index] = null;
            s_free.Push(index);
            return true;
        }
    }
}

/// <summary>An object that C refers to by a handle.</summary>
internal abstract class Handled
{
    /// <summary>The handle; 0 before the object gets one.</summary>
    public nuint Handle { get; set; }
}
