using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Batch;

/// <summary>The mouth of a goal, and the part of it that the goalkeeper covers.</summary>
internal readonly struct GoalPlane
{
    private readonly GoalMouth _mouth;
    private readonly bool _hasKeeper;
    private readonly RunnerMotion _keeper;
    private readonly Vector3d _right;

    public GoalPlane(Goal goal, Player? keeper)
    {
        goal.Validate("goal");
        _mouth = new GoalMouth(goal);
        _right = goal.Right;
        _hasKeeper = keeper is not null;
        if (keeper is { } given)
        {
            given.Validate();
        }

        Player runner = keeper ?? new Player();
        _keeper = new RunnerMotion(in runner, 0);
    }

    /// <summary>The centre of the goal line, in m.</summary>
    public Vector3d Center => _mouth.Center;

    /// <summary>The unit normal, towards the pitch.</summary>
    public Vector3d Out => _mouth.Out;

    /// <summary>The plane.</summary>
    public Plane3d Plane => new(Center, Out);

    /// <summary>Computes the offset to the right of the goal's centre, and the height.</summary>
    public void Place(in Vector3d position, out double aside, out double height) => _mouth.Place(in position, out aside, out height);

    /// <summary>Computes the components to the right and up of a displacement.</summary>
    public void Change(in Vector3d change, out double aside, out double height)
    {
        aside = Vector3d.Dot(in change, in _right);
        height = change.Y;
    }

    /// <summary>Returns true if the goalkeeper can reach a point in time.</summary>
    public bool IsCovered(double aside, double height, double time)
    {
        Covers(time, out double from, out double to, out double low, out double high);
        return aside >= from && aside <= to && height >= low && height <= high;
    }

    /// <summary>Computes the probabilities for a normal distribution of crossing points.</summary>
    /// <param name="s">The distribution.</param>
    /// <param name="frame">The spans in which kicks go in.</param>
    /// <param name="onTarget">The probability of a goal without a goalkeeper.</param>
    /// <param name="covered">The part of it that the goalkeeper can reach.</param>
    public void Chances(in GoalChanceResult s, FramePlays frame, out double onTarget, out double covered)
    {
        onTarget = 0;
        covered = 0;
        Covers(s.Time, out double from, out double to, out double low, out double high);
        foreach (FrameSpan aside in frame.Aside)
        {
            foreach (FrameSpan up in frame.Up)
            {
                onTarget += Chance(in s, aside.From, aside.To, up.From, up.To);
                covered += Chance(in s, Math.Max(from, aside.From), Math.Min(to, aside.To), Math.Max(low, up.From), Math.Min(high, up.To));
            }
        }
    }

    private static double Chance(in GoalChanceResult s, double from, double to, double low, double high) =>
        NormalDistribution.Rectangle(s.Aside, s.Height, s.AsideDeviation, s.HeightDeviation, s.Correlation, from, to, low, high);

    /// <summary>Computes the rectangle that the goalkeeper covers by a time; empty if there is no goalkeeper.</summary>
    private void Covers(double time, out double from, out double to, out double low, out double high)
    {
        (from, to) = (double.PositiveInfinity, double.NegativeInfinity);
        if (_hasKeeper)
        {
            _keeper.Covers(in _mouth, time, out from, out to);
        }

        // No ball crosses below the ground. A linear map may place it there, and a goalkeeper who reaches the ground covers it.
        low = _keeper.Lowest - Center.Y;
        low = low > 0 ? low : double.NegativeInfinity;
        high = _keeper.Highest - Center.Y;
    }
}
