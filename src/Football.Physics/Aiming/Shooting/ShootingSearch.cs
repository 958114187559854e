namespace Football.Physics;

/// <summary>The search for a kick of a given speed that knows nothing: a scan over all directions, and from what comes close there the method of Levenberg and Marquardt.</summary>
/// <remarks>Without it 8 of the known kicks of five balls in a storm are not found again, and with it all (<c>football lab answers --only known --count 300</c>).</remarks>
internal sealed class ShootingSearch
{
    private const int N = ShootingProblem.Unknowns;

    /// <summary>Elevations and azimuths of a scan, and its starts that are followed.</summary>
    private const int Rows = 13;
    private const int Columns = 12;
    private const int MostStarts = 8;

    private readonly ShootingProblem _problem;
    private readonly LevenbergMarquardt _solver;
    private readonly DirectionScan _scan;
    private readonly double[] _x = new double[N];

    public ShootingSearch(ShootingProblem problem, LevenbergMarquardt solver, DirectionScan scan)
    {
        _problem = problem;
        _solver = solver;
        _scan = scan;
    }

    /// <summary>Searches.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="speed">Its speed, m/s.</param>
    /// <param name="arc">Whether the one that is there first is wanted, or the last.</param>
    /// <param name="top">Its topspin, rad/s.</param>
    /// <param name="side">Its sidespin, rad/s.</param>
    /// <param name="solution">The kick.</param>
    /// <returns>Whether there is one, measured.</returns>
    public bool WithSpeed(AimRequest request, double speed, AimArc arc, double top, double side, out AimSolution solution)
    {
        solution = default;
        if (_problem.IsHalfSpent)
        {
            return false;
        }

        _problem.Begin(request, speed, through: false);
        _scan.Clear();
        _scan.Fly(Rows, Columns, speed, top, side);
        bool found = false;
        for (int start = 0; start < Math.Min(MostStarts, _scan.Count) && !_problem.IsHalfSpent; start++)
        {
            _scan.Start(start, _x);
            if (_solver.Hit(_x, out AimSolution one) && (!found || (arc == AimArc.Low ? one.Time < solution.Time : one.Time > solution.Time)))
            {
                solution = one;
                found = true;
            }
        }

        return found;
    }
}

/// <summary>The search for a two-point kick that the closed form is too far from: from many kicks, in all directions and with many spins.</summary>
/// <remarks>Without it 14 of 176 known kicks through two points are not found again, with it all are (<c>football lab answers --only known --count 300</c>).</remarks>
internal sealed class TwoPointSearch
{
    private const int N = ShootingProblem.Unknowns;

    /// <summary>Elevations, azimuths and spins that are tried.</summary>
    private const int Rows = 5;
    private const int Columns = 6;
    private const int Spins = 9;

    private readonly ShootingProblem _problem;
    private readonly LevenbergMarquardt _solver;
    private readonly DirectionScan _scan;
    private readonly double[] _x = new double[N];

    public TwoPointSearch(ShootingProblem problem, LevenbergMarquardt solver, DirectionScan scan)
    {
        _problem = problem;
        _solver = solver;
        _scan = scan;
    }

    /// <summary>Searches.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="near">A kick to begin with.</param>
    /// <param name="solution">The kick that passes both points.</param>
    /// <returns>Whether there is one, measured.</returns>
    public bool Find(AimRequest request, in Kick near, out AimSolution solution)
    {
        _problem.Begin(request, request.Speed, through: true);
        _x[ShootingProblem.Elevation] = _problem.Clamp(ShootingProblem.Elevation, near.Elevation);
        _x[ShootingProblem.Azimuth] = near.Azimuth;
        _x[ShootingProblem.LogSpeed] = Elementary.Log(request.Speed);
        _x[ShootingProblem.Top] = _problem.Clamp(ShootingProblem.Top, near.Top);
        _x[ShootingProblem.Side] = _problem.Clamp(ShootingProblem.Side, near.Side);
        _problem.Approach(_x);
        if (_solver.Hit(_x, out solution))
        {
            return true;
        }

        bool passes = Near(out solution);
        _scan.Clear();
        for (int spin = 0; spin < Spins; spin++)
        {
            // Without, much of one kind, and much of both.
            double top = spin is 0 or 3 or 4 ? 0 : spin is 1 or 5 or 6 ? -0.6 : 0.6;
            double side = spin is 0 or 1 or 2 ? 0 : spin is 3 or 5 or 7 ? -0.6 : 0.6;
            _scan.Fly(Rows, Columns, request.Speed, top * request.MaximumTopSpin, side * request.MaximumSideSpin);
        }

        for (int start = 0; start < _scan.Count && !_problem.IsSpent; start++)
        {
            _scan.Start(start, _x);
            if (_solver.Hit(_x, out AimSolution one))
            {
                solution = one;
                return true;
            }

            if (!passes && Near(out one))
            {
                solution = one;
                passes = true;
            }
        }

        return passes;
    }

    /// <summary>
    /// Goes on to the target alone where a search ended close to both points: angles and spins that do almost the same make a valley, along which it comes closer and
    /// closer, but too slowly.
    /// </summary>
    /// <param name="solution">The kick.</param>
    /// <returns>Whether it hits the target, and passes the other point within its tolerance.</returns>
    private bool Near(out AimSolution solution)
    {
        solution = default;
        double tolerance = _problem.Request.ThroughTolerance;
        double squares = 0;
        foreach (double residual in _solver.Residuals)
        {
            squares += residual * residual;
        }

        if (!(squares < tolerance * tolerance))
        {
            return false;
        }

        _problem.AskThrough(false);
        bool hits = _solver.Hit(_x, out solution) && solution.ThroughMiss <= tolerance;
        _problem.AskThrough(true);
        return hits;
    }
}

/// <summary>Flies kicks in directions all around, and lists those that come closer than their neighbours: where to begin a search that knows nothing.</summary>
internal sealed class DirectionScan
{
    /// <summary>Places to begin at that are listed.</summary>
    public const int MostStarts = 24;

    private const int MostRows = 13;
    private const int MostColumns = 12;
    private const int N = ShootingProblem.Unknowns;

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
        double lowest = _problem.Least[ShootingProblem.Elevation];
        double highest = _problem.Most[ShootingProblem.Elevation];
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

    /// <summary>Whether none of its neighbours comes closer.</summary>
    private bool IsLeast(int at)
    {
        int row = at / _columns;
        int column = at % _columns;
        for (int i = Math.Max(0, row - 1); i <= Math.Min(_rows - 1, row + 1); i++)
        {
            for (int k = -1; k <= 1; k++)
            {
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
