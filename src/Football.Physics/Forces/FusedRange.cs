using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Where the tables of the fused laws hold over a whole step.</summary>
internal static class FusedRange
{
    /// <summary>Speeds, m/s, beyond which the tables end; a step may not come near them.</summary>
    public const double Fastest = 120;
    private const double Slowest = 0.75;

    /// <summary>How much slower a ball may become within a step, m/s²: gravity and drag at speeds where that matters.</summary>
    private const double Deceleration = 30;

    /// <summary>A spin may lose this share within a step, for its powers are then good to 5e-9.</summary>
    private const double LargestLoss = 0.02;

    /// <summary>Whether the speed stays within the tables.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Holds(double speedSquared, double h)
    {
        double least = Slowest + (Deceleration * h);
        return speedSquared > least * least && speedSquared < Fastest * Fastest;
    }

    /// <summary>Whether the spin loses little enough; a ball without spin has none to lose.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Keeps(double spinRate, double loss) => spinRate * LargestLoss >= loss || spinRate == 0;
}
