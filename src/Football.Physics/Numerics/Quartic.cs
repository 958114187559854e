using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A + B x + C x² + D x³ + E x⁴.</summary>
internal struct Quartic
{
    public double A;
    public double B;
    public double C;
    public double D;
    public double E;

    /// <summary>Its value.</summary>
    /// <param name="x">Where.</param>
    /// <param name="squared">x².</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly double At(double x, double squared) => A + (B * x) + (squared * (C + (D * x) + (E * squared)));
}
