namespace FootballPhysics.Batch;

/// <summary>The crossing point and time of a kick as a polynomial of the independent errors of the kick.</summary>
/// <remarks>
/// Each error contributes a polynomial of degree three, fitted to the derivatives and to test kicks at two standard deviations on both sides.
/// Products of different errors are not included.
/// </remarks>
internal sealed class CrossingMap
{
    /// <summary>The number of points that a correction is averaged over.</summary>
    private const int Points = 8192;

    private readonly double[] _x = new double[3 * KickSpread.Count];
    private readonly double[] _y = new double[3 * KickSpread.Count];
    private readonly double[] _t = new double[3 * KickSpread.Count];
    private readonly double[] _normal = new double[KickSpread.Count];
    private readonly KickDraws _draws = new(0);
    private double _aside;
    private double _height;
    private double _time;

    /// <summary>Begins with the intended kick.</summary>
    public void Begin(double aside, double height, double time)
    {
        _aside = aside;
        _height = height;
        _time = time;
    }

    /// <summary>Sets the polynomials of one error.</summary>
    /// <param name="column">The index of the error.</param>
    /// <param name="right">The derivative of the offset, in m.</param>
    /// <param name="up">The derivative of the height, in m.</param>
    /// <param name="x0">The offset at −2 standard deviations, in m.</param>
    /// <param name="x1">The offset at +2 standard deviations, in m.</param>
    /// <param name="y0">The height at −2 standard deviations, in m.</param>
    /// <param name="y1">The height at +2 standard deviations, in m.</param>
    /// <param name="t0">The time at −2 standard deviations, in s.</param>
    /// <param name="t1">The time at +2 standard deviations, in s.</param>
    public void Set(int column, double right, double up, double x0, double x1, double y0, double y1, double t0, double t1)
    {
        Fit(_x, column, _aside, right, x0, x1);
        Fit(_y, column, _height, up, y0, y1);
        Fit(_t, column, _time, 0.25 * (t1 - t0), t0, t1);
    }

    /// <summary>Computes how much the curvature and the times of the crossings change the probabilities of the linear map.</summary>
    /// <param name="plane">The plane of the goal.</param>
    /// <param name="mean">The normal distribution of the linear map.</param>
    /// <param name="frame">The spans in which kicks go in.</param>
    /// <param name="onTarget">The change of the probability of a goal without a goalkeeper.</param>
    /// <param name="covered">The change of the probability that the goalkeeper reaches the ball.</param>
    public void Correct(in GoalPlane plane, in GoalChanceResult mean, FramePlays frame, out double onTarget, out double covered)
    {
        // Evaluate both maps at the same points, so that most of the sampling error cancels.
        int moreIn = 0;
        int moreCovered = 0;
        for (int k = 0; k < Points; k++)
        {
            _draws.Draw(k, _normal);
            double x = mean.Aside;
            double y = mean.Height;
            double bentX = _aside;
            double bentY = _height;
            double time = _time;
            for (int i = 0; i < _normal.Length; i++)
            {
                double z = _normal[i];
                x += _x[3 * i] * z;
                y += _y[3 * i] * z;
                bentX += Value(_x, i, z);
                bentY += Value(_y, i, z);
                time += Value(_t, i, z);
            }

            if (frame.IsIn(x, y))
            {
                moreIn--;
                moreCovered -= plane.IsCovered(x, y, mean.Time) ? 1 : 0;
            }

            if (frame.IsIn(bentX, bentY))
            {
                moreIn++;
                moreCovered += plane.IsCovered(bentX, bentY, time) ? 1 : 0;
            }
        }

        onTarget = (double)moreIn / Points;
        covered = (double)moreCovered / Points;
    }

    /// <summary>Fits a z + b z² + c z³ to the derivative at 0 and the values at ±2.</summary>
    private static void Fit(double[] coefficients, int column, double middle, double slope, double low, double high)
    {
        coefficients[3 * column] = slope;
        coefficients[(3 * column) + 1] = 0.125 * (high + low - (2.0 * middle));
        coefficients[(3 * column) + 2] = 0.125 * ((0.5 * (high - low)) - (2.0 * slope));
    }

    private static double Value(double[] coefficients, int column, double z) =>
        z * (coefficients[3 * column] + (z * (coefficients[(3 * column) + 1] + (z * coefficients[(3 * column) + 2]))));
}
