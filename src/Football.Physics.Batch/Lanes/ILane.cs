#if NET8_0_OR_GREATER
namespace FootballPhysics.Batch;

/// <summary>Some floats side by side, with the operations that give the same bits for each whatever their number.</summary>
/// <remarks>
/// The compiler puts no more than a few hundred values of one method into registers: what laws and integrators do most is one operation each.
/// A mask is a value too: what a comparison gives, and only <c>And</c>, <c>Or</c>, <c>Differs</c>, <c>Select</c> <c>Any</c> and <c>All</c> may take.
/// </remarks>
internal interface ILane<TSelf>
    where TSelf : struct, ILane<TSelf>
{
    /// <summary>How many.</summary>
    static abstract int Count { get; }

    static abstract TSelf operator +(TSelf a, TSelf b);

    static abstract TSelf operator -(TSelf a, TSelf b);

    static abstract TSelf operator *(TSelf a, TSelf b);

    static abstract TSelf operator /(TSelf a, TSelf b);

    static abstract TSelf operator *(float a, TSelf b);

    /// <summary>One number in all lanes.</summary>
    static abstract TSelf Of(float value);

    /// <summary>Reads from consecutive places.</summary>
    static abstract TSelf Load(float[] from, int at);

    /// <summary>Writes to consecutive places.</summary>
    static abstract void Store(TSelf value, float[] to, int at);

    static abstract TSelf Sqrt(TSelf x);

    /// <summary>True when a &lt; b.</summary>
    static abstract TSelf Less(TSelf a, TSelf b);

    static abstract TSelf And(TSelf a, TSelf b);

    static abstract TSelf Or(TSelf a, TSelf b);

    /// <summary>Where one mask is set and the other is not.</summary>
    static abstract TSelf Differs(TSelf a, TSelf b);

    /// <summary>a where the mask is set, b elsewhere.</summary>
    static abstract TSelf Select(TSelf mask, TSelf a, TSelf b);

    /// <summary>The greater; the second where one is not a number.</summary>
    static abstract TSelf AtLeast(TSelf x, TSelf low);

    /// <summary>The lesser; the second where one is not a number.</summary>
    static abstract TSelf AtMost(TSelf x, TSelf high);

    /// <summary>a + b c, each rounded.</summary>
    static abstract TSelf Plus(TSelf a, TSelf b, TSelf c);

    /// <summary>a b − c d, each rounded.</summary>
    static abstract TSelf Minus(TSelf a, TSelf b, TSelf c, TSelf d);

    /// <summary>(x² + y²) + z².</summary>
    static abstract TSelf Squares(TSelf x, TSelf y, TSelf z);

    /// <summary>(c0 + c1 x) + x² c2.</summary>
    static abstract TSelf Parabola(TSelf x, TSelf squared, float c0, float c1, float c2);

    /// <summary>(c0 + c1 x) + x² (c2 + c3 x).</summary>
    static abstract TSelf Cubic(TSelf x, TSelf squared, float c0, float c1, float c2, float c3);

    /// <summary>True when the mask is set in any lane.</summary>
    static abstract bool Any(TSelf mask);

    /// <summary>True when the mask is set in all lanes.</summary>
    static abstract bool All(TSelf mask);

    /// <summary>x = m · 2^e with m in √½ … √2, for positive normal x.</summary>
    static abstract void Split(TSelf x, out TSelf m, out TSelf e);

    /// <summary>2^k for a whole k from −126 to 127.</summary>
    static abstract TSelf Power2(TSelf k);
}
#endif
