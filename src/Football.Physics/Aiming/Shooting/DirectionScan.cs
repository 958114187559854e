namespace FootballPhysics.Aiming;

/// <summary>Flies kicks in directions all around, and lists those that come closer than their neighbours: where to begin a search that knows nothing.</summary>
internal sealed class DirectionScan
{
    /// <summary>Places to begin at that are listed.</summary>
    public const int MostStarts = 24;

    private const int MostRows = 13;
    private const int MostColumns = 12;
    private const int N = ShootingProblem.Most;

    private readonly ShootingProblem _problem;
    private readonly double[] _squares = new double[MostRows * MostColumns];
    private readonly double[] _x = new double[MostRows * MostColumns * N];
    private readonly double[] _one = new double[N];
    private readonly double[] _starts = new double[MostStarts * N];
    private readonly double[] _startSquares = new double[MostStarts];
    private int _rows;
    private int _columns;

    public DirectionScan(ShootingProblem problem) => _problem = problem;

    /// <summary>How many places are listed.</summary>
    public int Count { get; private set; }

    /// <summary>Empties the list.</summary>
    public void Clear() => Count = 0;

    /// <summary>Flies the kicks, and lists the places among those of flights before.</summary>
    /// <param name="rows">Elevations.</param>
    /// <param name="columns">Azimuths.</param>
    /// <param name="speed">Their speed, m/s.</param>
    /// <param name="top">Their topspin, rad/s.</param>
    /// <param name="side">Their sidespin, rad/s.</param>
    /// <param name="time">When they are to come close, s; null for any time.</param>
    public void Fly(int rows, int columns, double speed, double top, double side, double? time = null)
    {
        // A grid over all directions; of one elevation alone where the bounds allow no more.
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

        // Starts are the local minima: what lies beside one would lead to the same kick.
        for (int i = 0; i < _rows * _columns; i++)
        {
            if (IsLeast(i))
            {
                Insert(i);
            }
        }
    }

    /// <summary>A place to begin at, the closest first.</summary>
    public void Start(int index, double[] x) => Array.Copy(_starts, index * N, x, 0, N);

    /// <summary>True when none of its neighbours comes closer.</summary>
    private bool IsLeast(int at)
    {
        int row = at / _columns;
        int column = at % _columns;
        for (int i = Math.Max(0, row - 1); i <= Math.Min(_rows - 1, row + 1); i++)
        {
            for (int k = -1; k <= 1; k++)
            {
                // Azimuths go round; elevations end at their bounds.
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

        // Sorted by insertion; when the list is full the farthest falls out.
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
