namespace FootballPhysics;

/// <content>Events of all balls, in order.</content>
public sealed partial class BallGroup
{
    /// <summary>Adds the counts, and the events of all balls ordered by time and then by ball.</summary>
    private void Report(StepLog log)
    {
        log.AddCounts(_flown);
        int reported = 0;
        for (int i = 0; i < Count; i++)
        {
            // Skip balls of the cluster: their steps were repeated, and only the repeated steps are logged.
            for (int k = _firstEvent[i]; k < _firstEvent[i + 1] && !_cluster.Has(i); k++)
            {
                Insert(in _flown.Events[k], reported++);
            }
        }

        // Balls of the cluster have their own logs.
        for (int k = 0; k < _cluster.Count; k++)
        {
            StepLog own = _logs[_cluster[k]];
            log.AddCounts(own);
            for (int e = 0; e < own.Events.Count; e++)
            {
                Insert(in own.Events[e], reported++);
            }
        }

        for (int k = 0; k < reported; k++)
        {
            log.Events.Add(in _reported[k]);
        }
    }

    /// <summary>Inserts an event in order: by time, then by ball, then by its order within the ball.</summary>
    private void Insert(in BallEvent happened, int count)
    {
        if (count == _reported.Length)
        {
            Array.Resize(ref _reported, 2 * count);
        }

        // The insertion is stable, so each ball's events keep their order.
        int place = count;
        for (; place > 0 && (_reported[place - 1].Time > happened.Time || (_reported[place - 1].Time == happened.Time && _reported[place - 1].Ball > happened.Ball)); place--)
        {
            _reported[place] = _reported[place - 1];
        }

        _reported[place] = happened;
    }
}
