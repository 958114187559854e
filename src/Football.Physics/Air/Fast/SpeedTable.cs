using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// What the published laws need of the speed, as functions of |u|², all found with one index: the powers of the branch with spin,
/// and the two sums of the branch without; and what they need of the spin.
/// </summary>
/// <remarks>
/// The top mantissa bits of |u|² choose a segment, on it a cubic through the Chebyshev points. Powers: 64 segments an octave, relative
/// error 3e-11, for every positive normal |u|²; the branch without spin: 128 an octave, relative error 2e-9, from 1/2 to 128 m/s,
/// beyond which its values mean nothing. There is no call and no test inside, so that a step keeps its numbers in registers.
/// </remarks>
internal static class SpeedTable
{
    private const int PowerBits = 6;
    private const int NoSpinBits = 7;
    private const int LowestExponent = 1023 - 2; // |u| = 1/2 m/s
    private const int Octaves = 16;              // up to |u| = 128 m/s

    private const double D = FittedDrag.D;
    private const double Beta = EmpiricalMagnus.Beta;
    private const double OfDecay = 0.5 * (double)EmpiricalSpinDecay.SpeedExponent;

    private static readonly Segment[] Powers = MakePowers();
    private static readonly Scale[] Scales = MakeScales();
    private static readonly Pair[] NoSpins = MakeNoSpins();
    private static readonly Pair[] SpinPowers = MakeSpinPowers();
    private static readonly SpinScale[] SpinScales = MakeSpinScales();

    /// <summary>Makes the tables, if they are not: methods compiled later know that they are there, and need not ask.</summary>
    public static void Make() => RuntimeHelpers.RunClassConstructor(typeof(SpeedTable).TypeHandle);

    /// <summary>Three factors times |u|^(1−d), |u|^(1−β) and |u|^(1−β−d): the factors meet the scales while the cubics are still busy.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void WithSpin(double speedSquared, ref double drag, ref double lift, ref double liftByDrag)
    {
        long bits = BitConverter.DoubleToInt64Bits(speedSquared);
        ref Segment segment = ref Powers[(int)(bits >> (52 - PowerBits)) & ((1 << PowerBits) - 1)];
        ref Scale scale = ref Scales[(int)(bits >> 52) & 2047];
        double m = Mantissa(bits);
        double mm = m * m;
        drag = drag * scale.Drag * segment.Drag.At(m, mm);
        lift = lift * scale.Lift * segment.Lift.At(m, mm);
        liftByDrag = liftByDrag * scale.LiftByDrag * segment.LiftByDrag.At(m, mm);
    }

    /// <summary>|u|^1.8.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Decay(double speedSquared)
    {
        long bits = BitConverter.DoubleToInt64Bits(speedSquared);
        double m = Mantissa(bits);
        return Scales[(int)(bits >> 52) & 2047].Decay * Powers[(int)(bits >> (52 - PowerBits)) & ((1 << PowerBits) - 1)].Decay.At(m, m * m);
    }

    /// <summary>C_D |u| and (C_D0 − C_D) |u|^(1−β) of the branch without spin.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void WithoutSpin(double speedSquared, out double drag, out double lift)
    {
        long bits = BitConverter.DoubleToInt64Bits(speedSquared);
        ref Pair pair = ref NoSpins[((int)(bits >> (52 - NoSpinBits)) - (LowestExponent << NoSpinBits)) & ((Octaves << NoSpinBits) - 1)];
        double m = Mantissa(bits);
        double mm = m * m;
        drag = pair.Drag.At(m, mm);
        lift = pair.Lift.At(m, mm);
    }

    /// <summary>x^d and x^β.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void OfSpin(double surfaceSpeed, out double forDrag, out double forLift)
    {
        long bits = BitConverter.DoubleToInt64Bits(surfaceSpeed);
        ref Pair pair = ref SpinPowers[(int)(bits >> (52 - PowerBits)) & ((1 << PowerBits) - 1)];
        ref SpinScale scale = ref SpinScales[(int)(bits >> 52) & 2047];
        double m = Mantissa(bits);
        double mm = m * m;
        forDrag = scale.Drag * pair.Drag.At(m, mm);
        forLift = scale.Lift * pair.Lift.At(m, mm);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Mantissa(long bits) => BitConverter.Int64BitsToDouble((bits & 0x000FFFFFFFFFFFFFL) | 0x3FF0000000000000L);

    private static Segment[] MakePowers()
    {
        var powers = new Segment[1 << PowerBits];
        for (int i = 0; i < powers.Length; i++)
        {
            double low = 1.0 + ((double)i / powers.Length);
            double high = 1.0 + ((i + 1.0) / powers.Length);
            powers[i] = new Segment
            {
                Drag = Cubic.Through(static m => Elementary.Pow(m, 0.5 * (1.0 - D)), low, high),
                Lift = Cubic.Through(static m => Elementary.Pow(m, 0.5 * (1.0 - Beta)), low, high),
                LiftByDrag = Cubic.Through(static m => Elementary.Pow(m, 0.5 * (1.0 - Beta - D)), low, high),
                Decay = Cubic.Through(static m => Elementary.Pow(m, OfDecay), low, high),
            };
        }

        return powers;
    }

    private static Scale[] MakeScales()
    {
        const double Ln2 = 0.69314718055994530942;
        var scales = new Scale[2048];
        for (int e = 1; e < scales.Length; e++)
        {
            double ln = (e - 1023) * Ln2;
            scales[e] = new Scale
            {
                Drag = Elementary.Exp(0.5 * (1.0 - D) * ln),
                Lift = Elementary.Exp(0.5 * (1.0 - Beta) * ln),
                LiftByDrag = Elementary.Exp(0.5 * (1.0 - Beta - D) * ln),
                Decay = Elementary.Exp(OfDecay * ln),
            };
        }

        return scales;
    }

    private static Pair[] MakeSpinPowers()
    {
        var powers = new Pair[1 << PowerBits];
        for (int i = 0; i < powers.Length; i++)
        {
            double low = 1.0 + ((double)i / powers.Length);
            double high = 1.0 + ((i + 1.0) / powers.Length);
            powers[i] = new Pair
            {
                Drag = Cubic.Through(static m => Elementary.Pow(m, D), low, high),
                Lift = Cubic.Through(static m => Elementary.Pow(m, Beta), low, high),
            };
        }

        return powers;
    }

    private static SpinScale[] MakeSpinScales()
    {
        // A zero or denormal spin has no leading 1: its powers are taken as zero.
        const double Ln2 = 0.69314718055994530942;
        var scales = new SpinScale[2048];
        for (int e = 1; e < scales.Length; e++)
        {
            double ln = (e - 1023) * Ln2;
            scales[e] = new SpinScale { Drag = Elementary.Exp(D * ln), Lift = Elementary.Exp(Beta * ln) };
        }

        return scales;
    }

    private static Pair[] MakeNoSpins()
    {
        var pairs = new Pair[Octaves << NoSpinBits];
        for (int i = 0; i < pairs.Length; i++)
        {
            double octave = BitConverter.Int64BitsToDouble((long)(LowestExponent + (i >> NoSpinBits)) << 52);
            int segment = i & ((1 << NoSpinBits) - 1);
            double low = 1.0 + ((double)segment / (1 << NoSpinBits));
            double high = 1.0 + ((segment + 1.0) / (1 << NoSpinBits));
            pairs[i] = new Pair
            {
                Drag = Cubic.Through(m => DragWithoutSpin(octave * m), low, high),
                Lift = Cubic.Through(m => LiftWithoutSpin(octave * m), low, high),
            };
        }

        return pairs;
    }

    private static double DragWithoutSpin(double speedSquared)
    {
        double speed = Math.Sqrt(speedSquared);
        return FittedDrag.WithoutSpin(speed) * speed;
    }

    private static double LiftWithoutSpin(double speedSquared)
    {
        double speed = Math.Sqrt(speedSquared);
        return (FittedDrag.AtRest - FittedDrag.WithoutSpin(speed)) * Elementary.Pow(speedSquared, 0.5 * (1.0 - Beta));
    }

    private struct Segment
    {
        public Cubic Drag;
        public Cubic Lift;
        public Cubic LiftByDrag;
        public Cubic Decay;
    }

    private struct Scale
    {
        public double Drag;
        public double Lift;
        public double LiftByDrag;
        public double Decay;
    }

    private struct SpinScale
    {
        public double Drag;
        public double Lift;
    }

    private struct Pair
    {
        public Cubic Drag;
        public Cubic Lift;
    }
}
