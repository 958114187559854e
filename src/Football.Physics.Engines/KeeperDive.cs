namespace FootballPhysics.Engines;

/// <summary>A goalkeeper as a body of the scene: he stands before his goal, and dives for what comes at it where <see cref="Interception.FindSave"/> says that he can meet it.</summary>
/// <remarks>
/// He is told of a kick when the ball leaves the path that he expects, reacts, and brings his hands to the ball when it is there; what he cannot reach he dives for as far
/// as he gets. Then he goes back. He looks at the ball alone: no memory of the match. Follows allocate nothing.
/// </remarks>
public sealed class KeeperDive
{
    /// <summary>How far ahead he looks, s.</summary>
    private const double LooksAhead = 2.5;

    /// <summary>How long he stays where he has dived, and how long he takes to go back, s.</summary>
    private const double Stays = 0.7;
    private const double Returns = 1.4;

    /// <summary>Half the length of his axis, m: with the radius, from feet to hands 1.96 m.</summary>
    private const double HalfAxis = 0.78;
    private const double Radius = 0.2;

    /// <summary>What he reaches for lies this far within his hands, m.</summary>
    private const double Hands = 0.1;

    /// <summary>A shot no further aside than this he stands up to, m.</summary>
    private const double StandsUpTo = 0.3;

    private const double Difference = 1e-4;

    /// <summary>A ball that is no further off the way that he expects, m, and no more than a hundred times that by the second, is no new shot.</summary>
    private const double Notices = 0.01;

    /// <summary>A shot that goes to within this of where he dives to, m, needs no new dive.</summary>
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

    /// <summary>Makes him, standing before his goal.</summary>
    /// <param name="body">His body, of kind <see cref="Kind"/>: one of the scene that is played in.</param>
    /// <param name="goal">The goal that he guards.</param>
    /// <param name="ahead">The scene as he expects it, which he is no part of.</param>
    /// <param name="feet">Where he stands, m.</param>
    /// <param name="abilities">How fast he reacts and moves, how far he reaches, and from and to which height over his feet; his place and velocity do not count. Default null: <see cref="Typical"/>.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
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

    /// <summary>Shape and surface of a keeper: 1.96 m from his feet to his hands, about his middle; gloves all over, which take most of a ball's speed. Evidence: guess.</summary>
    public static BodyKind Kind { get; } = new()
    {
        Shape = new CapsuleShape(new Vector3d(0, -HalfAxis, 0), new Vector3d(0, HalfAxis, 0), Radius),
        Surface = SurfaceMaterial.Glove,
    };

    /// <summary>Abilities of a good keeper: reaction 0.2 s, 8 m/s², at most 5 m/s, 1.9 m of reach in a dive, up to 2.6 m. Evidence: guess.</summary>
    public static Player Typical => new() { Reaction = 0.2, Acceleration = 8, Speed = 5, Reach = 1.9, MaximumHeight = 2.6 };

    /// <summary>The goal that he guards.</summary>
    public Goal Goal { get; }

    /// <summary>His answer to the last shot that he has seen.</summary>
    public KeeperResult Answer { get; private set; }

    /// <summary>True from the moment at which he dives until he is back.</summary>
    public bool Dives => _now >= _start && _now < _end + Stays + Returns;

    /// <summary>How many shots he has dived for.</summary>
    public int Count { get; private set; }

    /// <summary>Where his body is, and how it is turned: for drawing.</summary>
    public BallPose BodyPose => new(_body.Position, _body.Orientation);

    /// <summary>Watches the ball, and puts the body where he is: before every step.</summary>
    /// <param name="ball">The ball before the step.</param>
    public void Follow(in BallState ball)
    {
        if (!(ball.Time >= _now))
        {
            // It was placed: a new start.
            (_from, _to, _end) = (_home, _home, double.NegativeInfinity);
            _start = double.PositiveInfinity;

            // He has not decided anything about this path yet, though it may be the one that is kept.
            _path.Invalidate();
        }

        _now = ball.Time;
        if (_path.Update(in ball))
        {
            Decide(_now);
        }

        Put(_now);
    }

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

    /// <summary>He as the search has him: at his feet, without motion; its heights are those of the world.</summary>
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

    /// <summary>How he lies when his hands are where the ball will be, or as near to it as he comes.</summary>
    private Pose Reaching(in Vector3d feet, Vector3d ball, double left)
    {
        Vector3d aside = (ball - feet).Horizontal;
        double distance = aside.Length;

        // D(s) = ½ a s² while s ≤ v/a, then v (s − v/2a); and his reach.
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

        // His feet stay on the ground, unless the ball is higher than he is long.
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

    /// <summary>Where he is at a time: smoothly from one pose to the other, then still, then back.</summary>
    private Pose At(double time)
    {
        if (time < _end + Stays)
        {
            return Along(in _from, in _to, (time - _start) / (_end - _start));
        }

        return Along(in _to, in _home, (time - _end - Stays) / Returns);
    }

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

    /// <summary>The place on the ground that he dives from.</summary>
    private Vector3d Feet(in Pose pose)
    {
        Vector3d end = pose.Middle - (HalfAxis * pose.Turn.Rotate(Vector3d.Up));
        return new Vector3d(end.X, _feet.Y, end.Z);
    }

    /// <summary>The shortest rotation from one direction to another, both of length 1.</summary>
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
