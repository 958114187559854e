namespace FootballPhysics.Prediction;

/// <summary>Tells when a ball that passed a point comes no closer to it any more.</summary>
/// <remarks>
/// Over the ground the ball is further away than it was at its closest, and recedes. Drag only slows it, towards the wind; the Magnus force turns its
/// velocity by Ω = lift |u|/|v|; a bounce or a slide turns it only where the ball spins back fast. Where those, over the time that is
/// left, could bring it back, it has not passed.
/// </remarks>
internal sealed class PassingCriterion
{
    /// <summary>How much more than now the Magnus force may turn the velocity while the ball grows slower.</summary>
    private const double TurnMargin = 1.5;

    /// <summary>How much longer than in vacuum a fall may take.</summary>
    private const double FallMargin = 1.25;

    /// <summary>Share of the speed over the ground up to which the speed of a ball's surface does not turn it back on the ground.</summary>
    private const double BackspinShare = 0.2;

    private const double MostElastic = 0.99;

    private Simulator? _simulator;
    private Vector3d _point;
    private Vector3d _wind;
    private double _end;
    private double _upward;
    private double _spinRate;
    private double _closest;
    private double _restitution;
    private bool _untilImpact;
    private bool _mayReturn;
    private bool _hasGround;

    /// <summary>Begins a look-ahead.</summary>
    public void Begin(Simulator simulator, in BallState from, LookAheadRequest request)
    {
        Scene scene = simulator.Scene;
        _simulator = simulator;
        _point = request.UntilPassing.GetValueOrDefault();
        _wind = scene.Air.Wind;
        _end = from.Time + request.Duration;
        _upward = Weight.UpwardAcceleration(scene);
        _spinRate = from.Spin.Length;
        _closest = double.PositiveInfinity;
        _restitution = ContactMaterial.LargestOn(scene.Ground, scene.Ball);
        _untilImpact = request.StopAt == StopAt.Impact;
        _hasGround = !scene.Ground.IsNone;

        // Things throw a ball back, and what a game's own forces and winds that change may do is not known.
        _mayReturn = !simulator.World.IsLevelGroundAlone || scene.Ground.Pattern is not null || scene.HasOwnForces || SceneAir.HasFieldIn(scene);
    }

    /// <summary>True when the ball comes no closer after a piece.</summary>
    public bool HasPassed(in PathSegment piece)
    {
        // Squared. It has not passed while it comes closer, or is no farther off than at its closest, or where the wind blows it back.
        _closest = Math.Min(_closest, piece.ClosestApproach(in _point, out _));
        Vector3d away = (piece.EndPosition - _point).Horizontal;
        Vector3d flat = piece.EndVelocity.Horizontal;
        double receding = Vector3d.Dot(in away, in flat);
        if (_mayReturn || !(receding > 0) || !(away.LengthSquared > _closest) || Vector3d.Dot(in away, in _wind) < 0)
        {
            return false;
        }

        // A ball that spins back fast may be turned by the ground: now where it slides, later where it still flies and will bounce.
        double speed = flat.Length;
        bool flies = piece.Motion == MotionState.Airborne;
        double radius = _simulator!.Scene.Ball.Radius;
        bool rubs = piece.Motion == MotionState.Sliding || (flies && !_untilImpact);
        if (rubs && _spinRate * radius > BackspinShare * speed)
        {
            return false;
        }

        // The Magnus acceleration, lift · |u|, may turn the velocity for as long as the ball flies.
        double air = (piece.EndVelocity - _wind).Length;
        _simulator.AirFactors(air, _spinRate, out _, out double lift);
        double across = Math.Abs(lift) * air;
        double left = Math.Max(0, _end - piece.EndTime);

        // A flight has an end only if the ball falls for certain, to a ground, and in still air if it bounces on.
        if (flies && _hasGround && -_upward > across && (_untilImpact || _wind == Vector3d.Zero))
        {
            left = Math.Min(left, FallMargin * TimeInAir(piece.EndPosition.Y - _simulator.ContactHeight, piece.EndVelocity.Y, -_upward - across));
        }
        else if (!flies && _wind == Vector3d.Zero)
        {
            // What rolls or slides in still air is slowed, and its spin too, long before it could turn round.
            return true;
        }

        // The angle by which the velocity may turn before it no longer recedes is at least its sine.
        return TurnMargin * across * left < receding / away.Length;
    }

    /// <summary>How long a ball flies, s: to its first impact, or with all hops after it, each lower by the restitution.</summary>
    private double TimeInAir(double height, double climb, double gravity)
    {
        // v² = c² + 2 g h; hops of 2 v eⁿ/g each sum to 2 v e/((1 − e) g).
        double impact = Math.Sqrt((climb * climb) + (2.0 * gravity * Math.Max(0, height)));
        double e = _untilImpact ? 0 : Math.Min(_restitution, MostElastic);
        return (climb + impact + (2.0 * impact * e / (1.0 - e))) / gravity;
    }
}
