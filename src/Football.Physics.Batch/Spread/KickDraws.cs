using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>Draws independent normal numbers that cover their space evenly: a shifted lattice, in several copies.</summary>
/// <remarks>
/// The points are multiples of powers of 1/φ, φ⁵ = φ + 1, modulo 1 (the additive recurrence R₄). Each copy has its own random shift, so that the
/// copies differ by the error of one of them. A point depends only on seed and index: integer arithmetic makes it bit-identical everywhere.
/// </remarks>
internal readonly struct KickDraws
{
    /// <summary>The number of copies; consecutive points belong to different copies.</summary>
    public const int Copies = 8;

    /// <summary>2⁶⁴ φ⁻¹ … 2⁶⁴ φ⁻⁴, φ = 1.16730397826141868….</summary>
    private static readonly ulong[] s_steps = [0xDB4F0B9175AE2165UL, 0xBBE0563303A4615FUL, 0xA0F2EC75A1FE1575UL, 0x89E182857D9ED688UL];

    private readonly ulong[] _shifts;

    public KickDraws(long seed)
    {
        _shifts = new ulong[Copies * KickSpread.Count];
        for (int i = 0; i < _shifts.Length; i++)
        {
            _shifts[i] = SplitMix64.BitsAt(seed, i);
        }
    }

    /// <summary>Draws the numbers of a point.</summary>
    /// <param name="index">The index of the point; at least 0.</param>
    /// <param name="normal">Receives the numbers.</param>
    public void Draw(int index, double[] normal)
    {
        int copy = index % Copies;
        ulong step = (ulong)(index / Copies);
        for (int i = 0; i < KickSpread.Count; i += 2)
        {
            int at = (copy * KickSpread.Count) + i;
            double first = SplitMix64.Uniform(unchecked(_shifts[at] + (step * s_steps[i])));
            double second = SplitMix64.Uniform(unchecked(_shifts[at + 1] + (step * s_steps[i + 1])));
            NormalDistribution.Draw(first, second, out normal[i], out normal[i + 1]);
        }
    }
}
