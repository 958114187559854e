namespace FootballPhysics.Simulation;

/// <content>The paths of the balls, and the first event on them.</content>
internal sealed partial class BallCluster
{
    /// <inheritdoc cref="BallMeetings.MayMeet"/>
    public bool MayMeet(int i, double reach, int j, double otherReach) => _meets.MayMeet(_before, i, reach, j, otherReach);

    /// <summary>The path of a ball.</summary>
    public BallTrial TrialOf(int ball) => _trials[ball];

    /// <summary>The balls that share a pushed object.</summary>
    public PushShares Shares => _shares;

    /// <summary>Computes the path of a ball from its current state, and adds the balls that it may reach.</summary>
    private void Try(BallState[] states, int i, double end)
    {
        // A trial pushes objects with a mass, just as a step does: restore their motions afterwards.
        _pushed.Keep();
        _trials[i].Run(_simulators[i], in states[i], _span.Left(in states[i], end), _stopAt, _shares[i], in _current[i].Spent);
        _pushed.PutBack();
        Reach(states, i);
    }

    /// <summary>Extends the reach of a ball after an impact: it may now reach balls that were not its neighbours.</summary>
    private void Reach(BallState[] states, int i)
    {
        _meets.Change(i);
        double reach = (states[i].Position - _before[i].Position).Length + _trials[i].Reach;
        _shares.Extend(i, reach);
        if (!(reach > _reaches[i]))
        {
            return;
        }

        // Add a margin to the reach, so that later calls need not search for more balls.
        reach *= MoreReach;
        for (int k = 0; k < _isIn.Length; k++)
        {
            if (!_isIn[k] && MayMeet(i, reach, k, _reaches[k]))
            {
                Join(k);
            }
        }

        _reaches[i] = reach;
        _meets.Forget();
    }

    /// <summary>Finds the first event: a contact of two balls, a push, or an event that ends the step.</summary>
    private Happening FindFirst(double end)
    {
        _meets.Find(_cluster, _clusterCount, _before, _reaches);
        Happening first = Happening.None;
        int pair = 0;
        for (int a = 0; a < _clusterCount; a++)
        {
            int i = _cluster[a];
            for (; pair < _meets.Count && _meets.First(pair) == i; pair++)
            {
                int j = _meets.Second(pair);
                if (!_piles.AreOne(i, j))
                {
                    // Search only up to the time until which both paths are known: a halt, or the end of a pile's part.
                    double until = Math.Min(Math.Min(KnownUntil(i), KnownUntil(j)), end);
                    first = Happening.Earlier(new Happening(_meets.TimeOf(pair, until, atEnd: until < end), i, j), in first);
                }
            }

            first = Happening.Earlier(new Happening(_trials[i].HaltsAt, i, Happening.NoOther), in first);
        }

        return first;
    }

    /// <summary>Returns the time up to which a path is known, s: the halt of the ball, or the end of its pile's part.</summary>
    private double KnownUntil(int ball) => _piles.Of(ball)?.Until ?? _trials[ball].HaltsAt;
}
