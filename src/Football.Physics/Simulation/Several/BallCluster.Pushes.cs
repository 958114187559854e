using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <content>Objects pushed by balls.</content>
internal sealed partial class BallCluster
{
    /// <summary>Maximum number of passes to find the balls that share a pushed object.</summary>
    /// <remarks>After that, all balls end their steps at each push.</remarks>
    private const int MostPlays = 4;

    /// <summary>Clears the list of balls that share a pushed object.</summary>
    public void ForgetShares() => _shares.Clear();

    /// <inheritdoc cref="PushShares.Find"/>
    public bool FindShares(MotionSnapshot motions, double dt)
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

    /// <summary>Handles a push, or another event that ends the step of a ball. Other balls that may reach the object first move to the
    /// time of the event.</summary>
    /// <returns>True if it ends the step.</returns>
    private bool Push(BallState[] states, in Happening met, double end)
    {
        // Move the ball to the object that it pushes, then change the object's motion.
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

        // Before the object's motion changes, move balls that may reach it to the time of the push. Then recompute their paths.
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
