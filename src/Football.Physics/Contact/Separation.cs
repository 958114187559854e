namespace Football.Physics;

/// <summary>An event sought along a piece: a function of the ball's place that is positive before it happens, and falls to zero where it does.</summary>
internal readonly struct Separation
{
    private readonly World _world;
    private readonly int _index;
    private readonly int _axis;
    private readonly double _side;

    private Separation(World world, SeparationKind what, int index, int axis, double side)
    {
        _world = world;
        What = what;
        _index = index;
        _axis = axis;
        _side = side;
    }

    /// <summary>Kind of the event.</summary>
    public SeparationKind What { get; }

    /// <summary>Index of the collider, the net or the goal.</summary>
    public int Index => _index;

    /// <summary>σ of the net that is met.</summary>
    public double Side => _side;

    /// <summary>The distance between the ball and a collider.</summary>
    public static Separation OfContact(World world, int collider) => new(world, SeparationKind.Contact, collider, 0, 0);

    /// <summary>Distance left until the ball is in a net: across its plane, or beside it.</summary>
    /// <param name="world">The world.</param>
    /// <param name="net">The net.</param>
    /// <param name="axis">0 and 1 beside it, 2 off its plane.</param>
    /// <param name="side">On which side of that axis the ball comes.</param>
    /// <param name="sheetSide">σ.</param>
    public static Separation OfMeetingNet(World world, int net, int axis, double side, double sheetSide) =>
        new(world, SeparationKind.NetMet, net, axis + (side < 0 ? 4 : 0), sheetSide);

    /// <summary>The depth in a net.</summary>
    public static Separation OfLeavingNet(World world, int net, double side) => new(world, SeparationKind.NetLeft, net, 0, side);

    /// <summary>The distance before the mouth of a goal, behind it, or before its line.</summary>
    /// <param name="world">The world.</param>
    /// <param name="what">Which of these: entering the mouth, leaving it, or the line.</param>
    /// <param name="goal">The goal.</param>
    public static Separation OfGoal(World world, SeparationKind what, int goal) => new(world, what, goal, 0, 0);

    /// <summary>Its value, m, and its rate, m/s, at a place with a velocity at a time.</summary>
    public void Evaluate(in Vector3d position, in Vector3d velocity, double time, out double value, out double rate)
    {
        switch (What)
        {
            case SeparationKind.Contact:
                Collider collider = _world.Colliders[_index];
                if (collider.StandingPlane is { } plane)
                {
                    value = plane.DistanceTo(in position) - _world.Ball.Radius;
                    rate = Vector3d.Dot(in velocity, plane.Normal);
                    break;
                }

                ShapePoint at = collider.At(in position, time);
                value = at.Distance - _world.Ball.Radius;
                rate = Vector3d.Dot(velocity - collider.Velocity, at.Normal);
                break;
            case SeparationKind.NetMet:
                NetSheet net = _world.Nets[_index];
                Vector3d place = net.PlaceInFrame(in position);
                Vector3d speed = net.InFrame(in velocity);
                int axis = _axis & 3;
                double sign = _axis >= 4 ? -1.0 : 1.0;
                value = (sign * (axis == 0 ? place.X : axis == 1 ? place.Y : place.Z))
                    - (axis == 0 ? net.HalfLength : axis == 1 ? net.HalfWidth : _world.Ball.Radius);
                rate = sign * (axis == 0 ? speed.X : axis == 1 ? speed.Y : speed.Z);
                break;
            case SeparationKind.NetLeft:
                NetSheet left = _world.Nets[_index];
                value = left.Depth(in position, _side);
                rate = -_side * Vector3d.Dot(in velocity, left.Normal);
                break;
            default:
                ref readonly GoalMouth goal = ref _world.Goals[_index];
                double direction = What == SeparationKind.MouthLeft ? -1.0 : 1.0;
                value = direction * (What == SeparationKind.GoalLine ? goal.BeforeLine(in position, _world.Ball.Radius) : goal.BeforeMouth(in position));
                rate = direction * Vector3d.Dot(in velocity, goal.Out);
                break;
        }
    }
}

/// <summary>Kinds of events that a piece of motion meets in the world.</summary>
internal enum SeparationKind
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>It touches a collider.</summary>
    Contact,

    /// <summary>It meets a net.</summary>
    NetMet,

    /// <summary>It leaves a net.</summary>
    NetLeft,

    /// <summary>It comes through the mouth of a goal.</summary>
    MouthEntered,

    /// <summary>It goes back through the mouth.</summary>
    MouthLeft,

    /// <summary>Having come through the mouth, all of it is over the line.</summary>
    GoalLine,
}
