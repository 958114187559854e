namespace FootballPhysics.Prediction;

/// <summary>A predicted way of the ball, dense in time. Its memory is made once and used again by every look-ahead.</summary>
public sealed partial class Trajectory
{
    private readonly PathSegment[] _pieces;
    private readonly Recorder _recorder;
    private BallState _final;
    private Action<double>? _bodiesAt;

    /// <summary>A trajectory with memory of its own.</summary>
    /// <param name="capacity">Pieces to make room for, at least 1; default 512, enough for 10 s in steps of 20 ms.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is below 1.</exception>
    public Trajectory(int capacity = 512)
        : this(new PathSegment[capacity >= 1 ? capacity : throw Check.Refusal(nameof(capacity), capacity.ToString(System.Globalization.CultureInfo.InvariantCulture), "1 or more")])
    {
    }

    /// <summary>A trajectory in the caller's memory.</summary>
    /// <param name="memory">Room for pieces, at least 1; a look-ahead ends where it is full, and says so in <see cref="IsComplete"/>.</param>
    /// <exception cref="ArgumentNullException"><paramref name="memory"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="memory"/> is empty.</exception>
    public Trajectory(PathSegment[] memory)
    {
        _pieces = memory ?? throw new ArgumentNullException(nameof(memory));
        if (memory.Length == 0)
        {
            throw Check.Refusal("memory.Length", "0", "1 or more");
        }

        _recorder = new Recorder(this);
        Log.Observer = _recorder;
    }

    /// <summary>The pieces, in order, without a gap.</summary>
    public ReadOnlySpan<PathSegment> Pieces => _pieces.AsSpan(0, Count);

    /// <summary>The events, in order.</summary>
    public EventBuffer Events => Log.Events;

    /// <summary>The state at the end.</summary>
    public BallState Final => _final;

    /// <summary>When it starts, s since the launch.</summary>
    public double StartTime { get; private set; }

    /// <summary>When it ends, s since the launch.</summary>
    public double EndTime => Count > 0 ? Math.Max(_pieces[Count - 1].EndTime, _final.Time) : _final.Time;

    /// <summary>False where the memory was full, or a force of the game's own threw, before the look-ahead was over.</summary>
    public bool IsComplete { get; private set; }

    /// <summary>Right-hand sides evaluated.</summary>
    public long Evaluations => Log.Evaluations;

    internal StepLog Log { get; } = new();

    /// <summary>For steps that are no part of the path.</summary>
    internal StepLog Trial { get; } = new(1) { IgnoresZones = true };

    internal int Count { get; private set; }

    /// <summary>A piece where it lies.</summary>
    internal ref readonly PathSegment Piece(int index) => ref _pieces[index];

    /// <summary>Moves what the game moves to where it will be after a step; null where that goes on as it goes now.</summary>
    internal Simulator.StepCallback? OnStep { get; private set; }

    /// <summary>True when a piece had no room.</summary>
    internal bool Overflows => _recorder.Overflows;

    /// <summary>The greatest height of the centre, m.</summary>
    public double Apex
    {
        get
        {
            // Each piece knows its own highest point; without any the ball stays where it is.
            double apex = Count > 0 ? double.NegativeInfinity : _final.Position.Y;
            for (int i = 0; i < Count; i++)
            {
                apex = Math.Max(apex, _pieces[i].Apex);
            }

            return apex;
        }
    }

    /// <summary>Time from the start to the first touchdown, s; NaN-free: infinite where there is none.</summary>
    public double HangTime => TryGetTouchdown(0, out BallEvent touchdown) ? touchdown.Time - StartTime : double.PositiveInfinity;

    /// <summary>Horizontal distance from the start to the first touchdown, m; infinite where there is none.</summary>
    public double Carry => TryGetTouchdown(0, out BallEvent touchdown) && Count > 0
        ? (touchdown.Position - _pieces[0].StartPosition).Horizontal.Length
        : double.PositiveInfinity;

    /// <summary>One of the touchdowns: impacts with the ground.</summary>
    /// <param name="index">Which, from 0.</param>
    /// <param name="touchdown">The impact.</param>
    /// <returns>False where there is no such touchdown.</returns>
    public bool TryGetTouchdown(int index, out BallEvent touchdown) => TryGetImpact(isTouchdown: true, index, out touchdown);

    /// <summary>One of the hits: impacts with anything but the ground, of which <see cref="BallEvent.ColliderIndex"/> tells.</summary>
    /// <param name="index">Which, from 0.</param>
    /// <param name="hit">The impact.</param>
    /// <returns>False where there is no such hit.</returns>
    public bool TryGetHit(int index, out BallEvent hit) => TryGetImpact(isTouchdown: false, index, out hit);

    /// <summary>Where and when the ball comes to rest.</summary>
    /// <param name="rest">The event.</param>
    /// <returns>False where it does not within the look-ahead.</returns>
    public bool TryGetRest(out BallEvent rest)
    {
        // Nothing happens after rest: it can only be the last event.
        rest = Events.Count > 0 ? Events[Events.Count - 1] : default;
        return Events.Count > 0 && rest.Kind == BallEventKind.Rest;
    }

    /// <summary>Where the ball is at a time, m. Before the start and after the end it is where it starts and ends.</summary>
    /// <param name="time">Time since the launch, s.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="time"/> is not a number.</exception>
    public Vector3d PositionAt(double time)
    {
        RefuseNaN(time);
        int i = Find(time);
        if (i < 0)
        {
            return _final.Position;
        }

        // Where two pieces meet it is where the earlier one ends: a body that was put over the ball moves it between two steps.
        bool isBetween = i > 0 && time == _pieces[i].Time && _pieces[i - 1].EndTime == time;
        return isBetween ? _pieces[i - 1].EndPosition : _pieces[i].PositionAt(Clamp(time, in _pieces[i]));
    }

    /// <summary>The velocity at a time, m/s; after the end that of the end.</summary>
    /// <param name="time">Time since the launch, s.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="time"/> is not a number.</exception>
    public Vector3d VelocityAt(double time)
    {
        RefuseNaN(time);
        int i = Find(time);
        return i < 0 || (i == Count - 1 && time > _pieces[i].EndTime) ? _final.Velocity : _pieces[i].VelocityAt(Clamp(time, in _pieces[i]));
    }

    /// <summary>The first crossing of a plane.</summary>
    /// <param name="plane">The plane.</param>
    /// <param name="crossing">Where and when.</param>
    /// <returns>False where the ball does not cross it.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="plane"/> was never made: its normal is zero.</exception>
    public bool TryGetCrossing(in Plane3d plane, out PathPoint crossing)
    {
        plane.Validate(nameof(plane));
        for (int i = 0; i < Count; i++)
        {
            ref readonly PathSegment piece = ref _pieces[i];
            if (piece.Crosses(plane.Point, plane.Normal, out double time))
            {
                crossing = new PathPoint(time, piece.PositionAt(time), piece.VelocityAt(time), 0);
                return true;
            }
        }

        crossing = default;
        return false;
    }

    /// <summary>The closest approach to a point.</summary>
    /// <param name="point">The point, m.</param>
    public PathPoint ClosestApproach(Vector3d point)
    {
        // By squares: a root for the best alone.
        var best = new PathPoint(_final.Time, _final.Position, _final.Velocity, Vector3d.Distance(_final.Position, in point));
        double bestSquared = best.Distance * best.Distance;
        for (int i = 0; i < Count; i++)
        {
            ref readonly PathSegment piece = ref _pieces[i];
            double squared = piece.ClosestApproach(in point, out double time);
            if (squared < bestSquared || i == 0)
            {
                bestSquared = squared;
                best = new PathPoint(time, piece.PositionAt(time), piece.VelocityAt(time), Math.Sqrt(squared));
            }
        }

        return best;
    }

    /// <summary>Prepares for a look-ahead.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="from">Where it begins.</param>
    /// <param name="request">How far it goes.</param>
    /// <param name="endsWhenFull">Whether it ends with the memory's last piece; else the first piece without room tells that it is too small.</param>
    /// <param name="goesOn">Whether the ball goes on without a path once the memory is full, as one of several does.</param>
    internal void Begin(Simulator simulator, in BallState from, LookAheadRequest request, bool endsWhenFull, bool goesOn = false)
    {
        _recorder.EndsWhenFull = endsWhenFull;
        _recorder.GoesOn = goesOn;

        // The same delegate as long as the request has the same one: a look-ahead allocates nothing.
        if (_bodiesAt != request.MoveBodies)
        {
            Action<double>? bodiesAt = request.MoveBodies;
            _bodiesAt = bodiesAt;
            OnStep = bodiesAt is null ? null : (in BallState state) => bodiesAt(state.Time);
        }

        Log.Clear();
        Log.Events.Ball = 0;
        Count = 0;
        IsComplete = true;
        StartTime = from.Time;
        _recorder.Begin(simulator, in from, request);
        _final = from;
    }

    internal void End(in BallState final) => _final = final;

    /// <summary>It is not complete where a piece had no room.</summary>
    internal void EndFull() => IsComplete &= !_recorder.Overflows;

    /// <summary>True when a path that is to be extended ends with whole steps, not where an event or its memory ended it within one.</summary>
    internal bool EndsWhole => IsComplete ? !Log.Halted : Count < _pieces.Length && !Log.Halted;

    /// <summary>Prepares for going on from the end.</summary>
    internal void Resume()
    {
        Log.Halted = false;
        IsComplete = true;
    }

    /// <summary>Ends it with the state before a step that failed: the pieces of that step are none.</summary>
    internal void Break(in BallState final)
    {
        // What began at or after that state belongs to the step that failed.
        while (Count > 0 && _pieces[Count - 1].Time >= final.Time)
        {
            Count--;
        }

        IsComplete = false;
        _final = final;
    }

    /// <summary>Forgets the pieces and events before a time.</summary>
    internal void Forget(double before)
    {
        // The piece that the time falls into stays, and so the path begins at or before it.
        int gone = 0;
        while (gone < Count - 1 && _pieces[gone].EndTime <= before)
        {
            gone++;
        }

        // Moved to the front; the events of the time before go too.
        if (gone > 0)
        {
            Array.Copy(_pieces, gone, _pieces, 0, Count - gone);
            Count -= gone;
            StartTime = _pieces[0].Time;
            Log.Events.Forget(StartTime);
        }
    }

    /// <summary>One of the impacts, with the ground or with anything else.</summary>
    private bool TryGetImpact(bool isTouchdown, int index, out BallEvent impact)
    {
        for (int i = 0; i < Events.Count; i++)
        {
            // The ground is thing 0.
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

    /// <summary>The piece that a time falls into: the later one where two meet; −1 where there is none.</summary>
    private int Find(double time)
    {
        // Bisection for the last piece that begins at or before the time; the first for all that is earlier.
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

    /// <summary>Keeps the pieces, and ends the look-ahead as soon as its question is answered.</summary>
    private sealed class Recorder : PieceObserver
    {
        private readonly Trajectory _owner;
        private bool _untilPlane;
        private Plane3d _plane;
        private bool _untilPassing;
        private PassingCriterion? _passing;

        public Recorder(Trajectory owner) => _owner = owner;

        public override bool WantsEndAcceleration => true;

        /// <summary>True when it ends with the memory's last piece, not with the first that has no room.</summary>
        public bool EndsWhenFull { get; set; } = true;

        /// <summary>True if the ball goes on without a path once the memory is full.</summary>
        public bool GoesOn { get; set; }

        /// <summary>True when there was a piece without room.</summary>
        public bool Overflows { get; private set; }

        public void Begin(Simulator simulator, in BallState from, LookAheadRequest request)
        {
            Overflows = false;
            _untilPlane = request.UntilPlane is not null;
            _plane = request.UntilPlane.GetValueOrDefault();
            _untilPassing = request.UntilPassing is not null;
            if (_untilPassing)
            {
                _passing ??= new PassingCriterion();
                _passing.Begin(simulator, in from, request);
            }
        }

        public override bool Add(in PathSegment piece)
        {
            PathSegment[] pieces = _owner._pieces;

            // There is no room: the step ends, and the caller may look ahead again up to where there is. The step of one of several balls goes on: ended
            // after every piece, it would begin again with all the pieces and evaluations that a step may have, and might never be over.
            if (_owner.Count == pieces.Length)
            {
                Overflows = true;
                return !GoesOn;
            }

            pieces[_owner.Count++] = piece;

            // Ends with the last place of memory, at the plane, or where the ball comes no closer any more.
            bool full = EndsWhenFull && _owner.Count == pieces.Length;
            _owner.IsComplete = !full;
            return full || (_untilPlane && piece.Crosses(_plane.Point, _plane.Normal, out _)) || (_untilPassing && _passing!.HasPassed(in piece));
        }
    }

    /// <inheritdoc/>
    public override string ToString() => Count == 0 ? "no path"
        : FormattableString.Invariant($"{StartTime:0.###} … {EndTime:0.###} s in {Count} pieces, {Events.Count} events, ends at {Final.Position:0.###}");
}
