using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>How the methods that fly many balls side by side are compiled.</summary>
internal static class Hot
{
    /// <summary>
    /// At once and in full: without optimisation code of vectors is a hundred times as slow, and a batch is over before it is compiled again. The methods of one
    /// ball are compiled by tiers: in full they cost each first use milliseconds, and ahead of time they would not be compiled at all. The number is <c>AggressiveOptimization</c>, which netstandard2.1 has no name for.
    /// </summary>
    public const MethodImplOptions Path = (MethodImplOptions)512;
}
