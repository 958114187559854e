using System.Runtime.CompilerServices;

namespace FootballPhysics.Native;

/// <summary>
/// The scenes that C holds. A handle is a place in a table and how often places were given before: one that was freed, or never was one, is found out, and a
/// scene that is freed while another thread steps in it lives until that step is over.
/// </summary>
internal static class SceneHandles
{
    /// <summary>Bits of a handle that tell the place; 0 is none, so that no handle is null.</summary>
    private const int PlaceBits = 20;

    private const nuint PlaceMask = ((nuint)1 << PlaceBits) - 1;

    private static readonly Lock s_lock = new();
    private static readonly Stack<int> s_free = [];
    private static CompiledScene?[] s_scenes = new CompiledScene?[16];
    private static int s_used = 1;
    private static nuint s_given;

    /// <summary>Creates a handle for a scene; 0 if the table is full.</summary>
    public static nuint Add(CompiledScene scene)
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

            if (place >= s_scenes.Length)
            {
                // A thread that still reads the old table finds its old entries.
                CompiledScene?[] larger = new CompiledScene?[2 * s_scenes.Length];
                s_scenes.CopyTo(larger, 0);
                Volatile.Write(ref s_scenes, larger);
            }

            scene.Handle = (++s_given << PlaceBits) | (nuint)place;
            Volatile.Write(ref s_scenes[place], scene);
            return scene.Handle;
        }
    }

    /// <summary>The scene of a handle; null if the handle is invalid.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static CompiledScene? Find(nuint handle)
    {
        CompiledScene?[] scenes = Volatile.Read(ref s_scenes);
        nuint place = handle & PlaceMask;
        if (place < (nuint)scenes.Length && Volatile.Read(ref scenes[place]) is { } scene && scene.Handle == handle)
        {
            return scene;
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
            s_scenes[place] = null;
            s_free.Push(place);
            return true;
        }
    }
}
