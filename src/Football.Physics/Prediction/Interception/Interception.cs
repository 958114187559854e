using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>Finds which players can reach the ball on a predicted path, and when.</summary>
/// <remarks>
/// Create one and reuse it: a query allocates only to enlarge its buffers. The results are exact for the predicted path. Bounds on the speeds and accelerations
/// of ball and player ensure that no window or gap of a microsecond or more is missed. Interval ends are accurate to a nanosecond. The accuracy of the path
/// itself depends on the look-ahead.
/// </remarks>
public sealed class Interception
{
    /// <summary>Times closer together than this, in s, count as equal.</summary>
    private const double Instant = 1e-9;

    private readonly PathSpans _path = new();
    private readonly WindowList _windows = new();
    private readonly WindowList _firsts = new();
    private readonly ShareSearch _shares;
    private int[] _starts = new int[23];
    private RunnerMotion[] _motions = new RunnerMotion[22];
    private InterceptWindow[] _earliest = new InterceptWindow[22];
    private int _runners;

    /// <summary>Creates an object that has no results yet.</summary>
    public Interception() => _shares = new ShareSearch(_path, _windows);

    /// <summary>The windows of all players from the last <see cref="Find"/>: sorted by player, then by time.</summary>
    public ReadOnlySpan<InterceptWindow> Windows => _windows.Items.AsSpan(0, _windows.Count);

    /// <summary>The index of the player who reaches the ball first; −1 if nobody does.</summary>
    /// <remarks>If several players reach the ball within the same nanosecond, this is the lowest of their indices.</remarks>
    public int First { get; private set; } = -1;

    /// <summary>The lead of the first player over the second, in s.</summary>
    /// <remarks>Infinite if no other player reaches the ball.</remarks>
    public double TimeMargin { get; private set; } = double.PositiveInfinity;

    /// <summary>Returns the windows of one player from the last <see cref="Find"/>, in order of time.</summary>
    /// <param name="runner">The index of the player.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such player.</exception>
    public ReadOnlySpan<InterceptWindow> WindowsOf(int runner)
    {
        Check.Within(nameof(runner), runner, 0, _runners - 1);
        return _windows.Items.AsSpan(_starts[runner], _starts[runner + 1] - _starts[runner]);
    }

    /// <summary>Finds all time intervals in which each player can reach the ball.</summary>
    /// <param name="path">The path of the ball. If it ends at rest, the ball stays there.</param>
    /// <param name="runners">The players, in their states at <paramref name="now"/>.</param>
    /// <param name="now">The start of the search, in s since the launch; default: the start of the path.</param>
    /// <param name="until">The end of the search, in s since the launch; default: the end of the path.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A player's number is out of range; the message names the field, the value and the
    /// range.</exception>
    public void Find(Trajectory path, Player[] runners, double? now = null, double? until = null)
    {
        double start = Begin(path, runners, now, until);
        _windows.Count = 0;
        for (int i = 0; i < _runners; i++)
        {
            // All windows share one list: player i has the windows from _starts[i] up to _starts[i + 1].
            _starts[i] = _windows.Count;
            new WindowSearch(_path, in _motions[i], i, firstOnly: false, _windows).Run(start, _path.End);
            _earliest[i] = _windows.Count > _starts[i] ? _windows.Items[_starts[i]] : new InterceptWindow(i, double.PositiveInfinity, double.PositiveInfinity, default, default);
        }

        _starts[_runners] = _windows.Count;
        Rank();
    }

    /// <summary>Finds the player who reaches the ball first.</summary>
    /// <remarks>This method is cheaper than <see cref="Find"/>, and leaves <see cref="Windows"/> unchanged.</remarks>
    /// <param name="path">The path of the ball. If it ends at rest, the ball stays there.</param>
    /// <param name="runners">The players, in their states at <paramref name="now"/>.</param>
    /// <param name="at">The point at which he reaches the ball.</param>
    /// <param name="now">The start of the search, in s since the launch; default: the start of the path.</param>
    /// <param name="until">The end of the search, in s since the launch; default: the end of the path.</param>
    /// <returns>The index of the player; −1 if nobody reaches the ball. Also sets <see cref="First"/> and <see cref="TimeMargin"/>.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A player's number is out of range; the message names the field, the value and the
    /// range.</exception>
    public int FindFirst(Trajectory path, Player[] runners, out PathPoint at, double? now = null, double? until = null)
    {
        double start = Begin(path, runners, now, until);
        double first = double.PositiveInfinity;
        double second = double.PositiveInfinity;
        for (int i = 0; i < _runners; i++)
        {
            // Players who arrive after the second one do not matter. Use the same search as Find, so that both return the same player.
            _firsts.Count = 0;
            new WindowSearch(_path, in _motions[i], i, firstOnly: true, _firsts).Run(start, _path.End, second + Instant);
            _earliest[i] = _firsts.Count > 0 ? _firsts.Items[0] : new InterceptWindow(i, double.PositiveInfinity, double.PositiveInfinity, default, default);
            double from = _earliest[i].From;

            // Update the two earliest times so far.
            second = Math.Min(second, Math.Max(first, from));
            first = Math.Min(first, from);
        }

        Rank();
        at = First >= 0 ? new PathPoint(_earliest[First].From, _earliest[First].Position, _earliest[First].Velocity, 0) : default;
        return First;
    }

    /// <summary>Divides the ball's path among the players; each point belongs to the player who can reach it first.</summary>
    /// <remarks>
    /// Call <see cref="Find"/> first: this method uses the same players and path. Only players who can reach the ball at a point compete for that point. Leads
    /// are checked at window edges and at the ends of path segments; a lead that begins and ends between two of these is not found.
    /// </remarks>
    /// <returns>The intervals in order of time; empty if nobody can reach the ball. Valid until the next call.</returns>
    public ReadOnlySpan<PossessionInterval> FindShares()
    {
        _shares.Run(_motions, _starts, _runners);
        return _shares.Items.AsSpan(0, _shares.Count);
    }

    /// <summary>Computes a goalkeeper's response to a shot: coverage of the goal line, save, and latest reaction.</summary>
    /// <param name="path">The path of the ball.</param>
    /// <param name="keeper">The goalkeeper in his state at <paramref name="now"/>, with the reach and heights of his dive.</param>
    /// <param name="goal">The goal.</param>
    /// <param name="now">The start of the search, in s since the launch; default: the start of the path.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public KeeperResult FindSave(Trajectory path, in Player keeper, Goal goal, double? now = null)
    {
        Check.Given(nameof(path), path);
        Check.Given(nameof(goal), goal);
        keeper.Validate();
        Check.Place("goal.center", goal.Center);
        double start = now ?? path.StartTime;
        Check.Finite(nameof(now), start);
        return new KeeperSearch(_path, _firsts).Run(path, in keeper, goal, start);
    }

    /// <summary>Validates a query, loads the path and the motions, and returns the start of the search.</summary>
    private double Begin(Trajectory path, Player[] runners, double? now, double? until)
    {
        Check.Given(nameof(path), path);
        Check.Given(nameof(runners), runners);
        double start = now ?? path.StartTime;
        Check.Finite(nameof(now), start);
        Check.Finite(nameof(until), until ?? 0);

        // The buffers grow to the largest number of players so far.
        if (_motions.Length < runners.Length)
        {
            _motions = new RunnerMotion[runners.Length];
            _earliest = new InterceptWindow[runners.Length];
            _starts = new int[runners.Length + 1];
        }

        _runners = runners.Length;
        for (int i = 0; i < runners.Length; i++)
        {
            runners[i].Validate();
            _motions[i] = new RunnerMotion(in runners[i], start);
        }

        // A ball at rest stays there until the requested end. Otherwise, stop at the end of the path.
        _path.Take(path, until ?? path.EndTime);
        return Math.Max(start, _path.Start);
    }

    /// <summary>Determines the first player and his lead; ties within a nanosecond go to the lowest index.</summary>
    private void Rank()
    {
        double least = double.PositiveInfinity;
        for (int i = 0; i < _runners; i++)
        {
            least = Math.Min(least, _earliest[i].From);
        }

        First = -1;
        double next = double.PositiveInfinity;
        for (int i = 0; i < _runners; i++)
        {
            double from = _earliest[i].From;

            // First is the lowest index among players within a nanosecond of the earliest; all other players are later.
            if (First < 0 && from <= least + Instant && !double.IsPositiveInfinity(from))
            {
                First = i;
            }
            else
            {
                next = Math.Min(next, from);
            }
        }

        TimeMargin = First < 0 ? double.PositiveInfinity : Math.Max(0, next - _earliest[First].From);
    }
}
