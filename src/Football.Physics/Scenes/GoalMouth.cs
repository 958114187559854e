namespace FootballPhysics.Scenes;

/// <summary>The definition of a goal, shared by the event and by every query that predicts goals.</summary>
/// <remarks>
/// The mouth is the plane of the posts' axes, between the posts and below the crossbar. A goal counts if the ball's centre passes through the mouth and then
/// the line, R + r behind it, without coming back through the mouth. At that point, the entire ball is over a line as wide as the posts.
/// </remarks>
internal readonly struct GoalMouth(Goal goal)
{
    /// <summary>The distance to the line at which the ball counts as over it, in m.</summary>
    private const double Reached = 1e-10;

    private readonly Vector3d _right = goal.Right;
    private readonly double _halfWidth = 0.5 * goal.Width;
    private readonly double _height = goal.Height;
    private readonly double _postRadius = goal.PostRadius;

    /// <summary>The centre of the goal line, in m.</summary>
    public Vector3d Center { get; } = goal.Center;

    /// <summary>The unit normal of the mouth, towards the pitch.</summary>
    public Vector3d Out { get; } = goal.Out;

    /// <summary>A bounding box of the opening.</summary>
    public Bounds3d Bounds
    {
        get
        {
            // A flat box, from the foot of one post to the top of the other.
            Vector3d left = Center - (_halfWidth * _right);
            Vector3d right = Center + (_halfWidth * _right) + new Vector3d(0, _height, 0);
            return Bounds3d.Around(left, 0, 0, 0).Union(Bounds3d.Around(right, 0, 0, 0));
        }
    }

    /// <summary>True if another goal has the same position and size.</summary>
    public bool IsAt(GoalMouth other) => Center == other.Center && Out == other.Out && _halfWidth == other._halfWidth && _height == other._height && _postRadius == other._postRadius;

    /// <summary>Returns the distance of the ball's centre in front of the mouth, in m; negative behind it.</summary>
    public double BeforeMouth(in Vector3d position) => Vector3d.Dot(position - Center, Out);

    /// <summary>Returns the distance that remains until the entire ball is over the line, in m.</summary>
    public double BeforeLine(in Vector3d position, double radius) => BeforeMouth(in position) + _postRadius + radius;

    /// <summary>Computes the offset to the right of the goal's centre, as seen by the goalkeeper, and the height, in m.</summary>
    public void Place(in Vector3d position, out double aside, out double height)
    {
        Vector3d from = position - Center;
        aside = Vector3d.Dot(in from, in _right);
        height = from.Y;
    }

    /// <summary>True if a point of the mouth is in the opening.</summary>
    public bool IsOpen(double aside, double height) => Math.Abs(aside) <= _halfWidth && height >= 0 && height <= _height;

    /// <inheritdoc cref="IsOpen(double, double)"/>
    public bool IsOpen(in Vector3d position)
    {
        Place(in position, out double aside, out double height);
        return IsOpen(aside, height);
    }

    /// <summary>True if a ball that is placed or kicked at a position counts as having come through the mouth.</summary>
    /// <remarks>It must be in the opening, between mouth and line. A ball that is already over the line must leave the goal first.</remarks>
    public bool IsEntered(in Vector3d position, double radius) =>
        BeforeMouth(in position) <= 0 && BeforeLine(in position, radius) > Reached && IsOpen(in position);

    /// <summary>True if a line segment passes through the opening from the front.</summary>
    public bool IsEntered(in Vector3d from, in Vector3d to)
    {
        // Both distances are linear along the segment: interpolate to the plane of the mouth.
        double before = BeforeMouth(in from);
        double after = BeforeMouth(in to);
        return before > 0 && after <= 0 && IsOpen(from + (before / (before - after) * (to - from)));
    }
}
