using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>Finds the moment at which a sudden change of the velocity explains the last points best, by the linearized fit of a hypothesis.</summary>
/// <remarks>
/// A change v at the time s adds (t − s) v to later positions. With post-fit residuals e, rows H and A of the derivatives with respect to the parameters and the
/// position, and the covariance P of the parameters: b = Σ (t − s) Aᵀe/σ², C = Σ (t − s) HᵀA/σ², S = Σ (t − s)² AᵀA/σ² − CᵀPC. The gain of evidence is
/// ½ bᵀ(S + 1/σ_v²)⁻¹b − ½ log det(1 + σ_v² S).
/// </remarks>
internal sealed class FilterGain
{
    private const int Most = FilterHypothesis.Most;

    /// <summary>The number of last moments that are all tried; before them, every third is.</summary>
    private const int EveryMoment = 6;
    private const int EveryOther = 3;

    private readonly double[] _b = new double[6];
    private readonly double[] _c = new double[2 * 3 * Most];
    private readonly double[] _s = new double[27];
    private readonly double[] _cross = new double[3 * Most];
    private readonly double[] _matrix = new double[9];

    /// <summary>The change of the velocity of the last search.</summary>
    public Vector3d Change { get; private set; }

    /// <summary>Returns the index of the moment just before which a kick is most likely.</summary>
    /// <returns>0 if no kick has a gain of at least <paramref name="least"/>.</returns>
    public int Find(FilterHypothesis of, BallFilterSettings settings, double least)
    {
        Array.Clear(_b, 0, _b.Length);
        Array.Clear(_c, 0, _c.Length);
        Array.Clear(_s, 0, _s.Length);
        FilterHistory history = of.History;
        double now = history.Last.Time;
        int found = 0;
        for (int at = history.Count - 1; at > 0; at--)
        {
            FilterMoment moment = history[at];
            Include(of, moment, moment.Time - now);
            double span = moment.Time - history[at - 1].Time;
            bool isTried = history.Count - at <= EveryMoment || (history.Count - at) % EveryOther == 0;
            if (isTried && span > 0 && moment.Coordinates > 0)
            {
                double gain = Gain(of, moment.Time - (0.5 * span) - now, settings.KickVelocity, out Vector3d change)
                    + Elementary.Log(Math.Min(0.5, settings.KicksPerSecond * span));
                if (gain > least)
                {
                    (least, found, Change) = (gain, at, change);
                }
            }
        }

        return found;
    }

    private void Include(FilterHypothesis of, FilterMoment moment, double time)
    {
        double weight = 1 / (moment.Deviation * moment.Deviation);
        int n = of.Count;
        for (int row = 0; row < moment.Coordinates; row++)
        {
            double residual = moment.Residual[row];
            ReadOnlySpan<double> rates = moment.Rows.AsSpan(row * Most, n);
            for (int j = 0; j < n; j++)
            {
                residual -= rates[j] * (of.Values[j] - of.Base[j]);
            }

            for (int axis = 0; axis < 3; axis++)
            {
                double a = weight * moment.ByPosition[(row * 3) + axis];
                if (a == 0)
                {
                    continue;
                }

                _b[axis] += a * residual;
                _b[3 + axis] += a * time * residual;
                Span<double> sums = _c.AsSpan(axis * Most, n);
                Span<double> timed = _c.AsSpan((axis + 3) * Most, n);
                for (int j = 0; j < n; j++)
                {
                    double h = a * rates[j];
                    sums[j] += h;
                    timed[j] += time * h;
                }

                for (int other = 0; other < 3; other++)
                {
                    double s = a * moment.ByPosition[(row * 3) + other];
                    _s[(axis * 3) + other] += s;
                    _s[9 + (axis * 3) + other] += time * s;
                    _s[18 + (axis * 3) + other] += time * time * s;
                }
            }
        }
    }

    private double Gain(FilterHypothesis of, double start, double deviation, out Vector3d change)
    {
        Span<double> b = stackalloc double[3];
        for (int axis = 0; axis < 3; axis++)
        {
            b[axis] = _b[3 + axis] - (start * _b[axis]);
            for (int j = 0; j < of.Count; j++)
            {
                _cross[(axis * Most) + j] = _c[((axis + 3) * Most) + j] - (start * _c[(axis * Most) + j]);
            }
        }

        double prior = 1 / (deviation * deviation);
        Span<double> products = stackalloc double[3 * Most];
        FilterMath.Multiply(of.Spread, _cross, products, of.Count);
        for (int axis = 0; axis < 3; axis++)
        {
            ReadOnlySpan<double> product = products.Slice(axis * Most, of.Count);
            for (int other = 0; other < 3; other++)
            {
                int k = (axis * 3) + other;
                double s = _s[18 + k] - (2 * start * _s[9 + k]) + (start * start * _s[k]);
                ReadOnlySpan<double> cross = _cross.AsSpan(other * Most, product.Length);
                for (int j = 0; j < product.Length; j++)
                {
                    s -= product[j] * cross[j];
                }

                _matrix[k] = s + (axis == other ? prior : 0);
            }
        }

        // Solve by the cofactors of the symmetric matrix.
        double[] m = _matrix;
        double c00 = (m[4] * m[8]) - (m[5] * m[7]);
        double c01 = (m[5] * m[6]) - (m[3] * m[8]);
        double c02 = (m[3] * m[7]) - (m[4] * m[6]);
        double determinant = (m[0] * c00) + (m[1] * c01) + (m[2] * c02);
        double c11 = (m[0] * m[8]) - (m[2] * m[6]);
        double c12 = (m[1] * m[6]) - (m[0] * m[7]);
        double c22 = (m[0] * m[4]) - (m[1] * m[3]);
        if (!(determinant > 0))
        {
            change = Vector3d.Zero;
            return double.NegativeInfinity;
        }

        change = new Vector3d((c00 * b[0]) + (c01 * b[1]) + (c02 * b[2]), (c01 * b[0]) + (c11 * b[1]) + (c12 * b[2]), (c02 * b[0]) + (c12 * b[1]) + (c22 * b[2])) / determinant;
        return (0.5 * ((b[0] * change.X) + (b[1] * change.Y) + (b[2] * change.Z))) - (0.5 * Elementary.Log(Math.Max(1, determinant / (prior * prior * prior))));
    }
}
