namespace FootballPhysics.Numerics;

/// <summary>The four Chebyshev points of an interval: a cubic through them stays close to the function on the entire interval.</summary>
internal readonly struct ChebyshevPoints
{
    private const double Outer = 0.92387953251128673848; // cos(π/8)
    private const double Inner = 0.38268343236508978178; // cos(3π/8)

    public readonly double X0;
    public readonly double X1;
    public readonly double X2;
    public readonly double X3;

    public ChebyshevPoints(double low, double high)
    {
        // x_k = mid ∓ half · cos((2k + 1) π/8).
        double mid = 0.5 * (low + high);
        double half = 0.5 * (high - low);
        X0 = mid - (half * Outer);
        X1 = mid - (half * Inner);
        X2 = mid + (half * Inner);
        X3 = mid + (half * Outer);
    }
}
