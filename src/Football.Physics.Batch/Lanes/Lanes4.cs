#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace FootballPhysics.Batch;

/// <summary>4 floats in a register of 128 bits.</summary>
/// <remarks>The project file makes the wider registers from this text.</remarks>
internal readonly struct Lanes4 : ILane<Lanes4>
{
    private readonly Vector128<float> _v;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Lanes4(Vector128<float> v) => _v = v;

    public static int Count => 4;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 operator +(Lanes4 a, Lanes4 b) => new(a._v + b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 operator -(Lanes4 a, Lanes4 b) => new(a._v - b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 operator *(Lanes4 a, Lanes4 b) => new(a._v * b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 operator /(Lanes4 a, Lanes4 b) => new(a._v / b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 operator *(float a, Lanes4 b) => new(Vector128.Create(a) * b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 Of(float value) => new(Vector128.Create(value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 Load(float[] from, int at) =>
        new(Vector128.LoadUnsafe(ref MemoryMarshal.GetArrayDataReference(from), (nuint)at));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Store(Lanes4 value, float[] to, int at) =>
        value._v.StoreUnsafe(ref MemoryMarshal.GetArrayDataReference(to), (nuint)at);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 Sqrt(Lanes4 x) => new(Vector128.Sqrt(x._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 Less(Lanes4 a, Lanes4 b) => new(Vector128.LessThan(a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 And(Lanes4 a, Lanes4 b) => new(a._v & b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 Or(Lanes4 a, Lanes4 b) => new(a._v | b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 Differs(Lanes4 a, Lanes4 b) => new(a._v ^ b._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 Select(Lanes4 mask, Lanes4 a, Lanes4 b) => new(Vector128.ConditionalSelect(mask._v, a._v, b._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 AtLeast(Lanes4 x, Lanes4 low) => new(Vector128.ConditionalSelect(Vector128.LessThan(low._v, x._v), x._v, low._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 AtMost(Lanes4 x, Lanes4 high) => new(Vector128.ConditionalSelect(Vector128.LessThan(x._v, high._v), x._v, high._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 Plus(Lanes4 a, Lanes4 b, Lanes4 c) => new(a._v + (b._v * c._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 Minus(Lanes4 a, Lanes4 b, Lanes4 c, Lanes4 d) => new((a._v * b._v) - (c._v * d._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 Squares(Lanes4 x, Lanes4 y, Lanes4 z) => new(((x._v * x._v) + (y._v * y._v)) + (z._v * z._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 Parabola(Lanes4 x, Lanes4 squared, float c0, float c1, float c2) =>
        new((Vector128.Create(c0) + (Vector128.Create(c1) * x._v)) + (Vector128.Create(c2) * squared._v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 Cubic(Lanes4 x, Lanes4 squared, float c0, float c1, float c2, float c3) =>
        new((Vector128.Create(c0) + (Vector128.Create(c1) * x._v)) + (squared._v * (Vector128.Create(c2) + (Vector128.Create(c3) * x._v))));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Any(Lanes4 mask) => mask._v.AsInt32() != Vector128<int>.Zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool All(Lanes4 mask) => mask._v.AsInt32() == Vector128<int>.AllBitsSet;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Split(Lanes4 x, out Lanes4 m, out Lanes4 e)
    {
        Vector128<int> bits = x._v.AsInt32();
        Vector128<int> exponent = Vector128.ShiftRightArithmetic(bits - Vector128.Create(LaneBits.RootHalf), 23);
        m = new Lanes4((bits - Vector128.ShiftLeft(exponent, 23)).AsSingle());
        e = new Lanes4(Vector128.ConvertToSingle(exponent));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Lanes4 Power2(Lanes4 k) =>
        new(Vector128.ShiftLeft(Vector128.ConvertToInt32(k._v) + Vector128.Create(LaneBits.Bias), 23).AsSingle());
}
#endif
