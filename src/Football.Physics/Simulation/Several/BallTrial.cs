using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>The path of a ball as if it were alone.</summary>
/// <remarks>It leads to the end of the step, or to the push of an object that another ball may reach.</remarks>
internal sealed class BallTrial : PieceObserver
{
    private PathCubic[] _paths = new PathCubic[8];
    private double[] _times = new double[8];
    private int _count;
    private BallState _start;
    private bool _isStep;

    /// <summary>The events and counts of the path.</summary>
    public StepLog Log { get; } = new();

    /// <summary>The ball at the end of the path.</summary>
    public BallState End;

    /// <summary>Start time, s.</summary>
    public double From => _start.Time;

    /// <summary>Time of the push or of the event that ends the path, s; infinite if it reaches the end of the step.</summary>
    public double HaltsAt { get; private set; }

    /// <summary>Upper bound of the ball's displacement from the start, m.</summary>
    public double Reach { get; private set; }

    /// <inheritdoc/>
    public override bool WantsEndAcceleration => false;

    /// <summary>Computes the path.</summary>
    /// <param name="simulator">The ball's scene.</param>
    /// <param name="start">The ball at the start.</param>
    /// <param name="duration">The duration, s.</param>
    /// <param name="stopAt">The event that ends it.</param>
    /// <param name="haltsAtPush">True if it ends when the ball pushes an object.</param>
    /// <param name="spent">The counters of the step so far.</param>
    public void Run(Simulator simulator, in BallState start, double duration, StopAt stopAt, bool haltsAtPush, in StepBudget spent)
    {
        _start = start;
        _isStep = stopAt == StopAt.Time;
        IsWhole = false;
        _count = 0;
        Log.Clear();
        Log.Pushed = false;
        Log.Observer = this;
        Log.StopAt = stopAt;
        Log.Pushes = true;
        Log.HaltsAtPush = haltsAtPush;
        Log.Continues = true;
        Log.Spent = spent;
        End = start;
        Reach = 0;
        simulator.Advance(ref End, duration, Log);
        HaltsAt = Log.Halted ? End.Time : double.PositiveInfinity;

        // Include a final displacement that no piece covers, such as a push out of an overlap.
        Vector3d last = _count > 0 ? _paths[_count - 1].At(_paths[_count - 1].Length) : start.Position;
        Reach += (End.Position - last).Length;
    }

    /// <summary>Moves a ball to the end of the path, if it is still at the start of the path, ends at the given time, and pushes no object.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="own">Receives its events and counts.</param>
    public bool TryTake(ref BallState s, double time, StepLog own)
    {
        bool isSame = _isStep && End.Time == time && _start.Time == s.Time && _start.Position == s.Position && _start.Velocity == s.Velocity
            && _start.Spin == s.Spin && _start.ClearUntil == s.ClearUntil && _start.Motion == s.Motion && _start.Carrier == s.Carrier;
        if (!isSame || Log.Pushed || Log.Halted || Log.Events.Dropped > 0 || own.Observer is not null)
        {
            return false;
        }

        own.Zones?.Begin(own, in _start);
        s = End;
        own.Add(Log);
        own.ZonePlace = End.Position;
        own.Spent = Log.Spent;
        return true;
    }

    /// <summary>Computes the path of a whole step, which may push objects.</summary>
    /// <param name="simulator">The ball's scene.</param>
    /// <param name="start">The ball at the start.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="motions">Stores the motions before the first push of the step.</param>
    public void RunStep(Simulator simulator, in BallState start, double dt, MotionSnapshot? motions)
    {
        Log.Motions = motions;
        Log.HasFollowed = false;
        Run(simulator, in start, dt, StopAt.Time, haltsAtPush: false, default);
        IsWhole = true;
    }

    /// <summary>Takes a whole step of a ball, and keeps its path in case the balls near it need it.</summary>
    /// <param name="simulator">The ball's scene.</param>
    /// <param name="s">The ball.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="own">Receives its events and counts.</param>
    public void TakeStep(Simulator simulator, ref BallState s, double dt, StepLog own)
    {
        RunStep(simulator, in s, dt, own.Motions);
        s = End;
        own.Add(Log);
        own.Pushed = Log.Pushed;
        own.HasFollowed = Log.HasFollowed;
    }

    /// <summary>True if the path covers this step, from its start to its end.</summary>
    public bool IsWhole { get; set; }

    /// <summary>True if the reach of the last step was unknown without its path.</summary>
    public bool IsNeeded { get; set; }

    /// <summary>Sets a straight path of a ball in a pile.</summary>
    /// <param name="start">The ball at the start.</param>
    /// <param name="velocity">The velocity, m/s.</param>
    /// <param name="duration">The duration, s.</param>
    public void Go(in BallState start, in Vector3d velocity, double duration)
    {
        var path = PathCubic.Line(start.Position, in velocity, duration);
        _start = start;
        _isStep = false;
        IsWhole = false;
        _paths[0] = path;
        _times[0] = start.Time;
        _count = 1;
        End = start;
        End.Position = path.At(path.Length);
        End.Time = start.Time + path.Length;
        HaltsAt = double.PositiveInfinity;
        Reach = duration * velocity.Length;
    }

    /// <summary>Returns position, m, and velocity, m/s, at a time for a ball in a pile.</summary>
    public Vector3d At(double time, out Vector3d velocity)
    {
        velocity = _paths[0].VelocityAt(time - _times[0]);
        return _paths[0].At(time - _times[0]);
    }

    /// <inheritdoc/>
    public override bool Add(in PathSegment piece)
    {
        if (_count == _paths.Length)
        {
            Array.Resize(ref _paths, 2 * _count);
            Array.Resize(ref _times, 2 * _count);
        }

        PathCubic path = PathCubic.Between(piece.StartPosition, piece.StartVelocity, piece.EndPosition, piece.EndVelocity, piece.Length, piece.Degree == 2);
        Vector3d last = _count > 0 ? _paths[_count - 1].At(_paths[_count - 1].Length) : _start.Position;
        Reach += (path.FastestSpeed * path.Length) + (piece.StartPosition - last).Length;
        _paths[_count] = path;
        _times[_count++] = piece.Time;
        return false;
    }

    /// <summary>Returns the piece of the path at a time.</summary>
    /// <param name="time">The time, s.</param>
    /// <param name="index">First index to check; on return, the index of the piece.</param>
    /// <param name="start">Start time of the piece, s.</param>
    /// <param name="until">End time of the piece, s; infinite after the last one.</param>
    public PathCubic At(double time, ref int index, out double start, out double until)
    {
        while (index < _count && _times[index] + _paths[index].Length <= time)
        {
            index++;
        }

        // Between pieces, and after the last one, the ball keeps its position.
        bool isOn = index < _count && time >= _times[index];
        start = isOn ? _times[index] : time;
        until = isOn ? _times[index] + _paths[index].Length : index < _count ? _times[index] : double.PositiveInfinity;
        return isOn ? _paths[index] : PathCubic.Line(index < _count ? _paths[index].At(0) : End.Position, Vector3d.Zero, 0);
    }

    /// <summary>Returns the first time at which two balls touch and close, by conservative advancement; infinite if they do not.</summary>
    /// <param name="other">The other ball's path.</param>
    /// <param name="distance">Distance of the centres at contact, m.</param>
    /// <param name="from">Start of the search, s.</param>
    /// <param name="until">End of the search, s.</param>
    /// <param name="atEnd">Whether to include a contact exactly at that time.</param>
    public double Meets(BallTrial other, double distance, double from, double until, bool atEnd)
    {
        int i = 0;
        int j = 0;
        double time = from;
        while (time < until || (atEnd && time == until))
        {
            // Evaluate both cubics up to the earlier end: until then, a single bound of the relative acceleration holds.
            PathCubic mine = At(time, ref i, out double start, out double end);
            PathCubic its = other.At(time, ref j, out double otherStart, out double otherEnd);
            double last = Math.Min(until, Math.Min(end, otherEnd));
            var gap = new BallGap(in mine, start, in its, otherStart, distance);
            var span = new SearchSpan(last, last) { Shortest = ContactTolerances.ShortestAdvance + (ContactTolerances.ClockRounding * last) };
            long evaluations = 0;
            double at = TimeOfImpact.First(ref gap, in span, ref evaluations, time);
            Log.SearchEvaluations += evaluations;
            Log.Spent.Evaluations += evaluations;
            if (at < last || (atEnd && at == until))
            {
                return at;
            }

            // The next cubics decide whether the balls touch at their start.
            time = Math.Max(last, Math.Min(at, Math.Min(end, otherEnd)));
        }

        return double.PositiveInfinity;
    }
}

/// <summary>The gap between two balls on their paths, over a time in which each path is one cubic.</summary>
/// <param name="one">The path of one ball.</param>
/// <param name="oneStart">Its start time, s.</param>
/// <param name="two">The path of the other ball.</param>
/// <param name="twoStart">Its start time, s.</param>
/// <param name="distance">Distance of the centres at contact, m.</param>
internal readonly struct BallGap(in PathCubic one, double oneStart, in PathCubic two, double twoStart, double distance) : IGap
{
    private readonly PathCubic _one = one;
    private readonly PathCubic _two = two;
    private readonly double _oneStart = oneStart;
    private readonly double _twoStart = twoStart;
    private readonly double _distance = distance;

    /// <summary>M bounds the relative acceleration, and so the second derivative of the gap.</summary>
    private readonly double _bend = one.GreatestAcceleration + two.GreatestAcceleration;

    public bool IsClosed(double t, out double step)
    {
        // The gap f = |p₁ − p₂| − d of the centres p₁ and p₂, which touch at the distance d, and its derivative f'.
        Vector3d apart = _one.At(t - _oneStart) - _two.At(t - _twoStart);
        double length = apart.Length;
        double gap = length - _distance;
        double rate = length > 0 ? Vector3d.Dot(in apart, _one.VelocityAt(t - _oneStart) - _two.VelocityAt(t - _twoStart)) / length : -1;
        bool meets = gap <= ContactTolerances.Touching && (rate < -ContactTolerances.Approaching || gap < -ContactTolerances.BallOverlap);
        step = meets ? 0 : TimeOfImpact.Safe(Math.Max(0, gap), rate, _bend);
        return meets;
    }
}
