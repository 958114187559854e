using System.Text;

namespace FootballPhysics.Tool.Sweep.Ranges;

/// <summary>The counter-based random number generator splitmix64. A random number depends only on the seed, the name of the field and the row.</summary>
internal static class CounterRandom
{
    private const ulong Golden = 0x9E3779B97F4A7C15UL;

    /// <summary>Returns the key of a field's random numbers.</summary>
    /// <param name="seed">The seed of the sweep.</param>
    /// <param name="field">The path of the field.</param>
    public static ulong Stream(long seed, string field)
    {
        // FNV-1a
        ulong hash = 0xCBF29CE484222325UL;
        foreach (byte letter in Encoding.UTF8.GetBytes(field))
        {
            hash = unchecked((hash ^ letter) * 0x100000001B3UL);
        }

        return Mix(unchecked(Mix((ulong)seed + Golden) ^ hash));
    }

    /// <summary>Returns the random number of a row, uniform in 0 … 1, both excluded.</summary>
    public static double At(ulong stream, long index)
    {
        ulong bits = Mix(unchecked(stream + (Golden * ((ulong)index + 1))));
        return ((bits >> 12) + 0.5) * (1.0 / (1UL << 52));
    }

    private static ulong Mix(ulong z)
    {
        unchecked
        {
            z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9UL;
            z = (z ^ (z >> 27)) * 0x94D049BB133111EBUL;
            return z ^ (z >> 31);
        }
    }
}
