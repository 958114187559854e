using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>One float: used without SIMD registers, and as the reference for the wider types.</summary>
/// <remarks>Every operation is rounded to float, even on runtimes that compute in double.</remarks>
internal readonly struct Lanes1
#if NET8_0_OR_GREATER
    : ILane<Lanes1>
#endif
{
    private readonly float _v;

    private Lanes1(float v) => _v = v;

    public static int Count => 1;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 operator +(Lanes1 a, Lanes1 b) => new((float)(a._v + b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 operator -(Lanes1 a, Lanes1 b) => new((float)(a._v - b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 operator *(Lanes1 a, Lanes1 b) => new((float)(a._v * b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 operator /(Lanes1 a, Lanes1 b) => new((float)(a._v / b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 operator *(float a, Lanes1 b) => new((float)(a * b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 Of(float value) => new(value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 Load(float[] from, int at) => new(from[at]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(Lanes1 value, float[] to, int at) => to[at] = value._v;

    // The double root, rounded to float, equals the correctly rounded float root.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 Sqrt(Lanes1 x) => new((float)Math.Sqrt(x._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 Less(Lanes1 a, Lanes1 b) => Mask(a._v < b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 And(Lanes1 a, Lanes1 b) => Mask(a._v != 0 && b._v != 0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 Or(Lanes1 a, Lanes1 b) => Mask(a._v != 0 || b._v != 0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 Differs(Lanes1 a, Lanes1 b) => Mask((a._v != 0) != (b._v != 0));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 Select(Lanes1 mask, Lanes1 a, Lanes1 b) => mask._v != 0 ? a : b;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 AtLeast(Lanes1 x, Lanes1 low) => low._v < x._v ? x : low;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 AtMost(Lanes1 x, Lanes1 high) => x._v < high._v ? x : high;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 Plus(Lanes1 a, Lanes1 b, Lanes1 c) => a + (b * c);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 Minus(Lanes1 a, Lanes1 b, Lanes1 c, Lanes1 d) => (a * b) - (c * d);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 Squares(Lanes1 x, Lanes1 y, Lanes1 z) => ((x * x) + (y * y)) + (z * z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 Parabola(Lanes1 x, Lanes1 squared, float c0, float c1, float c2) => (Of(c0) + (c1 * x)) + (c2 * squared);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 Cubic(Lanes1 x, Lanes1 squared, float c0, float c1, float c2, float c3) =>
        (Of(c0) + (c1 * x)) + (squared * (Of(c2) + (c3 * x)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(Lanes1 mask) => mask._v != 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All(Lanes1 mask) => mask._v != 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Split(Lanes1 x, out Lanes1 m, out Lanes1 e)
    {
        int bits = BitConverter.SingleToInt32Bits(x._v);
        int exponent = (bits - LaneBits.RootHalf) >> 23;
        m = new Lanes1(BitConverter.Int32BitsToSingle(bits - (exponent << 23)));
        e = new Lanes1(exponent);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes1 Power2(Lanes1 k) => new(BitConverter.Int32BitsToSingle(((int)k._v + LaneBits.Bias) << 23));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Lanes1 Mask(bool set) => new(set ? 1f : 0f);
}
