namespace FootballPhysics.Tracks;

/// <summary>The equations of one flight at the solution, without its launch: its information about the shared parameters, and the covariance of the scores.</summary>
/// <remarks>
/// With the blocks A of the launch, C of the shared parameters and B of both, K = A⁻¹B, T = [−Kᵀ, I], and the covariance V of the gradient (JᵀWr and the prior):
/// the information S = C − BᵀK, the score s = T g, its covariance T V Tᵀ, and its covariance with the launch's gradient V Tᵀ.
/// </remarks>
internal sealed class FlightScore
{
    private const int Launch = FlightPath.Launch;

    private readonly int _shared;
    private readonly int _size;
    private readonly double[] _spread;
    private readonly double[] _inverse = new double[Launch * Launch];
    private readonly double[] _coupling;
    private readonly double[] _across;

    /// <summary>Eliminates the launch.</summary>
    /// <param name="shared">The number of shared parameters.</param>
    /// <param name="normal">JᵀWJ with the prior of the spin.</param>
    /// <param name="gradient">JᵀWr with that prior.</param>
    /// <param name="spread">The covariance V of the gradient.</param>
    /// <param name="share">The weight of the flight in the shared parameters.</param>
    public FlightScore(int shared, double[] normal, double[] gradient, double[] spread, double share)
    {
        _shared = shared;
        _size = Launch + shared;
        _spread = spread;
        Share = share;
        var elimination = new LaunchElimination(shared);
        elimination.Invert(normal, _inverse);
        _coupling = elimination.Couple(normal, _inverse);
        Information = new double[shared * shared];
        Score = new double[shared];
        elimination.Eliminate(normal, gradient, _coupling, 1, Information, Score);
        _across = new double[_size * shared];
        for (int i = 0; i < _size; i++)
        {
            for (int j = 0; j < shared; j++)
            {
                double sum = spread[(i * _size) + Launch + j];
                for (int k = 0; k < Launch; k++)
                {
                    sum -= spread[(i * _size) + k] * _coupling[(k * shared) + j];
                }

                _across[(i * shared) + j] = sum;
            }
        }

        Spread = new double[shared * shared];
        for (int i = 0; i < shared; i++)
        {
            for (int j = 0; j < shared; j++)
            {
                double sum = _across[((Launch + i) * shared) + j];
                for (int k = 0; k < Launch; k++)
                {
                    sum -= _coupling[(k * shared) + i] * _across[(k * shared) + j];
                }

                Spread[(i * shared) + j] = sum;
            }
        }
    }

    /// <summary>The weight of the flight in the shared parameters.</summary>
    public double Share { get; }

    /// <summary>S, the information about the shared parameters.</summary>
    public double[] Information { get; }

    /// <summary>s, the score of the shared parameters.</summary>
    public double[] Score { get; }

    /// <summary>T V Tᵀ, the covariance of the score.</summary>
    public double[] Spread { get; }

    /// <summary>Computes the covariance of the launch.</summary>
    /// <param name="inverse">The inverse information of the shared parameters, of all flights and the prior.</param>
    /// <param name="covariance">The covariance of the shared parameters.</param>
    /// <param name="launch">Receives A⁻¹V A⁻¹ + K Cov Kᵀ − w (A⁻¹ V Tᵀ S⁻¹ Kᵀ + its transpose).</param>
    public void Launches(double[] inverse, double[] covariance, double[] launch)
    {
        double[] back = Transposed(_coupling, _shared);
        double[] own = Times(Times(_inverse, Block(_spread, _size, Launch), Launch, Launch), _inverse, Launch, Launch);
        double[] common = Times(Times(_coupling, covariance, _shared, _shared), back, _shared, Launch);
        double[] cross = Times(Times(Times(_inverse, Block(_across, _shared, _shared), Launch, _shared), inverse, _shared, _shared), back, _shared, Launch);
        for (int i = 0; i < Launch; i++)
        {
            for (int j = 0; j < Launch; j++)
            {
                int at = (i * Launch) + j;
                launch[at] = own[at] + common[at] - (Share * (cross[at] + cross[(j * Launch) + i]));
            }
        }
    }

    /// <summary>Adds the square of the launch's change −K δ for a change δ of shared parameters to a covariance.</summary>
    /// <param name="step">The change of the first shared parameters; the others stay.</param>
    /// <param name="share">The share of the square.</param>
    /// <param name="launch">The covariance of the launch.</param>
    public void AddChange(double[] step, double share, double[] launch)
    {
        double[] change = new double[Launch];
        for (int i = 0; i < Launch; i++)
        {
            for (int j = 0; j < step.Length; j++)
            {
                change[i] += _coupling[(i * _shared) + j] * step[j];
            }
        }

        for (int i = 0; i < launch.Length; i++)
        {
            launch[i] += share * change[i / Launch] * change[i % Launch];
        }
    }

    /// <summary>Returns the rows of the launch of a matrix with a number of columns.</summary>
    private static double[] Block(double[] matrix, int stride, int columns)
    {
        double[] block = new double[Launch * columns];
        for (int i = 0; i < Launch; i++)
        {
            Array.Copy(matrix, i * stride, block, i * columns, columns);
        }

        return block;
    }

    private static double[] Transposed(double[] matrix, int columns)
    {
        double[] transposed = new double[matrix.Length];
        int rows = columns == 0 ? 0 : matrix.Length / columns;
        for (int i = 0; i < matrix.Length; i++)
        {
            transposed[(i % columns * rows) + (i / columns)] = matrix[i];
        }

        return transposed;
    }

    /// <summary>Returns the product of two matrices.</summary>
    /// <param name="left">The left matrix, row by row.</param>
    /// <param name="right">The right matrix, row by row.</param>
    /// <param name="inner">The number of columns of the left, and of rows of the right.</param>
    /// <param name="columns">The number of columns of the right.</param>
    public static double[] Times(double[] left, double[] right, int inner, int columns)
    {
        double[] product = new double[inner == 0 ? Launch * columns : left.Length / inner * columns];
        for (int i = 0; i < product.Length; i++)
        {
            for (int k = 0; k < inner; k++)
            {
                product[i] += left[(i / columns * inner) + k] * right[(k * columns) + (i % columns)];
            }
        }

        return product;
    }
}
