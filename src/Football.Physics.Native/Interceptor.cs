namespace FootballPhysics.Native;

/// <summary>Predicts the path of a ball, and finds the players who reach it. A call allocates only if the path or the number of players differs from the last call.</summary>
/// <param name="simulator">The scene.</param>
internal sealed unsafe class Interceptor(Simulator simulator)
{
    private const int ShortestPath = 1 << 10;
    private const int LongestPath = 1 << 18;

    private int _capacity = ShortestPath;
    private LookAheadRequest _request = new();
    private Trajectory _path = new(new PathSegment[ShortestPath]);
    private Player[] _players = [];

    /// <summary>The results of the last call.</summary>
    public Interception Interception { get; } = new();

    /// <summary>Finds the player who reaches the ball first, and the point of the path.</summary>
    public int FindFirst(in BallState ball, double seconds, NativePlayer* players, int n, out PathPoint at)
    {
        Prepare(in ball, seconds, players, n);
        return Interception.FindFirst(_path, _players, out at, until: ball.Time + seconds);
    }

    /// <summary>Finds all time intervals in which each player reaches the ball.</summary>
    public ReadOnlySpan<InterceptWindow> FindWindows(in BallState ball, double seconds, NativePlayer* players, int n)
    {
        Prepare(in ball, seconds, players, n);
        Interception.Find(_path, _players, until: ball.Time + seconds);
        return Interception.Windows;
    }

    private void Prepare(in BallState ball, double seconds, NativePlayer* players, int n)
    {
        if (_players.Length != n)
        {
            _players = new Player[n];
        }

        for (int i = 0; i < n; i++)
        {
            NativePlayer from = players[i];
            _players[i] = Guard.Player(&from, i);
        }

        if (_request.Duration != seconds)
        {
            _request = new LookAheadRequest { Duration = seconds };
        }

        simulator.LookAhead(in ball, _request, _path);
        while (!_path.IsComplete)
        {
            if (_capacity >= LongestPath)
            {
                throw new ArgumentException("seconds is too long: the path has too many segments. Shorten it.");
            }

            _capacity *= 4;
            _path = new Trajectory(new PathSegment[_capacity]);
            simulator.LookAhead(in ball, _request, _path);
        }
    }
}
