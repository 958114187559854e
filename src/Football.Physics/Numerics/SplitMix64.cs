namespace FootballPhysics;

/// <summary>splitmix64 as a counter generator: the same number for the same seed and counter, in any order.</summary>
internal static class SplitMix64
{
    /// <summary>The number R(j), uniform in 0 … 1, 1 excluded.</summary>
    /// <param name="seed">The seed.</param>
    /// <param name="counter">j, not negative.</param>
    public static double At(long seed, int counter)
    {
        unchecked
        {
            // The counter-th multiple of the golden ratio's odd number, mixed by the finaliser of splitmix64.
            ulong z = (ulong)seed + (0x9E3779B97F4A7C15UL * ((ulong)counter + 1UL));
            z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9UL;
            z = (z ^ (z >> 27)) * 0x94D049BB133111EBUL;

            // The upper 53 bits: every double of that many digits as often.
            return ((z ^ (z >> 31)) >> 11) * (1.0 / 9007199254740992.0);
        }
    }
}
