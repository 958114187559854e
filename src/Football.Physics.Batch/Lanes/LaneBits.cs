namespace FootballPhysics.Batch;

/// <summary>Constants of the float format.</summary>
internal static class LaneBits
{
    /// <summary>The bits of √½.</summary>
    public const int RootHalf = 0x3F3504F3;

    /// <summary>The bias of the exponent.</summary>
    public const int Bias = 127;
}
