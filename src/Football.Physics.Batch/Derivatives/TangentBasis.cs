namespace FootballPhysics.Batch;

/// <summary>An orthonormal basis of the columns of a tangent, J = B R, with all components scaled to a velocity in m/s.</summary>
internal sealed class TangentBasis
{
    /// <summary>The maximum number of vectors.</summary>
    public const int Most = Tangent.Columns;

    /// <summary>The blocks: position, velocity, spin, distance flown, and turn.</summary>
    private const int Blocks = 5;

    /// <summary>The share of a column's position, velocity or spin that may be left out: below it, only rounding errors remain.</summary>
    private const double Negligible = 1e-8;

    private readonly double[] _units = new double[MotionVector.Whole];
    private readonly double[] _vectors = new double[Most * MotionVector.Whole];
    private readonly double[] _shares = new double[Most * Tangent.Columns];
    private readonly double[] _left = new double[Tangent.Columns * MotionVector.Whole];

    /// <param name="place">The displacement that counts as much as 1 m/s, in m.</param>
    /// <param name="spin">The spin that counts as much as 1 m/s, in rad/s.</param>
    /// <param name="turn">The turn that counts as much as 1 m/s, in rad.</param>
    public TangentBasis(double place, double spin, double turn)
    {
        for (int i = 0; i < MotionVector.Whole; i++)
        {
            _units[i] = i < MotionVector.Velocity ? place : i < MotionVector.Spin ? 1.0 : i < MotionVector.AirDistance ? spin : i < MotionVector.Turn ? 1.0 : turn;
        }
    }

    /// <summary>The number of vectors.</summary>
    public int Count { get; private set; }

    /// <summary>Gets one of the vectors.</summary>
    public Motion this[int index]
    {
        get
        {
            int at = index * MotionVector.Whole;
            return new Motion(
                Scaled(at, 0), Scaled(at, MotionVector.Velocity), Scaled(at, MotionVector.Spin), _units[MotionVector.AirDistance] * _vectors[at + MotionVector.AirDistance],
                Scaled(at, MotionVector.Turn));
        }
    }

    /// <summary>Returns an entry of R: the share of a vector in a column.</summary>
    public double Share(int index, int column) => _shares[(index * Tangent.Columns) + column];

    /// <summary>Computes the basis by the Gram–Schmidt method, starting with the column that has the largest remainder.</summary>
    /// <param name="tangent">The tangent.</param>
    /// <param name="withPlace">True to include the position.</param>
    public void Span(Tangent tangent, bool withPlace)
    {
        Count = 0;
        Span<double> sizes = stackalloc double[Tangent.Columns * Blocks];
        for (int c = 0; c < Tangent.Columns; c++)
        {
            for (int i = 0; i < MotionVector.Whole; i++)
            {
                _left[(c * MotionVector.Whole) + i] = withPlace || i >= MotionVector.Velocity ? tangent[i, c] / _units[i] : 0;
            }

            for (int b = 0; b < Blocks; b++)
            {
                sizes[(c * Blocks) + b] = Length(c, b);
            }
        }

        while (Count < Most)
        {
            // A law may not be smooth at zero spin, so never build the columns of position and velocity from those of the spin.
            int most = Largest(sizes, 0, MotionVector.Spin);
            most = most < 0 ? Largest(sizes, MotionVector.Spin, Tangent.Columns) : most;
            if (most < 0)
            {
                return;
            }

            Add(most);
        }
    }

    /// <summary>Returns the column in a range with the largest remainder; −1 if all are negligible.</summary>
    private int Largest(ReadOnlySpan<double> sizes, int from, int to)
    {
        int most = -1;
        double longest = Negligible;
        for (int c = from; c < to; c++)
        {
            for (int b = 0; b < Blocks; b++)
            {
                double size = sizes[(c * Blocks) + b];
                double share = size > 0 ? Length(c, b) / size : 0;
                (most, longest) = share > longest ? (c, share) : (most, longest);
            }
        }

        return most;
    }

    private void Add(int column)
    {
        int at = Count * MotionVector.Whole;
        double length = 0;
        for (int b = 0; b < Blocks; b++)
        {
            length += Length(column, b) * Length(column, b);
        }

        length = Math.Sqrt(length);
        for (int i = 0; i < MotionVector.Whole; i++)
        {
            _vectors[at + i] = _left[(column * MotionVector.Whole) + i] / length;
        }

        for (int c = 0; c < Tangent.Columns; c++)
        {
            double share = 0;
            for (int i = 0; i < MotionVector.Whole; i++)
            {
                share += _vectors[at + i] * _left[(c * MotionVector.Whole) + i];
            }

            _shares[(Count * Tangent.Columns) + c] = share;
            for (int i = 0; i < MotionVector.Whole; i++)
            {
                _left[(c * MotionVector.Whole) + i] -= share * _vectors[at + i];
            }
        }

        Array.Clear(_left, column * MotionVector.Whole, MotionVector.Whole);
        Count++;
    }

    /// <summary>Returns the length of one block of a column's remainder.</summary>
    private double Length(int column, int block)
    {
        double sum = 0;
        int from = block * MotionVector.Velocity;
        bool isTurn = from > MotionVector.AirDistance;
        from = isTurn ? MotionVector.Turn : from;
        int to = isTurn ? MotionVector.Whole : Math.Min(MotionVector.Turn, from + MotionVector.Velocity);
        for (int i = from; i < to; i++)
        {
            double value = _left[(column * MotionVector.Whole) + i];
            sum += value * value;
        }

        return Math.Sqrt(sum);
    }

    private Vector3d Scaled(int at, int row) => new(
        _units[row] * _vectors[at + row], _units[row + 1] * _vectors[at + row + 1], _units[row + 2] * _vectors[at + row + 2]);
}
