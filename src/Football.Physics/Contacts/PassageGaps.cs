using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Contacts;

/// <summary>The gap to an event of a net that is linear in the position: it falls to zero. A gap that is closed already does not count.</summary>
/// <param name="sought">The event.</param>
/// <param name="path">The path.</param>
/// <param name="time">Start time of the path, s.</param>
/// <param name="acceleration">Upper bound of the acceleration on it, m/s².</param>
internal readonly struct FallingGap(in Separation sought, in PathCubic path, double time, double acceleration) : IGap
{
    private readonly Separation _sought = sought;
    private readonly PathCubic _path = path;
    private readonly double _bend = sought.Bends * acceleration;
    private readonly double _time = time;

    public bool IsClosed(double t, out double step)
    {
        _sought.Evaluate(_path.At(t), _path.VelocityAt(t), _time + t, out double gap, out double rate);
        step = double.PositiveInfinity;

        // If the gap is closed and still decreases, the event has occurred. If it is closed and constant, there is no event.
        if (gap <= ContactTolerances.Touching)
        {
            if (rate < -ContactTolerances.Approaching && (t > 0 || gap > 0 || _sought.What == SeparationKind.NetLeft))
            {
                return true;
            }

            if (rate <= ContactTolerances.Approaching)
            {
                return false;
            }
        }

        step = TimeOfImpact.Step(gap, rate, _bend);
        return false;
    }
}

/// <summary>The gap to a net: closed within the ball's radius of the sheet, inside the rectangle.</summary>
/// <param name="world">The world.</param>
/// <param name="index">The net.</param>
/// <param name="deepest">The net in which the ball is deepest; −1 if it is in none.</param>
/// <param name="deepestSide">σ of that net.</param>
/// <param name="path">The path.</param>
/// <param name="acceleration">Upper bound of the acceleration on it, m/s².</param>
internal struct NetGap(World world, int index, int deepest, double deepestSide, in PathCubic path, double acceleration) : IGap
{
    private readonly PathCubic _path = path;

    /// <summary>The condition that was met last.</summary>
    public Separation Last;

    public bool IsClosed(double t, out double step)
    {
        Vector3d at = _path.At(t);
        Vector3d velocity = _path.VelocityAt(t);
        Vector3d place = world.Nets[index].PlaceInFrame(in at);

        // The side of entry is the side of the sheet from which the ball reaches the slab.
        double side = place.Z < 0 ? -1.0 : 1.0;
        var plane = new Separation(world, SeparationKind.NetMet, index, 2, side, side);
        Last = Last.What == SeparationKind.None ? plane : Last;
        step = 0;
        Consider(in plane, in at, in velocity, ref step);
        Consider(new Separation(world, SeparationKind.NetMet, index, 0, place.X, side, deepest, deepestSide), in at, in velocity, ref step);
        Consider(new Separation(world, SeparationKind.NetMet, index, 1, place.Y, side, deepest, deepestSide), in at, in velocity, ref step);
        return step == 0;
    }

    /// <summary>Computes for how long one condition of a net remains unmet. The longest such time is safe for all conditions.</summary>
    private void Consider(in Separation condition, in Vector3d place, in Vector3d velocity, ref double step)
    {
        condition.Evaluate(in place, in velocity, 0, out double value, out double rate);
        double bend = condition.Bends * acceleration;

        // If the gap is open, advance as far as it certainly stays open. If it is zero but not decreasing, advance until it could decrease. Otherwise, the step is zero.
        double safe = value > ContactTolerances.Touching ? TimeOfImpact.Safe(value, rate, bend)
            : value > -ContactTolerances.Touching && rate >= 0 ? TimeOfImpact.Along(rate, bend)
            : 0;
        if (value > -ContactTolerances.Touching && rate >= 0)
        {
            safe = Math.Max(safe, double.Epsilon);
        }

        if (safe > step)
        {
            step = safe;
            Last = condition;
        }
    }
}

/// <summary>The gap to the mouth of a goal, which the ball may enter only from the front.</summary>
/// <param name="mouth">The mouth.</param>
/// <param name="goal">Its goal.</param>
/// <param name="path">The path.</param>
/// <param name="time">Start time of the path, s.</param>
/// <param name="acceleration">Upper bound of the acceleration on it, m/s².</param>
internal struct MouthGap(in Separation mouth, in GoalMouth goal, in PathCubic path, double time, double acceleration) : IGap
{
    private readonly Separation _mouth = mouth;
    private readonly GoalMouth _goal = goal;
    private readonly PathCubic _path = path;
    private readonly double _time = time;
    private readonly double _bend = acceleration;

    /// <summary>At the start of the path, the ball may be slightly behind the mouth, because the last piece projected it onto its carrier.</summary>
    private bool _isBefore = goal.BeforeMouth(path.Start) >= -ContactTolerances.Projected;

    public bool IsClosed(double t, out double step)
    {
        Vector3d place = _path.At(t);
        _mouth.Evaluate(in place, _path.VelocityAt(t), _time + t, out double gap, out double rate);
        step = 0;
        if (_isBefore && TimeOfImpact.Closes(gap, rate) && _goal.IsOpen(in place))
        {
            return true;
        }

        // The ball can reach the plane from either side, so record on which side it is.
        _isBefore = gap > ContactTolerances.Touching || (_isBefore && rate >= -ContactTolerances.Approaching);
        step = gap < -ContactTolerances.Touching ? TimeOfImpact.Safe(-gap, -rate, _bend)
            : TimeOfImpact.Step(gap, gap > ContactTolerances.Touching ? rate : Math.Abs(rate), _bend);
        return false;
    }
}

/// <summary>The gap to a plane of a goal for a ball in its mouth. A plane that the ball has already passed counts at once.</summary>
/// <param name="plane">The plane.</param>
/// <param name="path">The path.</param>
/// <param name="time">Start time of the path, s.</param>
/// <param name="acceleration">Upper bound of the acceleration on it, m/s².</param>
internal readonly struct GoalPlaneGap(in Separation plane, in PathCubic path, double time, double acceleration) : IGap
{
    private readonly Separation _plane = plane;
    private readonly PathCubic _path = path;
    private readonly double _time = time;
    private readonly double _bend = acceleration;

    public bool IsClosed(double t, out double step)
    {
        _plane.Evaluate(_path.At(t), _path.VelocityAt(t), _time + t, out double gap, out double rate);

        // The ball is beyond the plane, or on the plane and moving through it.
        bool passes = gap < -2.0 * ContactTolerances.Touching || TimeOfImpact.Closes(gap, rate);
        step = passes ? 0 : TimeOfImpact.Step(gap, rate, _bend);
        return passes;
    }
}
