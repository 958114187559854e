namespace Football.Physics;

/// <summary>
/// The side force on a ball with little spin, a smooth pure function of seed, distance flown through the air, air velocity and spin (fitted to
/// Hong and Asai 2014: peak at 2.5 Hz and standard deviation K at 30 m/s, growth from 20 to 30 m/s; limits in the spin parameter and the four
/// waves are guesses):
/// F_K = κ(|u|, S) (f₁ ê₁ + f₂ ê₂),  ê₁ = û × ŷ normalised (ẑ if vertical),  ê₂ = ê₁ × û.
/// </summary>
internal sealed class KnuckleForce
{
    private const int Waves = 4;

    /// <summary>Strouhal number 2r f/|u| of the middle of the spectrum (measured).</summary>
    private const double Strouhal = 0.0183;

    private const double Slowest = 3;
    private const double Fastest = 40;
    private const double LeastSpin = 0.02;
    private const double SpinWidth = 0.04;

    private static readonly double[] Frequency = [0.45, 0.75, 1, 1.4];
    private static readonly double[] Weight = [0.70, 0.95, 1, 0.60];
    private static readonly PowerTable Power = new(2.9);

    private readonly double[] _turnsPerMetre = new double[2 * Waves];
    private readonly double[] _phase = new double[2 * Waves];
    private readonly double[] _amplitude = new double[Waves];
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

        // f_i = c Σ_k w_k sin 2π(0.0183 g_k (1 + 0.2 (R(8i+2k+1) − ½)) s/(2r) + R(8i+2k)),  c = 1/√(Σ w²/2)
        for (int k = 0; k < Waves; k++)
        {
            _amplitude[k] = Weight[k] / Math.Sqrt(sum);
            for (int i = 0; i < 2; i++)
            {
                int counter = (8 * i) + (2 * k);
                _turnsPerMetre[(Waves * i) + k] = Strouhal * Frequency[k] * (1.0 + (0.2 * (SplitMix64.At(seed, counter + 1) - 0.5))) / (2.0 * r);
                _phase[(Waves * i) + k] = SplitMix64.At(seed, counter);
            }
        }

        _radius = r;
        _perMass = scene.Ball.KnuckleForce * (scene.Air.Density / 1.2) * (r / 0.11) * (r / 0.11) / scene.Ball.Mass;
    }

    /// <summary>The force of a scene; null where none acts.</summary>
    public static KnuckleForce? Of(Scene scene) => scene.Forces.KnuckleSeed is { } seed && scene.Ball.KnuckleForce > 0 ? new KnuckleForce(scene, seed) : null;

    /// <summary>The acceleration, m/s².</summary>
    /// <param name="u">Velocity relative to the air, m/s.</param>
    /// <param name="spin">Spin, rad/s.</param>
    /// <param name="distance">Distance flown through the air, s, m.</param>
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
        Vector3d along = u / speed;
        var level = new Vector3d(-along.Z, 0, along.X);
        double across = level.Length;
        Vector3d first = across > 0 ? level / across : new Vector3d(0, 0, 1);
        return (strength * Wobble(0, distance) * first) + (strength * Wobble(Waves, distance) * Vector3d.Cross(in first, in along));
    }

    private double Wobble(int from, double distance)
    {
        double sum = 0;
        for (int k = 0; k < Waves; k++)
        {
            SineTable.SinCos((_turnsPerMetre[from + k] * distance) + _phase[from + k], out double sin, out _);
            sum += _amplitude[k] * sin;
        }

        return sum;
    }
}
