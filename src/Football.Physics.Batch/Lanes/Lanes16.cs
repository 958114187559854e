#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace FootballPhysics.Batch;

/// <summary>16 floats in a register of 512 bits.</summary>
internal readonly struct Lanes16 : ILane<Lanes16>
{
    private readonly Vector512<float> _v;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Lanes16(Vector512<float> v) => _v = v;

    public static int Count => 16;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 operator +(Lanes16 a, Lanes16 b) => new(a._v + b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 operator -(Lanes16 a, Lanes16 b) => new(a._v - b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 operator *(Lanes16 a, Lanes16 b) => new(a._v * b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 operator /(Lanes16 a, Lanes16 b) => new(a._v / b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 operator *(float a, Lanes16 b) => new(Vector512.Create(a) * b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 Of(float value) => new(Vector512.Create(value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 Load(float[] from, int at) =>
        new(Vector512.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(from), (nuint)at));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(Lanes16 value, float[] to, int at) =>
        value._v.StoreUnsafe(ref MemoryMarshal.GetArrayDataReference(to), (nuint)at);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 Sqrt(Lanes16 x) => new(Vector512.Sqrt(x._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 Less(Lanes16 a, Lanes16 b) => new(Vector512.LessThan(a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 And(Lanes16 a, Lanes16 b) => new(a._v & b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 Or(Lanes16 a, Lanes16 b) => new(a._v | b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 Differs(Lanes16 a, Lanes16 b) => new(a._v ^ b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 Select(Lanes16 mask, Lanes16 a, Lanes16 b) => new(Vector512.ConditionalSelect(mask._v, a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 AtLeast(Lanes16 x, Lanes16 low) => new(Vector512.ConditionalSelect(Vector512.LessThan(low._v, x._v), x._v, low._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 AtMost(Lanes16 x, Lanes16 high) => new(Vector512.ConditionalSelect(Vector512.LessThan(x._v, high._v), x._v, high._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 Plus(Lanes16 a, Lanes16 b, Lanes16 c) => new(a._v + (b._v * c._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 Minus(Lanes16 a, Lanes16 b, Lanes16 c, Lanes16 d) => new((a._v * b._v) - (c._v * d._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 Squares(Lanes16 x, Lanes16 y, Lanes16 z) => new(((x._v * x._v) + (y._v * y._v)) + (z._v * z._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 Parabola(Lanes16 x, Lanes16 squared, float c0, float c1, float c2) =>
        new((Vector512.Create(c0) + (Vector512.Create(c1) * x._v)) + (Vector512.Create(c2) * squared._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 Cubic(Lanes16 x, Lanes16 squared, float c0, float c1, float c2, float c3) =>
        new((Vector512.Create(c0) + (Vector512.Create(c1) * x._v)) + (squared._v * (Vector512.Create(c2) + (Vector512.Create(c3) * x._v))));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(Lanes16 mask) => mask._v.AsInt32() != Vector512<int>.Zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All(Lanes16 mask) => mask._v.AsInt32() == Vector512<int>.AllBitsSet;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Split(Lanes16 x, out Lanes16 m, out Lanes16 e)
    {
        Vector512<int> bits = x._v.AsInt32();
        Vector512<int> exponent = Vector512.ShiftRightArithmetic(bits - Vector512.Create(LaneBits.RootHalf), 23);
        m = new Lanes16((bits - Vector512.ShiftLeft(exponent, 23)).AsSingle());
        e = new Lanes16(Vector512.ConvertToSingle(exponent));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes16 Power2(Lanes16 k) =>
        new(Vector512.ShiftLeft(Vector512.ConvertToInt32(k._v) + Vector512.Create(LaneBits.Bias), 23).AsSingle());
}
#endif
