namespace FootballPhysics;

/// <summary>
/// What a goal is. The ball's centre comes through the mouth, the plane of the posts' axes, between the posts and below the bar; it does not go back through
/// it; and it passes the line, R + r behind the mouth, wherever on that plane: all of the ball is over a line as wide as the posts. The event, and every
/// query that asks whether a shot goes in, ask here.
/// </summary>
internal readonly struct GoalMouth
{
    /// <summary>So close to the line, m, a ball has reached it.</summary>
    private const double Reached = 1e-10;

    private readonly Vector3d _right;
    private readonly double _halfWidth;
    private readonly double _height;
    private readonly double _postRadius;

    public GoalMouth(Goal goal)
    {
        Center = goal.Center;
        Out = goal.Out;
        _right = goal.Right;
        _halfWidth = 0.5 * goal.Width;
        _height = goal.Height;
        _postRadius = goal.PostRadius;
    }

    /// <summary>The middle of the goal's line, m.</summary>
    public Vector3d Center { get; }

    /// <summary>Unit normal of the mouth, towards the pitch.</summary>
    public Vector3d Out { get; }

    /// <summary>A box around the opening.</summary>
    public Bounds3d Bounds
    {
        get
        {
            // A flat box: from the foot of one post to the top of the other.
            Vector3d left = Center - (_halfWidth * _right);
            Vector3d right = Center + (_halfWidth * _right) + new Vector3d(0, _height, 0);
            return Bounds3d.Around(left, 0, 0, 0).Union(Bounds3d.Around(right, 0, 0, 0));
        }
    }

    /// <summary>True when another goal stands in the same place.</summary>
    public bool IsAt(GoalMouth other) => Center == other.Center && Out == other.Out && _halfWidth == other._halfWidth && _height == other._height && _postRadius == other._postRadius;

    /// <summary>Distance of the ball's centre before the mouth, m; negative behind it.</summary>
    public double BeforeMouth(in Vector3d position) => Vector3d.Dot(position - Center, Out);

    /// <summary>How far a ball has to go until all of it is over the line, m.</summary>
    public double BeforeLine(in Vector3d position, double radius) => BeforeMouth(in position) + _postRadius + radius;

    /// <summary>How far right of the middle a place is, seen by who stands in the goal, and how high above the line, m.</summary>
    public void Place(in Vector3d position, out double aside, out double height)
    {
        Vector3d from = position - Center;
        aside = Vector3d.Dot(in from, in _right);
        height = from.Y;
    }

    /// <summary>True when a place on the mouth is in the opening.</summary>
    public bool IsOpen(double aside, double height) => Math.Abs(aside) <= _halfWidth && height >= 0 && height <= _height;

    /// <inheritdoc cref="IsOpen(double, double)"/>
    public bool IsOpen(in Vector3d position)
    {
        Place(in position, out double aside, out double height);
        return IsOpen(aside, height);
    }

    /// <summary>
    /// True when a ball that is put, or kicked, at a place counts as come through the mouth: it lies in the opening, between mouth and line. One that is over
    /// the line already must come out first.
    /// </summary>
    public bool IsEntered(in Vector3d position, double radius) =>
        BeforeMouth(in position) <= 0 && BeforeLine(in position, radius) > Reached && IsOpen(in position);

    /// <summary>True when a straight way comes through the opening.</summary>
    public bool IsEntered(in Vector3d from, in Vector3d to)
    {
        // Where the straight way comes through the plane, linear in both distances.
        double before = BeforeMouth(in from);
        double after = BeforeMouth(in to);
        return before > 0 && after <= 0 && IsOpen(from + (before / (before - after) * (to - from)));
    }
}
