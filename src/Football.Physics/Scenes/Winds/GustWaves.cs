using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Scenes;

/// <summary>The gusts as a function of the distance along the wind: twelve sines per component with a Dryden spectrum.</summary>
internal sealed class GustWaves
{
    private const int Bands = 12;
    private const int Components = 3;

    /// <summary>q = 400^(1/12): the bands cover wave numbers from 0.05/L to 20/L.</summary>
    private static readonly double BandRatio = Elementary.Pow(400.0, 1.0 / Bands);

    private static readonly double[] ShareOfComponent = [1.0, 0.8, 0.5];

    private readonly FourWaves[] _waves = new FourWaves[Bands / 4];

    /// <param name="gusts">The gusts.</param>
    /// <param name="speed">The wind speed at the reference height, in m/s.</param>
    public GustWaves(Gusts gusts, double speed)
    {
        // Each band has one random wave number, and its share of the variance.
        double q = BandRatio;
        double low = 0.05;
        Span<double> turnsPerMetre = stackalloc double[Bands];
        Span<double> along = stackalloc double[Bands];
        Span<double> across = stackalloc double[Bands];
        double sumAlong = 0;
        double sumAcross = 0;
        for (int i = 0; i < Bands; i++)
        {
            // lo is the lower end of the band and q the ratio of its ends, R(i) the random number i in 0 … 1, L the length of the gusts, k the wave number.
            // x = √(lo · lo q) (1 + 0.3 (R(100 + i) − ½)(q − 1)),  k = x/L
            double high = low * q;
            double x = Math.Sqrt(low * high) * (1.0 + (0.3 * (SplitMix64.At(gusts.Seed, 100 + i) - 0.5) * (q - 1.0)));
            turnsPerMetre[i] = x / gusts.Length / (2.0 * Math.PI);

            // The share of the variance: along (2/π)(atan hi − atan lo); across and up F(hi) − F(lo).
            along[i] = 2.0 / Math.PI * (Atan(high) - Atan(low));
            across[i] = AcrossUpTo(high) - AcrossUpTo(low);
            sumAlong += along[i];
            sumAcross += across[i];
            low = high;
        }

        // The variances of the amplitudes sum to the variance of the component; the phases are random.
        double deviation = gusts.Intensity * speed;
        Span<double> sines = stackalloc double[Bands];
        Span<double> cosines = stackalloc double[Bands];
        for (int component = 0; component < Components; component++)
        {
            Span<double> shares = component == 0 ? along : across;
            double sum = component == 0 ? sumAlong : sumAcross;
            double largest = 0;
            for (int i = 0; i < Bands; i++)
            {
                // a is the amplitude, φ the phase, ξ the distance along the wind, c the component, and R(i) the random number i.
                // a sin(k ξ + φ) = a cos φ sin(k ξ) + a sin φ cos(k ξ),  φ = 2π R(1000 (c + 1) + i)
                double amplitude = deviation * ShareOfComponent[component] * Math.Sqrt(2.0 * shares[i] / sum);
                Elementary.SinCos(2.0 * Math.PI * SplitMix64.At(gusts.Seed, (1000 * (component + 1)) + i), out double sin, out double cos);
                sines[i] = amplitude * cos;
                cosines[i] = amplitude * sin;
                largest += amplitude;
            }

            // The bound: all waves are at their crests at once.
            Largest += largest * Vector3d.Axis(component);
            for (int block = 0; block < _waves.Length; block++)
            {
                _waves[block].Set(component, At(sines, block), At(cosines, block));
            }
        }

        for (int block = 0; block < _waves.Length; block++)
        {
            _waves[block].TurnsPerMetre = At(turnsPerMetre, block);
        }
    }

    /// <summary>The maximum of each of g₀, g₁, g₂, in m/s.</summary>
    public Vector3d Largest { get; }

    /// <summary>Returns g₀, g₁, g₂ (along, across and up) as x, y and z, in m/s; each is Σ a sin(k ξ + φ).</summary>
    /// <param name="distance">The distance ξ, in m.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3d At(double distance)
    {
        Quad along = default;
        Quad across = default;
        Quad up = default;
        var far = Quad.Of(QuadSine.Limited(distance));
        foreach (ref readonly FourWaves waves in _waves.AsSpan())
        {
            // Evaluate four waves at a time. Angles are in turns, so that removing full turns is exact.
            QuadSine.SinCos(waves.TurnsPerMetre * far, out Quad sin, out Quad cos);
            along += (waves.AlongSin * sin) + (waves.AlongCos * cos);
            across += (waves.AcrossSin * sin) + (waves.AcrossCos * cos);
            up += (waves.UpSin * sin) + (waves.UpCos * cos);
        }

        return new Vector3d(along.Sum, across.Sum, up.Sum);
    }

    private static Quad At(Span<double> of, int block) => new(of[4 * block], of[(4 * block) + 1], of[(4 * block) + 2], of[(4 * block) + 3]);

    // F(y) = (2 atan y − y/(1 + y²))/π
    private static double AcrossUpTo(double y) => ((2.0 * Atan(y)) - (y / (1.0 + (y * y)))) / Math.PI;

    private static double Atan(double y) => Elementary.Atan2(y, 1.0);

    private struct FourWaves
    {
        public Quad TurnsPerMetre;
        public Quad AlongSin;
        public Quad AlongCos;
        public Quad AcrossSin;
        public Quad AcrossCos;
        public Quad UpSin;
        public Quad UpCos;

        public void Set(int component, Quad sin, Quad cos)
        {
            switch (component)
            {
                case 0:
                    AlongSin = sin;
                    AlongCos = cos;
                    break;
                case 1:
                    AcrossSin = sin;
                    AcrossCos = cos;
                    break;
                default:
                    UpSin = sin;
                    UpCos = cos;
                    break;
            }
        }
    }
}
