using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>How the methods that every step runs are compiled.</summary>
internal static class Hot
{
    /// <summary>
    /// At once and in full: not first without optimisation, and not by a profile of the calls so far, whose placement of the branches
    /// costs a step up to a fifth. The number is <c>AggressiveOptimization</c>, which netstandard2.1 has no name for.
    /// </summary>
    public const MethodImplOptions Path = (MethodImplOptions)512;
}
