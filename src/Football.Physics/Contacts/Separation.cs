using FootballPhysics.Scenes;

namespace FootballPhysics.Contacts;

/// <summary>An event searched for along a piece: a function of the ball's position that is positive before the event and zero at
/// it.</summary>
/// <param name="world">The world.</param>
/// <param name="what">The kind of the event.</param>
/// <param name="index">The collider, the net or the goal.</param>
/// <param name="axis">For nets: 0 and 1 along the sheet, 2 off its plane; plus 4 on the negative side.</param>
/// <param name="side">For nets: σ.</param>
/// <param name="deepest">The net in which the ball is deepest; −1 if it does not matter.</param>
/// <param name="deepestSide">σ of that net.</param>
internal readonly struct Separation(World world, SeparationKind what, int index, int axis = 0, double side = 0, int deepest = -1, double deepestSide = 0)
{
    private readonly World _world = world;
    private readonly int _axis = axis;
    private readonly int _deepest = deepest;
    private readonly double _deepestSide = deepestSide;

    /// <summary>Kind of the event.</summary>
    public SeparationKind What { get; } = what;

    /// <summary>Index of the collider, the net or the goal.</summary>
    public int Index { get; } = index;

    /// <summary>σ of the net that the ball enters.</summary>
    public double Side { get; } = side;

    /// <summary>Second derivative of the gap for unit acceleration: at the edge of a net, position and depth both contribute.</summary>
    public double Bends => _deepest >= 0 ? 2.0 : 1.0;

    /// <summary>The distance until the ball is in a net, across its plane or beyond its edge.</summary>
    /// <remarks>
    /// A net extends beyond its edge by the depth of the ball in another net. A ball pushed out of one net is thus caught by the next
    /// one if they are joined.
    /// </remarks>
    /// <param name="world">The world.</param>
    /// <param name="net">The net.</param>
    /// <param name="axis">0 and 1 along the sheet, 2 off its plane.</param>
    /// <param name="side">Side of that axis from which the ball comes.</param>
    /// <param name="sheetSide">σ.</param>
    /// <param name="deepest">The net in which the ball is deepest; −1 if it is in none.</param>
    /// <param name="deepestSide">σ of that net.</param>
    public static Separation OfMeetingNet(World world, int net, int axis, double side, double sheetSide, int deepest, double deepestSide) =>
        new(world, SeparationKind.NetMet, net, axis + (side < 0 ? 4 : 0), sheetSide, axis == 2 ? -1 : deepest, deepestSide);

    /// <summary>The depth in a net.</summary>
    public static Separation OfLeavingNet(World world, int net, double side) => new(world, SeparationKind.NetLeft, net, 2, side);

    /// <summary>The distance until a ball is off the edge of its net, by its radius plus its greatest depth in any net.</summary>
    /// <remarks>A ball held by one net rolls over its edge, but a ball held by two does not slip through where they are joined.</remarks>
    /// <param name="world">The world.</param>
    /// <param name="net">The net.</param>
    /// <param name="axis">0 or 1, along the sheet.</param>
    /// <param name="side">Side of that axis with the edge.</param>
    /// <param name="deepest">The net in which the ball is deepest.</param>
    /// <param name="deepestSide">σ of that net.</param>
    public static Separation OfNetEdge(World world, int net, int axis, double side, int deepest, double deepestSide) =>
        new(world, SeparationKind.NetLeft, net, axis + (side < 0 ? 4 : 0), 0, deepest, deepestSide);

    /// <summary>Returns the value, m, and the rate, m/s, at a position, velocity and time.</summary>
    public void Evaluate(in Vector3d position, in Vector3d velocity, double time, out double value, out double rate)
    {
        switch (What)
        {
            case SeparationKind.Contact:
                Collider collider = _world.Colliders[Index];

                // A stationary plane has the gap (p − c)·n − r, and no curvature.
                if (collider.StandingPlane is { } plane)
                {
                    value = plane.DistanceTo(in position) - _world.Ball.Radius;
                    rate = Vector3d.Dot(in velocity, plane.Normal);
                    break;
                }

                ShapePoint at = collider.At(in position, time);
                value = at.Distance - _world.Ball.Radius;

                // Along n, the shape's velocity at the ball's centre equals its velocity at the contact point.
                rate = Vector3d.Dot(velocity - collider.ShapeVelocity(in position, time), at.Normal);
                break;
            case SeparationKind.NetMet when (_axis & 3) == 2:
                double from = _axis >= 4 ? -1.0 : 1.0;
                value = (from * _world.Nets[Index].PlaceInFrame(in position).Z) - _world.Ball.Radius;
                rate = from * _world.Nets[Index].InFrame(in velocity).Z;
                break;
            case SeparationKind.NetMet:
                Beside(in position, in velocity, out value, out rate);
                break;
            case SeparationKind.NetLeft when (_axis & 3) == 2:
                value = _world.Nets[Index].Depth(in position, Side);
                rate = _world.Nets[Index].DepthRate(in velocity, Side);
                break;
            case SeparationKind.NetLeft:
                Beside(in position, in velocity, out value, out rate);
                value = _world.Ball.Radius - value;
                rate = -rate;
                break;
            default:
                ref readonly GoalMouth goal = ref _world.Goals[Index];
                double direction = What == SeparationKind.MouthLeft ? -1.0 : 1.0;
                value = direction * (What == SeparationKind.GoalLine ? goal.BeforeLine(in position, _world.Ball.Radius) : goal.BeforeMouth(in position));
                rate = direction * Vector3d.Dot(in velocity, goal.Out);
                break;
        }
    }

    /// <summary>Returns the distance of the ball beyond an edge of a net, minus its depth in its deepest net.</summary>
    private void Beside(in Vector3d position, in Vector3d velocity, out double value, out double rate)
    {
        NetSheet net = _world.Nets[Index];
        double sign = _axis >= 4 ? -1.0 : 1.0;
        Vector3d place = sign * net.PlaceInFrame(in position);
        Vector3d speed = sign * net.InFrame(in velocity);
        bool isLength = (_axis & 3) == 0;
        value = isLength ? place.X - net.HalfLength : place.Y - net.HalfWidth;
        rate = isLength ? speed.X : speed.Y;

        // A net extends beyond its edge by the depth of the ball in another net, so that it catches a ball between two nets.
        if (_deepest >= 0)
        {
            value -= _world.Nets[_deepest].Depth(in position, _deepestSide);
            rate -= _world.Nets[_deepest].DepthRate(in velocity, _deepestSide);
        }
    }
}

/// <summary>Kinds of events between a piece of motion and the world.</summary>
internal enum SeparationKind
{
    /// <summary>No event.</summary>
    None,

    /// <summary>The ball touches a collider. The gap is their distance.</summary>
    Contact,

    /// <summary>The ball reaches a collider that is flush with its carrier and becomes the carrier.</summary>
    Seam,

    /// <summary>The ball enters a net.</summary>
    NetMet,

    /// <summary>The ball leaves a net, off its plane or over its edge.</summary>
    NetLeft,

    /// <summary>The ball enters the mouth of a goal.</summary>
    MouthEntered,

    /// <summary>The ball goes back through the mouth.</summary>
    MouthLeft,

    /// <summary>The whole ball is over the line after it entered the mouth.</summary>
    GoalLine,
}
