using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The ball's height above contact over a step that comes down to it. If the start is at contact, divide by s, to find the next root.</summary>
/// <param name="curve">The cubic Hermite interpolant over the step, whose start is at least 0.</param>
internal readonly struct HeightArc(in CubicHermite curve) : IDifferentiableFunction
{
    /// <summary>The relative change at which Newton's method ends: the next one would be rounding, and repeating the step corrects the rest.</summary>
    private const double Close = 1e-6;

    private readonly CubicHermite _curve = curve;
    private readonly bool _onGround = curve.C0 <= 0;

    /// <summary>Returns the share of the step after which the height first falls to zero, or 1 if it does not.</summary>
    /// <param name="curve">The height over the step.</param>
    /// <param name="end">The height at the end, in m.</param>
    public static double Root(in CubicHermite curve, double end)
    {
        double high = end < 0 ? 1.0 : curve.Lowest;
        var height = new HeightArc(in curve);
        return Roots.Newton(ref height, 0, high, high, Close);
    }

    public bool Evaluate(double x, out double value, out double slope)
    {
        value = _onGround ? _curve.C1 + (x * (_curve.C2 + (x * _curve.C3))) : _curve.At(x);
        slope = _onGround ? _curve.C2 + (2.0 * x * _curve.C3) : _curve.SlopeAt(x);
        return false;
    }
}
