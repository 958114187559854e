using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>The update of an estimate by a point, as a Kalman filter of the parameters does: all coordinates at once.</summary>
/// <remarks>
/// With rows H of the derivatives, the covariance P and the variance R: G = P Hᵀ, and S = H G + R = L D Lᵀ. Then the estimate changes by G S⁻¹ e, and P by
/// −G S⁻¹ Gᵀ. A coordinate that is not measured has a row of zeros, and changes nothing.
/// </remarks>
internal sealed class FilterUpdate
{
    private const int Most = FilterHypothesis.Most;

    private readonly double[] _gains = new double[3 * Most];
    private double _l10;
    private double _l20;
    private double _l21;
    private Vector3d _inverse;
    private Vector3d _error;

    /// <summary>Computes the update, and changes nothing.</summary>
    /// <returns>The logarithm of the density of the point, if it is right.</returns>
    public double Try(FilterHypothesis of, in FilterPoint point, FilterMoment moment)
    {
        int n = of.Count;
        ReadOnlySpan<double> x = moment.Rows.AsSpan(0, n);
        ReadOnlySpan<double> y = moment.Rows.AsSpan(Most, n);
        ReadOnlySpan<double> z = moment.Rows.AsSpan(2 * Most, n);
        FilterMath.Multiply(of.Spread, moment.Rows, _gains, n);
        ReadOnlySpan<double> byX = _gains.AsSpan(0, n);
        ReadOnlySpan<double> byY = _gains.AsSpan(Most, n);
        ReadOnlySpan<double> byZ = _gains.AsSpan(2 * Most, n);
        (double ex, double ey, double ez) = (moment.Residual[0], moment.Residual[1], moment.Residual[2]);
        double variance = point.Deviation * point.Deviation;
        (double xx, double yy, double zz, double xy, double xz, double yz) = (variance, variance, variance, 0, 0, 0);
        for (int j = 0; j < n; j++)
        {
            double off = of.Values[j] - of.Base[j];
            ex -= x[j] * off;
            ey -= y[j] * off;
            ez -= z[j] * off;
            xx += x[j] * byX[j];
            xy += x[j] * byY[j];
            xz += x[j] * byZ[j];
            yy += y[j] * byY[j];
            yz += y[j] * byZ[j];
            zz += z[j] * byZ[j];
        }

        double d0 = Math.Max(xx, variance);
        _l10 = xy / d0;
        _l20 = xz / d0;
        double d1 = Math.Max(yy - (_l10 * xy), variance);
        double across = yz - (_l20 * xy);
        _l21 = across / d1;
        double d2 = Math.Max(zz - (_l20 * xz) - (_l21 * across), variance);
        ey -= _l10 * ex;
        ez -= (_l20 * ex) + (_l21 * ey);
        _inverse = new Vector3d(1 / d0, 1 / d1, 1 / d2);
        _error = new Vector3d(ex * _inverse.X, ey * _inverse.Y, ez * _inverse.Z);
        double squares = (ex * _error.X) + (ey * _error.Y) + (ez * _error.Z);
        return -0.5 * (squares + Elementary.Log(d0 / variance * (d1 / variance) * (d2 / variance)));
    }

    /// <summary>Updates the estimate as <see cref="Try"/> computed.</summary>
    public void Keep(FilterHypothesis of)
    {
        int n = of.Count;
        Span<double> byX = _gains.AsSpan(0, n);
        Span<double> byY = _gains.AsSpan(Most, n);
        Span<double> byZ = _gains.AsSpan(2 * Most, n);
        double[] spread = of.Spread;
        for (int i = 0; i < n; i++)
        {
            double gx = byX[i];
            double gy = byY[i] - (_l10 * gx);
            double gz = byZ[i] - (_l20 * gx) - (_l21 * gy);
            (byY[i], byZ[i]) = (gy, gz);
            of.Values[i] += (gx * _error.X) + (gy * _error.Y) + (gz * _error.Z);
            gx *= _inverse.X;
            gy *= _inverse.Y;
            gz *= _inverse.Z;
            Span<double> line = spread.AsSpan(i * Most, n);
            for (int j = 0; j <= i; j++)
            {
                double value = line[j] - ((gx * byX[j]) + (gy * byY[j]) + (gz * byZ[j]));
                line[j] = value;
                spread[(j * Most) + i] = value;
            }
        }
    }
}
