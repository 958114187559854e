namespace Football.Physics;

/// <summary>Watches a kick that is to meet some things first, and how close to a target it comes after that, before it meets the next.</summary>
internal sealed class BankShotPath : PieceObserver
{
    private readonly StepLog _log;
    private readonly bool _stillAir;
    private int[] _things = [];
    private Vector3d _target;
    private int _event;
    private int _met;
    private bool _wrong;

    /// <param name="log">What the flights write to.</param>
    /// <param name="stillAir">Whether there is no wind that brings a ball back.</param>
    public BankShotPath(StepLog log, bool stillAir)
    {
        _log = log;
        _stillAir = stillAir;
    }

    public override bool WantsEndAcceleration => true;

    /// <summary>Whether the kick met them all, in order.</summary>
    public bool MeetsAll => !_wrong && _met == _things.Length && !double.IsPositiveInfinity(Best);

    /// <summary>Square of the distance of the closest approach after that, m²; infinite where there was none.</summary>
    public double Best { get; private set; }

    /// <summary>When that was, s.</summary>
    public double Time { get; private set; }

    /// <summary>Where, m.</summary>
    public Vector3d Position { get; private set; }

    /// <summary>How fast, m/s.</summary>
    public Vector3d Velocity { get; private set; }

    /// <summary>Starts again.</summary>
    /// <param name="things">What to meet.</param>
    /// <param name="target">The target.</param>
    public void Begin(int[] things, in Vector3d target)
    {
        _things = things;
        _target = target;
        _event = 0;
        _met = 0;
        _wrong = false;
        Best = double.PositiveInfinity;
    }

    public override bool Add(in PathPiece piece) => false;

    public override bool Add(in BallState before, in BallState after, in PathPiece piece)
    {
        // Impacts come between pieces: those told of so far were before this one.
        for (; _event < _log.Events.Count; _event++)
        {
            ref readonly BallEvent e = ref _log.Events[_event];
            if (e.Kind != BallEventKind.Impact)
            {
                continue;
            }

            if (_met == _things.Length)
            {
                return true;
            }

            if (e.Thing != _things[_met])
            {
                _wrong = true;
                return true;
            }

            _met++;
        }

        if (_met == _things.Length)
        {
            double squared = piece.ClosestApproach(in _target, out double time);
            if (squared < Best)
            {
                Best = squared;
                Time = time;
                Position = piece.PositionAt(time);
                Velocity = piece.VelocityAt(time);
            }

            return IsPast(in piece);
        }

        // On the ground no ball comes down on it.
        return before.Carrier == 0 && piece.Motion is MotionState.Sliding or MotionState.Rolling && _things[_met] == 0;
    }

    /// <summary>Whether the ball comes no closer: on the ground it goes away; in the air it does so, and is farther off by its way over the ground alone.</summary>
    private bool IsPast(in PathPiece piece)
    {
        Vector3d gap = piece.EndPosition - _target;
        if (piece.Motion != MotionState.Airborne)
        {
            return Vector3d.Dot(in gap, piece.EndVelocity) > 0;
        }

        Vector3d flat = gap.Horizontal;
        return _stillAir && flat.LengthSquared > Best && Vector3d.Dot(in flat, piece.EndVelocity) > 0;
    }
}
