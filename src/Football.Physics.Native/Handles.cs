using System.Runtime.CompilerServices;

namespace FootballPhysics.Native;

/// <summary>The objects and matches that C holds.</summary>
/// <remarks>
/// A handle combines an index in a table with a counter, so a freed or invented handle is detected. An object that is freed while another thread uses it lives
/// until that call returns.
/// </remarks>
internal static class Handles
{
    /// <summary>Bits of a handle that tell the place; 0 is none, so that no handle is null.</summary>
    private const int PlaceBits = 20;

    private const nuint PlaceMask = ((nuint)1 << PlaceBits) - 1;

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
            if (!s_free.TryPop(out int place))
            {
                if (s_used > (int)PlaceMask)
                {
                    return 0;
                }

                place = s_used++;
            }

            if (place >= s_objects.Length)
            {
                // A thread that still reads the old table finds its old entries.
                Handled?[] larger = new Handled?[2 * s_objects.Length];
                s_objects.CopyTo(larger, 0);
                Volatile.Write(ref s_objects, larger);
            }

            handled.Handle = (++s_given << PlaceBits) | (nuint)place;
            Volatile.Write(ref s_objects[place], handled);
            return handled.Handle;
        }
    }

    /// <summary>The object of a handle; null if the handle is invalid.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Handled? Find(nuint handle)
    {
        Handled?[] objects = Volatile.Read(ref s_objects);
        nuint place = handle & PlaceMask;
        if (place < (nuint)objects.Length && Volatile.Read(ref objects[place]) is { } found && found.Handle == handle)
        {
            return found;
        }

        return null;
    }

    /// <summary>Frees a handle; false if the handle is invalid.</summary>
    public static bool Remove(nuint handle)
    {
        lock (s_lock)
        {
            if (Find(handle) is null)
            {
                return false;
            }

            int place = (int)(handle & PlaceMask);
            s_objects[place] = null;
            s_free.Push(place);
            return true;
        }
    }
}

/// <summary>An object that C refers to by a handle.</summary>
internal abstract class Handled
{
    /// <summary>The handle; 0 until there is one.</summary>
    public nuint Handle { get; set; }
}
