#if NET8_0_OR_GREATER

namespace FootballPhysics.Batch;

/// <summary>Several floats in one SIMD register, with operations that give bit-identical results for any number of lanes.</summary>
/// <remarks>
/// The compiler keeps only a few hundred values of one method in registers. So the most frequent combinations in laws and integrators are single operations.
/// <para>A mask is the result of a comparison. Only <c>And</c>, <c>Or</c>, <c>Differs</c>, <c>Select</c>, <c>Any</c> and <c>All</c> accept masks.</para>
/// </remarks>
internal interface ILane<TSelf>
    where TSelf : struct, ILane<TSelf>
{
    /// <summary>The number of lanes.</summary>
    static abstract int Count { get; }

    static abstract TSelf operator +(TSelf a, TSelf b);

    static abstract TSelf operator -(TSelf a, TSelf b);

    static abstract TSelf operator *(TSelf a, TSelf b);

    static abstract TSelf operator /(TSelf a, TSelf b);

    static abstract TSelf operator *(float a, TSelf b);

    /// <summary>Returns one number in all lanes.</summary>
    static abstract TSelf Of(float value);

    /// <summary>Loads consecutive elements.</summary>
    static abstract TSelf Load(float[] from, int at);

    /// <summary>Stores to consecutive elements.</summary>
    static abstract void Store(TSelf value, float[] to, int at);

    static abstract TSelf Sqrt(TSelf x);

    /// <summary>Returns the mask of a &lt; b.</summary>
    static abstract TSelf Less(TSelf a, TSelf b);

    static abstract TSelf And(TSelf a, TSelf b);

    static abstract TSelf Or(TSelf a, TSelf b);

    /// <summary>Returns the mask of lanes in which exactly one mask is set.</summary>
    static abstract TSelf Differs(TSelf a, TSelf b);

    /// <summary>Returns a in lanes in which the mask is set, and b in the others.</summary>
    static abstract TSelf Select(TSelf mask, TSelf a, TSelf b);

    /// <summary>Returns the greater value; the second if one is NaN.</summary>
    static abstract TSelf AtLeast(TSelf x, TSelf low);

    /// <summary>Returns the smaller value; the second if one is NaN.</summary>
    static abstract TSelf AtMost(TSelf x, TSelf high);

    /// <summary>Returns a + b c, each operation rounded.</summary>
    static abstract TSelf Plus(TSelf a, TSelf b, TSelf c);

    /// <summary>Returns a b − c d, each operation rounded.</summary>
    static abstract TSelf Minus(TSelf a, TSelf b, TSelf c, TSelf d);

    /// <summary>Returns (x² + y²) + z².</summary>
    static abstract TSelf Squares(TSelf x, TSelf y, TSelf z);

    /// <summary>Returns (c0 + c1 x) + x² c2.</summary>
    static abstract TSelf Parabola(TSelf x, TSelf squared, float c0, float c1, float c2);

    /// <summary>Returns (c0 + c1 x) + x² (c2 + c3 x).</summary>
    static abstract TSelf Cubic(TSelf x, TSelf squared, float c0, float c1, float c2, float c3);

    /// <summary>Returns true if the mask is set in any lane.</summary>
    static abstract bool Any(TSelf mask);

    /// <summary>Returns true if the mask is set in all lanes.</summary>
    static abstract bool All(TSelf mask);

    /// <summary>Splits x = m · 2^e with m in √½ … √2, for positive normal x.</summary>
    static abstract void Split(TSelf x, out TSelf m, out TSelf e);

    /// <summary>Returns 2^k for an integer k from −126 to 127.</summary>
    static abstract TSelf Power2(TSelf k);
}
#endif
