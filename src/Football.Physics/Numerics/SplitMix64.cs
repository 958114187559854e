namespace FootballPhysics.Numerics;

/// <summary>SplitMix64 as a counter-based generator: a number depends only on seed and counter.</summary>
internal static class SplitMix64
{
    /// <summary>Returns the number R(j), uniform in 0 … 1, excluding 1.</summary>
    /// <param name="seed">The seed.</param>
    /// <param name="counter">The counter j; at least 0.</param>
    public static double At(long seed, int counter) => Uniform(BitsAt(seed, counter));

    /// <summary>Returns 53 random bits, followed by 11 zeros.</summary>
    /// <param name="seed">The seed.</param>
    /// <param name="counter">The counter j; at least 0.</param>
    public static ulong BitsAt(long seed, int counter)
    {
        unchecked
        {
            // Add the golden-ratio constant counter + 1 times, then mix with SplitMix64's finaliser.
            ulong z = (ulong)seed + (0x9E3779B97F4A7C15UL * ((ulong)counter + 1UL));
            z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9UL;
            z = (z ^ (z >> 27)) * 0x94D049BB133111EBUL;
            return (z ^ (z >> 31)) >> 11 << 11;
        }
    }

    /// <summary>Returns the number in 0 … 1 of the upper 53 bits: all multiples of 2⁻⁵³ are equally likely.</summary>
    public static double Uniform(ulong bits) => (bits >> 11) * (1.0 / 9007199254740992.0);
}
