namespace Football.Physics;

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

    /// <summary>The first positive root of start + v τ + a τ², or the whole length where there is none.</summary>
    /// <param name="a">Coefficient of τ².</param>
    public double QuadraticRoot(double a)
    {
        double v = StartVelocity;
        double discriminant = (v * v) - (4.0 * a * Start);
        if (discriminant < 0)
        {
            return Length;
        }

        // Falling at the start or accelerating down: the root that avoids cancellation.
        double root = Math.Sqrt(discriminant);
        double tau = v > 0 ? (v + root) / (-2.0 * a) : (2.0 * Start) / (root - v);
        return tau > 0 && tau < Length ? tau : Length;
    }

    /// <summary>Coefficients of the cubic Hermite interpolant in s = τ / length: start + c1 s + c2 s² + c3 s³.</summary>
    public void Hermite(out double c1, out double c2, out double c3)
    {
        double rise = End - Start;
        double v0 = StartVelocity * Length;
        double v1 = EndVelocity * Length;
        c1 = v0;
        c2 = (3.0 * rise) - (2.0 * v0) - v1;
        c3 = v0 + v1 - (2.0 * rise);
    }

    /// <summary>The first time at which the cubic Hermite interpolant comes down to zero, or the whole length where it does not.</summary>
    public double HermiteRoot()
    {
        Hermite(out double c1, out double c2, out double c3);
        double high = End < 0 ? 1.0 : LowestPoint(c1, c2, c3);

        // A start at contact is a root already: the next one is that of the quotient by s.
        bool onGround = Start <= 0;
        double low = 0;
        double s = high;
        for (int i = 0; i < 60; i++)
        {
            double f = onGround ? c1 + (s * (c2 + (s * c3))) : Start + (s * (c1 + (s * (c2 + (s * c3)))));
            double slope = onGround ? c2 + (2.0 * s * c3) : c1 + (s * ((2.0 * c2) + (3.0 * s * c3)));
            if (f > 0)
            {
                low = s;
            }
            else
            {
                high = s;
            }

            double next = s - (f / slope);
            if (!(next > low && next < high))
            {
                next = 0.5 * (low + high);
            }

            bool done = Math.Abs(next - s) <= Close * s;
            s = next;
            if (done)
            {
                break;
            }
        }

        return s * Length;
    }

    /// <summary>Whether a ball that falls at the start and rises at the end goes below contact in between.</summary>
    public bool Dips
    {
        get
        {
            Hermite(out double c1, out double c2, out double c3);
            double s = LowestPoint(c1, c2, c3);
            return Start + (s * (c1 + (s * (c2 + (s * c3))))) < 0;
        }
    }

    /// <summary>Where in 0 … 1 the interpolant of a ball that falls and rises again is lowest.</summary>
    public static double LowestPoint(double c1, double c2, double c3)
    {
        // c1 + 2 c2 s + 3 c3 s² = 0 with the sign change from falling to rising
        double discriminant = (c2 * c2) - (3.0 * c1 * c3);
        if (discriminant <= 0)
        {
            return 1.0;
        }

        double s = -c1 / (c2 + Math.Sqrt(discriminant));
        return s > 0 && s < 1 ? s : 1.0;
    }
}
