namespace FootballPhysics.Prediction;

/// <summary>Who gets to the ball, and when: answers on a predicted path. Its memory is made once and used again; a query allocates nothing once there is room.</summary>
/// <remarks>
/// Exact on the dense path: no window and no gap of a microsecond or more is lost, which bounds of the speeds and accelerations of both prove, and ends are
/// within a nanosecond of it. How far the path itself is off the game's own steps is up to the look-ahead.
/// </remarks>
public sealed class Interception
{
    /// <summary>Instants closer than this, s, are one.</summary>
    private const double Instant = 1e-9;

    private readonly PathSpans _path = new();
    private readonly WindowList _windows = new();
    private readonly WindowList _firsts = new();
    private readonly ShareSearch _shares;
    private int[] _starts = new int[23];
    private RunnerMotion[] _motions = new RunnerMotion[22];
    private InterceptWindow[] _earliest = new InterceptWindow[22];
    private int _runners;

    /// <summary>Makes one without an answer.</summary>
    public Interception() => _shares = new ShareSearch(_path, _windows);

    /// <summary>The windows of all runners of the last <see cref="Find"/>: runner by runner, each in order of time.</summary>
    public ReadOnlySpan<InterceptWindow> Windows => _windows.Items.AsSpan(0, _windows.Count);

    /// <summary>Who meets the ball first, of those who do within the same nanosecond the one with the lowest index; −1 where nobody does.</summary>
    public int First { get; private set; } = -1;

    /// <summary>By how much he is first, s: how much later the next one meets it. Infinite where no one else does.</summary>
    public double TimeMargin { get; private set; } = double.PositiveInfinity;

    /// <summary>The windows of one runner of the last <see cref="Find"/>, in order of time.</summary>
    /// <param name="runner">Which, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such runner.</exception>
    public ReadOnlySpan<InterceptWindow> WindowsOf(int runner)
    {
        Check.Within(nameof(runner), runner, 0, _runners - 1);
        return _windows.Items.AsSpan(_starts[runner], _starts[runner + 1] - _starts[runner]);
    }

    /// <summary>Finds all times at which each of the runners can meet the ball.</summary>
    /// <param name="path">The ball's way. One that ends at rest goes on there.</param>
    /// <param name="runners">The runners, as they are at <paramref name="now"/>.</param>
    /// <param name="now">When their time begins, s since the launch; default the path's start. Nobody meets the ball before.</param>
    /// <param name="until">When to end, s since the launch; default the path's end.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number of a runner is out of range; the message names field, value and range.</exception>
    public void Find(Trajectory path, Player[] runners, double? now = null, double? until = null)
    {
        double start = Begin(path, runners, now, until);
        _windows.Count = 0;
        for (int i = 0; i < _runners; i++)
        {
            // One list for all: the windows of runner i are those from _starts[i] to _starts[i + 1].
            _starts[i] = _windows.Count;
            new WindowSearch(_path, in _motions[i], i, firstOnly: false, _windows).Run(start, _path.End);
            _earliest[i] = _windows.Count > _starts[i] ? _windows.Items[_starts[i]] : new InterceptWindow(i, double.PositiveInfinity, double.PositiveInfinity, default, default);
        }

        _starts[_runners] = _windows.Count;
        Rank();
    }

    /// <summary>Finds who meets the ball first: cheaper than <see cref="Find"/>, whose windows it leaves alone.</summary>
    /// <param name="path">The ball's way. One that ends at rest goes on there.</param>
    /// <param name="runners">The runners, as they are at <paramref name="now"/>.</param>
    /// <param name="at">Where and when he meets it.</param>
    /// <param name="now">When their time begins, s since the launch; default the path's start.</param>
    /// <param name="until">When to end, s since the launch; default the path's end.</param>
    /// <returns>Which of them; −1 where nobody does. <see cref="First"/> and <see cref="TimeMargin"/> tell so too.</returns>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number of a runner is out of range; the message names field, value and range.</exception>
    public int FindFirst(Trajectory path, Player[] runners, out PathPoint at, double? now = null, double? until = null)
    {
        double start = Begin(path, runners, now, until);
        double first = double.PositiveInfinity;
        double second = double.PositiveInfinity;
        for (int i = 0; i < _runners; i++)
        {
            // Who comes after the second changes nothing. Each search is that of Find, so that both name the same one.
            _firsts.Count = 0;
            new WindowSearch(_path, in _motions[i], i, firstOnly: true, _firsts).Run(start, _path.End, second + Instant);
            _earliest[i] = _firsts.Count > 0 ? _firsts.Items[0] : new InterceptWindow(i, double.PositiveInfinity, double.PositiveInfinity, default, default);
            double from = _earliest[i].From;

            // The two earliest so far.
            second = Math.Min(second, Math.Max(first, from));
            first = Math.Min(first, from);
        }

        Rank();
        at = First >= 0 ? new PathPoint(_earliest[First].From, _earliest[First].Position, _earliest[First].Velocity, 0) : default;
        return First;
    }

    /// <summary>
    /// Who owns which part of the ball's way: of those who can meet the ball somewhere, the one who could be there first. After <see cref="Find"/>, for its runners and path.
    /// </summary>
    /// <remarks>Who is ahead within a piece of the look-ahead without being so at either of its ends, or where a window begins or ends, is not told.</remarks>
    /// <returns>The parts, in order of time; where nobody can meet the ball there is none. They last until the next call.</returns>
    public ReadOnlySpan<PossessionInterval> FindShares()
    {
        _shares.Run(_motions, _starts, _runners);
        return _shares.Items.AsSpan(0, _shares.Count);
    }

    /// <summary>Finds a goalkeeper's answer to a shot: where and when it crosses the goal's plane, what he covers by then, whether he saves it, and when he must dive.</summary>
    /// <param name="path">The ball's way.</param>
    /// <param name="keeper">The goalkeeper as he is at <paramref name="now"/>, with the reach and the heights of his dive.</param>
    /// <param name="goal">The goal.</param>
    /// <param name="now">When his time begins, s since the launch; default the path's start.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
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

    private double Begin(Trajectory path, Player[] runners, double? now, double? until)
    {
        Check.Given(nameof(path), path);
        Check.Given(nameof(runners), runners);
        double start = now ?? path.StartTime;
        Check.Finite(nameof(now), start);
        Check.Finite(nameof(until), until ?? 0);

        // Memory grows to the most runners that were ever asked for.
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

        // As long as asked for, where the ball lies still; else up to the end of the path.
        _path.Take(path, until ?? path.EndTime);
        return Math.Max(start, _path.Start);
    }

    /// <summary>Who is first, and by how much. Instants are known to a nanosecond: within that, the lowest index is.</summary>
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

            // The lowest index within a nanosecond of the earliest; all others are behind him.
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
