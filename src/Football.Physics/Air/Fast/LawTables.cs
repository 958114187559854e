namespace FootballPhysics;

/// <summary>The functions of a law as tables that need no root of their argument.</summary>
internal sealed class LawTables
{
    /// <summary>log₂ S² from which on segments are fine: S 0.004.</summary>
    private const int Usual = -16;

    /// <summary>Exponent of the square of the largest spin parameter, 2.8.</summary>
    private const int Largest = 3;

    /// <summary>Below S 2.3e-10 there is no spin.</summary>
    private const int None = -64;

    /// <summary>Exponent below the S² that a ball without spin is given.</summary>
    private const int Least = -81;

    /// <summary>Tabulates a law's functions.</summary>
    /// <param name="law">The law; what it has from a scene is not asked.</param>
    /// <param name="speeds">Squares of the scaled speed.</param>
    /// <param name="crisis">Those with finer segments.</param>
    public LawTables(ITableLaw law, Octaves speeds, Octaves crisis)
    {
        Speeds = new FactorTable((double x, out LawFactors values) => law.OfSpeed(Math.Sqrt(x), out values), speeds, crisis);
        double none = new Octaves(None, Largest, 0).Lowest;
        Spins = law.NeedsSpinAcross
            ? new FactorTable(
                (double x, out LawFactors values) => law.OfSpin(x < none ? 0 : Math.Sqrt(x), out values),
                new Octaves(Least, Largest, 4),
                new Octaves(Usual, Largest, 6))
            : new FactorTable(
                (double x, out LawFactors values) => law.OfSpin(x * none > 1 ? 0 : 1.0 / Math.Sqrt(x), out values),
                new Octaves(-Largest, -Least, 4),
                new Octaves(-Largest, -Usual, 6));
        Slowest = Math.Sqrt(speeds.Lowest);
        Fastest = Math.Sqrt(speeds.Start(speeds.Segments));
    }

    /// <summary>Functions of the speed, over the square of the scaled speed.</summary>
    public FactorTable Speeds { get; }

    /// <summary>Functions of the spin parameter: over S² where that is of the spin across the motion, over 1/S² elsewhere.</summary>
    public FactorTable Spins { get; }

    /// <summary>The slowest scaled speed in the table.</summary>
    public double Slowest { get; }

    /// <summary>Fastest speed of the tables, m/s.</summary>
    public double Fastest { get; }
}
