namespace FootballPhysics.Tracks;

/// <summary>Divides a track into segments that a polynomial in time describes, with kicks, bounces and track errors between them.</summary>
/// <remarks>
/// The division is optimal (dynamic programming): it minimises Σ (|observed − polynomial|²/σ² + cost of a segment). A cubic, the default, describes a
/// flight of one second to within centimetres. Longer flights are divided, and joined again by the laws of flight.
/// </remarks>
internal sealed class TrackSegments
{
    /// <summary>The additional cost of a segment with fewer points than a cubic needs.</summary>
    private const double ShortPrice = 15;

    private const int Shortest = 5;

    /// <summary>The number of points between two checks for a cancellation.</summary>
    private const int PointsPerCheck = 64;

    private readonly TrackPoint[] _track;
    private readonly double _perVariance;
    private readonly double _price;
    private readonly int _longest;
    private readonly int _coefficients;
    private readonly double[] _moments;
    private readonly double[] _right;
    private readonly double[] _squares = new double[3];
    private readonly double[] _factor;
    private readonly double[] _solution;

    /// <summary>Prepares the division of a track.</summary>
    /// <param name="track">The track.</param>
    /// <param name="deviation">The standard deviation σ of a coordinate from the polynomial, in m.</param>
    /// <param name="longest">The maximum number of points in a segment.</param>
    /// <param name="price">The cost of a segment, in units of σ²: for the twelve coefficients of three cubics, and its start.</param>
    /// <param name="degree">The degree of the polynomial.</param>
    public TrackSegments(TrackPoint[] track, double deviation, int longest, double price, int degree = 3)
    {
        _coefficients = degree + 1;
        _moments = new double[(2 * degree) + 1];
        _right = new double[3 * _coefficients];
        _factor = new double[_coefficients * _coefficients];
        _solution = new double[_coefficients];
        _price = price;
        _track = track;
        _perVariance = 1.0 / (deviation * deviation);
        _longest = longest;
    }

    /// <summary>Divides the points of a run without gaps.</summary>
    /// <param name="first">The first point.</param>
    /// <param name="end">The index after the last point.</param>
    /// <param name="ends">Receives the exclusive end of each segment, in order.</param>
    /// <param name="watch">Cancels the division; default none.</param>
    public void Divide(int first, int end, List<int> ends, FitWatch? watch = null)
    {
        int count = end - first;
        double[] least = new double[count + 1];
        int[] from = new int[count + 1];
        least.AsSpan(1).Fill(double.PositiveInfinity);
        for (int start = 0; start < count; start++)
        {
            if (start % PointsPerCheck == 0)
            {
                watch?.Check();
            }

            // All segments that begin here: their moments grow by one point at a time.
            Clear();
            int last = Math.Min(count, start + _longest);
            for (int stop = start + 1; stop <= last; stop++)
            {
                Add(in _track[first + stop - 1], _track[first + start].Time, in _track[first + start]);
                double cost = least[start] + _price + (stop - start < Shortest ? ShortPrice : _perVariance * Residual());
                if (cost < least[stop])
                {
                    least[stop] = cost;
                    from[stop] = start;
                }
            }
        }

        int at = ends.Count;
        for (int stop = count; stop > 0; stop = from[stop])
        {
            ends.Insert(at, first + stop);
        }
    }

    private void Clear()
    {
        Array.Clear(_moments, 0, _moments.Length);
        Array.Clear(_right, 0, _right.Length);
        Array.Clear(_squares, 0, _squares.Length);
    }

    private void Add(in TrackPoint point, double from, in TrackPoint origin)
    {
        double t = point.Time - from;
        Vector3d p = point.Position - origin.Position;
        double power = 1;
        for (int k = 0; k < _moments.Length; k++, power *= t)
        {
            _moments[k] += power;
            if (k < _coefficients)
            {
                _right[k] += power * p.X;
                _right[_coefficients + k] += power * p.Y;
                _right[(2 * _coefficients) + k] += power * p.Z;
            }
        }

        _squares[0] += p.X * p.X;
        _squares[1] += p.Y * p.Y;
        _squares[2] += p.Z * p.Z;
    }

    /// <summary>Returns Σ p² − |L⁻¹ r|² over the three coordinates, where M = L Lᵀ.</summary>
    private double Residual()
    {
        for (int i = 0; i < _coefficients; i++)
        {
            for (int j = 0; j <= i; j++)
            {
                double sum = _moments[i + j];
                for (int k = 0; k < j; k++)
                {
                    sum -= _factor[(i * _coefficients) + k] * _factor[(j * _coefficients) + k];
                }

                _factor[(i * _coefficients) + j] = i > j ? sum / _factor[(j * _coefficients) + j] : Math.Sqrt(Math.Max(sum, 1e-30));
            }
        }

        double residual = 0;
        double[] y = _solution;
        for (int axis = 0; axis < 3; axis++)
        {
            double left = _squares[axis];
            for (int i = 0; i < _coefficients; i++)
            {
                double sum = _right[(axis * _coefficients) + i];
                for (int k = 0; k < i; k++)
                {
                    sum -= _factor[(i * _coefficients) + k] * y[k];
                }

                y[i] = sum / _factor[(i * _coefficients) + i];
                left -= y[i] * y[i];
            }

            residual += Math.Max(0, left);
        }

        return residual;
    }
}
