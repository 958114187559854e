namespace Football.Physics;

/// <summary>
/// Flies kicks with ground, in long steps, for their closest approach to the target. In still air a flight turns with its azimuth as it
/// is, so only distance and height of the way count, and the azimuth that goes with them is known exactly after one flight.
/// </summary>
internal sealed class PassFlight : PieceObserver
{
    /// <summary>On the ground above this speed, m/s, where the drag law's jump is still to come, steps are shorter.</summary>
    private const double FastRoll = 11;

    /// <summary>Step of a ball that is faster on the ground, s.</summary>
    private const double FastStep = 0.25;

    private readonly Simulator _simulator;
    private readonly Simulator _rough;
    private readonly StepLog _log = new();
    private readonly StepLog _watched = new();
    private Vector3d _from;
    private Vector3d _target;
    private Vector3d _targetVelocity;
    private Vector3d _forward;
    private Vector3d _left;
    private double _distance;
    private double _speed;
    private bool _stillAir;
    private double _best;
    private double _time;
    private Vector3d _position;
    private Vector3d _velocity;

    public PassFlight(Simulator simulator)
    {
        _simulator = simulator;
        _rough = new Simulator(simulator.Scene, simulator.Settings with { Integrator = Integrator.Rk2 });
        _stillAir = simulator.Scene.Air.Wind == Vector3d.Zero;
        _watched.Observer = this;
    }

    /// <summary>Whether flights turn with their azimuth: in still air, to a target at rest.</summary>
    public bool Turns { get; private set; }

    public override bool WantsEndAcceleration => !Roughly;

    /// <summary>Whether a ball that rolls only has its direction asked for: RK2 will do then.</summary>
    public bool Roughly { get; set; }

    /// <summary>Prepares for flights to a target.</summary>
    public void Aim(in Vector3d from, in Vector3d target, in Vector3d targetVelocity, double speed)
    {
        _from = from;
        _target = target;
        _targetVelocity = targetVelocity;
        _forward = AimContext.Forward(in from, in target, out _distance);
        _left = new Vector3d(_forward.Z, 0, -_forward.X); // ŷ × f
        _speed = speed;
        Turns = _stillAir && targetVelocity == Vector3d.Zero;
    }

    /// <summary>Flies a kick until it can come no closer.</summary>
    public Pass Fly(in Kick kick, double timeStep)
    {
        kick.Vectors(_speed, in _forward, out Vector3d velocity, out Vector3d spin);
        BallState state = _simulator.Launch(_from, velocity, spin);
        _log.Clear();
        _best = double.PositiveInfinity;
        Take(0, state.Position, state.Velocity);
        double rate = Rate(0, state.Position, state.Velocity);
        bool beyond = false;
        bool done = false;
        while (!done && state.Time < AimContext.LongestFlight)
        {
            if (state.Motion != MotionState.Airborne)
            {
                _watched.Clear();
                double step = state.Velocity.LengthSquared > FastRoll * FastRoll ? Math.Min(timeStep, FastStep) : timeStep;
                done = (Roughly ? _rough : _simulator).StepToImpact(ref state, step, _watched);
                rate = Rate(state.Time, state.Position, state.Velocity);
                done = done || IsOver(in state, state.Position - _from, rate);
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
            }
            else
            {
                Take(state.Time, state.Position, in end);
            }

            rate = endRate;
            Vector3d went = state.Position - _from;
            beyond |= (went.X * went.X) + (went.Z * went.Z) >= _distance * _distance;
            done = done || IsOver(in state, in went, rate);
        }

        return Passed(in kick, beyond);
    }

    public override bool Add(in PathPiece piece)
    {
        double start = Rate(piece.Time, piece.StartPosition, piece.StartVelocity);
        double end = Rate(piece.EndTime, piece.EndPosition, piece.EndVelocity);
        Take(piece.Time, piece.StartPosition, piece.StartVelocity);
        Take(piece.EndTime, piece.EndPosition, piece.EndVelocity);
        if (start < 0 && end > 0)
        {
            Turn(in piece, start, end);
        }

        return false;
    }

    private static Vector3d BeforeImpact(EventBuffer events)
    {
        int last = events.Count - 1;
        return events[events[last].Kind == BallEventKind.Impact ? last : last - 1].VelocityBefore;
    }

    /// <summary>Half the rate of change of the squared distance, m²/s.</summary>
    private double Rate(double time, in Vector3d position, in Vector3d velocity)
    {
        if (!Turns)
        {
            Vector3d gap = position - _target - (time * _targetVelocity);
            return Vector3d.Dot(in gap, velocity - _targetVelocity);
        }

        // (ρ − D) ρ̇ + (y − y_T) v_y
        Profile(in position, in velocity, out double along, out double alongRate);
        return (along * alongRate) + ((position.Y - _target.Y) * velocity.Y);
    }

    /// <summary>Way beyond the target's distance, and its rate.</summary>
    private void Profile(in Vector3d position, in Vector3d velocity, out double along, out double rate)
    {
        double x = position.X - _from.X;
        double z = position.Z - _from.Z;
        double went = Math.Sqrt((x * x) + (z * z));
        along = went - _distance;
        rate = went > 1e-9 ? ((x * velocity.X) + (z * velocity.Z)) / went : velocity.Horizontal.Length;
    }

    private void Take(double time, in Vector3d position, in Vector3d velocity)
    {
        double squared;
        if (Turns)
        {
            double x = position.X - _from.X;
            double z = position.Z - _from.Z;
            double along = Math.Sqrt((x * x) + (z * z)) - _distance;
            double up = position.Y - _target.Y;
            squared = (along * along) + (up * up);
        }
        else
        {
            squared = (position - _target - (time * _targetVelocity)).LengthSquared;
        }

        if (squared < _best)
        {
            _best = squared;
            _time = time;
            _position = position;
            _velocity = velocity;
        }
    }

    /// <summary>The closest point inside a piece: a root of the rate, which is nearly linear.</summary>
    private void Turn(in PathPiece piece, double atStart, double atEnd)
    {
        var rate = new RateInside(this, in piece);
        Roots.Illinois(ref rate, piece.Time, atStart, piece.EndTime, atEnd, 1e-9 * piece.Length, 30);
    }

    /// <summary>Whether a ball comes no closer any more.</summary>
    private bool IsOver(in BallState state, in Vector3d went, double rate)
    {
        double up = state.Position.Y - _target.Y;
        if (state.Motion != MotionState.Airborne)
        {
            return state.Motion == MotionState.Stopped || (_targetVelocity == Vector3d.Zero && up * up >= _best)
                || (Turns && state.Motion == MotionState.Rolling && rate > 0);
        }

        if (!Turns || !(Vector3d.Dot(went.Horizontal, state.Velocity) > 0))
        {
            return false;
        }

        double along = went.Horizontal.Length - _distance;
        return along > 0 && (along * along > _best || (up < 0 && state.Velocity.Y < 0));
    }

    private Pass Passed(in Kick kick, bool beyond)
    {
        var pass = new Pass { Kick = kick, Miss = Math.Sqrt(_best), Time = _time };
        if (!Turns)
        {
            // The target is below the way where it lies to the right of the motion, seen in the plane of kick and height.
            Vector3d u = kick.Direction(in _forward);
            Vector3d moving = _velocity - _targetVelocity;
            pass.Gap = _position - _target - (_time * _targetVelocity);
            pass.Above = (Vector3d.Dot(in moving, in u) * pass.Gap.Y) - (moving.Y * Vector3d.Dot(in pass.Gap, in u)) > 0;
            return pass;
        }

        Profile(in _position, in _velocity, out double along, out double rate);
        double up = _position.Y - _target.Y;
        Vector3d went = _position - _from;
        double across = Vector3d.Dot(in went, in _left);
        double ahead = Vector3d.Dot(in went, in _forward);
        pass.Kick.Azimuth -= across == 0 && ahead == 0 ? 0 : Elementary.Atan2(across, ahead);
        pass.Gap = new Vector3d(along * _forward.X, up, along * _forward.Z);
        pass.Above = beyond && (rate * up) - (_velocity.Y * along) > 0;
        return pass;
    }

    /// <summary>The rate over a piece.</summary>
    private readonly struct RateInside : IFunction
    {
        private readonly PassFlight _owner;
        private readonly PathPiece _piece;

        public RateInside(PassFlight owner, in PathPiece piece)
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
