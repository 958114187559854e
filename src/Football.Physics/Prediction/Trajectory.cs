using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>A predicted path of the ball, which can be evaluated at any time.</summary>
/// <remarks>Create one and reuse it: a look-ahead overwrites the path without allocating.</remarks>
public sealed partial class Trajectory
{
    /// <summary>The factor from a position tolerance to a velocity tolerance, in 1/s; a larger deviation counts as a kick.</summary>
    private const double VelocityShare = 100;

    private readonly bool _grows;
    private readonly PathRecorder _recorder;
    private PathSegment[] _pieces;
    private BallState _final;
    private LookAheadSteps? _alone;
    private Action<double>? _bodiesAt;

    /// <summary>Creates a trajectory with its own buffer, which grows if a path does not fit.</summary>
    /// <remarks>A trajectory that has grown keeps its size, so that later look-aheads of this length do not allocate.</remarks>
    /// <param name="capacity">The number of segments that fit at first, at least 1; default 512, enough for 10 s in steps of 20 ms.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is below 1.</exception>
    public Trajectory(int capacity = 512)
        : this(new PathSegment[capacity >= 1 ? capacity : throw Check.Refusal(nameof(capacity), capacity.ToString(System.Globalization.CultureInfo.InvariantCulture), "1 or more")]) => _grows = true;

    /// <summary>Creates a trajectory in a buffer that you provide.</summary>
    /// <param name="memory">The buffer, at least 1 segment. A look-ahead ends when the buffer is full, and <see cref="IsComplete"/> is then false.</param>
    /// <exception cref="ArgumentNullException"><paramref name="memory"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="memory"/> is empty.</exception>
    public Trajectory(PathSegment[] memory)
    {
        _pieces = memory ?? throw new ArgumentNullException(nameof(memory));
        if (memory.Length == 0)
        {
            throw Check.Refusal("memory.Length", "0", "1 or more");
        }

        _recorder = new PathRecorder(this, memory);
        Log.Observer = _recorder;
    }

    /// <summary>The segments of the path, in order and without gaps.</summary>
    public ReadOnlySpan<PathSegment> Pieces => _pieces.AsSpan(0, Count);

    /// <summary>The events, in order.</summary>
    public EventBuffer Events => Log.Events;

    /// <summary>The state at the end.</summary>
    public BallState Final => _final;

    /// <summary>The start time, in s since the launch.</summary>
    public double StartTime { get; private set; }

    /// <summary>The end time, in s since the launch.</summary>
    public double EndTime => Count > 0 ? Math.Max(_pieces[Count - 1].EndTime, _final.Time) : _final.Time;

    /// <summary>False if the buffer that you provided filled up, a custom force threw, or a <see cref="LookAheadRun"/> has not finished the path.</summary>
    public bool IsComplete { get; internal set; }

    /// <summary>The number of evaluations of the equations of motion.</summary>
    public long Evaluations => Log.Evaluations;

    /// <summary>The number of steps whose custom forces the look-ahead could not follow (see <see cref="StepLog.StiffSteps"/>).</summary>
    public long StiffSteps => Log.StiffSteps;

    internal StepLog Log { get; } = new();

    /// <summary>The steps of a look-ahead of one ball into this path.</summary>
    internal LookAheadSteps Alone => _alone ??= new LookAheadSteps(null, [this]);

    internal int Count { get; set; }

    /// <summary>A counter that changes whenever the path is computed again or extended.</summary>
    internal int Uses { get; private set; }

    /// <summary>Returns a reference to a segment.</summary>
    internal ref readonly PathSegment Piece(int index) => ref _pieces[index];

    /// <summary>The callback that positions the game's bodies after a step; null if they keep their motion.</summary>
    internal Simulator.StepCallback? OnStep { get; private set; }

    /// <summary>True if a segment did not fit.</summary>
    internal bool Overflows => _recorder.Overflows;

    /// <summary>The maximum height of the ball's centre, in m.</summary>
    public double Apex
    {
        get
        {
            // Each segment stores its own apex. Without segments, the ball does not move.
            double apex = Count > 0 ? double.NegativeInfinity : _final.Position.Y;
            for (int i = 0; i < Count; i++)
            {
                apex = Math.Max(apex, _pieces[i].Apex);
            }

            return apex;
        }
    }

    /// <summary>The time from the start to the first touchdown, in s; infinite if there is none.</summary>
    public double HangTime => TryGetTouchdown(0, out BallEvent touchdown) ? touchdown.Time - StartTime : double.PositiveInfinity;

    /// <summary>The horizontal distance from the start to the first touchdown, in m; infinite if there is none.</summary>
    public double Carry => TryGetTouchdown(0, out BallEvent touchdown) && Count > 0
        ? (touchdown.Position - _pieces[0].StartPosition).Horizontal.Length
        : double.PositiveInfinity;

    /// <summary>Finds a touchdown (an impact with the ground) by its index.</summary>
    /// <param name="index">The index, from 0.</param>
    /// <param name="touchdown">The impact.</param>
    /// <returns>False if there is no such touchdown.</returns>
    public bool TryGetTouchdown(int index, out BallEvent touchdown) => TryGetImpact(isTouchdown: true, index, out touchdown);

    /// <summary>Finds a hit (an impact with any object except the ground) by its index.</summary>
    /// <remarks><see cref="BallEvent.ColliderIndex"/> identifies the object.</remarks>
    /// <param name="index">The index, from 0.</param>
    /// <param name="hit">The impact.</param>
    /// <returns>False if there is no such hit.</returns>
    public bool TryGetHit(int index, out BallEvent hit) => TryGetImpact(isTouchdown: false, index, out hit);

    /// <summary>Finds the point at which the ball comes to rest.</summary>
    /// <param name="rest">The event; default if the ball does not come to rest.</param>
    /// <returns>False if the ball does not come to rest within the look-ahead.</returns>
    public bool TryGetRest(out BallEvent rest)
    {
        // No event follows rest, so only the last event can be a rest.
        bool rests = Events.Count > 0 && Events[Events.Count - 1].Kind == BallEventKind.Rest;
        rest = rests ? Events[Events.Count - 1] : default;
        return rests;
    }

    /// <summary>Returns the position of the ball at a time, in m.</summary>
    /// <remarks>Times before the start or after the end are clamped.</remarks>
    /// <param name="time">The time since the launch, in s.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="time"/> is NaN.</exception>
    public Vector3d PositionAt(double time)
    {
        RefuseNaN(time);
        int i = Find(time);
        if (i < 0)
        {
            return _final.Position;
        }

        // At a boundary, use the end of the earlier segment, because a body placed over the ball moves the ball between steps.
        bool isBetween = i > 0 && time == _pieces[i].Time && _pieces[i - 1].EndTime == time;
        return isBetween ? _pieces[i - 1].EndPosition : _pieces[i].PositionAt(Clamp(time, in _pieces[i]));
    }

    /// <summary>Returns the position of the ball at a time, if the path contains that time.</summary>
    /// <remarks>Use it to tell the end of a path from a position: <see cref="PositionAt"/> returns the last position for all later times.</remarks>
    /// <param name="time">The time since the launch, in s.</param>
    /// <param name="position">The position, in m. Before the start, it is the first position; after the end, the last one.</param>
    /// <returns>True from <see cref="StartTime"/> to <see cref="EndTime"/>; false before and after.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="time"/> is NaN.</exception>
    public bool TryPositionAt(double time, out Vector3d position)
    {
        position = PositionAt(time);
        return time >= StartTime && time <= EndTime;
    }

    /// <summary>Returns the velocity of the ball at a time, in m/s; after the end, the final velocity.</summary>
    /// <param name="time">The time since the launch, in s.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="time"/> is NaN.</exception>
    public Vector3d VelocityAt(double time)
    {
        RefuseNaN(time);
        int i = Find(time);
        return i < 0 || (i == Count - 1 && time > _pieces[i].EndTime) ? _final.Velocity : _pieces[i].VelocityAt(Clamp(time, in _pieces[i]));
    }

    /// <summary>Finds the first crossing of a plane.</summary>
    /// <param name="plane">The plane.</param>
    /// <param name="crossing">The point of the crossing.</param>
    /// <returns>False if the ball does not cross the plane.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="plane"/> is the default value, whose normal is zero.</exception>
    public bool TryGetCrossing(in Plane3d plane, out PathPoint crossing)
    {
        plane.Validate(nameof(plane));
        for (int i = 0; i < Count; i++)
        {
            ref readonly PathSegment piece = ref _pieces[i];
            if (piece.Crosses(plane.Point, plane.Normal, out double time))
            {
                crossing = At(in piece, time);
                return true;
            }
        }

        crossing = default;
        return false;
    }

    /// <summary>Returns the closest approach to a point.</summary>
    /// <param name="point">The point, in m.</param>
    public PathPoint ClosestApproach(Vector3d point)
    {
        // Compare squared distances, and compute the square root of the smallest one only.
        var best = new PathPoint(_final.Time, _final.Position, _final.Velocity, Vector3d.Distance(_final.Position, in point));
        double bestSquared = best.Distance * best.Distance;
        for (int i = 0; i < Count; i++)
        {
            ref readonly PathSegment piece = ref _pieces[i];
            double squared = piece.ClosestApproach(in point, out double time);
            if (squared < bestSquared || i == 0)
            {
                bestSquared = squared;
                best = At(in piece, time, Math.Sqrt(squared));
            }
        }

        return best;
    }

    /// <summary>Prepares for a look-ahead.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="from">The initial state.</param>
    /// <param name="request">The duration and stop conditions.</param>
    /// <param name="endsWhenFull">True to end with the last segment that fits; false to end at the first one that does not, and report an
    /// overflow.</param>
    /// <param name="goesOn">True if the ball continues without a path once the buffer is full, as in a group of balls.</param>
    internal void Begin(Simulator simulator, in BallState from, LookAheadRequest request, bool endsWhenFull, bool goesOn = false)
    {
        _recorder.EndsWhenFull = endsWhenFull;
        _recorder.GoesOn = goesOn;

        // Reuse the delegate while the request contains the same one, so that look-aheads do not allocate.
        if (_bodiesAt != request.MoveBodies)
        {
            Action<double>? bodiesAt = request.MoveBodies;
            _bodiesAt = bodiesAt;
            OnStep = bodiesAt is null ? null : (in BallState state) => bodiesAt(state.Time);
        }

        Log.Clear();
        Log.Events.Ball = 0;
        Uses++;
        Count = 0;
        IsComplete = true;
        StartTime = from.Time;
        _recorder.Begin(simulator, in from, request);
        _final = from;
    }

    /// <summary>Ends the path; it is incomplete if a segment did not fit.</summary>
    internal void End(in BallState final)
    {
        _recorder.Close();
        _final = final;
        IsComplete &= !_recorder.Overflows;
    }

    /// <summary>Returns the buffer, twice as large if it is full and is the trajectory's own.</summary>
    internal PathSegment[] Room()
    {
        if (_grows && Count == _pieces.Length)
        {
            Array.Resize(ref _pieces, 2 * _pieces.Length);
        }

        return _pieces;
    }

    /// <summary>True if a ball is on the path: no kick or hit has moved it away.</summary>
    /// <param name="ball">The ball.</param>
    /// <param name="tolerance">The maximum distance, in m; for velocities it is multiplied by 100/s.</param>
    internal bool Has(in BallState ball, double tolerance)
    {
        // There is no position to compare before the start of the path, nor after its end if the ball still moves there.
        if (!(ball.Time >= StartTime && (ball.Time <= EndTime || Final.Motion == MotionState.Rest)))
        {
            return false;
        }

        // Also compare the velocity, so that a kick is detected at once.
        return Vector3d.Distance(PositionAt(ball.Time), ball.Position) <= tolerance
            && Vector3d.Distance(VelocityAt(ball.Time), ball.Velocity) <= tolerance * VelocityShare;
    }

    /// <summary>Shows the path so far, before a look-ahead in parts continues.</summary>
    internal void Pause(in BallState at)
    {
        _recorder.Complete();
        _final = at;
        IsComplete = false;
    }

    /// <summary>Continues after <see cref="Pause"/>.</summary>
    internal void GoOn() => IsComplete = true;

    /// <summary>Prepares to continue from the end.</summary>
    internal void Resume()
    {
        Uses++;
        IsComplete = true;
    }

    /// <summary>Ends the path with the state before a failed step, and removes the segments of that step.</summary>
    internal void Break(in BallState final)
    {
        // Segments that start at or after this state belong to the failed step.
        while (Count > 0 && _pieces[Count - 1].Time >= final.Time)
        {
            Count--;
        }

        _recorder.Close();
        IsComplete = false;
        _final = final;
    }

    /// <summary>Removes the segments and events before a time.</summary>
    internal void Forget(double before)
    {
        // Keep the segment that contains the time, so that the path starts at or before it.
        int gone = 0;
        while (gone < Count - 1 && _pieces[gone].EndTime <= before)
        {
            gone++;
        }

        // Move the remaining segments to the front, and remove the earlier events.
        if (gone > 0)
        {
            Array.Copy(_pieces, gone, _pieces, 0, Count - gone);
            Count -= gone;
            StartTime = _pieces[0].Time;
            Log.Events.Forget(StartTime);
        }
    }

    /// <summary>Finds an impact by its index, with the ground or with any other object.</summary>
    private bool TryGetImpact(bool isTouchdown, int index, out BallEvent impact)
    {
        for (int i = 0; i < Events.Count; i++)
        {
            // The ground has the collider index 0.
            ref readonly BallEvent e = ref Events[i];
            if (e.Kind == BallEventKind.Impact && (e.ColliderIndex == 0) == isTouchdown && index-- == 0)
            {
                impact = e;
                return true;
            }
        }

        impact = default;
        return false;
    }

    private static void RefuseNaN(double time)
    {
        if (double.IsNaN(time))
        {
            throw Check.Refusal(nameof(time), "NaN", "a number");
        }
    }

    private static double Clamp(double time, in PathSegment piece) => Math.Min(Math.Max(time, piece.Time), piece.EndTime);

    /// <summary>Returns the index of the segment that contains a time; at a boundary, that of the later one; −1 if there are no segments.</summary>
    private int Find(double time)
    {
        // Binary search for the last segment that starts at or before the time. For earlier times, use the first segment.
        int low = 0;
        int high = Count - 1;
        while (low < high)
        {
            int middle = (low + high + 1) / 2;
            if (_pieces[middle].Time <= time)
            {
                low = middle;
            }
            else
            {
                high = middle - 1;
            }
        }

        return high;
    }

    /// <inheritdoc/>
    public override string ToString() => Count == 0 ? "no path"
        : FormattableString.Invariant($"{StartTime:0.###} … {EndTime:0.###} s in {Count} pieces, {Events.Count} events, ends at {Final.Position:0.###}");
}
