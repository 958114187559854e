using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>The update of an estimate by a point, as a Kalman filter of the parameters does. It changes a copy, so that a wrong point changes nothing.</summary>
internal sealed class FilterUpdate
{
    private const int Most = FilterHypothesis.Most;

    private readonly double[] _values = new double[Most];
    private readonly double[] _spread = new double[Most * Most];
    private readonly double[] _gain = new double[Most];

    /// <summary>Updates a copy of the estimate, by one coordinate after the other.</summary>
    /// <returns>The logarithm of the density of the point, if it is right.</returns>
    public double Try(FilterHypothesis of, in FilterPoint point, FilterMoment moment)
    {
        Array.Copy(of.Values, _values, Most);
        Array.Copy(of.Spread, _spread, _spread.Length);
        double variance = point.Deviation * point.Deviation;
        double squares = 0;
        double ratio = 1;
        for (int row = 0; row < point.Rows; row++)
        {
            Correct(of, moment.Rows.AsSpan(row * Most, Most), moment.Residual[row], variance, ref squares, ref ratio);
        }

        return -0.5 * (squares + Elementary.Log(ratio));
    }

    /// <summary>Replaces the estimate by the copy.</summary>
    public void Keep(FilterHypothesis of)
    {
        Array.Copy(_values, of.Values, Most);
        Array.Copy(_spread, of.Spread, _spread.Length);
    }

    private void Correct(FilterHypothesis of, ReadOnlySpan<double> row, double residual, double variance, ref double squares, ref double ratio)
    {
        int n = of.Count;
        double sum = variance;
        for (int i = 0; i < n; i++)
        {
            double value = 0;
            for (int j = 0; j < n; j++)
            {
                value += _spread[(i * Most) + j] * row[j];
            }

            _gain[i] = value;
            sum += row[i] * value;
            residual -= row[i] * (_values[i] - of.Base[i]);
        }

        sum = Math.Max(sum, variance);
        double inverse = 1 / sum;
        squares += residual * residual * inverse;
        ratio *= sum / variance;
        for (int i = 0; i < n; i++)
        {
            double gain = inverse * _gain[i];
            _values[i] += gain * residual;
            for (int j = 0; j < n; j++)
            {
                _spread[(i * Most) + j] -= gain * _gain[j];
            }
        }
    }
}
