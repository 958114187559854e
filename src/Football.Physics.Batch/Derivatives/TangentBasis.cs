namespace FootballPhysics.Batch;

/// <summary>An orthonormal basis of what the columns of a tangent span, J = B R, in numbers of one unit: of a velocity, m/s.</summary>
internal sealed class TangentBasis
{
    /// <summary>As many vectors as it may have.</summary>
    public const int Most = Tangent.Columns;

    /// <summary>Place, velocity, spin, and the distance flown.</summary>
    private const int Blocks = 4;

    /// <summary>Of a column's place, velocity or spin no more than this share is left out: what is less is rounding, which may point anywhere.</summary>
    private const double Negligible = 1e-8;

    private readonly double[] _units = new double[MotionVector.Size];
    private readonly double[] _vectors = new double[Most * MotionVector.Size];
    private readonly double[] _shares = new double[Most * Tangent.Columns];
    private readonly double[] _left = new double[Tangent.Columns * MotionVector.Size];

    /// <param name="place">The place that counts as much as a velocity of 1 m/s, m.</param>
    /// <param name="spin">The spin that does, rad/s.</param>
    public TangentBasis(double place, double spin)
    {
        for (int i = 0; i < MotionVector.Size; i++)
        {
            _units[i] = i < MotionVector.Velocity ? place : i < MotionVector.Spin ? 1.0 : i < MotionVector.AirDistance ? spin : 1.0;
        }
    }

    /// <summary>How many vectors it has.</summary>
    public int Count { get; private set; }

    /// <summary>One of the vectors.</summary>
    public Motion this[int index]
    {
        get
        {
            int at = index * MotionVector.Size;
            return new Motion(
                Scaled(at, 0), Scaled(at, MotionVector.Velocity), Scaled(at, MotionVector.Spin), _units[MotionVector.AirDistance] * _vectors[at + MotionVector.AirDistance]);
        }
    }

    /// <summary>R: how much of a vector is in a column.</summary>
    public double Share(int index, int column) => _shares[(index * Tangent.Columns) + column];

    /// <summary>Finds the basis, by Gram–Schmidt's method: the column of which most is left comes first.</summary>
    /// <param name="tangent">The tangent.</param>
    /// <param name="withPlace">Whether the place counts; else the basis is that of all else.</param>
    public void Span(Tangent tangent, bool withPlace)
    {
        Count = 0;
        Span<double> sizes = stackalloc double[Tangent.Columns * Blocks];
        for (int c = 0; c < Tangent.Columns; c++)
        {
            for (int i = 0; i < MotionVector.Size; i++)
            {
                _left[(c * MotionVector.Size) + i] = withPlace || i >= MotionVector.Velocity ? tangent[i, c] / _units[i] : 0;
            }

            for (int b = 0; b < Blocks; b++)
            {
                sizes[(c * Blocks) + b] = Length(c, b);
            }
        }

        while (Count < Most)
        {
            // A law may not be smooth where there is no spin: the columns of the launch's place and velocity are not to be made of those of its spin.
            int most = Largest(sizes, 0, MotionVector.Spin);
            most = most < 0 ? Largest(sizes, MotionVector.Spin, Tangent.Columns) : most;
            if (most < 0)
            {
                return;
            }

            Add(most);
        }
    }

    /// <summary>The column, from one up to another, of which the largest share is left; −1 where all is negligible.</summary>
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
        int at = Count * MotionVector.Size;
        double length = 0;
        for (int b = 0; b < Blocks; b++)
        {
            length += Length(column, b) * Length(column, b);
        }

        length = Math.Sqrt(length);
        for (int i = 0; i < MotionVector.Size; i++)
        {
            _vectors[at + i] = _left[(column * MotionVector.Size) + i] / length;
        }

        for (int c = 0; c < Tangent.Columns; c++)
        {
            double share = 0;
            for (int i = 0; i < MotionVector.Size; i++)
            {
                share += _vectors[at + i] * _left[(c * MotionVector.Size) + i];
            }

            _shares[(Count * Tangent.Columns) + c] = share;
            for (int i = 0; i < MotionVector.Size; i++)
            {
                _left[(c * MotionVector.Size) + i] -= share * _vectors[at + i];
            }
        }

        Array.Clear(_left, column * MotionVector.Size, MotionVector.Size);
        Count++;
    }

    /// <summary>Length of the place, velocity, spin or distance left in a column.</summary>
    private double Length(int column, int block)
    {
        double sum = 0;
        for (int i = 3 * block; i < Math.Min(MotionVector.Size, 3 * (block + 1)); i++)
        {
            double value = _left[(column * MotionVector.Size) + i];
            sum += value * value;
        }

        return Math.Sqrt(sum);
    }

    private Vector3d Scaled(int at, int row) => new(
        _units[row] * _vectors[at + row], _units[row + 1] * _vectors[at + row + 1], _units[row + 2] * _vectors[at + row + 2]);
}
