using System.Runtime.CompilerServices;
using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>The side force on a ball that hardly turns: a smooth, pure function of both seeds, orientation, distance flown, air velocity and spin.</summary>
/// <remarks>
/// F_K = ½ ρ π r² U² (1 − (1 − g₀) q)/(1 + (S/S_K)²) C_K (A G(b) + c_W (min(U, 40)/30)^0.9 (f₁ ê₁ + f₂ ê₂)), b = Aᵀ û, ê₁ = û × ŷ normalized (ẑ if vertical),
/// ê₂ = ê₁ × û. The first part belongs to the seams (<see cref="SeamField"/>) and turns with the ball. The second is a wave of the wake along the distance flown.
/// </remarks>
internal sealed class KnuckleForce
{
    private const int Waves = 4;

    /// <summary>The dynamic force at 30 m/s, in air of 1.2 kg/m³, on a ball with a radius of 0.11 m, in N: C_K = K/20.53 N.</summary>
    public const double ReferenceForce = 20.53;

    /// <summary>The Strouhal number 2r f/U of the middle of the wake's spectrum (measured: Hong and Asai 2014, peak at 2.5 Hz at 30 m/s).</summary>
    public const double Strouhal = 0.0183;

    /// <summary>The exponent of the growth of the wake's coefficient with speed (measured: Hong and Asai 2014, force by 320 % from 20 to 30 m/s; 2.9 − 2).</summary>
    public const double Growth = 0.9;

    /// <summary>c_W, the size of the wake's wave relative to the field of the seams (guess, 0 … 0.7).</summary>
    public const double Wake = 0.35;

    /// <summary>g₀, the share of the force that is left below the drag crisis (guess, 0 … 1).</summary>
    public const double Subcritical = 0.3;

    /// <summary>S_K, the spin parameter at which half of the force is left (guess, 0.05 … ∞). It matters only if the axis is tilted towards the motion.</summary>
    public const double SpinScale = 0.1;

    /// <summary>The speed above which the wake's coefficient stops growing, in m/s.</summary>
    private const double Fastest = 40;

    /// <summary>The speed below which no force acts, in m/s.</summary>
    private const double Slowest = 1e-9;

    /// <summary>The counter of the first random number of the orientation.</summary>
    private const int FirstOfOrientation = 64;

    private static readonly double[] Frequency = [0.45, 0.75, 1, 1.4];
    private static readonly double[] Weight = [0.70, 0.95, 1, 0.60];
    private static readonly PowerTable Power = new(Growth);

    private readonly SeamField _seams;
    private readonly FourWaves _first;
    private readonly FourWaves _second;
    private readonly double _scale; // ½ ρ π r² C_K/m, 1/m
    private readonly double _surface; // r²/S_K²
    private readonly SubcriticalFlow _flow;

    private KnuckleForce(Scene scene, long seed)
    {
        BallProperties ball = scene.Ball;
        double sum = 0;
        foreach (double w in Weight)
        {
            sum += 0.5 * w * w;
        }

        // c scales the weights w of the four waves of f₁ and f₂.
        // c = 1/√(Σ w²/2), so that the standard deviation of f is 1.
        double scale = 1.0 / Math.Sqrt(sum);
        var amplitude = new Quad(scale * Weight[0], scale * Weight[1], scale * Weight[2], scale * Weight[3]);
        _first = new FourWaves(seed, 0, ball.Radius, amplitude);
        _second = new FourWaves(seed, 8, ball.Radius, amplitude);
        _seams = new SeamField(ball.SeamSeed);
        _flow = new SubcriticalFlow(scene);
        _surface = ball.Radius * ball.Radius / (SpinScale * SpinScale);
        _scale = AirScale.DynamicArea(scene) * (ball.KnuckleForce / ReferenceForce);
    }

    /// <summary>Returns the force of a scene; null if none acts.</summary>
    public static KnuckleForce? Of(Scene scene) => scene.Forces.KnuckleSeed is { } seed && scene.Ball.KnuckleForce > 0 ? new KnuckleForce(scene, seed) : null;

    /// <summary>Returns the orientation of a ball that is launched without one: random by the seed of the kick, and the identity without a seed.</summary>
    public static Quaterniond Orientation(Scene scene)
    {
        if (scene.Forces.KnuckleSeed is not { } seed)
        {
            return Quaterniond.Identity;
        }

        // A uniform rotation of three uniform numbers (Shoemake 1992).
        double share = SplitMix64.At(seed, FirstOfOrientation);
        Elementary.SinCos(2.0 * Math.PI * SplitMix64.At(seed, FirstOfOrientation + 1), out double sinA, out double cosA);
        Elementary.SinCos(2.0 * Math.PI * SplitMix64.At(seed, FirstOfOrientation + 2), out double sinB, out double cosB);
        double a = Math.Sqrt(1.0 - share);
        double b = Math.Sqrt(share);
        return new Quaterniond(a * sinA, a * cosA, b * sinB, b * cosB);
    }

    /// <summary>An upper bound on the effect: the largest |G|, and √2 c Σ w for the wake.</summary>
    public RateBound Bound =>
        new(_scale * (_seams.Largest + (Wake * Power.Of(Fastest / 30.0) * Math.Sqrt(2.0) * _first.Amplitude.Sum)), 0, 0);

    /// <inheritdoc cref="IFlightLaws.Begin"/>
    public void Begin(in BallState start, out SeamAxes seams) => _seams.Turn(start.Angle == 0 ? start.BaseOrientation : start.Orientation, out seams);

    /// <summary>Returns the acceleration at an orientation, in m/s².</summary>
    /// <param name="u">The velocity relative to the air, in m/s.</param>
    /// <param name="spin">The spin, in rad/s.</param>
    /// <param name="distance">The distance flown through the air, s, in m.</param>
    /// <param name="orientation">The orientation.</param>
    public Vector3d Acceleration(in Vector3d u, in Vector3d spin, double distance, in Quaterniond orientation)
    {
        _seams.Turn(in orientation, out SeamAxes seams);
        double squared = u.LengthSquared;
        return Acceleration(in seams, u.X, u.Y, u.Z, 1.0 / squared, Math.Sqrt(squared), ShareAt(squared), Vector3d.Cross(in spin, in u).LengthSquared, distance);
    }

    /// <summary>Returns q, the share of subcritical flow.</summary>
    public double ShareAt(double speedSquared) => _flow.Share(speedSquared);

    /// <summary>Turns the seams about a constant axis.</summary>
    /// <param name="seams">The axes of the seams before the turn.</param>
    /// <param name="axis">The axis of the turn.</param>
    /// <param name="turn">The angle of the turn, in rad.</param>
    /// <param name="turned">The axes of the seams after it.</param>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Turn(in SeamAxes seams, in Vector3d axis, double turn, out SeamAxes turned)
    {
        SmallAngle(turn, out double sin, out double versine);
        seams.Turn(in axis, sin, versine, out turned);
    }

    /// <inheritdoc cref="IFlightLaws.Turn(in SeamAxes, in BallState, double, out SeamAxes, out Quaterniond)"/>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Turn(in SeamAxes seams, in BallState start, double half, out SeamAxes middle, out Quaterniond end)
    {
        SmallAngle(half, out double sin, out double versine);
        seams.Turn(in start.Flight.Axis, sin, versine, out middle);
        end = start.BaseOrientation.Turned(in start.Flight.Axis, sin, 1.0 - versine);
    }

    /// <summary>Returns the acceleration at an orientation, in m/s².</summary>
    /// <param name="seams">The axes of the seams.</param>
    /// <param name="ux">The x component of the velocity relative to the air, in m/s.</param>
    /// <param name="uy">Its y component.</param>
    /// <param name="uz">Its z component.</param>
    /// <param name="perSquared">1/|u|², in s²/m².</param>
    /// <param name="speed">|u|, in m/s.</param>
    /// <param name="share">q, the share of subcritical flow.</param>
    /// <param name="crossSquared">|ω × u|², in m²/s⁴.</param>
    /// <param name="distance">The distance flown through the air, s, in m.</param>
    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    public Vector3d Acceleration(in SeamAxes seams, double ux, double uy, double uz, double perSquared, double speed, double share, double crossSquared, double distance)
    {
        if (!(speed >= Slowest))
        {
            return Vector3d.Zero;
        }

        // The seams: U G, from u instead of û, so that nothing waits for a root. The axes turn, and not u and the field: turning them does not wait for u.
        Vector3d field = _seams.At(in seams, ux, uy, uz, perSquared, out double along);
        along *= perSquared;

        // The wake: ê₁ = û × ŷ normalised, or ẑ if û is vertical; ê₂ = ê₁ × û. All times U.
        double level = (ux * ux) + (uz * uz);
        var flown = Quad.Of(QuadSine.Limited(distance));
        double wake = Wake * Power.Of(Math.Min(speed, Fastest) * (1.0 / 30.0));
        double f1 = wake * speed * _first.At(flown);
        double f2 = wake * _second.At(flown);

        // U is the airspeed, q the share of the flow below the drag crisis; the constants above define C_K, g₀ and S_K.
        // ½ ρ π r² U C_K/m (1 − (1 − g₀) q)/(1 + (S/S_K)²),  S² = r² |ω × u|²/U⁴
        double left = 1.0 - ((1.0 - Subcritical) * share);
        double fading = 1.0 + (_surface * crossSquared * (perSquared * perSquared));

        // One division serves 1/fading and 1/√level.
        double root = level > 0 ? Math.Sqrt(level) : 1.0;
        double reciprocal = 1.0 / (fading * root);
        double scale = _scale * speed * left * (reciprocal * root);
        double perLevel = reciprocal * fading;
        double ex = -uz * perLevel;
        double ez = level > 0 ? ux * perLevel : 1.0;
        return new Vector3d(
            scale * (field.X + (((f1 * ex) - (f2 * ez * uy)) - (along * ux))),
            scale * (field.Y + ((f2 * ((ez * ux) - (ex * uz))) - (along * uy))),
            scale * (field.Z + (((f1 * ez) + (f2 * ex * uy)) - (along * uz))));
    }

    /// <summary>Returns sin θ and 1 − cos θ, by Taylor series for the turn within a step.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void SmallAngle(double angle, out double sin, out double versine)
    {
        double z = angle * angle;
        if (z > 0.4)
        {
            Elementary.SinCos(angle, out sin, out double cos);
            versine = 1.0 - cos;
            return;
        }

        // Remainders below 1e-16. A slow turn needs fewer terms.
        double zz = z * z;
        double s = (1.0 / 362_880.0) - (z * (1.0 / 39_916_800.0));
        double v = (1.0 / 3_628_800.0) - (z * (1.0 / 479_001_600.0));
        if (z > 0.1)
        {
            s += zz * ((1.0 / 6_227_020_800.0) - (z * (1.0 / 1_307_674_368_000.0)));
            v += zz * ((1.0 / 87_178_291_200.0) - (z * (1.0 / 20_922_789_888_000.0)));
        }

        double zzzz = zz * zz;
        sin = angle * ((1.0 - (z * (1.0 / 6.0))) + (zz * ((1.0 / 120.0) - (z * (1.0 / 5040.0)))) + (zzzz * s));
        versine = z * ((0.5 - (z * (1.0 / 24.0))) + (zz * ((1.0 / 720.0) - (z * (1.0 / 40_320.0)))) + (zzzz * v));
    }

    // This is a separate class, so that a scene without a knuckle force loads no SIMD data.
    private sealed class FourWaves
    {
        public readonly Quad Amplitude;
        private readonly Quad _turnsPerMetre;
        private readonly Quad _phase;

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

            _turnsPerMetre = new Quad(turns[0], turns[1], turns[2], turns[3]);
            _phase = new Quad(phase[0], phase[1], phase[2], phase[3]);
        }

        /// <summary>Returns f_i = c Σ_k w_k sin 2π(0.0183 g_k (1 + 0.2 (R(8i+2k+1) − ½)) s/(2r) + R(8i+2k)), c = 1/√(Σ w²/2).</summary>
        /// <param name="distance">s in all lanes.</param>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public double At(Quad distance)
        {
            return (Amplitude * QuadSine.Sin((_turnsPerMetre * distance) + _phase)).SumOfHalves;
        }
    }
}
