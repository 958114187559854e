using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>How the step of flight is compiled, and the methods that fly many balls side by side.</summary>
internal static class Hot
{
    /// <summary>
    /// At once and in full. Code of vectors is a hundred times as slow without, and a batch is over before it is compiled again; placed by a profile of the calls
    /// so far, the step of flight takes up to a fifth longer (`quick --only "flight step, fast: RK4"`). All else of one ball is compiled by tiers: in full it costs each
    /// first use milliseconds, and ahead of time it would not be compiled at all. The number is <c>AggressiveOptimization</c>, which netstandard2.1 has no name for.
    /// </summary>
    public const MethodImplOptions Path = (MethodImplOptions)512;
}
