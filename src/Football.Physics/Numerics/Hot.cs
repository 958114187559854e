using System.Runtime.CompilerServices;

namespace FootballPhysics.Numerics;

/// <summary>The compiler options of the flight step and of the SIMD batch methods.</summary>
internal static class Hot
{
    /// <summary>Full optimization at the first call, without tiers and profiles.</summary>
    /// <remarks>
    /// SIMD code is a hundred times slower without it, and a batch ends before tiered compilation starts. With code laid out from a call profile, the flight step
    /// can take a fifth longer (`quick --only "flight step, fast: RK4"`).
    /// <para>Other code of a single ball uses tiers: full optimization costs milliseconds at each first use, and excludes a method from ahead-of-time compilation.
    /// The value is <c>AggressiveOptimization</c>, which netstandard2.1 does not define.</para>
    /// </remarks>
    public const MethodImplOptions Path = (MethodImplOptions)512;
}
