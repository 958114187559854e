namespace Football.Physics;

/// <summary>
/// Flies kicks with ground, in long steps, for their closest approach to the target. In still air a flight turns with its azimuth as it
/// is, so only distance and height of the way count, and the azimuth that goes with them is known exactly after one flight.
/// </summary>
internal sealed class ApproachShooter : PieceObserver
{
    /// <summary>On the ground above this speed, m/s, where the drag law's jump is still to come, steps are shorter.</summary>
    private const double FastRoll = 11;

    /// <summary>Step of a ball that is faster on the ground, s.</summary>
    private const double FastStep = 0.25;

    /// <summary>Points of one piece that may be looked at for the closest.</summary>
    private const int MostInside = 30;

    private readonly AimContext _context;
    private readonly Simulator _simulator;
    private readonly Simulator _rough;
    private readonly StepLog _log = new();
    private readonly StepLog _watched = new();
    private readonly bool _stillAir;
    private TargetFrame _frame;
    private Vector3d _targetVelocity;
    private double _speed;
    private bool _roughly;
    private double _best;
    private double _time;
    private Vector3d _position;
    private Vector3d _velocity;

    /// <param name="context">Where flights are counted.</param>
    /// <param name="simulator">The scene.</param>
    public ApproachShooter(AimContext context, Simulator simulator)
    {
        _context = context;
        _simulator = simulator;
        _rough = new Simulator(simulator.Scene, simulator.Settings with { Integrator = Integrator.Rk2 });
        _stillAir = simulator.Scene.Air.IsStill;
        _watched.Observer = this;
    }

    /// <summary>Whether flights turn with their azimuth as they are: in still air, to a target at rest.</summary>
    public bool TurnWithAzimuth { get; private set; }

    public override bool WantsEndAcceleration => !_roughly;

    /// <summary>Whether flights of a request turn with their azimuth.</summary>
    public bool Separates(AimRequest request) => _stillAir && request.TargetVelocity == Vector3d.Zero;

    /// <summary>Prepares for flights to a target.</summary>
    public void Aim(in TargetFrame frame, in Vector3d targetVelocity, double speed)
    {
        _frame = frame;
        _targetVelocity = targetVelocity;
        _speed = speed;
        TurnWithAzimuth = _stillAir && targetVelocity == Vector3d.Zero;
    }

    /// <summary>Flies a kick until it can come no closer.</summary>
    /// <param name="kick">The kick.</param>
    /// <param name="timeStep">Step of the flight, s.</param>
    /// <param name="roughly">Whether only the direction of a ball that rolls is asked for: RK2 will do then.</param>
    public Approach Fly(in Kick kick, double timeStep, bool roughly)
    {
        // On the ground every piece is looked at. In the air a step is flown unwatched; where the distance fell at its start and grows at its end, the
        // closest point lies inside: read off the cubic of a whole step, or off the pieces of the step taken again. Ends at the impact, at rest,
        // or where the ball can come no closer.
        _roughly = roughly;
        kick.Vectors(_speed, in _frame.Forward, out Vector3d velocity, out Vector3d spin);
        BallState state = _simulator.Launch(_frame.From, velocity, spin);
        _log.Clear();
        _best = double.PositiveInfinity;
        Take(0, state.Position, state.Velocity);
        double rate = Rate(0, state.Position, state.Velocity);
        bool beyond = false;
        bool done = false;
        long watched = 0;
        while (!done && state.Time < AimContext.LongestFlight && _log.Steps + watched < AimContext.MostPieces)
        {
            if (state.Motion != MotionState.Airborne)
            {
                _watched.Clear();
                double step = state.Velocity.LengthSquared > FastRoll * FastRoll ? Math.Min(timeStep, FastStep) : timeStep;
                done = (_roughly ? _rough : _simulator).StepToImpact(ref state, step, _watched);
                watched += _watched.Steps;
                rate = Rate(state.Time, state.Position, state.Velocity);
                done = done || IsOver(in state, state.Position - _frame.From, rate);
                continue;
            }

            // In the air a step that nobody watches is the fastest; one with the closest point in it and more than one piece is taken again, watched.
            BallState before = state;
            long pieces = _log.Steps;
            done = _simulator.StepToImpact(ref state, timeStep, _log);
            Vector3d end = done ? BeforeImpact(_log.Events) : state.Velocity;
            double endRate = Rate(state.Time, state.Position, in end);
            if (rate < 0 && endRate > 0 && !done && _log.Steps == pieces + 1)
            {
                Add(PathPiece.Cubic(in before, in state));
            }
            else if (rate < 0 && endRate > 0)
            {
                _watched.Clear();
                BallState again = before;
                _simulator.StepToImpact(ref again, timeStep, _watched);
                watched += _watched.Steps;
            }
            else
            {
                Take(state.Time, state.Position, in end);
            }

            rate = endRate;
            Vector3d went = state.Position - _frame.From;
            beyond |= (went.X * went.X) + (went.Z * went.Z) >= _frame.Distance * _frame.Distance;
            done = done || IsOver(in state, in went, rate);
        }

        _context.CountSimulation(_log.Steps + watched);
        return Found(in kick, beyond);
    }

    public override bool Add(in PathPiece piece)
    {
        double start = Rate(piece.Time, piece.StartPosition, piece.StartVelocity);
        double end = Rate(piece.EndTime, piece.EndPosition, piece.EndVelocity);
        Take(piece.Time, piece.StartPosition, piece.StartVelocity);
        Take(piece.EndTime, piece.EndPosition, piece.EndVelocity);
        if (start < 0 && end > 0)
        {
            // A root of the rate, which is nearly linear
            var rate = new RateOfDistance(this, in piece);
            Roots.Illinois(ref rate, piece.Time, start, piece.EndTime, end, 1e-9 * piece.Length, MostInside);
        }

        return false;
    }

    /// <summary>The velocity with which the ball met the ground.</summary>
    private static Vector3d BeforeImpact(EventBuffer events)
    {
        int last = events.Count - 1;
        return events[events[last].Kind == BallEventKind.Impact ? last : last - 1].VelocityBefore;
    }

    /// <summary>Half the rate of change of the squared distance, m²/s.</summary>
    private double Rate(double time, in Vector3d position, in Vector3d velocity)
    {
        if (!TurnWithAzimuth)
        {
            Vector3d gap = position - _frame.Target - (time * _targetVelocity);
            return Vector3d.Dot(in gap, velocity - _targetVelocity);
        }

        // (ρ − D) ρ̇ + (y − y_T) v_y
        Profile(in position, in velocity, out double along, out double alongRate);
        return (along * alongRate) + ((position.Y - _frame.Target.Y) * velocity.Y);
    }

    /// <summary>Way beyond the target's distance, and its rate.</summary>
    private void Profile(in Vector3d position, in Vector3d velocity, out double along, out double rate)
    {
        double x = position.X - _frame.From.X;
        double z = position.Z - _frame.From.Z;
        double went = Math.Sqrt((x * x) + (z * z));
        along = went - _frame.Distance;
        rate = went > 1e-9 ? ((x * velocity.X) + (z * velocity.Z)) / went : velocity.Horizontal.Length;
    }

    /// <summary>Takes a point of the flight for the closest if it is.</summary>
    private void Take(double time, in Vector3d position, in Vector3d velocity)
    {
        double squared;
        if (TurnWithAzimuth)
        {
            Profile(in position, in velocity, out double along, out _);
            double up = position.Y - _frame.Target.Y;
            squared = (along * along) + (up * up);
        }
        else
        {
            squared = (position - _frame.Target - (time * _targetVelocity)).LengthSquared;
        }

        if (squared < _best)
        {
            _best = squared;
            _time = time;
            _position = position;
            _velocity = velocity;
        }
    }

    /// <summary>Whether a ball comes no closer any more.</summary>
    private bool IsOver(in BallState state, in Vector3d went, double rate)
    {
        double up = state.Position.Y - _frame.Target.Y;
        if (state.Motion != MotionState.Airborne)
        {
            return state.Motion == MotionState.Stopped || (_targetVelocity == Vector3d.Zero && up * up >= _best)
                || (TurnWithAzimuth && state.Motion == MotionState.Rolling && rate > 0);
        }

        if (!TurnWithAzimuth || !(Vector3d.Dot(went.Horizontal, state.Velocity) > 0))
        {
            return false;
        }

        double along = went.Horizontal.Length - _frame.Distance;
        return along > 0 && (along * along > _best || (up < 0 && state.Velocity.Y < 0));
    }

    /// <summary>The closest approach of the flight that was flown.</summary>
    /// <param name="kick">The kick.</param>
    /// <param name="beyond">Whether the ball got as far as the target is.</param>
    private Approach Found(in Kick kick, bool beyond)
    {
        var approach = new Approach { Kick = kick, Miss = Math.Sqrt(_best), Time = _time };
        if (!TurnWithAzimuth)
        {
            // The target is below the way where it lies to the right of the motion, seen in the plane of kick and height.
            Vector3d u = kick.Direction(in _frame.Forward);
            Vector3d moving = _velocity - _targetVelocity;
            approach.Gap = _position - _frame.Target - (_time * _targetVelocity);
            approach.Above = (Vector3d.Dot(in moving, in u) * approach.Gap.Y) - (moving.Y * Vector3d.Dot(in approach.Gap, in u)) > 0;
            return approach;
        }

        Profile(in _position, in _velocity, out double along, out double rate);
        double up = _position.Y - _frame.Target.Y;
        Vector3d went = _position - _frame.From;
        double across = Vector3d.Dot(in went, in _frame.Left);
        double ahead = Vector3d.Dot(in went, in _frame.Forward);
        approach.Kick.Azimuth -= across == 0 && ahead == 0 ? 0 : Elementary.Atan2(across, ahead);
        approach.Gap = new Vector3d(along * _frame.Forward.X, up, along * _frame.Forward.Z);
        approach.Above = beyond && (rate * up) - (_velocity.Y * along) > 0;
        return approach;
    }

    /// <summary>The rate of the distance over the time of a piece.</summary>
    private readonly struct RateOfDistance : IFunction
    {
        private readonly ApproachShooter _owner;
        private readonly PathPiece _piece;

        public RateOfDistance(ApproachShooter owner, in PathPiece piece)
        {
            _owner = owner;
            _piece = piece;
        }

        public bool Evaluate(double x, out double value)
        {
            Vector3d position = _piece.PositionAt(x);
            Vector3d velocity = _piece.VelocityAt(x);
            value = _owner.Rate(x, in position, in velocity);
            _owner.Take(x, in position, in velocity);

            // The distance is flat here: 1e-4 of it along the way is 5e-9 of it in the distance itself.
            return value * value < 1e-8 * _owner._best * velocity.LengthSquared;
        }
    }
}
