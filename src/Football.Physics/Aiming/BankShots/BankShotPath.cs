namespace Football.Physics;

/// <summary>
/// Flies a kick that is to meet some things first, and watches how close to a target it comes after that, before it meets the next. Only where it passes the target
/// is it looked at closely.
/// </summary>
internal sealed class BankShotPath : PieceObserver
{
    /// <summary>A kick is given up after this, s.</summary>
    private const double LongestFlight = 8;

    /// <summary>A ball that has been in a net, slower than this, for so long only creeps on, m/s and s: no more than twice as fast.</summary>
    private const double Slow = 0.3;
    private const double Long = 0.4;

    private readonly Simulator _simulator;
    private readonly World _world;
    private readonly StepLog _log = new();
    private readonly StepLog _watched = new();
    private readonly bool _stillAir;
    private int[] _things = [];
    private Vector3d _target;
    private int _met;
    private double _best;
    private double _time;
    private Vector3d _position;
    private Vector3d _velocity;
    private double _start;
    private double _fast;

    /// <param name="simulator">The scene.</param>
    public BankShotPath(Simulator simulator)
    {
        _simulator = simulator;
        _world = simulator.World;
        _stillAir = simulator.Scene.Air.IsStill;
        _watched.Observer = this;
    }

    public override bool WantsEndAcceleration => true;

    private bool HasMetAll => _met == _things.Length;

    /// <summary>Flies a kick.</summary>
    /// <param name="state">The ball.</param>
    /// <param name="step">Length of a step, s.</param>
    /// <param name="things">What to meet.</param>
    /// <param name="target">The target.</param>
    /// <param name="shot">What is found: whether it meets them all in order before anything else, and how close it comes then.</param>
    public void Fly(BallState state, double step, int[] things, in Vector3d target, ref BankShotStart shot)
    {
        _things = things;
        _target = target;
        _met = 0;
        _best = double.PositiveInfinity;
        _start = state.Time;
        _fast = _start;
        bool goesOn = true;
        double last = _start + LongestFlight - (1e-9 * step);
        while (goesOn && state.Motion != MotionState.Stopped && state.Time < last)
        {
            BallState before = state;
            StepLog log = _log;
            log.Clear();
            _simulator.StepToImpact(ref state, step, log);
            if (HasMetAll)
            {
                if (log.Steps > 1 || Passes(in before, in state))
                {
                    // Taken again, and looked at closely.
                    state = before;
                    log = _watched;
                    log.Clear();
                    _simulator.StepToImpact(ref state, step, log);
                }
                else
                {
                    Take((state.Position - _target).LengthSquared, state.Time, state.Position, state.Velocity);
                }
            }

            goesOn = Meet(log.Events, in state) && !(HasMetAll ? IsPast(in state) : StaysDown(in state)) && !Creeps(in state);
        }

        shot.Meets = HasMetAll;
        shot.Miss = shot.Meets ? Math.Sqrt(_best) : double.MaxValue;
        shot.Time = _time - _start;
        shot.Position = _position;
        shot.Velocity = _velocity;
    }

    public override bool Add(in PathPiece piece)
    {
        double squared = piece.ClosestApproach(in _target, out double time);
        Take(squared, time, piece.PositionAt(time), piece.VelocityAt(time));
        return false;
    }

    private void Take(double squared, double time, in Vector3d position, in Vector3d velocity)
    {
        if (squared < _best)
        {
            _best = squared;
            _time = time;
            _position = position;
            _velocity = velocity;
        }
    }

    /// <summary>Looks at what the ball met in a step.</summary>
    /// <returns>False where it was what was not to be met, or the next after all that was.</returns>
    private bool Meet(EventBuffer events, in BallState state)
    {
        for (int i = 0; i < events.Count; i++)
        {
            ref readonly BallEvent e = ref events[i];
            if (e.Kind != BallEventKind.Impact)
            {
                continue;
            }

            if (HasMetAll || e.Thing != _things[_met])
            {
                return false;
            }

            _met++;
            if (HasMetAll)
            {
                Take((state.Position - _target).LengthSquared, state.Time, state.Position, state.Velocity);
            }
        }

        return true;
    }

    /// <summary>Whether a ball that came closer goes away again.</summary>
    private bool Passes(in BallState before, in BallState after) =>
        Vector3d.Dot(before.Position - _target, before.Velocity) < 0 && Vector3d.Dot(after.Position - _target, after.Velocity) > 0;

    /// <summary>Whether the ball comes no closer: on the ground it goes away; in the air it does so, and is farther off by its way over the ground alone.</summary>
    private bool IsPast(in BallState state)
    {
        Vector3d gap = state.Position - _target;
        if (state.Motion != MotionState.Airborne)
        {
            return Vector3d.Dot(in gap, state.Velocity) > 0;
        }

        Vector3d flat = gap.Horizontal;
        return _stillAir && flat.LengthSquared > _best && Vector3d.Dot(in flat, state.Velocity) > 0;
    }

    /// <summary>Whether a ball that is to come down on the ground stays on it.</summary>
    private bool StaysDown(in BallState state) => state.Motion is MotionState.Sliding or MotionState.Rolling && state.Carrier == 0 && _things[_met] == 0;

    /// <summary>Whether the ball creeps down a net, and gets nowhere in time.</summary>
    private bool Creeps(in BallState state)
    {
        double speed = state.Velocity.Length;
        if (state.Nets == 0 || speed > Slow)
        {
            _fast = state.Time;
            return false;
        }

        if (state.Time - _fast < Long)
        {
            return false;
        }

        double gap = HasMetAll ? (state.Position - _target).Length - Math.Sqrt(_best)
            : _world.Colliders[_things[_met] - _world.FirstCollider].At(state.Position, state.Time).Distance - _world.Ball.Radius;
        return gap > 2.0 * speed * (_start + LongestFlight - state.Time);
    }
}

/// <summary>A kick that was flown, and how close it comes after what it is to meet.</summary>
internal struct BankShotStart
{
    public Kick Kick;

    /// <summary>Whether it meets what it is to meet.</summary>
    public bool Meets;

    /// <summary>Whether it was flown in short steps.</summary>
    public bool IsFine;

    /// <summary>Closest approach, m.</summary>
    public double Miss;

    /// <summary>When, s.</summary>
    public double Time;

    /// <summary>Where, m.</summary>
    public Vector3d Position;

    /// <summary>How fast, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>Whether it does what is asked.</summary>
    public readonly bool IsHit(AimRequest request) => IsFine && Miss <= request.Tolerance;
}
