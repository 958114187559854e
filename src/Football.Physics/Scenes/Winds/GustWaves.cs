namespace Football.Physics;

/// <summary>Twelve sines a component with a Dryden spectrum: the gusts as a function of the distance along the wind.</summary>
internal sealed class GustWaves
{
    private const int Bands = 12;

    /// <summary>q = 400^(1/12): the bands reach from 0.05/L to 20/L.</summary>
    private static readonly double BandRatio = Elementary.Pow(400.0, 1.0 / Bands);

    private static readonly double[] ShareOfComponent = [1.0, 0.8, 0.5];

    private readonly Wave[] _waves = new Wave[Bands];

    /// <param name="gusts">The gusts.</param>
    /// <param name="speed">Speed of the wind at the reference height, m/s.</param>
    public GustWaves(Gusts gusts, double speed)
    {
        double q = BandRatio;
        double low = 0.05;
        Span<double> along = stackalloc double[Bands];
        Span<double> across = stackalloc double[Bands];
        double sumAlong = 0;
        double sumAcross = 0;
        for (int i = 0; i < Bands; i++)
        {
            // x = √(lo · lo q) (1 + 0.3 (R(100 + i) − ½)(q − 1)),  k = x/L
            double high = low * q;
            double x = Math.Sqrt(low * high) * (1.0 + (0.3 * (SplitMix64.At(gusts.Seed, 100 + i) - 0.5) * (q - 1.0)));
            _waves[i].TurnsPerMetre = x / gusts.Length / (2.0 * Math.PI);

            // Share of the variance: along (2/π)(atan hi − atan lo), across and up F(hi) − F(lo)
            along[i] = 2.0 / Math.PI * (Atan(high) - Atan(low));
            across[i] = AcrossUpTo(high) - AcrossUpTo(low);
            sumAlong += along[i];
            sumAcross += across[i];
            low = high;
        }

        double deviation = gusts.Intensity * speed;
        for (int i = 0; i < Bands; i++)
        {
            ref Wave wave = ref _waves[i];
            double ofAlong = Math.Sqrt(2.0 * along[i] / sumAlong);
            double ofAcross = Math.Sqrt(2.0 * across[i] / sumAcross);
            Phase(gusts.Seed, 0, i, deviation * ShareOfComponent[0] * ofAlong, out wave.AlongSin, out wave.AlongCos);
            Phase(gusts.Seed, 1, i, deviation * ShareOfComponent[1] * ofAcross, out wave.AcrossSin, out wave.AcrossCos);
            Phase(gusts.Seed, 2, i, deviation * ShareOfComponent[2] * ofAcross, out wave.UpSin, out wave.UpCos);
            Largest += deviation * new Vector3d(ShareOfComponent[0] * ofAlong, ShareOfComponent[1] * ofAcross, ShareOfComponent[2] * ofAcross);
        }
    }

    /// <summary>The largest that each of g₀, g₁, g₂ can be, m/s.</summary>
    public Vector3d Largest { get; }

    /// <summary>g₀, g₁, g₂, m/s, as x, y and z: along, across and up, each Σ a sin(k ξ + φ).</summary>
    /// <param name="distance">ξ, m.</param>
    public Vector3d At(double distance)
    {
        double along = 0;
        double across = 0;
        double up = 0;
        foreach (ref readonly Wave wave in _waves.AsSpan())
        {
            SineTable.SinCos(wave.TurnsPerMetre * distance, out double sin, out double cos);
            along += (wave.AlongSin * sin) + (wave.AlongCos * cos);
            across += (wave.AcrossSin * sin) + (wave.AcrossCos * cos);
            up += (wave.UpSin * sin) + (wave.UpCos * cos);
        }

        return new Vector3d(along, across, up);
    }

    // a sin(k ξ + φ) = a cos φ sin(k ξ) + a sin φ cos(k ξ),  φ = 2π R(1000 (c + 1) + i)
    private static void Phase(long seed, int component, int band, double amplitude, out double ofSin, out double ofCos)
    {
        SineTable.SinCos(SplitMix64.At(seed, (1000 * (component + 1)) + band), out double sin, out double cos);
        ofSin = amplitude * cos;
        ofCos = amplitude * sin;
    }

    // F(y) = (2 atan y − y/(1 + y²))/π
    private static double AcrossUpTo(double y) => ((2.0 * Atan(y)) - (y / (1.0 + (y * y)))) / Math.PI;

    private static double Atan(double y) => Elementary.Atan2(y, 1.0);

    private struct Wave
    {
        public double TurnsPerMetre;
        public double AlongSin;
        public double AlongCos;
        public double AcrossSin;
        public double AcrossCos;
        public double UpSin;
        public double UpCos;
    }
}
