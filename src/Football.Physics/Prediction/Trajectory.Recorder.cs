namespace FootballPhysics.Prediction;

/// <content>The observer that records a path.</content>
public sealed partial class Trajectory
{
    /// <summary>Stores the segments, and ends the look-ahead as soon as a stop condition is met.</summary>
    private sealed class Recorder : PieceObserver
    {
        private readonly Trajectory _owner;
        private bool _untilPlane;
        private Plane3d _plane;
        private bool _untilPassing;
        private PassingCriterion? _passing;
        private int _open = -1; // the piece that lacks the acceleration at its end
        private Stepper? _openStepper;
        private BallState _openEnd;
        private double _openLength;
        private bool _isShown; // true if it has been completed for a pause

        public Recorder(Trajectory owner) => _owner = owner;

        public override bool WantsEndAcceleration => true;

        internal override bool WantsStates => false;

        /// <summary>True to take the acceleration at the end of a step of flight from the start of the next one.</summary>
        public bool LeavesOpen { get; set; }

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
            LeavesOpen = false;
            _untilPlane = request.UntilPlane is not null;
            _plane = request.UntilPlane.GetValueOrDefault();
            _untilPassing = request.UntilPassing is not null;
            if (_untilPassing)
            {
                _passing ??= new PassingCriterion();
                _passing.Begin(simulator, in from, request);
            }
        }

        internal override bool Close(in Vector3d position, in Vector3d velocity, double spin, double time, in Vector3d acceleration)
        {
            // The step starts where the open piece ends: it has computed the same acceleration.
            if (_open >= 0 && _openEnd.Time == time && _openEnd.Position == position && _openEnd.Flight.Velocity == velocity && _openEnd.Flight.SpinRate == spin)
            {
                PathSegment.Close(ref _owner._pieces[_open], in acceleration);
                _owner.Log.Evaluations -= _isShown ? 1 : 0;
                _open = -1;
                _isShown = false;
            }

            return LeavesOpen;
        }

        internal override void LeaveOpen(Stepper stepper, in BallState end, double h)
        {
            // A piece that did not fit is not stored.
            _open = Overflows ? -1 : _owner.Count - 1;
            _isShown = false;
            _openStepper = stepper;
            _openLength = h;

            // Copy only the values that an acceleration depends on, one by one: they were stored one by one just now.
            _openEnd.Time = end.Time;
            _openEnd.Position = new Vector3d(end.Position.X, end.Position.Y, end.Position.Z);
            _openEnd.Flight.Velocity = new Vector3d(end.Flight.Velocity.X, end.Flight.Velocity.Y, end.Flight.Velocity.Z);
            _openEnd.Flight.Axis = end.Flight.Axis;
            _openEnd.Flight.SpinRate = end.Flight.SpinRate;
            _openEnd.Branch = end.Branch;
            _openEnd.AirDistance = end.AirDistance;
            _openEnd.Motion = end.Motion;
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
                PathSegment.Close(ref _owner._pieces[_open], in acceleration);
                _isShown = true;
            }
        }

        public override bool Add(in PathSegment piece)
        {
            PathSegment[] pieces = _owner._pieces;
            Close();

            // The buffer is full: end the step, and let the caller repeat the look-ahead with less. A ball in a group continues instead, because ending
            // after every segment would restart the step each time, possibly forever.
            if (_owner.Count == pieces.Length)
            {
                Overflows = true;
                return !GoesOn;
            }

            pieces[_owner.Count++] = piece;

            // End at the last segment that fits, at the plane, or when the ball comes no closer to the point.
            bool full = EndsWhenFull && _owner.Count == pieces.Length;
            _owner.IsComplete = !full;
            return full || (_untilPlane && piece.Crosses(_plane.Point, _plane.Normal, out _)) || (_untilPassing && _passing!.HasPassed(in piece));
        }
    }
}
