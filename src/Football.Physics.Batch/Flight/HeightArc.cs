using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The ball's height above contact over a step that comes down to it.</summary>
internal readonly struct HeightArc(double start, double startVelocity, double startAcceleration, double end, double endVelocity, double length)
{
    /// <summary>The relative change at which Newton's method ends: the next one would be rounding, and repeating the step corrects the rest.</summary>
    private const double Close = 1e-6;

    /// <summary>The height at the start, in m; at least 0.</summary>
    public readonly double Start = start;

    /// <summary>The vertical velocity at the start, in m/s.</summary>
    public readonly double StartVelocity = startVelocity;

    /// <summary>The vertical acceleration at the start, in m/s².</summary>
    public readonly double StartAcceleration = startAcceleration;

    /// <summary>The height at the end, in m.</summary>
    public readonly double End = end;

    /// <summary>The vertical velocity at the end, in m/s.</summary>
    public readonly double EndVelocity = endVelocity;

    /// <summary>The length of the step, in s.</summary>
    public readonly double Length = length;

    /// <summary>Returns the first time at which the cubic Hermite interpolant falls to zero, or the full length if it does not.</summary>
    public double HermiteRoot()
    {
        CubicHermite curve = Curve;
        double high = End < 0 ? 1.0 : curve.Lowest;
        var height = new HeightOverArc(in curve);
        return Roots.Newton(ref height, 0, high, high, Close) * Length;
    }

    private CubicHermite Curve => new(Start, StartVelocity * Length, End, EndVelocity * Length);

    /// <summary>The height over the step. If the start is at contact, divide by s, to find the next root.</summary>
    private readonly struct HeightOverArc(in CubicHermite curve) : IDifferentiableFunction
    {
        private readonly CubicHermite _curve = curve;
        private readonly bool _onGround = curve.C0 <= 0;

        public bool Evaluate(double x, out double value, out double slope)
        {
            value = _onGround ? _curve.C1 + (x * (_curve.C2 + (x * _curve.C3))) : _curve.At(x);
            slope = _onGround ? _curve.C2 + (2.0 * x * _curve.C3) : _curve.SlopeAt(x);
            return false;
        }
    }
}
