#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace FootballPhysics.Batch;

/// <summary>8 floats in a register of 256 bits.</summary>
internal readonly struct Lanes8 : ILane<Lanes8>
{
    private readonly Vector256<float> _v;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Lanes8(Vector256<float> v) => _v = v;

    public static int Count => 8;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 operator +(Lanes8 a, Lanes8 b) => new(a._v + b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 operator -(Lanes8 a, Lanes8 b) => new(a._v - b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 operator *(Lanes8 a, Lanes8 b) => new(a._v * b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 operator /(Lanes8 a, Lanes8 b) => new(a._v / b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 operator *(float a, Lanes8 b) => new(Vector256.Create(a) * b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 Of(float value) => new(Vector256.Create(value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 Load(float[] from, int at) =>
        new(Vector256.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(from), (nuint)at));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(Lanes8 value, float[] to, int at) =>
        value._v.StoreUnsafe(ref MemoryMarshal.GetArrayDataReference(to), (nuint)at);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 Sqrt(Lanes8 x) => new(Vector256.Sqrt(x._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 Less(Lanes8 a, Lanes8 b) => new(Vector256.LessThan(a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 And(Lanes8 a, Lanes8 b) => new(a._v & b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 Or(Lanes8 a, Lanes8 b) => new(a._v | b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 Differs(Lanes8 a, Lanes8 b) => new(a._v ^ b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 Select(Lanes8 mask, Lanes8 a, Lanes8 b) => new(Vector256.ConditionalSelect(mask._v, a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 AtLeast(Lanes8 x, Lanes8 low) => new(Vector256.ConditionalSelect(Vector256.LessThan(low._v, x._v), x._v, low._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 AtMost(Lanes8 x, Lanes8 high) => new(Vector256.ConditionalSelect(Vector256.LessThan(x._v, high._v), x._v, high._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 Plus(Lanes8 a, Lanes8 b, Lanes8 c) => new(a._v + (b._v * c._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 Minus(Lanes8 a, Lanes8 b, Lanes8 c, Lanes8 d) => new((a._v * b._v) - (c._v * d._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 Squares(Lanes8 x, Lanes8 y, Lanes8 z) => new(((x._v * x._v) + (y._v * y._v)) + (z._v * z._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 Parabola(Lanes8 x, Lanes8 squared, float c0, float c1, float c2) =>
        new((Vector256.Create(c0) + (Vector256.Create(c1) * x._v)) + (Vector256.Create(c2) * squared._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 Cubic(Lanes8 x, Lanes8 squared, float c0, float c1, float c2, float c3) =>
        new((Vector256.Create(c0) + (Vector256.Create(c1) * x._v)) + (squared._v * (Vector256.Create(c2) + (Vector256.Create(c3) * x._v))));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(Lanes8 mask) => mask._v.AsInt32() != Vector256<int>.Zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All(Lanes8 mask) => mask._v.AsInt32() == Vector256<int>.AllBitsSet;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Split(Lanes8 x, out Lanes8 m, out Lanes8 e)
    {
        Vector256<int> bits = x._v.AsInt32();
        Vector256<int> exponent = Vector256.ShiftRightArithmetic(bits - Vector256.Create(LaneBits.RootHalf), 23);
        m = new Lanes8((bits - Vector256.ShiftLeft(exponent, 23)).AsSingle());
        e = new Lanes8(Vector256.ConvertToSingle(exponent));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes8 Power2(Lanes8 k) =>
        new(Vector256.ShiftLeft(Vector256.ConvertToInt32(k._v) + Vector256.Create(LaneBits.Bias), 23).AsSingle());
}
#endif
