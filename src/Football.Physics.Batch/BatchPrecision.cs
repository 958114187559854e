namespace FootballPhysics.Batch;

/// <summary>The floating-point precision of a batch.</summary>
public enum BatchPrecision
{
    /// <summary>Single precision with compensated sums, several balls at once in SIMD lanes.</summary>
    /// <remarks>
    /// With steps up to 20 ms, a landing point typically differs by 1e-6 m from that of a single ball with the same step. The difference is within 1e-5 m for
    /// 99 % of footballers' shots, and within 1e-4 m for all (5e-4 m with steps of 40 ms).
    /// <para>The jump in the published drag law is located within its step. Balls that only graze the jump or slide along it are simulated in double
    /// precision. So are balls with a surface speed above 14 m/s, a speed above 128 m/s, or a height above 100 m.</para>
    /// </remarks>
    Single = 0,

    /// <summary>Double precision, ball by ball: bit-identical to a single ball.</summary>
    Double = 1,
}
