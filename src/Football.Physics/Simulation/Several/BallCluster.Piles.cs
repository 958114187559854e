namespace FootballPhysics.Simulation;

/// <content>The piles of the cluster.</content>
internal sealed partial class BallCluster
{
    /// <summary>Computes the next part of each pile that has reached the end of its current part.</summary>
    /// <returns>True if a ball of a pile bounced and the bounce ends the step.</returns>
    private bool PlanPiles(BallState[] states, out double time)
    {
        for (int k = 0; k < _piles.Count; k++)
        {
            BallPile pile = _piles[k];
            time = pile.Time;
            if (pile.Count == 0 || pile.Until > time || !(time < _span.End))
            {
                continue;
            }

            if (pile.Plan(states, _span.End, _current) && _stopAt == StopAt.Impact)
            {
                return true;
            }

            for (int m = 0; m < pile.Count; m++)
            {
                int i = pile[m];
                _trials[i].Go(in states[i], pile.WayOf(m), pile.Until - time);
                Reach(states, i);
            }
        }

        time = 0;
        BeginNew(states);
        return false;
    }

    /// <summary>Adds all balls in contact with each other to a pile.</summary>
    private void TakeAllOf(int root, BallState[] states, BallPile pile, double time)
    {
        for (int i = root; i < _isIn.Length; i++)
        {
            if (_rests.RootOf(i) == root)
            {
                Take(i, states, pile, time);
            }
        }

        pile.Sort(states);
    }

    private void Take(int i, BallState[] states, BallPile pile, double time)
    {
        // The ball may already be in the cluster without having started its step.
        Join(i);
        int at = Array.IndexOf(_cluster, i, _begun, _clusterCount - _begun);
        if (at >= 0)
        {
            // Start this ball's step now: swap it with the first ball that has not started.
            Begin(states, i);
            (_cluster[_begun], _cluster[at]) = (i, _cluster[_begun]);
            _begun++;
        }

        if (!_piles.Has(i))
        {
            Commit(states, i, time);
            _piles.Add(i, ref states[i], pile);
            _trials[i].Go(in states[i], Vector3d.Zero, 0);
            _meets.Change(i);
        }
    }

    /// <summary>Puts two balls in sustained contact, and all balls connected to them, into one pile.</summary>
    private void Press(BallState[] states, int i, int j, double time)
    {
        BallPile? mine = _piles.Of(i);
        BallPile? its = _piles.Of(j);
        BallPile pile = mine ?? its ?? _piles.Begin(time, _span.Length);
        TakeAllOf(_rests.RootOf(i), states, pile, time);
        TakeAllOf(_rests.RootOf(j), states, pile, time);
        if (mine is not null && its is not null && mine != its)
        {
            _piles.Unite(mine, its, states, _span.Length);
        }
    }
}
