using FootballPhysics.Numerics;

namespace FootballPhysics.Tool.Sweep.Ranges;

/// <summary>The quantiles of the normal distribution, bit-identical on every machine.</summary>
internal static class NormalQuantile
{
    /// <summary>The largest |p − ½| of the middle approximation.</summary>
    private const double Middle = 0.425;

    /// <summary>The largest √(−ln p) of the near tail.</summary>
    private const double Far = 5;

    // M. J. Wichura, Algorithm AS 241, Applied Statistics 37 (1988): PPND16, accurate to about 1 part in 10¹⁶. Coefficients start with that of the
    // highest power.
    private static readonly double[] s_middleTop =
    [
        2.5090809287301226727e+3, 3.3430575583588128105e+4, 6.7265770927008700853e+4, 4.5921953931549871457e+4,
        1.3731693765509461125e+4, 1.9715909503065514427e+3, 1.3314166789178437745e+2, 3.3871328727963666080,
    ];

    private static readonly double[] s_middleBottom =
    [
        5.2264952788528545610e+3, 2.8729085735721942674e+4, 3.9307895800092710610e+4, 2.1213794301586595867e+4,
        5.3941960214247511077e+3, 6.8718700749205790830e+2, 4.2313330701600911252e+1, 1.0,
    ];

    private static readonly double[] s_tailTop =
    [
        7.74545014278341407640e-4, 2.27238449892691845833e-2, 2.41780725177450611770e-1, 1.27045825245236838258,
        3.64784832476320460504, 5.76949722146069140550, 4.63033784615654529590, 1.42343711074968357734,
    ];

    private static readonly double[] s_tailBottom =
    [
        1.05075007164441684324e-9, 5.47593808499534494600e-4, 1.51986665636164571966e-2, 1.48103976427480074590e-1,
        6.89767334985100004550e-1, 1.67638483018380384940, 2.05319162663775882187, 1.0,
    ];

    private static readonly double[] s_farTop =
    [
        2.01033439929228813265e-7, 2.71155556874348757815e-5, 1.24266094738807843860e-3, 2.65321895265761230930e-2,
        2.96560571828504891230e-1, 1.78482653991729133580, 5.46378491116411436990, 6.65790464350110377720,
    ];

    private static readonly double[] s_farBottom =
    [
        2.04426310338993978564e-15, 1.42151175831644588870e-7, 1.84631831751005468180e-5, 7.86869131145613259100e-4,
        1.48753612908506148525e-2, 1.36929880922735805310e-1, 5.99832206555887937690e-1, 1.0,
    ];

    /// <summary>Returns the quantile: the number below which a share p of the distribution lies.</summary>
    /// <param name="p">The share p; 0 … 1, both excluded.</param>
    public static double At(double p)
    {
        double q = p - 0.5;
        if (Math.Abs(q) <= Middle)
        {
            double r = (Middle * Middle) - (q * q);
            return q * Polynomial(s_middleTop, r) / Polynomial(s_middleBottom, r);
        }

        double t = Math.Sqrt(-Elementary.Log(q < 0 ? p : 1.0 - p));
        double z = t <= Far
            ? Polynomial(s_tailTop, t - 1.6) / Polynomial(s_tailBottom, t - 1.6)
            : Polynomial(s_farTop, t - Far) / Polynomial(s_farBottom, t - Far);
        return q < 0 ? -z : z;
    }

    private static double Polynomial(double[] coefficients, double x)
    {
        double sum = coefficients[0];
        for (int i = 1; i < coefficients.Length; i++)
        {
            sum = (sum * x) + coefficients[i];
        }

        return sum;
    }
}
