using FootballPhysics.Contacts;
using FootballPhysics.Scenes;

namespace FootballPhysics.Prediction;

/// <summary>Decides if a ball that passed a point can no longer come closer.</summary>
/// <remarks>
/// The ball must be horizontally farther away than at its closest, and recede. Drag only brings its velocity closer to the wind's. The Magnus force
/// turns the velocity at Ω = lift |u|/|v|, and a bounce or a slide can reverse it only with fast backspin. If these effects could bring the ball
/// back in the remaining time, it has not passed.
/// </remarks>
internal sealed class PassingCriterion
{
    /// <summary>The margin for a stronger turn by the Magnus force while the ball slows down.</summary>
    private const double TurnMargin = 1.5;

    /// <summary>The margin for a fall, which takes longer than in vacuum.</summary>
    private const double FallMargin = 1.25;

    /// <summary>The share of the horizontal speed up to which a ball's surface speed cannot turn it back on the ground.</summary>
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

        // Obstacles can throw the ball back, and custom forces and variable winds have unknown effects.
        _mayReturn = !simulator.World.IsLevelGroundAlone || scene.Ground.Pattern is not null || scene.HasOwnForces || scene.IsTilted || SceneAir.HasFieldIn(scene);
    }

    /// <summary>True if the ball comes no closer after a segment.</summary>
    public bool HasPassed(in PathSegment piece)
    {
        // Compare squared distances. The ball has not passed while it approaches, is at its closest point, or may be blown back by the wind.
        _closest = Math.Min(_closest, piece.ClosestApproach(in _point, out _));
        Vector3d away = (piece.EndPosition - _point).Horizontal;
        Vector3d flat = piece.EndVelocity.Horizontal;
        double receding = Vector3d.Dot(in away, in flat);
        if (_mayReturn || !(receding > 0) || !(away.LengthSquared > _closest) || Vector3d.Dot(in away, in _wind) < 0)
        {
            return false;
        }

        // The ground may turn back a ball with fast backspin: at once if the ball slides, or later if it bounces.
        double speed = flat.Length;
        bool flies = piece.Motion == MotionState.Airborne;
        double radius = _simulator!.Scene.Ball.Radius;
        bool rubs = piece.Motion == MotionState.Sliding || (flies && !_untilImpact);
        if (rubs && _spinRate * radius > BackspinShare * speed)
        {
            return false;
        }

        // In flight, the Magnus acceleration, lift · |u|, can turn the velocity.
        double air = (piece.EndVelocity - _wind).Length;
        _simulator.AirFactors(air, _spinRate, out _, out double lift);
        double across = Math.Abs(lift) * air;
        double left = Math.Max(0, _end - piece.EndTime);

        // The flight time is bounded only if the ball certainly falls to a ground and bounces in still air.
        if (flies && _hasGround && -_upward > across && (_untilImpact || _wind == Vector3d.Zero))
        {
            left = Math.Min(left, FallMargin * TimeInAir(piece.EndPosition.Y - _simulator.ContactHeight, piece.EndVelocity.Y, -_upward - across));
        }
        else if (!flies && _wind == Vector3d.Zero)
        {
            // In still air, rolling or sliding slows the ball and its spin long before the ball could turn back.
            return true;
        }

        // Compare sines instead of angles: an angle is never smaller than its sine.
        return TurnMargin * across * left < receding / away.Length;
    }

    /// <summary>Returns the flight time, in s, up to the first impact or including all hops, each of which is lower by the restitution.</summary>
    private double TimeInAir(double height, double climb, double gravity)
    {
        // v is the speed of the first impact, c the climb, h the height, g gravity, e the restitution, and n counts the hops.
        // v² = c² + 2 g h; the hops, of duration 2 v eⁿ/g each, add up to 2 v e/((1 − e) g).
        double impact = Math.Sqrt((climb * climb) + (2.0 * gravity * Math.Max(0, height)));
        double e = _untilImpact ? 0 : Math.Min(_restitution, MostElastic);
        return (climb + impact + (2.0 * impact * e / (1.0 - e))) / gravity;
    }
}
