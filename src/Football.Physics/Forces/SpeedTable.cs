using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// What the published laws need of the speed, as functions of |u|², all found with one index: the powers of the branch with spin,
/// and the two sums of the branch without.
/// </summary>
/// <remarks>
/// The top mantissa bits of |u|² choose a segment, on it a cubic through the Chebyshev points. Powers: 64 segments an octave, relative
/// error 3e-11; the branch without spin: 128 an octave from 1/16 to 256 m/s, relative error 2e-9, beyond that in closed form.
/// </remarks>
internal static class SpeedTable
{
    private const int PowerBits = 6;
    private const int NoSpinBits = 7;
    private const int LowestExponent = 1023 - 8; // |u| = 1/16 m/s
    private const int Octaves = 24;              // up to |u| = 256 m/s

    private const double D = FittedDrag.D;
    private const double Beta = EmpiricalMagnus.Beta;

    private static readonly Segment[] Powers = new Segment[1 << PowerBits];
    private static readonly Scale[] Scales = new Scale[2048];
    private static readonly Pair[] NoSpins = new Pair[Octaves << NoSpinBits];

    static SpeedTable()
    {
        const double Ln2 = 0.69314718055994530942;
        for (int i = 0; i < Powers.Length; i++)
        {
            double low = 1.0 + ((double)i / Powers.Length);
            double high = 1.0 + ((i + 1.0) / Powers.Length);
            Powers[i] = new Segment
            {
                Drag = Cubic.Through(static m => Elementary.Pow(m, 0.5 * (1.0 - D)), low, high),
                Lift = Cubic.Through(static m => Elementary.Pow(m, 0.5 * (1.0 - Beta)), low, high),
                LiftByDrag = Cubic.Through(static m => Elementary.Pow(m, 0.5 * (1.0 - Beta - D)), low, high),
                Decay = Cubic.Through(static m => Elementary.Pow(m, 0.9), low, high),
            };
        }

        for (int e = 1; e < Scales.Length; e++)
        {
            double ln = (e - 1023) * Ln2;
            Scales[e] = new Scale
            {
                Drag = Elementary.Exp(0.5 * (1.0 - D) * ln),
                Lift = Elementary.Exp(0.5 * (1.0 - Beta) * ln),
                LiftByDrag = Elementary.Exp(0.5 * (1.0 - Beta - D) * ln),
                Decay = Elementary.Exp(0.9 * ln),
            };
        }

        for (int i = 0; i < NoSpins.Length; i++)
        {
            double octave = BitConverter.Int64BitsToDouble((long)(LowestExponent + (i >> NoSpinBits)) << 52);
            int segment = i & ((1 << NoSpinBits) - 1);
            double low = 1.0 + ((double)segment / (1 << NoSpinBits));
            double high = 1.0 + ((segment + 1.0) / (1 << NoSpinBits));
            NoSpins[i] = new Pair
            {
                Drag = Cubic.Through(m => DragWithoutSpin(octave * m), low, high),
                Lift = Cubic.Through(m => LiftWithoutSpin(octave * m), low, high),
            };
        }
    }

    /// <summary>|u|^(1−d), |u|^(1−β) and |u|^(1−β−d).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void WithSpin(double speedSquared, out double drag, out double lift, out double liftByDrag)
    {
        long bits = BitConverter.DoubleToInt64Bits(speedSquared);
        ref Segment segment = ref Powers[(int)(bits >> (52 - PowerBits)) & ((1 << PowerBits) - 1)];
        ref Scale scale = ref Scales[(int)(bits >> 52) & 2047];
        double m = Mantissa(bits);
        double mm = m * m;
        drag = scale.Drag * segment.Drag.At(m, mm);
        lift = scale.Lift * segment.Lift.At(m, mm);
        liftByDrag = scale.LiftByDrag * segment.LiftByDrag.At(m, mm);
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
        int index = (int)(bits >> (52 - NoSpinBits)) - (LowestExponent << NoSpinBits);
        if ((uint)index < (uint)NoSpins.Length)
        {
            ref Pair pair = ref NoSpins[index];
            double m = Mantissa(bits);
            double mm = m * m;
            drag = pair.Drag.At(m, mm);
            lift = pair.Lift.At(m, mm);
            return;
        }

        Beyond(speedSquared, out drag, out lift);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Beyond(double speedSquared, out double drag, out double lift)
    {
        drag = DragWithoutSpin(speedSquared);
        lift = speedSquared > 0 ? LiftWithoutSpin(speedSquared) : 0;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Mantissa(long bits) => BitConverter.Int64BitsToDouble((bits & 0x000FFFFFFFFFFFFFL) | 0x3FF0000000000000L);

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

    private struct Pair
    {
        public Cubic Drag;
        public Cubic Lift;
    }
}
