namespace Football.Physics.Batch;

/// <summary>The mouth of a goal, and what a place on its plane is worth.</summary>
internal readonly struct GoalPlane
{
    private readonly GoalMouth _mouth;
    private readonly double _halfWidth;
    private readonly double _height;
    private readonly bool _hasKeeper;
    private readonly RunnerMotion _keeper;
    private readonly Vector3d _right;

    public GoalPlane(Goal goal, Player? keeper)
    {
        goal.Validate("goal");
        _mouth = new GoalMouth(goal);
        _right = goal.Right;
        _halfWidth = 0.5 * goal.Width;
        _height = goal.Height;
        _hasKeeper = keeper is not null;
        if (keeper is { } given)
        {
            given.Validate();
        }

        Player runner = keeper ?? new Player();
        _keeper = new RunnerMotion(in runner, 0);
    }

    /// <summary>The middle of the goal's line, m.</summary>
    public Vector3d Center => _mouth.Center;

    /// <summary>Unit normal, to the pitch.</summary>
    public Vector3d Out => _mouth.Out;

    /// <summary>The plane.</summary>
    public Plane3d Plane => new(Center, Out);

    /// <summary>How far right of the middle, and how high.</summary>
    public void Place(in Vector3d position, out double aside, out double height) => _mouth.Place(in position, out aside, out height);

    /// <summary>How far right, and up, a change of place is.</summary>
    public void Change(in Vector3d change, out double aside, out double height)
    {
        aside = Vector3d.Dot(in change, in _right);
        height = change.Y;
    }

    /// <summary>True when the ball goes in there.</summary>
    public bool IsIn(double aside, double height) => _mouth.IsOpen(aside, height);

    /// <summary>True when the goalkeeper can be there by then.</summary>
    public bool IsCovered(double aside, double height, double time)
    {
        Covers(time, out double from, out double to, out double low, out double high);
        return aside >= from && aside <= to && height >= low && height <= high;
    }

    /// <summary>Chances of a normal distribution of places.</summary>
    /// <param name="s">The distribution.</param>
    /// <param name="onTarget">That it goes in.</param>
    /// <param name="covered">That it does so where the goalkeeper can be.</param>
    public void Chances(in GoalChanceResult s, out double onTarget, out double covered)
    {
        onTarget = NormalDistribution.Rectangle(
            s.Aside, s.Height, s.AsideDeviation, s.HeightDeviation, s.Correlation, -_halfWidth, _halfWidth, double.NegativeInfinity, _height);
        Covers(s.Time, out double from, out double to, out double low, out double high);
        covered = NormalDistribution.Rectangle(
            s.Aside, s.Height, s.AsideDeviation, s.HeightDeviation, s.Correlation, Math.Max(from, -_halfWidth), Math.Min(to, _halfWidth), low, Math.Min(high, _height));
    }

    /// <summary>Rectangle that the goalkeeper covers by a time; empty without one.</summary>
    private void Covers(double time, out double from, out double to, out double low, out double high)
    {
        _keeper.MiddleAt(time, out double x, out double z);
        Vector3d middle = new Vector3d(x, 0, z) - Center;
        double off = Vector3d.Dot(in middle, Out);
        double aside = Vector3d.Dot(in middle, in _right);
        double radius = _hasKeeper ? _keeper.RadiusAt(time) : 0;
        double half = radius > Math.Abs(off) ? Math.Sqrt((radius * radius) - (off * off)) : double.NegativeInfinity;
        from = aside - half;
        to = aside + half;
        low = _keeper.Lowest - Center.Y;
        high = _keeper.Highest - Center.Y;
    }
}
