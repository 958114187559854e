using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>The side force on a ball with little spin: a smooth, pure function of seed, distance flown, air velocity and spin.</summary>
/// <remarks>
/// F_K = κ(|u|, S) (f₁ ê₁ + f₂ ê₂), ê₁ = û × ŷ normalized (ẑ if vertical), ê₂ = ê₁ × û.
/// <para>Fitted to Hong and Asai 2014: peak at 2.5 Hz and standard deviation K at 30 m/s, growth from 20 to 30 m/s. The limits in the spin parameter and the
/// four waves are guesses.</para>
/// </remarks>
internal sealed class KnuckleForce
{
    private const int Waves = 4;

    /// <summary>The Strouhal number 2r f/|u| of the middle of the spectrum (measured).</summary>
    public const double Strouhal = 0.0183;

    /// <summary>The exponent of the growth with speed (measured: by 320 % from 20 to 30 m/s).</summary>
    public const double Growth = 2.9;

    /// <summary>The spin parameter up to which the full force acts (guess).</summary>
    public const double LeastSpin = 0.02;

    /// <summary>The width in spin parameter over which the force falls to 0 (guess).</summary>
    public const double SpinWidth = 0.04;

    private const double Slowest = 3;
    private const double Fastest = 40;

    private static readonly double[] Frequency = [0.45, 0.75, 1, 1.4];
    private static readonly double[] Weight = [0.70, 0.95, 1, 0.60];
    private static readonly PowerTable Power = new(Growth);

    private readonly FourWaves _first;
    private readonly FourWaves _second;
    private readonly double _perMass;
    private readonly double _radius;

    private KnuckleForce(Scene scene, long seed)
    {
        double r = scene.Ball.Radius;
        double sum = 0;
        foreach (double w in Weight)
        {
            sum += 0.5 * w * w;
        }

        // c = 1/√(Σ w²/2), so that the standard deviation of f is 1.
        double scale = 1.0 / Math.Sqrt(sum);
        var amplitude = new Quad(scale * Weight[0], scale * Weight[1], scale * Weight[2], scale * Weight[3]);
        _first = new FourWaves(seed, 0, r, amplitude);
        _second = new FourWaves(seed, 8, r, amplitude);
        _radius = r;
        _perMass = scene.Ball.KnuckleForce * (scene.Air.Density / 1.2) * (r / 0.11) * (r / 0.11) / scene.Ball.Mass;
    }

    /// <summary>Returns the force of a scene; null if none acts.</summary>
    public static KnuckleForce? Of(Scene scene) => scene.Forces.KnuckleSeed is { } seed && scene.Ball.KnuckleForce > 0 ? new KnuckleForce(scene, seed) : null;

    /// <summary>An upper bound on the effect: |F_K|/m ≤ √2 c Σ w κ/m, and κ/|u|² is largest at the speed where κ stops growing.</summary>
    public RateBound Bound => new(_perMass * Math.Sqrt(2.0) * _first.Amplitude.Sum * Power.Of(Fastest / 30.0) / (Fastest * Fastest), 0, 0);

    /// <summary>Returns the acceleration, in m/s².</summary>
    /// <param name="u">The velocity relative to the air, in m/s.</param>
    /// <param name="spin">The spin, in rad/s.</param>
    /// <param name="distance">The distance flown through the air, s, in m.</param>
    public Vector3d Acceleration(in Vector3d u, in Vector3d spin, double distance)
    {
        double speedSquared = u.LengthSquared;
        if (!(speedSquared >= Slowest * Slowest))
        {
            return Vector3d.Zero;
        }

        // κ = K (ρ/1.2)(r/0.11)² (min(|u|, 40)/30)^2.9 (1 − h),  h = x²(3 − 2x),  x = clamp((S − 0.02)/0.04, 0, 1),  S = r|ω × u|/|u|²
        double spinParameter = _radius * Vector3d.Cross(in spin, in u).Length / speedSquared;
        double x = Math.Min(Math.Max((spinParameter - LeastSpin) / SpinWidth, 0.0), 1.0);
        double fade = 1.0 - (x * x * (3.0 - (2.0 * x)));
        if (fade <= 0)
        {
            return Vector3d.Zero;
        }

        double speed = Math.Sqrt(speedSquared);
        double strength = _perMass * Power.Of(Math.Min(speed, Fastest) / 30.0) * fade;

        // ê₁ = û × ŷ normalised, or ẑ if û is vertical; ê₂ = ê₁ × û.
        Vector3d along = u / speed;
        var level = new Vector3d(-along.Z, 0, along.X);
        double across = level.Length;
        Vector3d first = across > 0 ? level / across : new Vector3d(0, 0, 1);
        return (strength * Wobble(_first, distance) * first) + (strength * Wobble(_second, distance) * Vector3d.Cross(in first, in along));
    }

    // f_i = c Σ_k w_k sin 2π(0.0183 g_k (1 + 0.2 (R(8i+2k+1) − ½)) s/(2r) + R(8i+2k)),  c = 1/√(Σ w²/2)
    private static double Wobble(FourWaves waves, double distance)
    {
        QuadSine.SinCos((waves.TurnsPerMetre * Quad.Of(QuadSine.Limited(distance))) + waves.Phase, out Quad sin, out _);
        return (waves.Amplitude * sin).Sum;
    }

    // This is a separate class, so that a scene without a knuckle force loads no SIMD data.
    private sealed class FourWaves
    {
        public readonly Quad Amplitude;
        public readonly Quad TurnsPerMetre;
        public readonly Quad Phase;

        public FourWaves(long seed, int first, double radius, Quad amplitude)
        {
            Amplitude = amplitude;
            Span<double> turns = stackalloc double[Waves];
            Span<double> phase = stackalloc double[Waves];
            for (int k = 0; k < Waves; k++)
            {
                turns[k] = Strouhal * Frequency[k] * (1.0 + (0.2 * (SplitMix64.At(seed, first + (2 * k) + 1) - 0.5))) / (2.0 * radius);
                phase[k] = SplitMix64.At(seed, first + (2 * k));
            }

            TurnsPerMetre = new Quad(turns[0], turns[1], turns[2], turns[3]);
            Phase = new Quad(phase[0], phase[1], phase[2], phase[3]);
        }
    }
}
