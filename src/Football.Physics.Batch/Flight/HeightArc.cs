namespace FootballPhysics.Batch;

/// <summary>The ball's height above contact over a step that comes down to it.</summary>
internal readonly struct HeightArc
{
    /// <summary>Newton ends at this relative change: the next one would be at rounding, and a re-step corrects what is left.</summary>
    private const double Close = 1e-6;

    /// <summary>Height at the start, m; not negative.</summary>
    public readonly double Start;

    /// <summary>Vertical velocity at the start, m/s.</summary>
    public readonly double StartVelocity;

    /// <summary>Vertical acceleration at the start, m/s².</summary>
    public readonly double StartAcceleration;

    /// <summary>Height at the end, m.</summary>
    public readonly double End;

    /// <summary>Vertical velocity at the end, m/s.</summary>
    public readonly double EndVelocity;

    /// <summary>Length of the step, s.</summary>
    public readonly double Length;

    public HeightArc(double start, double startVelocity, double startAcceleration, double end, double endVelocity, double length)
    {
        Start = start;
        StartVelocity = startVelocity;
        StartAcceleration = startAcceleration;
        End = end;
        EndVelocity = endVelocity;
        Length = length;
    }

    /// <summary>The first time at which the cubic Hermite interpolant comes down to zero, or the whole length where it does not.</summary>
    public double HermiteRoot()
    {
        CubicHermite curve = Curve;
        double high = End < 0 ? 1.0 : curve.Lowest;
        var height = new HeightOverArc(in curve);
        return Roots.Newton(ref height, 0, high, high, Close) * Length;
    }

    private CubicHermite Curve => new(Start, StartVelocity * Length, End, EndVelocity * Length);

    /// <summary>The height over the step. A start at contact is a root already: the next one is that of the quotient by s.</summary>
    private readonly struct HeightOverArc : IDifferentiableFunction
    {
        private readonly CubicHermite _curve;
        private readonly bool _onGround;

        public HeightOverArc(in CubicHermite curve)
        {
            _curve = curve;
            _onGround = curve.C0 <= 0;
        }

        public bool Evaluate(double x, out double value, out double slope)
        {
            value = _onGround ? _curve.C1 + (x * (_curve.C2 + (x * _curve.C3))) : _curve.At(x);
            slope = _onGround ? _curve.C2 + (2.0 * x * _curve.C3) : _curve.SlopeAt(x);
            return false;
        }
    }
}
