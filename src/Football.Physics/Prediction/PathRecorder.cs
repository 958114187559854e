using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics.Prediction;

/// <summary>Stores the segments of a path, and ends the look-ahead as soon as a stop condition is met.</summary>
internal sealed class PathRecorder(Trajectory owner, PathSegment[] pieces) : PathObserver
{
    private readonly Trajectory _owner = owner;
    private PathSegment[] _pieces = pieces;
    private bool _untilPlane;
    private Plane3d _plane;
    private bool _untilPassing;
    private PassingCriterion? _passing;
    private int _open = -1; // the piece that lacks the acceleration at its end
    private Stepper? _openStepper;
    private BallState _openEnd;
    private double _openLength;
    private bool _isShown; // true if it has been completed for a pause
    private bool _leavesOpen; // true if the acceleration at the end of a step of flight comes from the start of the next one

    /// <summary>True to end with the last segment that fits; false to end at the first one that does not.</summary>
    public bool EndsWhenFull { get; set; } = true;

    /// <summary>True if the ball continues without a path once the buffer is full.</summary>
    public bool GoesOn { get; set; }

    /// <summary>True if a segment did not fit.</summary>
    public bool Overflows { get; private set; }

    public void Begin(Simulator simulator, in BallState from, LookAheadRequest request)
    {
        Overflows = false;
        _open = -1;
        _isShown = false;
        _untilPlane = request.UntilPlane is not null;
        _plane = request.UntilPlane.GetValueOrDefault();
        _untilPassing = request.UntilPassing is not null;

        // The stop conditions need the shape of each segment at once, and a group may repeat its steps.
        _leavesOpen = !(_untilPlane || _untilPassing || GoesOn);
        if (_untilPassing)
        {
            _passing ??= new PassingCriterion();
            _passing.Begin(simulator, in from, request);
        }
    }

    public override bool AddFlight(
        Stepper stepper, in BallState end, double time, in Vector3d position, in Vector3d velocity, double spin, in Vector3d acceleration, int degree)
    {
        double length = end.Time - time;
        if (!_leavesOpen)
        {
            stepper.EndAcceleration(in end, length, out Vector3d atEnd);
            _owner.Log.Evaluations++;
            return Add(new PathSegment(
                time, length, in position, in velocity, in acceleration, end.Position, end.Velocity, in atEnd, MotionState.Airborne, degree));
        }

        // If the step starts where the open segment ends, it has computed the acceleration that this segment lacks.
        if (_open >= 0 && _openEnd.Time == time && _openEnd.Position == position && _openEnd.Flight.Velocity == velocity && _openEnd.Flight.SpinRate == spin)
        {
            PathSegment.Close(ref _pieces[_open], in acceleration);
            _owner.Log.Evaluations -= _isShown ? 1 : 0;
            _open = -1;
        }

        Close();
        if (!HasRoom())
        {
            Overflows = true;
            return !GoesOn;
        }

        _open = _owner.Count++;
        PathSegment.Write(ref _pieces[_open], time, length, in position, in velocity, in acceleration, end.Position, in end.Flight.Velocity, degree);

        // Copy only the values on which an acceleration depends.
        _openStepper = stepper;
        _openLength = length;
        _openEnd.Time = end.Time;
        _openEnd.Position = end.Position;
        _openEnd.Flight = end.Flight;
        _openEnd.Branch = end.Branch;
        _openEnd.AirDistance = end.AirDistance;
        _openEnd.Motion = end.Motion;
        return IsFull();
    }

    public override bool AddFall(in BallState start, double h, double end, double climb, double height, double upward, int degree)
    {
        if (_untilPlane || _untilPassing)
        {
            var acceleration = new Vector3d(0, upward, 0);
            Vector3d v = start.Velocity;
            var to = new Vector3d(start.Position.X + (h * v.X), height, start.Position.Z + (h * v.Z));
            return Add(new PathSegment(
                start.Time, end - start.Time, start.Position, in v, in acceleration, in to, new Vector3d(v.X, climb, v.Z), in acceleration, MotionState.Airborne, degree));
        }

        if (_open >= 0)
        {
            Close();
        }

        if (!HasRoom())
        {
            Overflows = true;
            return !GoesOn;
        }

        PathSegment.WriteFall(ref _pieces[_owner.Count++], in start, h, end, climb, height, upward, degree);
        return IsFull();
    }

    /// <summary>True if another segment fits.</summary>
    private bool HasRoom()
    {
        if (_owner.Count == _pieces.Length)
        {
            _pieces = _owner.Room();
        }

        return _owner.Count < _pieces.Length;
    }

    /// <summary>True if the last segment fills the buffer and the look-ahead is to end there.</summary>
    private bool IsFull()
    {
        bool full = EndsWhenFull && !HasRoom();
        _owner.IsComplete = !full;
        return full;
    }

    /// <summary>Completes the last piece by an evaluation.</summary>
    public void Close()
    {
        Complete();
        _open = -1;
        _isShown = false;
    }

    /// <summary>Completes the last piece for now; the next step may complete it again.</summary>
    public void Complete()
    {
        if (_open >= 0 && _open < _owner.Count && !_isShown)
        {
            _openStepper!.EndAcceleration(in _openEnd, _openLength, out Vector3d acceleration);
            _owner.Log.Evaluations++;
            PathSegment.Close(ref _pieces[_open], in acceleration);
            _isShown = true;
        }
    }

    public override bool Add(in PathSegment piece)
    {
        Close();
        AddRest(in piece);

        // The buffer is full: end the step, and let the caller repeat the look-ahead with less. A ball in a group continues instead, because ending
        // after every segment would restart the step each time, possibly forever.
        if (!HasRoom())
        {
            Overflows = true;
            return !GoesOn;
        }

        _pieces[_owner.Count++] = piece;

        // End at the last segment that fits, at the plane, or when the ball no longer approaches the point.
        return IsFull() || (_untilPlane && piece.Crosses(_plane.Point, _plane.Normal, out _)) || (_untilPassing && _passing!.HasPassed(in piece));
    }

    /// <summary>Adds a segment for the time that the ball rested before a segment, because a ball at rest takes no pieces.</summary>
    private void AddRest(in PathSegment next)
    {
        if (!HasRoom())
        {
            return;
        }

        bool isFirst = _owner.Count == 0;
        double from = isFirst ? _owner.StartTime : _pieces[_owner.Count - 1].EndTime;
        double length = next.Time - from;
        if (length > ContactTolerances.ShortestAdvance + (ContactTolerances.ClockRounding * next.Time))
        {
            Vector3d still = Vector3d.Zero;
            Vector3d place = isFirst ? next.StartPosition : _pieces[_owner.Count - 1].EndPosition;
            _pieces[_owner.Count++] = new PathSegment(from, length, in place, in still, in still, in place, in still, in still, MotionState.Rest, 5);
        }
    }
}
