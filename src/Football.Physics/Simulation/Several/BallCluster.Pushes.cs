namespace FootballPhysics;

/// <content>What balls push.</content>
internal sealed partial class BallCluster
{
    /// <summary>The step is played so many times to find the balls that share a pushed object; after them all balls end their steps at each push.</summary>
    private const int MostPlays = 4;

    /// <summary>Forgets which balls can reach a pushed object that another ball can reach as well.</summary>
    public void ForgetShares() => _shares.Clear();

    /// <inheritdoc cref="PushShares.Find"/>
    public bool FindShares(MotionsBefore motions, double dt)
    {
        bool found = _shares.Find(motions, dt);
        for (int i = 0; found && i < _isIn.Length; i++)
        {
            if (_shares[i])
            {
                Join(i);
            }
        }

        return found;
    }

    /// <summary>A ball meets what it pushes, or what ends the step: all that may meet that too go there first.</summary>
    /// <returns>Whether it ends the step.</returns>
    private bool Push(BallState[] states, in Happening met, double end)
    {
        // Move the ball to the object that it pushes; the push changes the object's motion.
        _pushed.ReadBefore();
        StepLog own = _current[met.Ball];
        own.HaltsAtPush = true;
        own.StopAt = _stopAt;
        _simulators[met.Ball].Advance(ref states[met.Ball], _span.Left(in states[met.Ball], end), own);
        own.HaltsAtPush = false;
        own.StopAt = StopAt.Time;
        own.Halted = false;
        if (_stopAt == StopAt.Impact)
        {
            return true;
        }

        // Move balls that may reach the object to that time while its motion is still the old one. Then recompute their paths.
        _pushed.ReadAfter();
        for (int k = 0; k < _clusterCount; k++)
        {
            int i = _cluster[k];
            if (i != met.Ball && _shares[i] && !_piles.Has(i) && _pushed.MayBeMet(states[i].Position, _trials[i].Reach + _simulators[i].Scene.Ball.Radius, met.Time, end))
            {
                Commit(states, i, Math.Max(states[i].Time, met.Time));
                states[i].ClearUntil = 0;
                _again[i] = true;
            }
        }

        _pushed.PutAfter();
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
}
