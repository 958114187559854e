using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>The spread of a player's kicks: normally distributed errors of speed, direction and spin, with correlations.</summary>
public sealed record KickSpread
{
    /// <summary>The number of variables that spread: relative speed, elevation, azimuth, relative spin.</summary>
    internal const int Count = 4;

    /// <summary>The standard deviation of the speed, in % of the speed. 0 … 100; default 3.</summary>
    public double SpeedPercent { get; init; } = 3;

    /// <summary>The standard deviation of the elevation, in degrees. 0 … 45; default 1.</summary>
    public double ElevationDegrees { get; init; } = 1;

    /// <summary>The standard deviation of the azimuth, in degrees. 0 … 45; default 1.</summary>
    public double AzimuthDegrees { get; init; } = 1;

    /// <summary>The standard deviation of the spin, in % of the spin. 0 … 100; default 10.</summary>
    public double SpinPercent { get; init; } = 10;

    /// <summary>The correlation of speed and elevation. −1 … 1; default 0.</summary>
    public double SpeedWithElevation { get; init; }

    /// <summary>The correlation of speed and azimuth (positive to the left). −1 … 1; default 0.</summary>
    public double SpeedWithAzimuth { get; init; }

    /// <summary>The correlation of speed and spin. −1 … 1; default 0.</summary>
    public double SpeedWithSpin { get; init; }

    /// <summary>The correlation of elevation and azimuth. −1 … 1; default 0.</summary>
    public double ElevationWithAzimuth { get; init; }

    /// <summary>The correlation of elevation and spin. −1 … 1; default 0.</summary>
    public double ElevationWithSpin { get; init; }

    /// <summary>The correlation of azimuth and spin. −1 … 1; default 0.</summary>
    public double AzimuthWithSpin { get; init; }

    /// <summary>Throws if a number is out of range, or if the correlations contradict each other.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or the correlations contradict each other; the message names field, value and
    /// range.</exception>
    internal void Validate() => Factor(new double[Count * Count]);

    /// <summary>Draws one kick: the intended one with random errors of speed, direction and spin.</summary>
    /// <param name="random">The source of the errors. Seed it to repeat them.</param>
    /// <param name="velocity">The intended velocity, in m/s; at most 1000, not vertical.</param>
    /// <param name="spin">The intended spin, in rad/s; at most 10 000. It rotates with the direction.</param>
    /// <returns>The velocity, in m/s, and the spin, in rad/s.</returns>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or the velocity is vertical.</exception>
    /// <exception cref="ArgumentNullException"><paramref name="random"/> is null.</exception>
    public (Vector3d Velocity, Vector3d Spin) Draw(Random random, Vector3d velocity, Vector3d spin)
    {
        if (random is null)
        {
            throw new ArgumentNullException(nameof(random));
        }

        Check.Size("launch.velocity", velocity, Limits.Speed, "m/s");
        Check.Size("launch.spin", spin, Limits.Spin, "rad/s");
        var kick = new SpreadKick(Vector3d.Zero, in velocity, in spin);
        double[] factor = new double[Count * Count];
        Factor(factor);
        double[] independent = new double[Count];
        for (int i = 0; i < Count; i += 2)
        {
            NormalDistribution.Draw(random.NextDouble(), random.NextDouble(), out independent[i], out independent[i + 1]);
        }

        double[] by = new double[Count];
        Correlate(factor, independent, by);
        kick.With(by, out Vector3d drawn, out Vector3d turning);
        return (KickVectors.Limited(in drawn, Limits.Speed), KickVectors.Limited(in turning, Limits.Spin));
    }

    /// <summary>Computes L z: numbers with the covariance L Lᵀ from independent ones.</summary>
    internal static void Correlate(double[] factor, double[] independent, double[] correlated)
    {
        for (int i = 0; i < Count; i++)
        {
            double sum = 0;
            for (int j = 0; j <= i; j++)
            {
                sum += factor[(i * Count) + j] * independent[j];
            }

            correlated[i] = sum;
        }
    }

    /// <summary>Factors the covariance C = L Lᵀ of relative speed, elevation, azimuth (rad) and relative spin.</summary>
    /// <param name="factor">L, row by row.</param>
    internal void Factor(double[] factor)
    {
        Check.Within("spread.speedPercent", SpeedPercent, 0, 100);
        Check.Within("spread.elevationDegrees", ElevationDegrees, 0, 45);
        Check.Within("spread.azimuthDegrees", AzimuthDegrees, 0, 45);
        Check.Within("spread.spinPercent", SpinPercent, 0, 100);
        const double PerDegree = Math.PI / 180.0;
        for (int i = 0; i < Count; i++)
        {
            for (int j = 0; j <= i; j++)
            {
                double sum = i == j ? 1.0 : Correlation(i, j);
                Check.Within("spread's correlations", sum, -1, 1);
                for (int k = 0; k < j; k++)
                {
                    sum -= factor[(i * Count) + k] * factor[(j * Count) + k];
                }

                // Cholesky factorization. A pivot of nearly zero means a number that depends on the others.
                double pivot = factor[(j * Count) + j];
                if (i == j && sum < -1e-12)
                {
                    throw Check.Refusal("spread's correlations", ToString(), "correlations of a positive definite matrix");
                }

                if (i != j && pivot <= 1e-9 && Math.Abs(sum) > 1e-6)
                {
                    throw Check.Refusal("spread's correlations", ToString(), "correlations of a positive definite matrix");
                }

                factor[(i * Count) + j] = i == j ? Math.Sqrt(Math.Max(0, sum)) : pivot > 1e-9 ? sum / pivot : 0;
                factor[(j * Count) + i] = i == j ? factor[(i * Count) + i] : 0;
            }
        }

        for (int i = 0; i < Count; i++)
        {
            double deviation = i == 0 ? 0.01 * SpeedPercent : i == 1 ? PerDegree * ElevationDegrees : i == 2 ? PerDegree * AzimuthDegrees : 0.01 * SpinPercent;
            for (int j = 0; j < Count; j++)
            {
                factor[(i * Count) + j] *= deviation;
            }
        }
    }

    private double Correlation(int row, int column) => (row, column) switch
    {
        (1, 0) => SpeedWithElevation,
        (2, 0) => SpeedWithAzimuth,
        (3, 0) => SpeedWithSpin,
        (2, 1) => ElevationWithAzimuth,
        (3, 1) => ElevationWithSpin,
        _ => AzimuthWithSpin,
    };
}
