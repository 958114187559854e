namespace Football.Physics;

/// <content>What balls push.</content>
internal sealed partial class BallCluster
{
    /// <summary>A ball meets what it pushes, or what ends the step: all that may meet that too go there first.</summary>
    /// <returns>Whether it ends the step.</returns>
    private bool Push(BallState[] states, in Happening met, double end)
    {
        World world = _simulators[0].World;

        // The ball goes up to what it pushes, which then moves differently.
        world.ReadMotions(_motions);
        StepLog own = _current[met.Ball];
        own.HaltsAtPush = true;
        own.StopAt = _stopAt;
        _simulators[met.Ball].Advance(ref states[met.Ball], Left(in states[met.Ball], end), own);
        own.HaltsAtPush = false;
        own.StopAt = StopAt.Time;
        own.Halted = false;
        if (_stopAt == StopAt.Impact)
        {
            return true;
        }

        // Who may find it elsewhere goes to that time while it is where it was, and looks again.
        world.ReadMotions(_motionsAfter);
        Restore(_motions);
        for (int k = 0; k < _clusterCount; k++)
        {
            int i = _cluster[k];
            if (i != met.Ball && _pileOf[i] < 0 && FindsElsewhere(i, in states[i], met.Time, end))
            {
                Commit(states, i, Math.Max(states[i].Time, met.Time));
                states[i].ClearUntil = 0;
                _again[i] = true;
            }
        }

        Restore(_motionsAfter);
        _again[met.Ball] = true;
        for (int k = 0; k < _clusterCount; k++)
        {
            int i = _cluster[k];
            if (_again[i])
            {
                _again[i] = false;
                Try(states, i, end);
            }
        }

        return false;
    }

    /// <summary>True when a ball may come to a place, in the rest of a step, where something is that was pushed, or would have been.</summary>
    private bool FindsElsewhere(int ball, in BallState s, double time, double end)
    {
        World world = _simulators[0].World;
        if (world.Engine is not null)
        {
            return true;
        }

        double reach = _trials[ball].Reach + _simulators[ball].Scene.Ball.Radius;
        for (int m = 0; m < _motions.Length; m++)
        {
            if (_motions[m].Velocity != _motionsAfter[m].Velocity)
            {
                // All that it sweeps until the end, pushed and not pushed.
                Bounds3d box = world.BoundsOfMover(m, time);
                box = box.With(box.Moved((end - time) * _motions[m].Velocity)).With(box.Moved((end - time) * _motionsAfter[m].Velocity));
                if (box.Grown(reach).Touches(new Bounds3d(s.Position, s.Position)))
                {
                    return true;
                }
            }
        }

        return false;
    }

    private void Restore(RigidMotion[] motions)
    {
        if (motions.Length > 0)
        {
            _simulators[0].World.WriteMotions(motions);
        }
    }
}
