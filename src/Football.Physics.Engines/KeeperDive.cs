using FootballPhysics.Game;
using FootballPhysics.Numerics;

namespace FootballPhysics.Engines;

/// <summary>A goalkeeper as a body of the scene: he stands in front of his goal and dives for shots.</summary>
/// <remarks>
/// <see cref="Interception.FindSave"/> decides if and where he can reach the ball. He notices a kick when the ball leaves its predicted path, reacts, and moves
/// his hands to the ball. If he cannot reach the ball, he dives as far as he can. After the dive, he returns to his position. He only watches the ball and has
/// no memory of the match. <see cref="Follow"/> does not allocate.
/// </remarks>
public sealed class KeeperDive
{
    /// <summary>The duration of his prediction, in s.</summary>
    private const double LooksAhead = 2.5;

    /// <summary>The time that he stays down after a dive, and the time that he takes to return, in s.</summary>
    private const double Stays = 0.7;
    private const double Returns = 1.4;

    /// <summary>Half the length of his axis, in m; with the radius, 1.96 m from feet to hands.</summary>
    private const double HalfAxis = 0.78;
    private const double Radius = 0.2;

    /// <summary>The assumed distance of the ball from the tips of his hands, in m.</summary>
    private const double Hands = 0.1;

    /// <summary>The lateral distance below which he stays upright, in m.</summary>
    private const double StandsUpTo = 0.3;

    private const double Difference = 1e-4;

    /// <summary>The deviation from the predicted path that counts as a new shot, in m. The limit for the velocity is a hundred times as large, in m/s.</summary>
    private const double Notices = 0.01;

    /// <summary>The distance from the target of his dive within which a new shot needs no new dive, in m.</summary>
    private const double SamePlace = 0.2;

    private readonly KinematicBody _body;
    private readonly Interception _interception = new();
    private readonly TrajectoryCache _path;
    private readonly Player _abilities;
    private readonly Pose _home;
    private readonly Vector3d _feet;
    private Pose _from;
    private Pose _to;
    private double _start;
    private double _end = double.NegativeInfinity;
    private double _now = double.NaN;
    private Vector3d _target;

    /// <summary>Creates a keeper who stands in front of his goal.</summary>
    /// <param name="body">His body, of kind <see cref="Kind"/>, in the scene of the game.</param>
    /// <param name="goal">His goal.</param>
    /// <param name="ahead">The scene for predictions, without him.</param>
    /// <param name="feet">The position of his feet, in m.</param>
    /// <param name="abilities">His reaction, acceleration, speed, reach and height limits above his feet; position and velocity are ignored. Default
    /// null: <see cref="Typical"/>.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public KeeperDive(KinematicBody body, Goal goal, Simulator ahead, Vector3d feet, Player? abilities = null)
    {
        Check.Given(nameof(body), body);
        Check.Given(nameof(goal), goal);
        Check.Given(nameof(ahead), ahead);
        Check.Place(nameof(feet), feet);
        _abilities = abilities ?? Typical;
        _abilities.Validate();
        goal.Validate(nameof(goal));
        _body = body;
        Goal = goal;
        _feet = feet;
        _home = new Pose(feet + new Vector3d(0, HalfAxis + Radius, 0), Quaterniond.Identity);
        _path = new TrajectoryCache(ahead, new LookAheadRequest { Duration = LooksAhead, TimeStep = 0.02 }, Notices);
        _from = _home;
        _to = _home;
        Put(0);
    }

    /// <summary>The shape and surface of a keeper: 1.96 m from feet to hands, about his centre.</summary>
    /// <remarks>The entire surface has the material of gloves, which absorb most of a ball's speed. The values are guesses.</remarks>
    public static BodyKind Kind { get; } = new()
    {
        Shape = new CapsuleShape(new Vector3d(0, -HalfAxis, 0), new Vector3d(0, HalfAxis, 0), Radius),
        Surface = SurfaceMaterial.Glove,
    };

    /// <summary>The abilities of a good goalkeeper.</summary>
    /// <remarks>Reaction 0.2 s, acceleration 8 m/s², speed at most 5 m/s, reach 1.9 m in a dive, height 2.6 m. All values are guesses.</remarks>
    public static Player Typical => new() { Reaction = 0.2, Acceleration = 8, Speed = 5, Reach = 1.9, MaximumHeight = 2.6 };

    /// <summary>His goal.</summary>
    public Goal Goal { get; }

    /// <summary>His response to the last shot that he noticed.</summary>
    public KeeperResult Answer { get; private set; }

    /// <summary>True from the start of a dive until he is back.</summary>
    public bool Dives => _now >= _start && _now < _end + Stays + Returns;

    /// <summary>The number of shots that he has dived for.</summary>
    public int Count { get; private set; }

    /// <summary>The position and orientation of his body, for drawing.</summary>
    public BallPose BodyPose => new(_body.Position, _body.Orientation);

    /// <summary>Watches the ball and moves his body; call it before every step.</summary>
    /// <param name="ball">The ball before the step.</param>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    public void Follow(in BallState ball)
    {
        BallState.Launched(in ball);
        if (!(ball.Time >= _now))
        {
            // The clock went back, so the ball was placed: start again.
            (_from, _to, _end) = (_home, _home, double.NegativeInfinity);
            _start = double.PositiveInfinity;

            // Recompute the path even if it matches, because no decision was made for it.
            _path.Invalidate();
        }

        _now = ball.Time;
        if (_path.Update(in ball))
        {
            Decide(_now);
        }

        Put(_now);
    }

    /// <summary>Evaluates the predicted path, and starts a dive if the ball crosses the goal at a new point.</summary>
    private void Decide(double now)
    {
        Pose present = At(now);
        Vector3d feet = Feet(in present);
        Player self = Standing(in feet);
        KeeperResult answer = _interception.FindSave(_path.Path, in self, Goal, now);
        if (!answer.Crosses || !answer.IsOnTarget)
        {
            return;
        }

        Answer = answer;
        PathPoint at = answer.Saves ? answer.Save : answer.Crossing;
        if (now < _end && Vector3d.Distance(at.Position, _target) < SamePlace)
        {
            return;
        }

        _target = at.Position;
        double left = Math.Max(0, at.Time - now - _abilities.Reaction);
        (_from, _to) = (present, Reaching(in feet, at.Position, left));
        _start = now + _abilities.Reaction;
        _end = Math.Max(at.Time, _start + 0.05);
        Count++;
    }

    /// <summary>Returns the keeper for the search: at his feet, without motion, and with heights in world coordinates.</summary>
    private Player Standing(in Vector3d feet) => new()
    {
        Position = feet,
        Reaction = _abilities.Reaction,
        Acceleration = _abilities.Acceleration,
        Speed = _abilities.Speed,
        Reach = _abilities.Reach,
        MinimumHeight = _feet.Y + _abilities.MinimumHeight,
        MaximumHeight = _feet.Y + _abilities.MaximumHeight,
    };

    /// <summary>Returns his pose with the hands at the ball, or as close to it as he gets.</summary>
    private Pose Reaching(in Vector3d feet, Vector3d ball, double left)
    {
        Vector3d aside = (ball - feet).Horizontal;
        double distance = aside.Length;

        // D(s) = ½ a s² while s ≤ v/a, then v (s − v/2a); plus his reach.
        double speeding = _abilities.Speed / _abilities.Acceleration;
        double run = left <= speeding ? 0.5 * _abilities.Acceleration * left * left : _abilities.Speed * (left - (0.5 * speeding));
        double share = Math.Min(1, (run + _abilities.Reach) / Math.Max(distance, 1e-9));
        double low = feet.Y + Radius;
        double high = feet.Y + _abilities.MaximumHeight;
        Vector3d hands = feet + (share * aside) + new Vector3d(0, Math.Max(low, Math.Min(high, ball.Y)) - feet.Y, 0);
        double length = 2.0 * (HalfAxis + Radius) - Hands;
        if (distance <= StandsUpTo)
        {
            double lift = Math.Max(0, hands.Y - feet.Y - length);
            return new Pose(feet + (share * aside) + new Vector3d(0, HalfAxis + Radius + lift, 0), Quaterniond.Identity);
        }

        // His feet stay on the ground, unless the ball is higher than his length.
        double up = Math.Min(hands.Y - feet.Y, 0.98 * length);
        double along = Math.Sqrt((length * length) - (up * up));
        double gone = share * distance;
        Vector3d unit = aside / distance;
        Vector3d foot = feet + (Math.Max(0, gone - along) * unit);
        Vector3d axis = (hands - foot).Normalized();
        double reach = Math.Max(length, (hands - foot).Length);
        Vector3d middle = foot + ((reach - (0.5 * length)) * axis);
        middle = new Vector3d(middle.X, Math.Max(middle.Y, low), middle.Z);
        return new Pose(in middle, Between(Vector3d.Up, in axis));
    }

    /// <summary>Returns his pose at a time: a smooth transition to the dive, a pause, and the return.</summary>
    private Pose At(double time)
    {
        if (time < _end + Stays)
        {
            return Along(in _from, in _to, (time - _start) / (_end - _start));
        }

        return Along(in _to, in _home, (time - _end - Stays) / Returns);
    }

    /// <summary>Moves the body to its pose at a time; the velocities are difference quotients.</summary>
    private void Put(double time)
    {
        Pose now = At(time);
        Pose next = At(time + Difference);
        Vector3d velocity = (next.Middle - now.Middle) / Difference;

        // q(t + δ) q(t)⁻¹ ≈ (1, ½ ω δ)
        Quaterniond back = new(-now.Turn.X, -now.Turn.Y, -now.Turn.Z, now.Turn.W);
        Quaterniond turned = next.Turn * back;
        double sign = turned.W < 0 ? -2.0 : 2.0;
        Vector3d spin = new Vector3d(turned.X, turned.Y, turned.Z) * (sign / Difference);
        _body.MoveTo(now.Middle, now.Turn, velocity, spin, time);
    }

    private static Pose Along(in Pose from, in Pose to, double part)
    {
        double s = part > 0 ? Math.Min(1, part) : 0;
        double smooth = s * s * (3.0 - (2.0 * s));
        return new Pose(Vector3d.Lerp(from.Middle, to.Middle, smooth), Slerp.Between(from.Turn, to.Turn, smooth));
    }

    /// <summary>Returns the point on the ground from which he dives.</summary>
    private Vector3d Feet(in Pose pose)
    {
        Vector3d end = pose.Middle - (HalfAxis * pose.Turn.Rotate(Vector3d.Up));
        return new Vector3d(end.X, _feet.Y, end.Z);
    }

    /// <summary>Returns the shortest rotation between two unit vectors.</summary>
    private static Quaterniond Between(in Vector3d from, in Vector3d to)
    {
        Vector3d axis = Vector3d.Cross(in from, in to);
        return new Quaterniond(axis.X, axis.Y, axis.Z, 1.0 + Vector3d.Dot(in from, in to)).Normalized();
    }

    private readonly struct Pose
    {
        public Pose(in Vector3d middle, in Quaterniond turn)
        {
            Middle = middle;
            Turn = turn;
        }

        public Vector3d Middle { get; }

        public Quaterniond Turn { get; }
    }
}
