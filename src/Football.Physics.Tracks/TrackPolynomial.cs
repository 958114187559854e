using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>A least-squares polynomial in time through points of a track.</summary>
internal readonly struct TrackPolynomial
{
    private readonly double _middle;
    private readonly Vector3d[] _coefficients;

    private TrackPolynomial(double middle, Vector3d[] coefficients)
    {
        _middle = middle;
        _coefficients = coefficients;
    }

    /// <summary>The acceleration at the midpoint, in m/s².</summary>
    public Vector3d Acceleration => 2 * _coefficients[2];

    /// <summary>Fits a polynomial to points, in time scaled to −1 … 1 for conditioning.</summary>
    public static TrackPolynomial Of(TrackPoint[] track, int first, int end, int degree)
    {
        int size = Math.Min(degree, end - first - 1) + 1;
        double middle = 0.5 * (track[first].Time + track[end - 1].Time);
        Vector3d origin = track[first].Position;
        double half = Math.Max(1e-9, 0.5 * (track[end - 1].Time - track[first].Time));
        var coefficients = new Vector3d[Math.Max(3, size)];
        double[] x = new double[size];
        double[] power = new double[2 * size];
        for (int axis = 0; axis < 3; axis++)
        {
            double[] system = new double[size * (size + 1)];
            for (int i = first; i < end; i++)
            {
                double t = (track[i].Time - middle) / half;
                Vector3d p = track[i].Position - origin;
                power[0] = 1;
                for (int k = 1; k < power.Length; k++)
                {
                    power[k] = power[k - 1] * t;
                }

                for (int k = 0; k < size; k++)
                {
                    for (int j = 0; j < size; j++)
                    {
                        system[(k * (size + 1)) + j] += power[k + j];
                    }

                    system[(k * (size + 1)) + size] += power[k] * p.Along(axis);
                }
            }

            Linear.Solve(system, x, size);
            double scale = 1;
            for (int k = 0; k < size; k++, scale /= half)
            {
                coefficients[k] += scale * x[k] * Vector3d.Axis(axis);
            }
        }

        coefficients[0] += origin;
        return new TrackPolynomial(middle, coefficients);
    }

    public Vector3d At(double time)
    {
        Vector3d sum = Vector3d.Zero;
        for (int k = _coefficients.Length - 1; k >= 0; k--)
        {
            sum = ((time - _middle) * sum) + _coefficients[k];
        }

        return sum;
    }

    public Vector3d VelocityAt(double time)
    {
        Vector3d sum = Vector3d.Zero;
        for (int k = _coefficients.Length - 1; k > 0; k--)
        {
            sum = ((time - _middle) * sum) + (k * _coefficients[k]);
        }

        return sum;
    }
}
