namespace FootballPhysics.Labs.Goals;

/// <summary>
/// Detects goals on a sampled path, independently of the library. It samples the path of each piece every half millisecond, and finds the time at which
/// the path passes a plane by bisection.
/// </summary>
internal sealed class GoalWatch(Goal goal, double radius)
{
    private const double Interval = 0.0005;

    /// <summary>Distances to post or bar below this, m, are undecided: the path agrees with the steps only to this accuracy.</summary>
    private const double Edge = 1e-6;

    private readonly Vector3d _out = goal.Facing / goal.Facing.Length;
    private bool _isThrough;
    private double _last;

    /// <summary>The time at which the ball was over the line, s; infinite if it never was.</summary>
    public double Time { get; private set; } = double.PositiveInfinity;

    /// <summary>True if the ball passed within rounding of post or bar, or turned back within rounding of the line.</summary>
    public bool IsUndecided { get; private set; }

    /// <summary>The position of the plane behind the mouth at which the ball is completely over the line, m.</summary>
    private double Line => -goal.PostRadius - radius;

    /// <summary>Returns the distance before the mouth, the distance aside of its middle, and the height above the ground.</summary>
    public (double Before, double Aside, double Height) Seen(Vector3d place)
    {
        Vector3d from = place - goal.Center;
        return ((from.X * _out.X) + (from.Z * _out.Z), (from.Z * _out.X) - (from.X * _out.Z), from.Y);
    }

    /// <summary>True if a ball that lies at the point lies in the goal: before the slanted back net. A ball behind the net may lie against it.</summary>
    public bool LiesIn(Vector3d place)
    {
        (double before, double aside, double height) = Seen(place);
        double depth = goal.DepthOnGround - ((goal.DepthOnGround - goal.DepthAtBar) * height / (goal.Height + goal.PostRadius));
        return before <= -goal.PostRadius - radius && before >= -depth
            && Math.Abs(aside) <= (0.5 * goal.Width) + goal.PostRadius && height <= 0.5 * goal.Height;
    }

    /// <summary>Follows a path from its start.</summary>
    public void Follow(Trajectory path)
    {
        // A ball that is kicked on the line, in the opening, is already through the mouth.
        Begin(path.Pieces.Length > 0 ? path.Pieces[0].StartPosition : path.Final.Position);
        Continue(path, double.PositiveInfinity);
    }

    /// <summary>Starts with a ball that is kicked or placed. A ball between mouth and line is through the mouth if it lies in the opening, or came through before.</summary>
    public void Begin(Vector3d place)
    {
        (double before, double aside, double height) = Seen(place);
        bool wasThrough = _isThrough && double.IsInfinity(Time) && before <= 0;
        _isThrough = wasThrough || (before <= 0 && before > -goal.PostRadius - radius && Math.Abs(aside) <= 0.5 * goal.Width && height <= goal.Height);
        _last = before;
        Time = double.PositiveInfinity;
        IsUndecided = false;
    }

    /// <summary>Follows the next part of a path, up to a time.</summary>
    public void Continue(Trajectory path, double until)
    {
        foreach (ref readonly PathSegment piece in path.Pieces)
        {
            double length = Math.Min(piece.Length, until - piece.Time);
            int parts = length > 0 ? Math.Max(2, (int)Math.Ceiling(length / Interval)) : 0;
            for (int i = 1; i <= parts && double.IsInfinity(Time); i++)
            {
                double from = piece.Time + (length * (i - 1) / parts);
                double to = piece.Time + (length * i / parts);
                double now = Seen(i == parts && length == piece.Length ? piece.EndPosition : piece.PositionAt(to)).Before;
                Look(in piece, from, to, _last, now);
                _last = now;
            }
        }
    }

    /// <summary>Follows a ball that an object in sustained contact moved straight from one position to another at a time.</summary>
    public void Jump(Vector3d from, Vector3d to, double time)
    {
        (double before, double aside, double height) = Seen(from);
        (double now, double asideNow, double heightNow) = Seen(to);
        if (before > 0 && now <= 0)
        {
            double share = before / (before - now);
            Pass(aside + (share * (asideNow - aside)), height + (share * (heightNow - height)));
        }

        _isThrough &= now <= 0;
        _last = now;
        if (_isThrough && now <= Line && double.IsInfinity(Time))
        {
            Time = time;
        }
    }

    private void Look(in PathSegment piece, double from, double to, double last, double now)
    {
        double line = Line;
        if (last > 0 && now <= 0)
        {
            (_, double aside, double height) = Seen(piece.PositionAt(Passes(piece, from, to, 0)));
            Pass(aside, height);
        }
        else if (now > 0)
        {
            _isThrough = false;
        }

        if (_isThrough && now <= line)
        {
            Time = last > line ? Passes(piece, from, to, line) : from;
        }

        // The ball turned back at the line: whether it was over the line for an instant is within rounding.
        IsUndecided |= _isThrough && double.IsInfinity(Time) && now > last && last - line < Edge;
    }

    private void Pass(double aside, double height)
    {
        double toPost = (0.5 * goal.Width) - Math.Abs(aside);
        double toBar = goal.Height - height;
        _isThrough = toPost >= 0 && toBar >= 0 && height >= 0;
        IsUndecided |= Math.Abs(Math.Min(toPost, toBar)) < Edge;
    }

    /// <summary>Returns the time at which a path passes a plane from front to back.</summary>
    private double Passes(PathSegment piece, double from, double to, double plane) => LabMath.Bisect(from, to, time => !(Seen(piece.PositionAt(time)).Before > plane));
}
