namespace FootballPhysics.Laws;

/// <summary>The tabulated functions of a law, over squared arguments, so that no root is needed.</summary>
internal sealed class LawTables
{
    /// <summary>log₂ S² at which the fine segments begin: S = 0.004.</summary>
    private const int Usual = -16;

    /// <summary>The exponent of S² at which the fine segments end: S = 2.8.</summary>
    private const int Rare = 3;

    /// <summary>The exponent of the square of the largest spin parameter, 32.</summary>
    private const int Largest = 10;

    /// <summary>The exponent of S² below which there is no spin: S = 2.3e-10.</summary>
    private const int None = -64;

    /// <summary>An exponent below that of the S² used for a ball without spin.</summary>
    private const int Least = -91;

    /// <summary>Tabulates the functions of a law.</summary>
    /// <remarks>At S = 2, one plate of the empirical spin decay has zero speed. A segment ends there, because its square is a power of two.</remarks>
    /// <param name="law">The law; its constants from a scene are not used.</param>
    /// <param name="speeds">The range of the squared scaled speed.</param>
    /// <param name="crisis">The part of this range with finer segments.</param>
    public LawTables(ITableLaw law, Octaves speeds, Octaves crisis)
    {
        Speeds = new FactorTable((double x, out LawFactors values) => law.OfSpeed(Math.Sqrt(x), out values), speeds, crisis);
        double none = new Octaves(None, Largest, 0).Lowest;
        Spins = law.NeedsSpinAcross
            ? new FactorTable(
                (double x, out LawFactors values) => law.OfSpin(x < none ? 0 : Math.Sqrt(x), out values),
                new Octaves(Least, Largest, 4),
                new Octaves(Usual, Rare, 6))
            : new FactorTable(
                (double x, out LawFactors values) => law.OfSpin(x * none > 1 ? 0 : 1.0 / Math.Sqrt(x), out values),
                new Octaves(-Largest, -Least, 4),
                new Octaves(-Rare, -Usual, 6));
        Slowest = Math.Sqrt(speeds.Lowest);
        Fastest = Math.Sqrt(speeds.Start(speeds.Segments));
    }

    /// <summary>The functions of speed, over the squared scaled speed.</summary>
    public FactorTable Speeds { get; }

    /// <summary>The functions of the spin parameter: over S² for spin across the motion, over 1/S² for the total spin.</summary>
    public FactorTable Spins { get; }

    /// <summary>The lowest scaled speed in the table.</summary>
    public double Slowest { get; }

    /// <summary>The highest scaled speed in the table.</summary>
    public double Fastest { get; }
}
