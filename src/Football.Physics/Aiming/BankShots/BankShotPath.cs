namespace Football.Physics;

/// <summary>Watches a kick that is to meet some things first, and how close to a target it comes after that, before it meets the next.</summary>
internal sealed class BankShotPath : PieceObserver
{
    private readonly StepLog _log;
    private int[] _things = [];
    private Vector3d _target;
    private int _event;
    private int _met;
    private bool _wrong;

    public BankShotPath(StepLog log) => _log = log;

    public override bool WantsEndAcceleration => true;

    /// <summary>Whether the kick met them all, in order.</summary>
    public bool MeetsAll => !_wrong && _met == _things.Length && !double.IsPositiveInfinity(Best);

    /// <summary>How many of them it met before anything else.</summary>
    public int Met => _met;

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

    public override bool Add(in PathPiece piece)
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

            // On the ground it comes no closer once it goes away.
            return piece.Motion != MotionState.Airborne && Vector3d.Dot(piece.EndPosition - _target, piece.EndVelocity) > 0;
        }

        return false;
    }
}
