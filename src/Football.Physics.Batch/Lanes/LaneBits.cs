namespace FootballPhysics.Batch;

/// <summary>The bits of floats.</summary>
internal static class LaneBits
{
    /// <summary>Bits of √½.</summary>
    public const int RootHalf = 0x3F3504F3;

    /// <summary>Bias of the exponent.</summary>
    public const int Bias = 127;
}
