namespace FootballPhysics.Batch;

/// <summary>The polynomial c0 + c1 z + … + c8 z⁸ with float coefficients, evaluated by <see cref="LaneMath{F}"/>.</summary>
internal readonly struct LanePolynomial
{
    private const int MostCoefficients = 9;

    public readonly float C0;
    public readonly float C1;
    public readonly float C2;
    public readonly float C3;
    public readonly float C4;
    public readonly float C5;
    public readonly float C6;
    public readonly float C7;
    public readonly float C8;

    /// <param name="coefficients">At most nine coefficients, starting with that of z⁰.</param>
    public LanePolynomial(double[] coefficients)
    {
        Span<float> c = stackalloc float[MostCoefficients];
        c.Clear();
        for (int i = 0; i < coefficients.Length; i++)
        {
            c[i] = (float)coefficients[i];
        }

        C0 = c[0];
        C1 = c[1];
        C2 = c[2];
        C3 = c[3];
        C4 = c[4];
        C5 = c[5];
        C6 = c[6];
        C7 = c[7];
        C8 = c[8];
    }

    /// <summary>Returns the power x^q as a polynomial in z = log₂ x, which is 2^(q z).</summary>
    /// <remarks>With a small exponent, it needs no table even over many octaves.</remarks>
    /// <param name="scale">The factor on the power.</param>
    /// <param name="exponent">The exponent q.</param>
    /// <param name="low">The smallest z.</param>
    /// <param name="high">The largest z.</param>
    /// <param name="degree">The degree of the polynomial; at most 8.</param>
    public static LanePolynomial OfPower(double scale, double exponent, double low, double high, int degree)
    {
        DoubleDouble rate = exponent * DoubleDouble.Ln2;
        return new LanePolynomial(ChebyshevFit.Polynomial(z => scale * DoubleDouble.Exp(rate * z), low, high, degree));
    }
}
