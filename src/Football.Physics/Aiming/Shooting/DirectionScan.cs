using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>Simulates kicks in all directions, and lists the local minima of the miss as starts for a search.</summary>
internal sealed class DirectionScan(ShootingProblem problem)
{
    /// <summary>The maximum number of starts.</summary>
    public const int MostStarts = 24;

    private const int MostRows = 13;
    private const int MostColumns = 12;
    private const int N = ShootingProblem.Most;

    private readonly ShootingProblem _problem = problem;
    private readonly double[] _squares = new double[MostRows * MostColumns];
    private readonly double[] _x = new double[MostRows * MostColumns * N];
    private readonly double[] _one = new double[N];
    private readonly double[] _starts = new double[MostStarts * N];
    private readonly double[] _startSquares = new double[MostStarts];
    private int _rows;
    private int _columns;

    /// <summary>The number of starts.</summary>
    public int Count { get; private set; }

    /// <summary>Empties the list.</summary>
    public void Clear() => Count = 0;

    /// <summary>Simulates kicks, and adds the local minima to the list.</summary>
    /// <param name="rows">The number of elevations.</param>
    /// <param name="columns">The number of azimuths.</param>
    /// <param name="speed">The speed, in m/s.</param>
    /// <param name="top">The topspin, in rad/s.</param>
    /// <param name="side">The sidespin, in rad/s.</param>
    /// <param name="time">The time at which the miss is measured, in s; null for the closest approach.</param>
    public void Fly(int rows, int columns, double speed, double top, double side, double? time = null)
    {
        // Simulate a grid of kicks over all directions, or a single row if the bounds allow only one elevation.
        double lowest = _problem.Clamp(ShootingProblem.Elevation, double.NegativeInfinity);
        double highest = _problem.Clamp(ShootingProblem.Elevation, double.PositiveInfinity);
        _rows = highest > lowest ? rows : 1;
        _columns = columns;
        for (int i = 0; i < _rows * _columns; i++)
        {
            _one[ShootingProblem.Elevation] = _rows > 1 ? lowest + ((highest - lowest) * (i / _columns) / (_rows - 1)) : lowest;
            _one[ShootingProblem.Azimuth] = 2.0 * Math.PI * (i % _columns) / _columns;
            _one[ShootingProblem.LogSpeed] = Elementary.Log(speed);
            _one[ShootingProblem.Top] = top;
            _one[ShootingProblem.Side] = side;
            _squares[i] = _problem.IsSpent ? double.PositiveInfinity : time is { } at ? _problem.GapAt(_one, at) : _problem.Approach(_one);
            Array.Copy(_one, 0, _x, i * N, N);
        }

        // Start only from local minima, because neighbours would lead to the same kick.
        for (int i = 0; i < _rows * _columns; i++)
        {
            if (IsLeast(i))
            {
                Insert(i);
            }
        }
    }

    /// <summary>Returns a start; index 0 is the closest.</summary>
    public void Start(int index, double[] x) => Array.Copy(_starts, index * N, x, 0, N);

    /// <summary>True if no neighbour comes closer.</summary>
    private bool IsLeast(int at)
    {
        int row = at / _columns;
        int column = at % _columns;
        for (int i = Math.Max(0, row - 1); i <= Math.Min(_rows - 1, row + 1); i++)
        {
            for (int k = -1; k <= 1; k++)
            {
                // Azimuths wrap around; elevations end at their bounds.
                int other = (i * _columns) + ((column + k + _columns) % _columns);
                if (_squares[other] < _squares[at])
                {
                    return false;
                }
            }
        }

        return true;
    }

    private void Insert(int look)
    {
        double square = _squares[look];
        if (Count == MostStarts && !(square < _startSquares[Count - 1]))
        {
            return;
        }

        // Insertion sort: when the list is full, drop the farthest start.
        int at = Count < MostStarts ? Count++ : MostStarts - 1;
        while (at > 0 && square < _startSquares[at - 1])
        {
            _startSquares[at] = _startSquares[at - 1];
            Array.Copy(_starts, (at - 1) * N, _starts, at * N, N);
            at--;
        }

        _startSquares[at] = square;
        Array.Copy(_x, look * N, _starts, at * N, N);
    }
}
