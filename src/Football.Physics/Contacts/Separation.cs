using FootballPhysics.Scenes;

namespace FootballPhysics.Contacts;

/// <summary>An event searched for along a piece: a function of the ball's position that is positive before the event and zero at
/// it.</summary>
/// <param name="world">The world.</param>
/// <param name="what">The kind of the event.</param>
/// <param name="index">The collider, the net or the goal.</param>
/// <param name="axis">For a net: 0 or 1 for an edge along the sheet, 2 for its plane.</param>
/// <param name="from">For a net: the side of that axis, as the sign of a coordinate.</param>
/// <param name="side">σ of a net that the ball enters.</param>
/// <param name="deepest">For an edge: the net in which the ball is deepest; −1 if it is in none.</param>
/// <param name="deepestSide">σ of that net.</param>
internal readonly struct Separation(World world, SeparationKind what, int index, int axis = 0, double from = 0, double side = 0, int deepest = -1, double deepestSide = 0)
{
    private readonly World _world = world;
    private readonly int _axis = axis;
    private readonly double _sign = from < 0 ? -1.0 : 1.0;
    private readonly int _deepest = deepest;
    private readonly double _deepestSide = deepestSide;

    /// <summary>Kind of the event.</summary>
    public SeparationKind What { get; } = what;

    /// <summary>Index of the collider, the net or the goal.</summary>
    public int Index { get; } = index;

    /// <summary>σ of the net that the ball enters.</summary>
    public double Side { get; } = side;

    /// <summary>Second derivative of the gap for unit acceleration: at the edge of a net, position and depth both contribute.</summary>
    public readonly double Bends = deepest >= 0 ? 2.0 : 1.0;

    /// <summary>Returns the value, m, and the rate, m/s, at a position, velocity and time.</summary>
    public void Evaluate(in Vector3d position, in Vector3d velocity, double time, out double value, out double rate)
    {
        if (What != SeparationKind.Contact)
        {
            EvaluatePassage(in position, in velocity, out value, out rate);
            return;
        }

        Collider collider = _world.ByIndex[Index];
        if (collider.StandingPlane is { } plane)
        {
            // A stationary plane through c has the gap (p − c)·n − r, and no curvature.
            value = plane.DistanceTo(in position) - _world.Ball.Radius;
            rate = Vector3d.Dot(in velocity, plane.Normal);
            return;
        }

        // Along n, the shape's velocity at the ball's centre equals its velocity at the contact point.
        ShapePoint at = collider.At(in position, time);
        value = at.Distance - _world.Ball.Radius;
        rate = Vector3d.Dot(velocity - collider.ShapeVelocity(in position, time), at.Normal);
    }

    /// <summary>Returns the same for a net or a goal; these do not move.</summary>
    private void EvaluatePassage(in Vector3d position, in Vector3d velocity, out double value, out double rate)
    {
        if (What is SeparationKind.NetMet or SeparationKind.NetLeft)
        {
            value = _world.Nets[Index].Beyond(_axis, _sign, in position, in velocity, out rate);
            if (_deepest >= 0)
            {
                // A net extends beyond its edge by the depth of the ball in another net, so that it catches a ball between two nets.
                value -= _world.Nets[_deepest].Depth(in position, _deepestSide);
                rate -= _world.Nets[_deepest].DepthRate(in velocity, _deepestSide);
            }

            // A ball enters a net when it touches the sheet inside the edges, and leaves it when it is off the plane or the edges by its radius.
            bool leaves = What == SeparationKind.NetLeft;
            value = leaves ? _world.Ball.Radius - value : _axis == 2 ? value - _world.Ball.Radius : value;
            rate = leaves ? -rate : rate;
            return;
        }

        ref readonly GoalMouth goal = ref _world.Goals[Index];
        double direction = What == SeparationKind.MouthLeft ? -1.0 : 1.0;
        value = direction * (What == SeparationKind.GoalLine ? goal.BeforeLine(in position, _world.Ball.Radius) : goal.BeforeMouth(in position));
        rate = direction * Vector3d.Dot(in velocity, goal.Out);
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
