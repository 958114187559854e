using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace FootballPhysics.Numerics;

/// <summary>Four doubles, in a SIMD register if available; bit-identical with and without it.</summary>
internal readonly struct Quad
{
#if NET8_0_OR_GREATER
    private readonly Vector256<double> _v;

    public Quad(double a, double b, double c, double d) => _v = Vector256.Create(a, b, c, d);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Quad(Vector256<double> v) => _v = v;

    /// <summary>The sum (a + b) + (c + d).</summary>
    public double Sum
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => (_v.GetElement(0) + _v.GetElement(1)) + (_v.GetElement(2) + _v.GetElement(3));
    }

    /// <summary>The sum (a + c) + (b + d), in fewer operations.</summary>
    public double SumOfHalves
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            Vector128<double> halves = _v.GetLower() + _v.GetUpper();
            return halves.GetElement(0) + halves.GetElement(1);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quad operator +(Quad x, Quad y) => new(x._v + y._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quad operator -(Quad x, Quad y) => new(x._v - y._v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quad operator *(Quad x, Quad y) => new(x._v * y._v);

    /// <summary>Returns a quad with one number in all lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quad Of(double x) => new(Vector256.Create(x));

    /// <summary>Loads four numbers from memory.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quad From(ref double numbers, int first) => new(Vector256.LoadUnsafe(ref numbers, (nuint)first));

    /// <summary>Returns the absolute values.</summary>
    public Quad Abs
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector256.Abs(_v));
    }

    /// <summary>True if every lane is greater than that of the other quad.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool IsAbove(Quad other) => Vector256.GreaterThanAll(_v, other._v);
#else
    private readonly double _a;
    private readonly double _b;
    private readonly double _c;
    private readonly double _d;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Quad(double a, double b, double c, double d)
    {
        _a = a;
        _b = b;
        _c = c;
        _d = d;
    }

    /// <summary>The sum (a + b) + (c + d).</summary>
    public double Sum => (_a + _b) + (_c + _d);

    /// <summary>The sum (a + c) + (b + d).</summary>
    public double SumOfHalves => (_a + _c) + (_b + _d);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quad operator +(Quad x, Quad y) => new(x._a + y._a, x._b + y._b, x._c + y._c, x._d + y._d);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quad operator -(Quad x, Quad y) => new(x._a - y._a, x._b - y._b, x._c - y._c, x._d - y._d);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quad operator *(Quad x, Quad y) => new(x._a * y._a, x._b * y._b, x._c * y._c, x._d * y._d);

    /// <summary>Returns a quad with one number in all lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quad Of(double x) => new(x, x, x, x);

    /// <summary>Loads four numbers from memory.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quad From(ref double numbers, int first) =>
        new(Unsafe.Add(ref numbers, first), Unsafe.Add(ref numbers, first + 1), Unsafe.Add(ref numbers, first + 2), Unsafe.Add(ref numbers, first + 3));

    /// <summary>Returns the absolute values.</summary>
    public Quad Abs => new(Math.Abs(_a), Math.Abs(_b), Math.Abs(_c), Math.Abs(_d));

    /// <summary>True if every lane is greater than that of the other quad.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool IsAbove(Quad other) => _a > other._a && _b > other._b && _c > other._c && _d > other._d;
#endif
}
