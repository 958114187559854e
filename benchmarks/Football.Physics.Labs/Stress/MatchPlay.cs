using FootballPhysics.Labs.Goals;
using FootballPhysics.Labs.People;
using FootballPhysics.Scenes;

namespace FootballPhysics.Labs.Stress;

/// <summary>Simulates one match of an arena, and checks each step with independent geometry.</summary>
internal sealed class MatchPlay
{
    /// <summary>A ball that is deeper than this in a standing object, m, is inside it.</summary>
    private const double Entered = 1e-6;

    /// <summary>The interval, s, at which a path is compared with standing objects.</summary>
    private const double Sample = 0.002;

    /// <summary>The distance, m, by which the path of a step may end away from the ball: objects in sustained contact move the ball straight at the end of a piece.</summary>
    private const double PutOn = 2e-6;

    /// <summary>The largest difference between the times of a goal and its event, s. The time in which the ball moves by the error of its path is added.</summary>
    private const double Closeness = 1e-6;

    /// <summary>The speed, m/s and rad/s, below which a ball hangs in a net, or is held by a player who stands on it.</summary>
    private const double Hanging = 1e-6;

    /// <summary>The speed, m/s, above which the wind drives a ball along a board or a net.</summary>
    private const double Driven = 1e-3;

    /// <summary>The length of the frames after the match, s, and the time for all balls to come to rest, s.</summary>
    private const double RestFrame = 1 / 30.0;
    private const double LongestRest = 150;

    /// <summary>The number of pieces that the path of a step can hold: enough for two steps at their limit.</summary>
    private const int PathPieces = 1 << 14;

    private const double ShortestFrame = 0.004;
    private const double LongestFrame = 0.25;

    private readonly Arena _arena;
    private readonly SeededRandom _frames;
    private readonly int _frameKind;
    private readonly double _fixedFrame;
    private readonly StepLog _log = new();
    private readonly Trajectory[] _paths;
    private readonly GoalWatch[][] _watches;
    private readonly MatchOutcome _outcome;
    private readonly LabCounts _counts;

    private readonly bool _times;
    private readonly BallState[] _before;
    private readonly BallState[] _after;

    private MatchPlay(long seed, long index, LabCounts counts, bool times)
    {
        _times = times;
        _counts = counts;
        _arena = new Arena(SeededRandom.Mix(seed, index));
        _frames = new SeededRandom(SeededRandom.Mix(seed, ~index));
        _frameKind = _frames.Below(4);
        _fixedFrame = _frames.Any(ShortestFrame, 1 / 120.0, 1 / 30.0, 0.05, 0.1, LongestFrame);
        _before = new BallState[_arena.Balls.Length];
        _after = new BallState[_arena.Balls.Length];
        _paths = [.. _arena.Balls.Select(_ => new Trajectory(PathPieces))];
        _watches = [.. _arena.Balls.Select(_ => _arena.Scene.Goals.Select(goal => new GoalWatch(goal, _arena.Radius)).ToArray())];
        _outcome = new MatchOutcome(index) { Balls = _arena.Balls.Length };
        _counts.Add("matches");
        _counts.Add("balls", _arena.Balls.Length);
    }

    /// <summary>Simulates a match and the time until its balls rest.</summary>
    /// <param name="seed">The seed of all matches.</param>
    /// <param name="index">The number of the match.</param>
    /// <param name="seconds">Its length, s.</param>
    /// <param name="counts">The counts of all matches.</param>
    /// <param name="times">Whether to repeat steps that take long.</param>
    public static MatchOutcome Play(long seed, long index, double seconds, LabCounts counts, bool times = false)
    {
        var play = new MatchPlay(seed, index, counts, times);
        try
        {
            play.Match(seconds);
            play.Rest();
        }
        catch (Exception e) when (e is not OutOfMemoryException)
        {
            play._outcome.See(MatchClaim.Throws, 1, false, $"{play._arena.Time} s: {e.GetType().Name}: {e.Message} {e.StackTrace?.Split('\n')[0].Trim()}");
        }

        return play._outcome;
    }

    private void Match(double seconds)
    {
        for (int ball = 0; ball < _arena.Balls.Length; ball++)
        {
            BeginWatches(ball);
        }

        while (_arena.Time < seconds)
        {
            double frame = Frame();
            _arena.Put();
            for (int ball = 0; ball < _arena.Balls.Length; ball++)
            {
                if (_arena.Decide(ball, frame) is { } kick)
                {
                    _counts.Add("kicks");
                    _counts.AddIf(_arena.Balls[ball].Nets != 0, "of balls in nets");
                    _arena.Kick(ball, kick.Velocity, kick.Spin);
                    BeginWatches(ball);
                }
            }

            _arena.LookAhead(frame, _paths);
            Step(frame);
            for (int ball = 0; ball < _arena.Balls.Length; ball++)
            {
                Compare(ball, frame);
            }

            _arena.Walk(frame);
        }
    }

    /// <summary>Runs the time after the match: actors stop, and the balls come to rest.</summary>
    private void Rest()
    {
        double end = _arena.Time;
        double longest = _arena.MustRest ? LongestRest : 1;
        while (_arena.Time - end < longest && !_arena.Balls.All(IsAtRest))
        {
            _arena.Put();
            Step(RestFrame);
            _arena.Leave(RestFrame, _arena.Time - end);
        }

        if (!_arena.MustRest)
        {
            return;
        }

        _counts.Most("latest rest, s", _arena.Time - end);
        for (int ball = 0; ball < _arena.Balls.Length; ball++)
        {
            BallState state = _arena.Balls[ball];
            if (state.Motion == MotionState.Rolling && state.Velocity.Length > Driven && _arena.Drives(state.Velocity.Normalized()))
            {
                continue;
            }

            _counts.Add("balls that must rest");
            _outcome.See(MatchClaim.Rests, 0, IsAtRest(state), $"ball {ball} of {_arena.Balls.Length}, wind {_arena.Scene.Air.Wind}: {state.ToString("R", null)}");
        }
    }

    /// <summary>True if a ball is at rest, lies still in a net, or lies still in a corner while a standing player overlaps it.</summary>
    private static bool IsAtRest(BallState ball) =>
        ball.Motion == MotionState.Rest || ((ball.Nets != 0 || ball.Motion == MotionState.Pinned) && ball.Velocity.Length < Hanging && ball.Spin.Length < Hanging);

    private void Step(double frame)
    {
        FormattableString at = $"{_arena.Time} s, frame of {frame} s, {(_arena.IsGroup ? "group" : "alone")}";
        _log.Clear();
        _arena.Balls.CopyTo(_before, 0);
        RigidMotion[] bodies = _times ? _arena.Keep() : [];
        double start = ThreadClock.Milliseconds;
        _arena.Step(frame, _log);
        double time = ThreadClock.Milliseconds - start;
        if (_times && time > StepTimes.Slow)
        {
            Repeat(frame, time, bodies, at);
        }

        _counts.Add("steps");
        int balls = _arena.Balls.Length;
        int evaluations = (int)Math.Min((_log.Evaluations + _log.SearchEvaluations + balls - 1) / balls, int.MaxValue);
        _outcome.Evaluations.Add(evaluations);
        _outcome.MostEvaluations.See(evaluations, $"match {_outcome.Index}, {at}");
        _outcome.See(MatchClaim.Stalled, _log.StalledSteps, _log.StalledSteps == 0, at);
        _counts.Add("counted only", _log.UnreportedImpacts);
        Span<int> events = stackalloc int[balls];
        foreach (ref readonly BallEvent item in _log.Events)
        {
            events[item.Ball]++;
        }

        foreach (int count in events)
        {
            _counts.Most("most events", count);
            _outcome.See(MatchClaim.Events, count, count <= StepMeter.MostAllowed, at);
        }

        for (int i = 0; i < balls; i++)
        {
            ref readonly BallState ball = ref _arena.Balls[i];
            bool isFinite = ball.Position.IsFinite && ball.Velocity.IsFinite && ball.Spin.IsFinite && Math.Abs(ball.Orientation.LengthSquared - 1) < 1e-6;
            _outcome.See(MatchClaim.Finite, 0, isFinite, at);
            _outcome.See(MatchClaim.Stays, 0, !_arena.IsOutside(ball.Position), $"{at}, ball {i} at {ball.Position}");
            Deep(ball.Position, $"{at}, ball {i}, end, {ball.Motion}");
        }
    }

    /// <summary>Repeats a step that took long from the same states of balls and bodies, and keeps it if it takes long in each repeat.</summary>
    private void Repeat(double frame, double time, RigidMotion[] bodies, FormattableString at)
    {
        _arena.Balls.CopyTo(_after, 0);
        RigidMotion[] pushed = _arena.Keep();
        for (int i = 0; i < StepTimes.Repeats && time > StepTimes.Slow; i++)
        {
            _before.CopyTo(_arena.Balls, 0);
            _arena.Restore(bodies);
            _log.Clear();
            double start = ThreadClock.Milliseconds;
            _arena.Step(frame, _log);
            time = Math.Min(time, ThreadClock.Milliseconds - start);
        }

        _after.CopyTo(_arena.Balls, 0);
        _arena.Restore(pushed);
        if (time > StepTimes.Slow)
        {
            _outcome.Slow.Add(new SlowStep(time, _log.Evaluations, _log.SearchEvaluations, _log.Steps, FormattableString.Invariant($"match {_outcome.Index}, {at}")));
        }
    }

    private void Deep(Vector3d point, FormattableString at)
    {
        double depth = _arena.Radius - _arena.ToStanding(point);
        if (depth > _outcome[MatchClaim.Inside].Worst || depth > Entered)
        {
            _outcome.See(MatchClaim.Inside, depth, depth <= Entered, at);
        }
    }

    /// <summary>Compares the path of a ball in the last step with standing objects and goals.</summary>
    private void Compare(int ball, double frame)
    {
        ref readonly BallState after = ref _arena.Balls[ball];
        Trajectory path = _paths[ball];
        double start = after.Time - frame;
        if (!path.IsComplete || _log.StalledSteps > 0)
        {
            // A step at its limit leaves the ball where it is; its look-ahead may not. Restart the watches from here.
            _counts.Add("not judged");
            BeginWatches(ball);
            return;
        }

        Vector3d end = path.PositionAt(after.Time);
        double apart = (end - after.Position).Length;
        string at = FormattableString.Invariant($"{start} s, frame of {frame} s, {(_arena.IsGroup ? "group" : "alone")}, ball {ball}");
        _outcome.See(MatchClaim.Path, apart, apart <= PutOn || after.Motion == MotionState.Pinned, $"{at}: {after.ToString("R", null)}");
        int parts = Math.Max(1, (int)(frame / Sample));
        for (int i = 1; i < parts; i++)
        {
            Deep(path.PositionAt(start + (frame * i / parts)), $"{at}, {i} of {parts} parts");
        }

        for (int goal = 0; goal < _arena.Scene.Goals.Count; goal++)
        {
            GoalWatch watch = _watches[ball][goal];
            bool wasOver = !double.IsInfinity(watch.Time);
            watch.Continue(path, after.Time);
            watch.Jump(end, after.Position, after.Time);
            Judge(ball, goal, watch, wasOver, at);
        }
    }

    private void Judge(int ball, int goal, GoalWatch watch, bool wasOver, string at)
    {
        int reported = 0;
        double time = double.NaN;
        foreach (ref readonly BallEvent item in _log.Events)
        {
            if (item.Kind == BallEventKind.Goal && item.Ball == ball && Math.Sign(item.Position.Z) == Math.Sign(_arena.Scene.Goals[goal].Center.Z))
            {
                reported++;
                time = item.Time;
            }
        }

        bool isOver = !wasOver && !double.IsInfinity(watch.Time);
        _counts.Add("goals", reported);
        if (watch.IsUndecided)
        {
            // The watch restarts with the next kick.
            _counts.AddIf(isOver || reported > 0, "not judged");
            return;
        }

        // A ball that an object moves straight at the end of a piece crosses the line at a time within the step.
        double room = Closeness + (PutOn / Math.Max(_arena.Balls[ball].Velocity.Length, 1e-3));
        bool holds = reported == (isOver ? 1 : 0) && (!isOver || Math.Abs(time - watch.Time) <= room || watch.Time == _arena.Balls[ball].Time);
        _outcome.See(MatchClaim.Goals, 0, holds, $"{at}: {reported} reported at {time} s, over the line {isOver} at {watch.Time} s");
    }

    private void BeginWatches(int ball)
    {
        foreach (GoalWatch watch in _watches[ball])
        {
            watch.Begin(_arena.Balls[ball].Position);
        }
    }

    private double Frame() => _frameKind switch
    {
        0 => 1 / 60.0,
        1 => _fixedFrame,
        2 => _frames.Log(ShortestFrame, LongestFrame),
        _ => _frames.Chance(0.1) ? _frames.Log(ShortestFrame, LongestFrame) : _frames.Uniform(0.014, 0.019),
    };
}
